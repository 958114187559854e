using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The air coefficients of a scene as functions of speed and spin, for display next to the numbers of a preset.</summary>
public static class AirCurve
{
    /// <summary>Calculates the drag coefficient C_D from the drag on the ball.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="speed">The airspeed, in m/s; above 0, at most 1000.</param>
    /// <param name="spin">The spin perpendicular to the velocity, in rad/s; 0 … 10 000; default 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    public static double Drag(Simulator simulator, double speed, double spin = 0)
    {
        Find(simulator, speed, spin, out double drag, out _);

        // a = −D u with D = ½ ρ A C_D |u|/m
        return drag * PerFactor(simulator) / speed;
    }

    /// <summary>Calculates the lift coefficient C_L from the lift on the ball.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="speed">The airspeed, in m/s; above 0, at most 1000.</param>
    /// <param name="spin">The spin perpendicular to the velocity, in rad/s; 0 … 10 000.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    public static double Lift(Simulator simulator, double speed, double spin)
    {
        Find(simulator, speed, spin, out _, out double lift);

        // a = L (ω̂ × u) with L = ½ ρ A C_L |u|/m
        return lift * PerFactor(simulator) / speed;
    }

    private static void Find(Simulator simulator, double speed, double spin, out double drag, out double lift)
    {
        Check.Given(nameof(simulator), simulator);
        Check.Within(nameof(speed), speed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within(nameof(spin), spin, 0, Limits.Spin);
        simulator.AirFactors(speed, spin, out drag, out lift);
    }

    /// <summary>Returns 2 m/(ρ A); 0 if there is no air.</summary>
    private static double PerFactor(Simulator simulator)
    {
        double area = Math.PI * simulator.Scene.Ball.Radius * simulator.Scene.Ball.Radius;
        double air = simulator.Scene.Air.Density * area;
        return air > 0 ? 2.0 * simulator.Scene.Ball.Mass / air : 0;
    }
}
