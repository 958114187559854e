using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The passes to try: kicks of all speeds, elevations and directions of a fan.</summary>
/// <remarks>
/// A ball kicked from the ground stays on the ground if its upward speed is below <see cref="Ground.MinimumBounceSpeed"/>, as at elevation 0. It then slides,
/// and later rolls.
/// </remarks>
public sealed record PassFanRequest
{
    /// <summary>The maximum number of kicks.</summary>
    private const int Most = 100_000;

    /// <summary>The maximum duration, in s.</summary>
    private const double Longest = 60;

    private const double PerDegree = Math.PI / 180.0;

    /// <summary>The position of the ball, in m; components within ±1e6.</summary>
    public required Vector3d From { get; init; }

    /// <summary>The central direction. Only its horizontal part is used, which must not be zero.</summary>
    public required Vector3d Direction { get; init; }

    /// <summary>The angle of the entire fan, in degrees. 0 … 360; default 90.</summary>
    public double FanDegrees { get; init; } = 90;

    /// <summary>The number of directions, from edge to edge. At least 1; default 10.</summary>
    public int Directions { get; init; } = 10;

    /// <summary>The lowest elevation, in degrees. 0 … 90; default 8; 0 for passes on the ground.</summary>
    public double MinimumElevationDegrees { get; init; } = 8;

    /// <summary>The highest elevation, in degrees. At least the lowest, at most 90; default 50.</summary>
    public double MaximumElevationDegrees { get; init; } = 50;

    /// <summary>The number of elevations. At least 1; default 10.</summary>
    public int Elevations { get; init; } = 10;

    /// <summary>The lowest speed, in m/s. Above 0; default 8.</summary>
    public double MinimumSpeed { get; init; } = 8;

    /// <summary>The highest speed, in m/s. At least the lowest, at most 1000; default 28.</summary>
    public double MaximumSpeed { get; init; } = 28;

    /// <summary>The number of speeds. At least 1; default 10.</summary>
    public int Speeds { get; init; } = 10;

    /// <summary>The topspin of all kicks, in rad/s. Within ±10 000; default 0.</summary>
    public double TopSpin { get; init; }

    /// <summary>The sidespin of all kicks, in rad/s. Within ±10 000; default 0.</summary>
    public double SideSpin { get; init; }

    /// <summary>The lead that a team mate needs over every opponent, in s. At least 0; default 0.1.</summary>
    public double Margin { get; init; } = 0.1;

    /// <summary>The target if there are no team mates, in m.</summary>
    /// <remarks>A pass in the air should land there; a pass on the ground should come to rest there. Default: the position of the ball.</remarks>
    public Vector3d? Target { get; init; }

    /// <summary>The time within which a player must reach the ball, in s. Above 0, at most 60; default 8.</summary>
    public double Duration { get; init; } = 8;

    /// <summary>The number of kicks.</summary>
    internal int Count => Directions * Elevations * Speeds;

    /// <summary>The magnitude of the spin, in rad/s.</summary>
    internal double SpinRate => Math.Sqrt((TopSpin * TopSpin) + (SideSpin * SideSpin));

    /// <summary>Computes one of the kicks.</summary>
    internal void Kick(int index, out Vector3d velocity, out Vector3d spin)
    {
        double azimuth = PerDegree * FanDegrees * (Share(index % Directions, Directions) - 0.5);
        double speed = Launch(index / Directions, out double up, out double flat);
        Vector3d middle = Direction.Horizontal / Direction.Horizontal.Length;
        Elementary.SinCos(azimuth, out double sine, out double cosine);
        Vector3d d = (cosine * middle) + (sine * Vector3d.Cross(Vector3d.Up, in middle));
        velocity = speed * ((flat * d) + new Vector3d(0, up, 0));

        // ω = top ŷ × d + side ŷ
        spin = new Vector3d(TopSpin * d.Z, SideSpin, -(TopSpin * d.X));
    }

    /// <summary>Computes the kick of a speed and elevation along x. Rotating it about the vertical gives all directions.</summary>
    internal void KickAlongX(int pair, out Vector3d velocity, out Vector3d spin)
    {
        double speed = Launch(pair, out double up, out double flat);
        velocity = speed * new Vector3d(flat, up, 0);
        spin = new Vector3d(0, SideSpin, -TopSpin);
    }

    /// <summary>Checks every number.</summary>
    internal void Validate()
    {
        Check.Place("fan.from", From);
        Check.Direction("fan.direction", Direction.Horizontal);
        Check.Within("fan.degrees", FanDegrees, 0, 360);
        Check.AtLeast("fan.directions", Directions, 1);
        Check.Within("fan.elevation.min", MinimumElevationDegrees, 0, 90);
        Check.Within("fan.elevation.max", MaximumElevationDegrees, MinimumElevationDegrees, 90);
        Check.AtLeast("fan.elevations", Elevations, 1);
        Check.Within("fan.speed.min", MinimumSpeed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within("fan.speed.max", MaximumSpeed, MinimumSpeed, Limits.Speed);
        Check.AtLeast("fan.speeds", Speeds, 1);
        Check.Within("fan.directions × elevations × speeds", (double)Directions * Elevations * Speeds, 1, Most);
        Check.Within("fan.spin.top", TopSpin, -Limits.Spin, Limits.Spin);
        Check.Within("fan.spin.side", SideSpin, -Limits.Spin, Limits.Spin);
        Check.Within("fan.spin", SpinRate, 0, Limits.Spin);
        Check.NotNegative("fan.margin", Margin);
        Check.Within("fan.duration", Duration, 0, Longest, exclusiveLow: true);
        Check.Place("fan.target", Target ?? From);
    }

    /// <summary>Returns the speed of a pair, in m/s, and the sine and cosine of its elevation.</summary>
    private double Launch(int pair, out double up, out double flat)
    {
        Elementary.SinCos(
            PerDegree * (MinimumElevationDegrees + ((MaximumElevationDegrees - MinimumElevationDegrees) * Share(pair % Elevations, Elevations))), out up, out flat);
        return MinimumSpeed + ((MaximumSpeed - MinimumSpeed) * Share(pair / Elevations, Speeds));
    }

    private static double Share(int index, int count) => count > 1 ? (double)index / (count - 1) : 0.5;
}
