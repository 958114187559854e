using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tests.Reference;

/// <summary>A ball that several surfaces press, against two independent methods: alone, in groups and by a look-ahead, with RK4 at 10 ms.</summary>
public sealed class PressedReferenceTests
{
    private const double TimeStep = 0.01;

    /// <summary>Where the second ball of a group starts above the first, m: it falls for longer than any case lasts before it is near.</summary>
    private const double Above = 900;

    private static readonly IReadOnlyDictionary<string, JsonElement> s_cases =
        ReferenceCase.Lines("pressed.ndjson").ToDictionary(line => line.GetProperty("name").GetString()!, StringComparer.Ordinal);

    public static TheoryData<string> Names => [.. s_cases.Keys];

    [Fact]
    public void All_cases_are_there() => Assert.Equal(40, s_cases.Count);

    [Theory]
    [MemberData(nameof(Names))]
    public void A_ball_alone_ends_where_the_reference_says(string name)
    {
        Scenario scenario = Read(name);
        var log = new StepLog();
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        BallState state = Launch(simulator, scenario);
        simulator.Run(ref state, TimeStep, scenario.Duration, scenario.StopAt, log);
        Hold(name, in state, log.Events);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void A_group_of_one_ends_where_the_reference_says(string name)
    {
        Scenario scenario = Read(name);
        var log = new StepLog();
        var group = new BallGroup(new Simulator(scenario.Scene, scenario.Settings), 1);
        BallState[] states = [Launch(group.SimulatorOf(0), scenario)];
        group.Run(states, TimeStep, scenario.Duration, scenario.StopAt, log);
        Hold(name, in states[0], log.Events);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void A_ball_of_a_group_ends_where_the_reference_says(string name)
    {
        Scenario scenario = Read(name);
        var log = new StepLog();

        // Of half the size, so that it touches none of the boards on its way down.
        BallProperties other = scenario.Scene.Ball with { Radius = 0.5 * scenario.Scene.Ball.Radius };
        var group = new BallGroup(scenario.Scene, [scenario.Scene.Ball, other], scenario.Settings);
        BallState[] states =
        [
            Launch(group.SimulatorOf(0), scenario),
            group.SimulatorOf(1).Launch(scenario.Position + (Above * Vector3d.Up), Vector3d.Zero, Vector3d.Zero),
        ];

        // The second never rests here, so the steps end when the first does.
        double end = scenario.Duration - (1e-9 * TimeStep);
        while (states[0].Time < end && !(scenario.StopAt == StopAt.Rest && states[0].Motion == MotionState.Rest))
        {
            group.Step(states, Math.Min(TimeStep, scenario.Duration - states[0].Time), log);
        }

        Hold(name, in states[0], log.Events);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void A_look_ahead_ends_where_the_reference_says(string name)
    {
        Scenario scenario = Read(name);
        var path = new Trajectory(4096);
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        BallState state = Launch(simulator, scenario);
        simulator.LookAhead(in state, new LookAheadRequest { Duration = scenario.Duration, TimeStep = TimeStep, StopAt = scenario.StopAt }, path);
        Assert.True(path.IsComplete);
        Hold(name, path.Final, path.Events);
        JsonElement expected = s_cases[name].GetProperty("expected");
        Vector3d last = path.PositionAt(path.EndTime);
        Assert.InRange(Vector3d.Distance(last, ReferenceCase.Vector(expected.GetProperty("position"))), 0, Place(expected));
    }

    private static Scenario Read(string name)
    {
        var scenario = Scenario.Read(new InputFields(s_cases[name].GetProperty("scenario")));
        return scenario with { Settings = scenario.Settings with { Integrator = Integrator.Rk4 } };
    }

    private static BallState Launch(Simulator simulator, Scenario scenario) =>
        simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation ?? simulator.LaunchOrientation);

    private static double Place(JsonElement expected) => Math.Max(1e-6, 1e4 * ReferenceCase.Number(expected, "sensitivity"));

    private static void Hold(string name, in BallState state, EventBuffer events)
    {
        JsonElement expected = s_cases[name].GetProperty("expected");
        (double time, Vector3d velocity, Vector3d spin) = (state.Time, state.Velocity, state.Spin);
        if (expected.TryGetProperty("restTime", out JsonElement rest))
        {
            // The reference has the last motion before the ball was stopped, as the event has it.
            BallEvent end = events.Span.ToArray().LastOrDefault(item => item.Kind == BallEventKind.Rest && item.Ball == 0);
            (time, velocity, spin) = (end.Time, end.Velocity, end.Spin);
            Assert.True(Math.Abs(time - rest.GetDouble()) <= 1e-5, $"{name}: at rest at {time:R} s, expected {rest.GetDouble():R} s");
        }
        else
        {
            Assert.Equal(ReferenceCase.Number(expected, "time"), time, 1e-9);
        }

        if (expected.TryGetProperty("motion", out JsonElement motion))
        {
            Assert.Equal(Enum.GetValues<MotionState>().Single(value => motion.ValueEquals(Words.Of(value))), state.Motion);
        }

        Near(name, expected, "position", state.Position, Place(expected));
        Near(name, expected, "velocity", velocity, 1e-5);
        Near(name, expected, "spin", spin, 1e-4);
    }

    private static void Near(string name, JsonElement expected, string member, in Vector3d found, double tolerance)
    {
        double off = Vector3d.Distance(ReferenceCase.Vector(expected.GetProperty(member)), found);
        Assert.True(off <= tolerance, $"{name}: {member} is {off:e2} off, allowed {tolerance:e1}");
    }
}
