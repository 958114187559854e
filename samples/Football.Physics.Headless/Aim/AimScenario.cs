using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Aim;

/// <summary>One request for a kick, checked: scene, what the kick is to do, by which method, in which steps.</summary>
internal sealed record AimScenario
{
    /// <summary>The shortest step of the thesis' methods, s: flights that reach nothing are followed for 30 s.</summary>
    private const double ShortestStep = 30e-6;

    /// <summary>All fields of a scenario with an aim in the place of a launch.</summary>
    public static FieldSet Fields { get; } = new(SceneFields.All, AimFields.All, SolverFields.All, StopFields.All);

    public required Scene Scene { get; init; }

    public required SolverSettings Settings { get; init; }

    public required double TimeStep { get; init; }

    public required AimMethod Method { get; init; }

    public required AimRequest Request { get; init; }

    /// <summary>Reads and checks a scenario.</summary>
    /// <exception cref="RefusedException">A field is not as it should be.</exception>
    public static AimScenario Read(JsonValue root)
    {
        FieldValues values = Fields.Read(root);
        AimMethod method = values.Get(AimFields.Method);
        double timeStep = values.Get(SolverFields.TimeStep);
        if (method == AimMethod.Direct)
        {
            // Its steps are its own.
            timeStep = SolverFields.TimeStep.Default;
        }
        else if (timeStep < ShortestStep)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"{SolverFields.TimeStep.Path} is {timeStep}; allowed: {ShortestStep} s or more, for any aim.method but direct."));
        }

        return new AimScenario
        {
            Scene = SceneFields.Build(values),
            Settings = SolverFields.Build(values),
            TimeStep = timeStep,
            Method = method,
            Request = AimFields.Build(values),
        };
    }
}
