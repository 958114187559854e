using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Aim;

/// <summary>One request for a kick: scene, what the kick is to do, by which method, in which steps.</summary>
internal sealed record AimScenario
{
    public required Scene Scene { get; init; }

    public required SolverSettings Settings { get; init; }

    public required double TimeStep { get; init; }

    public required AimMethod Method { get; init; }

    public required AimRequest Request { get; init; }

    /// <summary>Whether the slowest kick is wanted that gets there; its speed is then the fastest allowed.</summary>
    public bool Slowest { get; init; }

    /// <summary>When to be there, s; null for whenever.</summary>
    public double? ArrivalTime { get; init; }

    /// <summary>How fast to be there, m/s; null for however.</summary>
    public double? ArrivalSpeed { get; init; }

    /// <summary>The colliders to hit before the target, in order; null if there are none.</summary>
    public string[]? After { get; init; }

    /// <summary>Reads a scenario. The library checks the numbers during the search.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static AimScenario Read(InputFields fields)
    {
        AimScenario scenario = Take(fields.Root);
        fields.Check();
        return scenario;
    }

    /// <summary>Takes a scenario's members from an input that may hold more; the fields are still to be checked.</summary>
    public static AimScenario Take(InputObject root)
    {
        Scene scene = SceneInput.Scene(root);
        InputObject aim = root.Object("aim");
        SolverSettings settings = SceneInput.Solver(root, out double timeStep);
        SceneInput.Stop(root);
        AimMethod method = aim.Choice("method", AimMethod.Direct);
        InputObject arrival = aim.Object("arrival");
        arrival.Exclude("time", "speed");
        aim.Exclude("slowest", "arrival");
        aim.Exclude("after", "arrival");
        aim.Exclude("after", "slowest");
        aim.Exclude("after", "kickTime");
        var scenario = new AimScenario
        {
            Scene = scene,
            Settings = settings,

            // The direct method's steps are its own.
            TimeStep = method == AimMethod.Direct ? Scenario.DefaultTimeStep : timeStep,
            Method = method,
            Request = AimInput.Request(aim),
            Slowest = aim.Flag("slowest", false),
            ArrivalTime = arrival.OptionalPositive("time"),
            ArrivalSpeed = arrival.OptionalPositive("speed"),
            After = aim.Texts("after"),
        };
        aim.Demand("method", method == AimMethod.Direct || !(scenario.Slowest || scenario.After is not null || aim.Has("arrival")), "direct, with slowest, arrival or after");
        return scenario;
    }
}
