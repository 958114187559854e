namespace FootballPhysics.Labs;

/// <summary>A request, the kick that a method found for it, and its measured miss.</summary>
/// <param name="Request">The request.</param>
/// <param name="Result">The result; its misses are measured.</param>
/// <param name="Miss">The miss that the experiment counts, m: in the reference simulation, or in the game's own integrator.</param>
/// <param name="Microseconds">The time of the search, µs.</param>
internal sealed record AimShot(AimRequest Request, AimResult Result, double Miss, double Microseconds)
{
    /// <summary>Horizontal distance of the target, m.</summary>
    public double Distance => (Request.Target - Request.From).Horizontal.Length;

    /// <summary>Elevation of the kick, degrees.</summary>
    public double Elevation => Math.Atan2(Result.Velocity.Y, Result.Velocity.Horizontal.Length) * 180 / Math.PI;

    /// <summary>Sidespin of the kick, rad/s.</summary>
    public double SideSpin => Result.Spin.Y;

    /// <summary>Topspin of the kick, rad/s.</summary>
    public double TopSpin
    {
        get
        {
            Vector3d d = Result.Velocity.Horizontal;
            double length = d.Length;
            return length > 0 ? ((Result.Spin.X * d.Z) - (Result.Spin.Z * d.X)) / length : 0;
        }
    }
}
