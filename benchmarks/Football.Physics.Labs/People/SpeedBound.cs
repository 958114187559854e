namespace FootballPhysics.Labs.People;

/// <summary>
/// How fast things that move may make a ball: no faster than the fastest of them times 1 + e, or than the impact of the first alone made it, which adds (1 + e) u
/// at most. After a while without a touch it comes anew. What it falls is its own.
/// </summary>
internal sealed class SpeedBound(double gravity)
{
    /// <summary>Touches that are farther apart, s, have nothing to do with one another.</summary>
    private const double Apart = 0.1;

    private double _most;
    private double _highest;
    private double _touched = double.NegativeInfinity;

    /// <summary>The most that a step allows, m/s.</summary>
    /// <param name="before">The ball before it.</param>
    /// <param name="after">The ball after it.</param>
    /// <param name="touch">What moves and touched it in that step.</param>
    /// <param name="material">The material of it.</param>
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
            // What it makes of its spin on the ground is its own.
            _most = Math.Max(_most, after.Velocity.Length);
        }

        _highest = Math.Max(_highest, Math.Max(touch.Highest, Math.Max(before.Position.Y, after.Position.Y)));
        return double.IsInfinity(_touched)
            ? double.PositiveInfinity
            : Math.Sqrt((_most * _most) + (2 * gravity * (_highest - Math.Min(before.Position.Y, after.Position.Y))) + SpinEnergy(before.Spin));
    }

    /// <summary>2 E/m of the spin, m²/s²: a contact with friction may turn it into speed.</summary>
    private static double SpinEnergy(in Vector3d spin) => BallProperties.Modern.InertiaFactor * BallProperties.Modern.Radius * BallProperties.Modern.Radius * spin.LengthSquared;

    /// <summary>e(v) = e₆ √(1 + (6/V_e)²)/√(1 + (v/V_e)²), that of the slowest hits.</summary>
    private static double Restitution(SurfaceMaterial surface) => double.IsInfinity(surface.RestitutionSpeedScale)
        ? surface.NormalRestitution
        : Math.Min(1, surface.NormalRestitution * Math.Sqrt(1 + (36 / (surface.RestitutionSpeedScale * surface.RestitutionSpeedScale))));
}

/// <summary>What moves and touched a ball in a step.</summary>
/// <param name="Speed">Its speed, m/s; negative where nothing did.</param>
/// <param name="Came">How fast the ball came to it, m/s; negative where it was there before.</param>
/// <param name="From">When it did so first, s.</param>
/// <param name="To">When it did so last, s.</param>
/// <param name="Highest">How high the ball was at an event of the step, m.</param>
internal readonly record struct MoverTouch(double Speed, double Came, double From, double To, double Highest);
