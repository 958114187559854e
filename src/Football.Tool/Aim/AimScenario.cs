using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Aim;

/// <summary>A request for a kick: the scene, the goal of the kick, the method, and the steps.</summary>
internal sealed record AimScenario
{
    public required Scene Scene { get; init; }

    public required SolverSettings Settings { get; init; }

    public required double TimeStep { get; init; }

    public required AimMethod Method { get; init; }

    public required AimRequest Request { get; init; }

    /// <summary>True to find the slowest kick that reaches the target; the given speed is then the maximum.</summary>
    public bool Slowest { get; init; }

    /// <summary>The time of arrival, in s; null for any.</summary>
    public double? ArrivalTime { get; init; }

    /// <summary>The speed at arrival, in m/s; null for any.</summary>
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

    /// <summary>Reads the members of a scenario from an input that may have others. Call <see cref="InputFields.Check"/> afterwards.</summary>
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

            // The direct method uses its own step.
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
