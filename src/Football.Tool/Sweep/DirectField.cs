using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A number of a launch or an aim. It can differ between rows of one scene.</summary>
/// <param name="Path">The path of the field.</param>
/// <param name="Column">The name of the column.</param>
/// <param name="Unit">The unit.</param>
/// <param name="Allowed">The allowed values.</param>
/// <param name="Range">The default range; null for none.</param>
internal sealed record DirectField(string Path, string Column, string Unit, NumberRange Allowed, (double Low, double High)? Range = null)
{
    /// <summary>The index in <see cref="OfLaunch"/> of the numbers of a kick: speed, elevation, azimuth, topspin, sidespin.</summary>
    public const int Kick = 0;

    /// <summary>The number of numbers of a kick.</summary>
    public const int KickNumbers = 5;

    /// <summary>The index of the position of a launch.</summary>
    public const int Position = 5;

    /// <summary>The index of the velocity of a launch.</summary>
    public const int Velocity = 8;

    /// <summary>The index of the spin of a launch.</summary>
    public const int Spin = 11;

    /// <summary>The index in <see cref="OfAim"/> of the position of the kick.</summary>
    public const int From = 3;

    /// <summary>The index of the target.</summary>
    public const int Target = 6;

    private static readonly NumberRange s_place = new(-Limits.Length, Limits.Length, "m");
    private static readonly NumberRange s_speed = new(-Limits.Speed, Limits.Speed, "m/s");
    private static readonly NumberRange s_spin = new(-Limits.Spin, Limits.Spin, "rad/s");

    /// <summary>The numbers of a launch.</summary>
    public static IReadOnlyList<DirectField> OfLaunch { get; } =
    [
        new("launch.speed", "speed", "m/s", FootballPhysics.Scenarios.KickNumbers.Speeds, (15, 35)),
        new("launch.elevation", "elevation", "degrees", FootballPhysics.Scenarios.KickNumbers.Elevations, (5, 35)),
        new("launch.azimuth", "azimuth", "degrees", FootballPhysics.Scenarios.KickNumbers.Azimuths),
        new("launch.topSpin", "topSpin", "rad/s", FootballPhysics.Scenarios.KickNumbers.Spins, (-40, 40)),
        new("launch.sideSpin", "sideSpin", "rad/s", FootballPhysics.Scenarios.KickNumbers.Spins, (-40, 40)),
        .. Components("launch.position", "m", s_place),
        .. Components("launch.velocity", "m/s", s_speed),
        .. Components("launch.spin", "rad/s", s_spin),
    ];

    /// <summary>The numbers of an aim.</summary>
    public static IReadOnlyList<DirectField> OfAim { get; } =
    [
        new("aim.speed", "aim.speed", "m/s", new NumberRange(0, Limits.Speed, "m/s")),
        new("aim.spin.top", "aim.spin.top", "rad/s", s_spin),
        new("aim.spin.side", "aim.spin.side", "rad/s", s_spin),
        .. Components("aim.from", "m", s_place),
        .. Components("aim.target", "m", s_place),
    ];

    /// <summary>Returns three consecutive numbers as a vector.</summary>
    public static Vector3d Vector(ReadOnlySpan<double> numbers, int first) => new(numbers[first], numbers[first + 1], numbers[first + 2]);

    private static IEnumerable<DirectField> Components(string path, string unit, NumberRange allowed) =>
        Enumerable.Range(0, 3).Select(i => new DirectField(FormattableString.Invariant($"{path}.{i}"), FormattableString.Invariant($"{path}.{i}"), unit, allowed));
}
