namespace Football.Physics.Headless.Lab.People;

/// <summary>
/// How fast things that move may make a ball: no faster than the fastest of them times 1 + e, or than it came; and what the impact of one alone gives,
/// (1 + e) u + e v. Between two touches that lie a while apart it comes anew. What it falls is its own.
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
    /// <param name="touching">The fastest surface that moves and is close to the ball, m/s; negative for none.</param>
    /// <param name="restitution">The material of it.</param>
    public double Follow(in BallState before, in BallState after, double touching, Surface restitution)
    {
        if (touching >= 0)
        {
            double came = before.Velocity.Length;
            double closing = touching + came;
            double e = Restitution(restitution, closing);
            if (before.Time - _touched > Apart)
            {
                _most = Math.Max(came, ((1 + e) * touching) + (e * came));
                _highest = before.Position.Y;
            }

            _most = Math.Max(_most, (1 + Restitution(restitution, touching)) * touching);
            _touched = after.Time;
        }

        _highest = Math.Max(_highest, Math.Max(before.Position.Y, after.Position.Y));
        return double.IsInfinity(_touched)
            ? double.PositiveInfinity
            : Math.Sqrt((_most * _most) + (2 * gravity * (_highest - Math.Min(before.Position.Y, after.Position.Y))));
    }

    /// <summary>e(v) = e₆ √(1 + (6/V_e)²)/√(1 + (v/V_e)²), the greatest up to a speed: that of slow ones.</summary>
    private static double Restitution(Surface surface, double speed) => double.IsInfinity(surface.RestitutionSpeed) || speed < 0
        ? surface.NormalRestitution
        : Math.Min(1, surface.NormalRestitution * Math.Sqrt(1 + (36 / (surface.RestitutionSpeed * surface.RestitutionSpeed))));
}
