using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Reference;

/// <summary>The library against trajectories computed by two independent solvers.</summary>
public sealed class ReferenceTests
{
    private static readonly Lazy<IReadOnlyList<ReferenceRun>> s_fine = new(() => ReferenceRun.PlayAll(Integrator.Rk4, 0.01));
    private static readonly Lazy<IReadOnlyList<ReferenceRun>> s_coarse = new(() => ReferenceRun.PlayAll(Integrator.Rk4, 0.04));
    private static readonly Lazy<IReadOnlyList<ReferenceRun>> s_midpoint = new(() => ReferenceRun.PlayAll(Integrator.Rk2, 0.01));

    [Fact]
    public void All_cases_are_there() => Assert.Equal(110, ReferenceCase.All.Count);

    [Theory]
    [InlineData(Integrator.Rk4, 0.01)]
    [InlineData(Integrator.Rk4, 0.04)]
    [InlineData(Integrator.Rk2, 0.01)]
    public void Every_event_of_every_case_is_present_and_in_order(Integrator integrator, double timeStep)
    {
        string[] wrong = [.. Runs(integrator, timeStep).Where(run => !run.EventsMatch).Select(run =>
            $"{run}: expected {string.Join(' ', run.Case.Expected.Events.Select(item => item.Kind))}, got {string.Join(' ', run.Events.Select(item => item.Kind))}")];
        Assert.True(wrong.Length == 0, string.Join('\n', wrong));
    }

    [Fact]
    public void Final_positions_hold_with_rk4_at_10_ms() =>
        Positions(s_fine.Value).Hold(p95: 1e-7, worst: 1e-3);

    [Fact]
    public void Final_positions_hold_with_rk4_at_40_ms() =>
        Positions(s_coarse.Value).Hold(p95: 1e-4, worst: 1e-2);

    [Fact]
    public void Final_positions_hold_with_rk2_at_10_ms() =>
        Positions(s_midpoint.Value).Hold(mean: 5e-4);

    [Fact]
    public void Final_times_hold() =>
        Of("final time", run => Math.Abs(run.Time - run.Case.Expected.Time)).Hold(p95: 1e-7, worst: 1e-3);

    [Fact]
    public void Final_velocities_hold() =>
        Of("final velocity", run => Differences.Relative(run.Velocity, run.Case.Expected.Velocity)).Hold(p95: 1e-6, worst: 1e-3);

    [Fact]
    public void Final_spins_hold() =>
        Of("final spin", run => Differences.Relative(run.Spin, run.Case.Expected.Spin)).Hold(p95: 1e-6, worst: 1e-2);

    [Fact]
    public void Final_orientations_hold_up_to_sign() =>
        Of("final orientation", run => Differences.Rotation(run.Orientation, run.Case.Expected.Orientation)).Hold(p95: 1e-6, worst: 1e-2);

    [Fact]
    public void The_apex_holds() =>
        Of("apex", run => Math.Abs(run.Apex - run.Case.Expected.Apex)).Hold(p95: 1e-7, worst: 1e-4);

    [Fact]
    public void Every_impact_is_counted() =>
        Of("bounces", run => Math.Abs(run.Events.Count(item => item.Kind == BallEventKind.Impact) - run.Case.Expected.Bounces)).Hold(worst: 0);

    [Fact]
    public void Impact_times_hold() =>
        OfEvents("impact time", BallEventKind.Impact, (actual, expected) => Math.Abs(actual.Time - expected.Time)).Hold(p95: 1e-8, worst: 1e-3);

    [Theory]
    [InlineData(BallEventKind.Impact)]
    [InlineData(BallEventKind.Slide)]
    [InlineData(BallEventKind.Roll)]
    [InlineData(BallEventKind.Rest)]
    public void Events_happen_when_and_where_they_must(BallEventKind kind)
    {
        OfEvents("event time", kind, (actual, expected) => Math.Abs(actual.Time - expected.Time)).Hold(p95: 1e-7, worst: 1e-3);
        OfEvents("event position", kind, (actual, expected) => Vector3d.Distance(actual.Position, expected.Position)).Hold(p95: 1e-7, worst: 1e-3);
    }

    [Theory]
    [InlineData(BallEventKind.Impact)]
    [InlineData(BallEventKind.Slide)]
    [InlineData(BallEventKind.Roll)]
    [InlineData(BallEventKind.Rest)]
    public void Events_carry_the_velocity_and_spin_just_after(BallEventKind kind)
    {
        OfEvents("event velocity", kind, (actual, expected) => Differences.Relative(actual.Velocity, expected.Velocity)).Hold(p95: 1e-6, worst: 1e-3);
        OfEvents("event spin", kind, (actual, expected) => Differences.Relative(actual.Spin, expected.Spin)).Hold(p95: 1e-6, worst: 1e-2);
    }

    [Fact]
    public void Impacts_carry_the_velocity_and_spin_just_before()
    {
        var velocities = new Errors("velocity before");
        var spins = new Errors("spin before");
        foreach (ReferenceRun run in s_fine.Value)
        {
            if (run.Case.Expected is { VelocityBefore: { } velocity, SpinBefore: { } spin })
            {
                velocities.Add(run.Case.Name, Differences.Relative(run.Events[^1].VelocityBefore, velocity));
                spins.Add(run.Case.Name, Differences.Relative(run.Events[^1].SpinBefore, spin));
            }
        }

        velocities.Hold(p95: 1e-6, worst: 1e-3);
        spins.Hold(p95: 1e-6, worst: 1e-2);
    }

    private static IReadOnlyList<ReferenceRun> Runs(Integrator integrator, double timeStep) =>
        integrator == Integrator.Rk2 ? s_midpoint.Value : timeStep < 0.02 ? s_fine.Value : s_coarse.Value;

    private static Errors Positions(IReadOnlyList<ReferenceRun> runs) => Of("final position", runs, run => Vector3d.Distance(run.Position, run.Case.Expected.Position));

    private static Errors Of(string what, Func<ReferenceRun, double> error) => Of(what, s_fine.Value, error);

    private static Errors Of(string what, IReadOnlyList<ReferenceRun> runs, Func<ReferenceRun, double> error)
    {
        var errors = new Errors(what);
        foreach (ReferenceRun run in runs)
        {
            errors.Add(run.Case.Name, error(run));
        }

        return errors;
    }

    private static Errors OfEvents(string what, BallEventKind kind, Func<BallEvent, ReferenceEvent, double> error)
    {
        var errors = new Errors($"{what} of {kind}");
        foreach (ReferenceRun run in s_fine.Value.Where(run => run.EventsMatch))
        {
            foreach ((BallEvent actual, ReferenceEvent expected) in run.Events.Zip(run.Case.Expected.Events).Where(pair => pair.First.Kind == kind))
            {
                errors.Add(run.Case.Name, error(actual, expected));
            }
        }

        return errors;
    }
}
