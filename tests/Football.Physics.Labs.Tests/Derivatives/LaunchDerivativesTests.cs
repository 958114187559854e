using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Labs.Derivatives;
using FootballPhysics.Scenarios;
using FootballPhysics.Tests.Reference;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Derivatives;

/// <summary>How the end of a shot changes with its launch.</summary>
public sealed class LaunchDerivativesTests
{
    /// <summary>The reference's own spread is 1e-9.</summary>
    [Fact]
    public void Blocks_are_those_of_an_independent_solver()
    {
        int cases = 0;
        foreach (JsonElement line in ReferenceCase.Lines("derivatives.ndjson"))
        {
            LaunchDerivatives found = ScenarioRun.Play(Scenario.Read(new InputFields(line.GetProperty("scenario")))).Derivatives!;
            JsonElement expected = line.GetProperty("expected").GetProperty("derivatives");
            string name = line.GetProperty("name").GetString()!;
            JsonElement position = expected.GetProperty("position");
            JsonElement time = expected.GetProperty("time");
            Compare(name, Matrix(position.GetProperty("velocity")), [found.PositionByVelocity.X, found.PositionByVelocity.Y, found.PositionByVelocity.Z]);
            Compare(name, Matrix(position.GetProperty("spin")), [found.PositionBySpin.X, found.PositionBySpin.Y, found.PositionBySpin.Z]);
            Compare(name, [ReferenceCase.Vector(time.GetProperty("velocity"))], [found.TimeByVelocity]);
            Compare(name, [ReferenceCase.Vector(time.GetProperty("spin"))], [found.TimeBySpin]);
            cases++;
        }

        Assert.Equal(24, cases);
    }

    [Theory]
    [InlineData((int)DerivativesKind.Published)]
    [InlineData((int)DerivativesKind.Measured)]
    [InlineData((int)DerivativesKind.Goal)]
    [InlineData((int)DerivativesKind.Slope)]
    [InlineData((int)DerivativesKind.Hills)]
    public void Random_flights_agree_with_central_differences(int kind)
    {
        var check = new DerivativesCheck((DerivativesKind)kind);
        for (int i = 0; i < 12; i++)
        {
            check.Run(new SeededRandom(SeededRandom.Mix(3, i)));
        }

        // football lab derivatives tells of thousands. In a net a step may be taken in one piece more or less, which is not smooth.
        Assert.InRange(check.Errors.Count, 8, 12);
        Assert.InRange(check.Errors.Order().ElementAt(check.Errors.Count / 2), 0, 0.5 * DerivativesCheck.Reach);
        Assert.InRange(check.Errors.Count(error => error <= DerivativesCheck.Reach), check.Errors.Count - 1, check.Errors.Count);
        Assert.InRange(check.Errors.Max(), 0, 10 * DerivativesCheck.Reach);
    }

    /// <summary>A net is met at 24 m/s and left, becomes slack and tight again, and shortens the steps' pieces; then a bounce, a slide, a roll.</summary>
    [Theory]
    [InlineData(7, 13)]
    [InlineData(7, 22)]
    [InlineData(21, 16)]
    public void Through_a_net_they_are_those_of_the_steps_as_they_are_taken(int seed, int flight)
    {
        var check = new DerivativesCheck(DerivativesKind.Goal);
        check.Run(new SeededRandom(SeededRandom.Mix(seed, ((int)DerivativesKind.Goal * 1_000_003) + flight)));
        Assert.InRange(Assert.Single(check.Errors), 0, DerivativesCheck.Reach);
        Assert.NotEqual(0, check.Counts["Net"]);
    }

    /// <summary>
    /// The ball comes to spin about its way, where drag by spin has a kink: in flight, along the ground; the speed just reaches the drag law's jump.
    /// </summary>
    [Theory]
    [InlineData(DerivativesKind.Measured, 31, 37)]
    [InlineData(DerivativesKind.Measured, 11, 37)]
    [InlineData(DerivativesKind.Slope, 11, 20)]
    public void Near_a_kink_of_the_air_they_are_those_of_one_side(object kind, int seed, int flight)
    {
        var check = new DerivativesCheck((DerivativesKind)kind);
        check.Run(new SeededRandom(SeededRandom.Mix(seed, ((int)(DerivativesKind)kind * 1_000_003) + flight)));
        Assert.InRange(Assert.Single(check.Errors), 0, DerivativesCheck.Reach);
    }

