using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>A kick given by speed, angles and spin.</summary>
/// <param name="Speed">The speed, in m/s.</param>
/// <param name="Elevation">The elevation above the horizontal, in degrees.</param>
/// <param name="Azimuth">The azimuth in degrees, counter-clockwise from −z seen from above: to the left.</param>
/// <param name="TopSpin">The topspin, in rad/s; negative for backspin.</param>
/// <param name="SideSpin">The sidespin, in rad/s; positive for counter-clockwise seen from above.</param>
public readonly record struct KickNumbers(double Speed, double Elevation, double Azimuth, double TopSpin, double SideSpin)
{
    private const double Degree = Math.PI / 180.0;

    public static NumberRange Speeds { get; } = new(0, Limits.Speed, "m/s");

    public static NumberRange Elevations { get; } = new(-90, 90, "degrees");

    public static NumberRange Azimuths { get; } = new(-360, 360, "degrees");

    /// <summary>The range of topspin and of sidespin. Together they do not exceed the library's limit.</summary>
    public static NumberRange Spins { get; } = new(-Limits.Spin / 2, Limits.Spin / 2, "rad/s");

    /// <summary>Describes the kick in words.</summary>
    public string Text => string.Join(", ", Parts());

    /// <summary>A line of C# that makes the kick.</summary>
    public string Code
    {
        get
        {
            (double sinUp, double cosUp) = Math.SinCos(Elevation * Degree);
            (double sinLeft, double cosLeft) = Math.SinCos(Azimuth * Degree);
            return FormattableString.Invariant(
                $"ball.Kick(speed: {Speed:0.###}, direction: new Vector3d({Direction(-cosUp * sinLeft)}, {Direction(sinUp)}, {Direction(-cosUp * cosLeft)}), topSpin: {TopSpin:0.###}, sideSpin: {SideSpin:0.###});");
        }
    }

    /// <summary>The command that plays the kick from the ground.</summary>
    public string Command => FormattableString.Invariant(
        $"football kick --speed {Speed:0.###} --elevation {Elevation:0.###} --azimuth {Azimuth:0.###} --top-spin {TopSpin:0.###} --side-spin {SideSpin:0.###}");

    /// <summary>Returns the kick of a launch, without the component of the spin along the direction of the kick.</summary>
    public static KickNumbers Of(Scenario scenario)
    {
        Vector3d flat = scenario.Velocity.Horizontal;
        double along = flat.Length;
        Vector3d forward = along > 0 ? flat / along : new Vector3d(0, 0, -1);
        return new KickNumbers(
            scenario.Velocity.Length,
            Math.Atan2(scenario.Velocity.Y, along) / Degree,
            (Math.Atan2(-forward.X, -forward.Z) / Degree) + 0.0,
            Vector3d.Dot(scenario.Spin, Vector3d.Cross(Vector3d.Up, forward)) + 0.0,
            scenario.Spin.Y);
    }

    /// <summary>Computes the velocity, in m/s, and the spin, in rad/s.</summary>
    public void Vectors(out Vector3d velocity, out Vector3d spin) =>
        KickVectors.FromAngles(Speed, Elevation, Azimuth, TopSpin, SideSpin, out velocity, out spin);

    private static double Direction(double part) => Math.Round(part, 4) + 0.0;

    private IEnumerable<string> Parts()
    {
        yield return Speed > 0 ? FormattableString.Invariant($"{Speed:0.##} m/s") : "let go";
        if (Math.Round(Elevation, 1) != 0)
        {
            yield return FormattableString.Invariant($"{Math.Abs(Elevation):0.#}° {(Elevation > 0 ? "up" : "down")}");
        }
        else if (Speed > 0)
        {
            yield return "level";
        }

        if (Math.Round(Azimuth, 1) != 0)
        {
            yield return FormattableString.Invariant($"{Math.Abs(Azimuth):0.#}° to the {(Azimuth > 0 ? "left" : "right")}");
        }

        if (Math.Round(TopSpin, 1) != 0)
        {
            yield return FormattableString.Invariant($"{(TopSpin > 0 ? "topspin" : "backspin")} {Math.Abs(TopSpin):0.#} rad/s");
        }

        if (Math.Round(SideSpin, 1) != 0)
        {
            yield return FormattableString.Invariant($"sidespin {Math.Abs(SideSpin):0.#} rad/s to the {(SideSpin > 0 ? "left" : "right")}");
        }
    }
}
