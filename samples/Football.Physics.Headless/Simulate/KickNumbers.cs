using Football.Physics.Headless.Input;

namespace Football.Physics.Headless.Simulate;

/// <summary>A kick as a person says it.</summary>
/// <param name="Speed">m/s.</param>
/// <param name="Elevation">Degrees above the horizontal.</param>
/// <param name="Azimuth">Degrees from −z, counter-clockwise seen from above: to the left.</param>
/// <param name="TopSpin">rad/s; negative is backspin.</param>
/// <param name="SideSpin">rad/s; positive is counter-clockwise seen from above.</param>
internal readonly record struct KickNumbers(double Speed, double Elevation, double Azimuth, double TopSpin, double SideSpin)
{
    private const double Degree = Math.PI / 180.0;

    public static NumberRange Speeds { get; } = new(0, Limits.Speed, "m/s");

    public static NumberRange Elevations { get; } = new(-90, 90, "degrees");

    public static NumberRange Azimuths { get; } = new(-360, 360, "degrees");

    /// <summary>Topspin and sidespin together must not be above the library's limit.</summary>
    public static NumberRange Spins { get; } = new(-Limits.Spin / 2, Limits.Spin / 2, "rad/s");

    /// <summary>Velocity and spin.</summary>
    public void Vectors(out Vector3d velocity, out Vector3d spin)
    {
        var kick = new Kick { Elevation = Elevation * Degree, Azimuth = Azimuth * Degree, Top = TopSpin, Side = SideSpin };
        kick.Vectors(Speed, new Vector3d(0, 0, -1), out velocity, out spin);
    }
}
