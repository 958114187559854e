namespace Football.Physics;

/// <summary>Which passes to try: kicks through the air of all speeds, elevations and directions of a fan.</summary>
public sealed record PassFanRequest
{
    /// <summary>Most kicks of a fan.</summary>
    private const int Most = 100_000;

    /// <summary>Where the ball is, m; components within ±1e6.</summary>
    public required Vector3d From { get; init; }

    /// <summary>The middle direction; its horizontal part counts and must not be zero.</summary>
    public required Vector3d Direction { get; init; }

    /// <summary>Angle of the whole fan, degrees. 0 … 360; default 90.</summary>
    public double FanDegrees { get; init; } = 90;

    /// <summary>How many directions, from one edge to the other. At least 1; default 10.</summary>
    public int Directions { get; init; } = 10;

    /// <summary>Lowest elevation, degrees. Above 0, at most 90; default 8.</summary>
    public double MinimumElevationDegrees { get; init; } = 8;

    /// <summary>Highest elevation, degrees. At least the lowest, at most 90; default 50.</summary>
    public double MaximumElevationDegrees { get; init; } = 50;

    /// <summary>How many elevations. At least 1; default 10.</summary>
    public int Elevations { get; init; } = 10;

    /// <summary>Slowest kick, m/s. Above 0; default 8.</summary>
    public double MinimumSpeed { get; init; } = 8;

    /// <summary>Fastest kick, m/s. At least the slowest, at most 1000; default 28.</summary>
    public double MaximumSpeed { get; init; } = 28;

    /// <summary>How many speeds. At least 1; default 10.</summary>
    public int Speeds { get; init; } = 10;

    /// <summary>Topspin of all kicks, rad/s. Within ±10 000; default 0.</summary>
    public double TopSpin { get; init; }

    /// <summary>Sidespin of all kicks, rad/s. Within ±10 000; default 0.</summary>
    public double SideSpin { get; init; }

    /// <summary>How much earlier than any opponent a team mate must be able to meet the ball, s. Not negative; default 0.1.</summary>
    public double Margin { get; init; } = 0.1;

    /// <summary>Without team mates: where the ball is to come down, m. Default the place where it is.</summary>
    public Vector3d? Target { get; init; }

    /// <summary>How many kicks.</summary>
    internal int Count => Directions * Elevations * Speeds;

    /// <summary>One of the kicks.</summary>
    internal void Kick(int index, out Vector3d velocity, out Vector3d spin)
    {
        const double PerDegree = Math.PI / 180.0;
        double azimuth = PerDegree * FanDegrees * (Share(index % Directions, Directions) - 0.5);
        int rest = index / Directions;
        double elevation = PerDegree * (MinimumElevationDegrees + ((MaximumElevationDegrees - MinimumElevationDegrees) * Share(rest % Elevations, Elevations)));
        double speed = MinimumSpeed + ((MaximumSpeed - MinimumSpeed) * Share(rest / Elevations, Speeds));
        Vector3d middle = Direction.Horizontal / Direction.Horizontal.Length;
        Elementary.SinCos(azimuth, out double sine, out double cosine);
        Elementary.SinCos(elevation, out double up, out double flat);
        Vector3d d = (cosine * middle) + (sine * Vector3d.Cross(Vector3d.Up, in middle));
        velocity = speed * ((flat * d) + new Vector3d(0, up, 0));

        // ω = top ŷ × d + side ŷ
        spin = new Vector3d(TopSpin * d.Z, SideSpin, -(TopSpin * d.X));
    }

    /// <summary>Checks every number.</summary>
    internal void Validate()
    {
        Check.Place("fan.from", From);
        Check.Direction("fan.direction", Direction.Horizontal);
        Check.Within("fan.degrees", FanDegrees, 0, 360);
        Check.AtLeast("fan.directions", Directions, 1);
        Check.Within("fan.elevation.min", MinimumElevationDegrees, 0, 90, exclusiveLow: true);
        Check.Within("fan.elevation.max", MaximumElevationDegrees, MinimumElevationDegrees, 90);
        Check.AtLeast("fan.elevations", Elevations, 1);
        Check.Within("fan.speed.min", MinimumSpeed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within("fan.speed.max", MaximumSpeed, MinimumSpeed, Limits.Speed);
        Check.AtLeast("fan.speeds", Speeds, 1);
        Check.Within("fan.directions × elevations × speeds", (double)Directions * Elevations * Speeds, 1, Most);
        Check.Within("fan.spin.top", TopSpin, -Limits.Spin, Limits.Spin);
        Check.Within("fan.spin.side", SideSpin, -Limits.Spin, Limits.Spin);
        Check.NotNegative("fan.margin", Margin);
        Check.Place("fan.target", Target ?? From);
    }

    private static double Share(int index, int count) => count > 1 ? (double)index / (count - 1) : 0.5;
}
