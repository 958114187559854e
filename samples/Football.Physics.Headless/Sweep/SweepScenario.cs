using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Sweep;

/// <summary>A sweep, checked: the scene, the ranges that launches are drawn from, and how to fly them.</summary>
internal sealed record SweepScenario
{
    private static readonly VectorField Position = new("launch.position", VectorBound.Position);
    private static readonly RangeField Speed = new("launch.speed", (15, 35), NumberRange.Within(0, Limits.Speed), "m/s");
    private static readonly RangeField Elevation = new("launch.elevation", (5, 35), NumberRange.Within(-90, 90), "degrees");
    private static readonly RangeField Azimuth = new("launch.azimuth", (0, 0), NumberRange.Within(-360, 360), "degrees");
    private static readonly RangeField TopSpin = new("launch.topSpin", (-40, 40), NumberRange.Within(-Limits.Spin / 2, Limits.Spin / 2), "rad/s");
    private static readonly RangeField SideSpin = new("launch.sideSpin", (-40, 40), NumberRange.Within(-Limits.Spin / 2, Limits.Spin / 2), "rad/s");

    private static readonly ChoiceField<Integrator> Method = new(
        "solver.integrator", BatchSettings.Default.Integrator, ("rk2", Integrator.Rk2), ("rk4", Integrator.Rk4));

    private static readonly NumberField TimeStep = new("solver.timeStep", BatchSettings.Default.TimeStep, NumberRange.Within(1e-5, 1), "s");

    private static readonly ChoiceField<BatchPrecision> Precision = new(
        "solver.precision", BatchPrecision.Single, ("single", BatchPrecision.Single), ("double", BatchPrecision.Double));

    private static readonly NumberField Time = new("stop.time", 20, NumberRange.AboveZeroTo(600), "s");

    /// <summary>All fields of a sweep.</summary>
    public static FieldSet Fields { get; } = new(
        SceneFields.All, [Position, Speed, Elevation, Azimuth, TopSpin, SideSpin], [Method, TimeStep, Precision], [Time]);

    public required Scene Scene { get; init; }

    public required BatchSettings Settings { get; init; }

    public required double Duration { get; init; }

    public Vector3d From { get; init; }

    public (double Low, double High) Speeds { get; init; }

    /// <summary>Degrees above the horizontal.</summary>
    public (double Low, double High) Elevations { get; init; }

    /// <summary>Degrees from −z, counter-clockwise seen from above.</summary>
    public (double Low, double High) Azimuths { get; init; }

    public (double Low, double High) TopSpins { get; init; }

    public (double Low, double High) SideSpins { get; init; }

    /// <summary>Reads and checks a sweep.</summary>
    /// <exception cref="RefusedException">A field is not as it should be.</exception>
    public static SweepScenario Read(JsonValue root)
    {
        FieldValues values = Fields.Read(root);
        return new SweepScenario
        {
            Scene = SceneFields.Build(values),
            Settings = new BatchSettings
            {
                Integrator = values.Get(Method),
                TimeStep = values.Get(TimeStep),
                Precision = values.Get(Precision),
                FindApex = true,
            },
            Duration = values.Get(Time),
            From = values.Get(Position),
            Speeds = values.Get(Speed),
            Elevations = values.Get(Elevation),
            Azimuths = values.Get(Azimuth),
            TopSpins = values.Get(TopSpin),
            SideSpins = values.Get(SideSpin),
        };
    }
}
