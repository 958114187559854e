namespace FootballPhysics.Labs.People;

/// <summary>
/// Bounds the speed that moving objects may give a ball: (1 + e) times the fastest object's speed, or the speed after the impact of the first object
/// alone, which adds (1 + e) u at most. After a time without a touch the bound starts from scratch. Speed gained by falling does not count.
/// </summary>
internal sealed class SpeedBound(double gravity)
{
    /// <summary>Touches that are farther apart than this, s, are independent.</summary>
    private const double Apart = 0.1;

    private double _most;
    private double _highest;
    private double _touched = double.NegativeInfinity;

    /// <summary>Returns the largest speed that a step allows, m/s.</summary>
    /// <param name="before">The ball before the step.</param>
    /// <param name="after">The ball after the step.</param>
    /// <param name="touch">The moving objects that touched the ball in the step.</param>
    /// <param name="material">Their material.</param>
    public double Follow(in BallState before, in BallState after, in MoverTouch touch, SurfaceMaterial material)
    {
        if (touch.Speed >= 0)
        {
            double e = Restitution(material);
            if (touch.Came >= 0 && touch.From - _touched > Apart)
            {
                _most = touch.Came + ((1 + e) * touch.Speed);
                _highest = before.Position.Y;
            }

            _most = Math.Max(_most, (1 + e) * touch.Speed);
            _touched = touch.To;
        }
        else
        {
            // Speed that the ball gains from its spin on the ground is allowed.
            _most = Math.Max(_most, after.Velocity.Length);
        }

        _highest = Math.Max(_highest, Math.Max(touch.Highest, Math.Max(before.Position.Y, after.Position.Y)));
        return double.IsInfinity(_touched)
            ? double.PositiveInfinity
            : Math.Sqrt((_most * _most) + (2 * gravity * (_highest - Math.Min(before.Position.Y, after.Position.Y))) + SpinEnergy(before.Spin));
    }

    /// <summary>Returns 2 E/m of the spin, m²/s²: a contact with friction may turn it into speed.</summary>
    private static double SpinEnergy(in Vector3d spin) => BallProperties.Modern.InertiaFactor * BallProperties.Modern.Radius * BallProperties.Modern.Radius * spin.LengthSquared;

    /// <summary>Returns e(v) = e₆ √(1 + (6/V_e)²)/√(1 + (v/V_e)²) of the slowest hits.</summary>
    private static double Restitution(SurfaceMaterial surface) => double.IsInfinity(surface.RestitutionSpeedScale)
        ? surface.NormalRestitution
        : Math.Min(1, surface.NormalRestitution * Math.Sqrt(1 + (36 / (surface.RestitutionSpeedScale * surface.RestitutionSpeedScale))));
}

/// <summary>The touches of moving objects with a ball in a step.</summary>
/// <param name="Speed">The speed of the fastest object, m/s; negative without a touch.</param>
/// <param name="Came">The speed of the ball before the first touch, m/s; negative if the object already touched the ball.</param>
/// <param name="From">The time of the first touch, s.</param>
/// <param name="To">The time of the last touch, s.</param>
/// <param name="Highest">The greatest height of the ball at an event of the step, m.</param>
internal readonly record struct MoverTouch(double Speed, double Came, double From, double To, double Highest);