    /// <summary>A net pushes on while the slip ends; a ball stands and spins under drilling friction; one that rolls in the wind until the flow all but stops; a lift that ends with a kink.</summary>
    [Theory]
    [InlineData(DerivativesKind.Goal, 7, 1)]
    [InlineData(DerivativesKind.Measured, 11, 0)]
    [InlineData(DerivativesKind.Published, 7, 24)]
    [InlineData(DerivativesKind.Published, 7, 6)]
    [InlineData(DerivativesKind.Slope, 3, 11)]
    [InlineData(DerivativesKind.Slope, 21, 85)]
    public void Slides_rolls_and_what_follows_are_those_of_the_steps(object kind, int seed, int flight)
    {
        var check = new DerivativesCheck((DerivativesKind)kind);
        check.Run(new SeededRandom(SeededRandom.Mix(seed, ((int)(DerivativesKind)kind * 1_000_003) + flight)));
        Assert.InRange(Assert.Single(check.Errors), 0, DerivativesCheck.Reach);
        Assert.NotEqual(0, check.Counts["Roll"]);
    }

    /// <summary>An integrator whose steps are far from the flow that they follow: the differences are those of its own steps.</summary>
    [Fact]
    public void A_roll_by_a_crude_method_is_differentiated_as_it_is_taken()
    {
        var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = Integrator.Euler });
        var derivatives = new LaunchDerivatives(simulator);
        Vector3d End(double faster)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(6 + faster, 0, 0), new Vector3d(0, 5, 0));
            simulator.Run(ref ball, 0.05, 2, StopAt.Time, new StepLog());
            return ball.Position;
        }

        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(6, 0, 0), new Vector3d(0, 5, 0));
        derivatives.Run(ref state, 0.05, 2, StopAt.Time);
        Vector3d wanted = (End(1e-4) - End(-1e-4)) / 2e-4;
        Assert.Equal(wanted.X, derivatives.PositionByVelocity.X.X, 7);
        Assert.Equal(wanted.Z, derivatives.PositionByVelocity.Z.X, 7);
    }

    /// <summary>The force of the seams depends on the orientation, which a changed spin changes: through flight, a bounce, and what comes after it.</summary>
    [Theory]
    [InlineData(0, 0.8, StopAt.Time)]
    [InlineData(4, 0.8, StopAt.Time)]
    [InlineData(60, 0.8, StopAt.Time)]
    [InlineData(6, 3, StopAt.Impact)]
    [InlineData(6, 2.1, StopAt.Time)]
    public void With_seams_the_end_changes_with_the_launch_as_flights_do(double spin, double duration, StopAt stopAt)
    {
        var simulator = new Simulator(Scene.Default with { Forces = ForceSet.Measured with { KnuckleSeed = 5 } }, new SolverSettings { Integrator = Integrator.Rk4 });
        var velocity = new Vector3d(26, 8, 2);
        var turning = new Vector3d(0.3 * spin, 0.9 * spin, -0.3 * spin);
        var orientation = new Quaterniond(0.1, -0.4, 0.3, 0.8);
        Vector3d End(in Vector3d v, in Vector3d w)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), velocity + v, turning + w, orientation);
            simulator.Run(ref ball, 0.01, duration, stopAt, new StepLog());
            return ball.Position;
        }

        BallState state = simulator.Launch(new Vector3d(0, 0.5, 0), velocity, turning, orientation);
        var derivatives = new LaunchDerivatives(simulator);
        Assert.Equal(stopAt == StopAt.Impact, derivatives.Run(ref state, 0.01, duration, stopAt));
        foreach (Vector3d axis in (Vector3d[])[new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)])
        {
            Vector3d byVelocity = (End(1e-4 * axis, Vector3d.Zero) - End(-1e-4 * axis, Vector3d.Zero)) / 2e-4;
            Vector3d bySpin = (End(Vector3d.Zero, 1e-3 * axis) - End(Vector3d.Zero, -1e-3 * axis)) / 2e-3;
            Assert.InRange((byVelocity - (derivatives.PositionByVelocity * axis)).Length, 0, 1e-5 * derivatives.PositionByVelocity.X.Length);
            Assert.InRange((bySpin - (derivatives.PositionBySpin * axis)).Length, 0, 1e-4);
        }
    }

    /// <summary>Without spin the published lift is not smooth: how the end changes with velocity and place must not be mixed with how it changes with spin.</summary>
    [Fact]
    public void Without_spin_the_end_changes_with_the_velocity_as_flights_without_spin_do()
    {
        var simulator = new Simulator(Scene.Published);
        var derivatives = new LaunchDerivatives(simulator);
        Vector3d End(double faster)
        {
            BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(9, 5 + faster, 1), Vector3d.Zero);
            simulator.Run(ref ball, 0.01, 1.8, StopAt.Time, new StepLog());
            return ball.Position;
        }

        BallState state = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(9, 5, 1), Vector3d.Zero);
        derivatives.Run(ref state, 0.01, 1.8, StopAt.Time);
        Vector3d wanted = (End(1e-4) - End(-1e-4)) / 2e-4;
        Assert.Equal(wanted.X, derivatives.PositionByVelocity.X.Y, 5);
        Assert.Equal(wanted.Y, derivatives.PositionByVelocity.Y.Y, 5);
    }

    /// <summary>The impact is not the last event of a ball that stays down: the velocity is still that before it.</summary>
    [Theory]
    [InlineData(0.113)]
    [InlineData(0.5)]
    public void At_an_impact_the_velocity_is_that_before_it(double height)
    {
        var simulator = new Simulator(Scene.Published);
        var derivatives = new LaunchDerivatives(simulator);
        BallEvent Impact(double faster)
        {
            var log = new StepLog();
            BallState ball = simulator.Launch(new Vector3d(0, height, 0), new Vector3d(9 + faster, 0, 1), new Vector3d(0, 5, 20));
            simulator.Run(ref ball, 0.01, 5, StopAt.Impact, log);
            return log.Events[0];
        }

        BallState state = simulator.Launch(new Vector3d(0, height, 0), new Vector3d(9, 0, 1), new Vector3d(0, 5, 20));
        Assert.True(derivatives.Run(ref state, 0.01, 5, StopAt.Impact));
        Vector3d wanted = (Impact(1e-3).VelocityBefore - Impact(-1e-3).VelocityBefore) / 2e-3;
        Assert.Equal(wanted.X, derivatives.VelocityByVelocity.X.X, 5);
        Assert.Equal(wanted.Y, derivatives.VelocityByVelocity.Y.X, 5);
        Assert.Equal(wanted.Z, derivatives.VelocityByVelocity.Z.X, 5);
    }

    [Fact]
    public void A_flight_in_vacuum_has_those_of_the_parabola()
    {
        // x = v_x t, y = v_y t − g t²/2 at y = 0: t = 2 v_y/g
        var derivatives = new LaunchDerivatives(new Simulator(Scene.Vacuum));
        BallState state = derivatives.Simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(10, 5, 0), Vector3d.Zero);
        Assert.True(derivatives.Run(ref state, 0.01, 5, StopAt.Impact));
        Assert.Equal(1e0, derivatives.PositionByVelocity.X.X / (2 * 5 / 9.81), 9);
        Assert.Equal(2 * 10 / 9.81, derivatives.PositionByVelocity.X.Y, 9);
        Assert.Equal(0, derivatives.PositionByVelocity.Y.Y, 9);
        Assert.Equal(2 / 9.81, derivatives.TimeByVelocity.Y, 9);
        Assert.Equal(1, derivatives.PositionByPosition.X.X, 9);
    }

    [Fact]
    public void The_run_is_the_simulators_own()
    {
        var simulator = new Simulator(Scene.Measured);
        var derivatives = new LaunchDerivatives(simulator);
        BallState watched = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(12, 6, 3), new Vector3d(5, 30, -10));
        BallState plain = watched;
        derivatives.Run(ref watched, 0.01, 20, StopAt.Rest);
        simulator.Run(ref plain, 0.01, 20, StopAt.Rest, new StepLog());
        Assert.Equal(plain, watched);
    }

    [Fact]
    public void A_run_allocates_nothing_once_there_is_room()
    {
        var derivatives = new LaunchDerivatives(new Simulator(Scene.Measured));
        BallState launched = derivatives.Simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(12, 6, 3), new Vector3d(5, 30, -10));
        long allocated = long.MaxValue;
        for (int i = 0; i < 4; i++)
        {
            BallState state = launched;
            long before = GC.GetAllocatedBytesForCurrentThread();
            derivatives.Run(ref state, 0.01, 20, StopAt.Rest);
            allocated = Math.Min(allocated, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, allocated);
    }

    [Fact]
    public void A_scenario_that_asks_for_them_gets_them()
    {
        JsonElement answer = FootballCommand.Play($$"""{{{FootballCommand.Launch}}, "derivatives": true}""").GetProperty("derivatives");
        Assert.Equal(3, answer.GetProperty("position").GetProperty("velocity").GetArrayLength());
        Assert.Equal(3, answer.GetProperty("time").GetProperty("spin").GetArrayLength());
        Assert.False(FootballCommand.Play($$"""{{{FootballCommand.Launch}}}""").TryGetProperty("derivatives", out _));
    }

    private static Vector3d[] Matrix(JsonElement rows) => [.. rows.EnumerateArray().Select(ReferenceCase.Vector)];

    private static void Compare(string name, Vector3d[] wanted, Vector3d[] found)
    {
        double Largest(Vector3d v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));
        double scale = Math.Max(1e-4, wanted.Max(Largest));
        double error = wanted.Zip(found, (a, b) => Largest(a - b)).Max() / scale;
        Assert.True(error <= 1e-5, $"{name}: {error:e1}");
    }
}
