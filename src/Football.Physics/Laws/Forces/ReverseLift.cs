using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The part of the lift of a smooth ball that reverses it near the drag crisis: −Λ (σ(b − a) − σ(b + a)), a = S Re/Re_s, b = (Re − Re_c)/Re_s.</summary>
/// <remarks>
/// The side that moves against the air has the higher relative speed. Near the crisis, only this side is turbulent, and the ball bends the other way. The force uses
/// (σ(b − a) − σ(b + a))/a, which is smooth and even in a.
/// </remarks>
internal struct ReverseLift
{
    /// <summary>|a| below which the quotient equals its limit to ten digits.</summary>
    private const double SmallShift = 1e-3;

    /// <summary>|u|² below which there is no lift, in m²/s².</summary>
    private const double StillAir = 1e-18;

    private double _scale; // ½ ρ A r Λ/m
    private double _radius;
    private double _perSpeed; // 2r/(ν Re_s), s/m
    private double _critical; // Re_c/Re_s

    /// <summary>True if the scene has a reverse lift: the Magnus force is that of the measured laws, and Λ is not 0.</summary>
    public readonly bool Acts => _scale > 0;

    public void Prepare(Scene scene)
    {
        BallProperties ball = scene.Ball;
        bool isMeasured = scene.Forces is { Coefficients: AerodynamicModel.Measured, Magnus: ForceLaw.Empirical };
        _scale = isMeasured ? AirScale.DynamicArea(scene) * ball.Radius * ball.ReverseLift : 0;
        _radius = ball.Radius;
        _perSpeed = 2.0 * ball.Radius / (scene.Air.KinematicViscosity * ball.DragCurve.Width);
        _critical = ball.DragCurve.CriticalReynolds / ball.DragCurve.Width;
    }

    /// <summary>Returns the part of L in a = L (ω̂ × u), in 1/s; at most 0. Without spin or speed, it is 0.</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    public readonly double Part(double speedSquared, double spinRate, double acrossSquared) =>
        spinRate > 0 && speedSquared > StillAir ? Factor(Math.Sqrt(speedSquared), spinRate, acrossSquared) : 0;

    /// <summary>Returns the part of L in a = L (ω̂ × u), in 1/s; at most 0.</summary>
    /// <param name="speed">|u|, m/s; above 0.</param>
    /// <param name="spinRate">|ω|, rad/s; at least 0.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    public readonly double Factor(double speed, double spinRate, double acrossSquared)
    {
        // Re is the Reynolds number, Re_c and Re_s are the position and width of the crisis, Λ is the reverse lift, σ the logistic function, b = (Re − Re_c)/Re_s.
        // a = S Re/Re_s with S = r|ω × u|/|u|². L = ½ρA/m r|ω| C_L/S, and C_L/S = −Λ Re/Re_s (σ(b − a) − σ(b + a))/a.
        double reynolds = _perSpeed * speed;
        double a = _radius * spinRate * Math.Sqrt(acrossSquared) / (speed * speed) * reynolds;
        double b = reynolds - _critical;
        double slope = a < SmallShift
            ? 2.0 * Elementary.Logistic(b) * Elementary.Logistic(-b)
            : (Elementary.Logistic(a - b) - Elementary.Logistic(-a - b)) / a;
        return -_scale * spinRate * reynolds * slope;
    }
}
