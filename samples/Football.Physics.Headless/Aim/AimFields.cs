using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Aim;

/// <summary>The fields that say what a kick is to do.</summary>
internal static class AimFields
{
    public static readonly ChoiceField<AimMethod> Method = new(
        "aim.method",
        AimMethod.Direct,
        ("direct", AimMethod.Direct),
        ("angle", AimMethod.Angle),
        ("bisection", AimMethod.Bisection),
        ("twoPoint", AimMethod.TwoPoint));

    private static readonly AimRequest Default = new();
    private static readonly NumberRange Spin = NumberRange.Within(-Limits.Spin, Limits.Spin);
    private static readonly NumberRange SpinLimit = NumberRange.Within(0, Limits.Spin);
    private static readonly NumberRange Elevation = NumberRange.Within(-90, 90);

    private static readonly VectorField From = new("aim.from", VectorBound.Position, required: true);
    private static readonly VectorField Target = new("aim.target", VectorBound.Position, required: true);
    private static readonly OptionalPointField Through = new("aim.through");
    private static readonly NumberField Speed = new("aim.speed", Default.Speed, NumberRange.AboveZeroTo(Limits.Speed), "m/s", required: true);
    private static readonly NumberField TopSpin = new("aim.spin.top", Default.TopSpin, Spin, "rad/s");
    private static readonly NumberField SideSpin = new("aim.spin.side", Default.SideSpin, Spin, "rad/s");
    private static readonly NumberField MinimumElevation = new("aim.elevation.min", Default.MinimumElevation, Elevation, "degrees");
    private static readonly NumberField MaximumElevation = new("aim.elevation.max", Default.MaximumElevation, Elevation, "degrees");
    private static readonly NumberField MaximumTopSpin = new("aim.maxSpin.top", Default.MaximumTopSpin, SpinLimit, "rad/s");
    private static readonly NumberField MaximumSideSpin = new("aim.maxSpin.side", Default.MaximumSideSpin, SpinLimit, "rad/s");
    private static readonly NumberField Tolerance = new("aim.tolerance", Default.Tolerance, NumberRange.Positive, "m");
    private static readonly NumberField ThroughTolerance = new("aim.throughTolerance", Default.ThroughTolerance, NumberRange.Positive, "m");
    private static readonly CountField MaximumIterations = new("aim.maxIterations", Default.MaximumIterations);

    /// <summary>All of them.</summary>
    public static IReadOnlyList<Field> All { get; } =
    [
        Method, From, Target, Through, Speed, TopSpin, SideSpin, MinimumElevation, MaximumElevation,
        MaximumTopSpin, MaximumSideSpin, Tolerance, ThroughTolerance, MaximumIterations,
    ];

    /// <summary>The request that the values describe.</summary>
    /// <exception cref="RefusedException">Values that are allowed each contradict one another.</exception>
    public static AimRequest Build(FieldValues values)
    {
        var request = new AimRequest
        {
            From = values.Get(From),
            Target = values.Get(Target),
            Through = values.Get(Through),
            Speed = values.Get(Speed),
            TopSpin = values.Get(TopSpin),
            SideSpin = values.Get(SideSpin),
            MinimumElevation = values.Get(MinimumElevation),
            MaximumElevation = values.Get(MaximumElevation),
            MaximumTopSpin = values.Get(MaximumTopSpin),
            MaximumSideSpin = values.Get(MaximumSideSpin),
            Tolerance = values.Get(Tolerance),
            ThroughTolerance = values.Get(ThroughTolerance),
            MaximumIterations = values.Get(MaximumIterations),
        };
        if (request.MaximumElevation < request.MinimumElevation)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"{MaximumElevation.Path} is {request.MaximumElevation}; allowed: a number from {MinimumElevation.Path} ({request.MinimumElevation}) to 90 degrees."));
        }

        if (!VectorBound.Spin.Contains(new Vector3d(request.TopSpin, request.SideSpin, 0)))
        {
            throw new RefusedException(FormattableString.Invariant(
                $"aim.spin is {{top: {request.TopSpin}, side: {request.SideSpin}}}; allowed: size at most {Limits.Spin} rad/s."));
        }

        if (values.Get(Method) == AimMethod.TwoPoint && request.Through is null)
        {
            throw new RefusedException(Through.Path, values.Has(Through) ? "null" : "missing", "a point [x, y, z], as aim.method is twoPoint");
        }

        return request;
    }
}
