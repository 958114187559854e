using FootballPhysics.Tests.Game;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>A game's own force may throw, or give what is no number: then nothing has happened.</summary>
public sealed class ThrowingForceTests
{
    private static readonly Vector3d s_velocity = new(6, 5, -9);
    private static readonly Vector3d s_spin = new(3, 40, -7);

    public static TheoryData<Integrator> Integrators() => [.. Enum.GetValues<Integrator>()];

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void Whenever_it_throws_the_ball_is_as_before_the_step(Profile profile, Integrator integrator)
    {
        var force = new Failing();
        var simulator = new Simulator(profile.Scene() with { Forces = profile.Forces() with { CustomForces = [force] } }, new SolverSettings { Integrator = integrator });
        var log = new StepLog(1);
        int failed = 0;
        for (int after = 0; after < 4000; after += 7)
        {
            BallState state = simulator.Launch(new Vector3d(0, 0.5, 0), s_velocity, s_spin);
            force.Begin(after);
            BallState before = state;
            (int Events, long Steps, long Evaluations, long Stalled) counts = default;
            log.Clear();
            try
            {
                for (int i = 0; i < 150; i++)
                {
                    before = state;
                    counts = (log.Events.Count, log.Steps, log.Evaluations, log.StalledSteps);
                    simulator.Step(ref state, 0.03, log);
                }
            }
            catch (FailedException)
            {
                failed++;
                Assert.True(Snapshot.Same(before, state));
                Assert.Equal(counts, (log.Events.Count, log.Steps, log.Evaluations, log.StalledSteps));
            }
        }

        Assert.True(failed > 20);
    }

    [Theory]
    [ProfileData]
    public void A_runner_goes_on_as_if_nothing_had_happened(Profile profile)
    {
        var force = new Failing();
        var simulator = new Simulator(profile.Scene() with { Forces = profile.Forces() with { CustomForces = [force] } });
        for (int after = 0; after < 3000; after += 61)
        {
            force.Begin(int.MaxValue);
            BallState[] expected = Inputs.Play(Runner(simulator), 210);
            FixedStepRunner runner = Runner(simulator);
            force.Begin(after);
            Recording segment = runner.Record();
            while (runner.Tick < 200)
            {
                long tick = runner.Tick;
                BallPose pose = runner.PoseAt(1);
                try
                {
                    runner.Advance(0.04);
                }
                catch (FailedException)
                {
                    tick = runner.Tick;
                    Assert.InRange(runner.Fraction, 0, 1);
                    Assert.InRange(runner.DroppedTime, 0, 0.04 + runner.TimeStep);
                    force.Begin(int.MaxValue);
                }

                Assert.True(Snapshot.Same(expected[runner.Tick], runner.State), $"tick {runner.Tick}, fails after {after}");
            }

            Assert.Equal(runner.Tick, segment.EndTick);
            force.Begin(int.MaxValue);
            Assert.Null(segment.FirstDivergence(simulator));
        }
    }

    [Theory]
    [ProfileData]
    public void A_kick_of_a_tick_that_fails_is_applied_once_it_does_not(Profile profile)
    {
        var force = new Failing();
        FixedStepRunner runner = Runner(new Simulator(profile.Scene() with { Forces = profile.Forces() with { CustomForces = [force] } }));
        force.Begin(0);
        BallState before = runner.State;
        Assert.Throws<FailedException>(runner.Step);
        Assert.True(Snapshot.Same(before, runner.State));
        Assert.Equal(0, runner.Tick);
        force.Begin(int.MaxValue);
        runner.Step();
        Assert.InRange(runner.State.Velocity.Length, 0.9 * s_velocity.Length, s_velocity.Length);
    }

    [Theory]
    [ProfileData(true)]
    [ProfileData(false)]
    public void A_look_ahead_that_fails_leaves_a_path_without_overlap(Profile profile, bool kept)
    {
        var force = new Failing();
        var simulator = new Simulator(profile.Scene() with { Forces = profile.Forces() with { CustomForces = [force] } });
        int failures = 0;
        for (int after = 0; after < 2000; after += 31)
        {
            var prediction = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = 0.02, Duration = 1.5 });
            BallState real = simulator.Launch(new Vector3d(0, 0.5, 0), s_velocity, s_spin);
            force.Begin(int.MaxValue);
            if (kept)
            {
                prediction.Update(in real);
            }

            force.Begin(after);
            try
            {
                for (int i = 0; i < 60; i++)
                {
                    prediction.Update(in real);
                    simulator.Step(ref real, 0.02, new StepLog());
                }
            }
            catch (FailedException)
            {
                failures++;
                Contiguous(prediction.Path);
                Assert.False(prediction.Path.IsComplete && prediction.Path.Count > 0 && force.Left >= 0);
                force.Begin(int.MaxValue);
                int before = prediction.Recomputations;
                bool anew = prediction.Update(in real);
                Assert.Equal(anew ? before + 1 : before, prediction.Recomputations);
                Contiguous(prediction.Path);
                var expected = new TrajectoryCache(simulator, new LookAheadRequest { TimeStep = 0.02, Duration = 1.5 });
                expected.Update(in real);
                Assert.InRange(Vector3d.Distance(expected.Path.PositionAt(real.Time + 1.4), prediction.Path.PositionAt(real.Time + 1.4)), 0, 1e-9);
            }
        }

        // A path that is kept needs few forces more, where no jump lets it be flown again.
        Assert.True(failures > (kept ? 5 : 20));
    }

    [Theory]
    [ProfileData(1)]
    [ProfileData(2)]
    [ProfileData(7)]
    public void A_batch_throws_the_same_whatever_the_number_of_threads(Profile profile, int threads)
    {
        const int Count = 600;
        Scene scene = profile.Scene() with { Forces = profile.Forces() with { CustomForces = [new FailingAt(333, 100, 580)] } };
        var batch = new BallBatch(scene, new BatchSettings { Threads = threads });
        var launches = new BatchLaunches(Count);
        for (int i = 0; i < Count; i++)
        {
            launches.Set(i, new Vector3d(i, 1, 0), new Vector3d(0, 3, -5), Vector3d.Zero);
        }

        for (int repeat = 0; repeat < 5; repeat++)
        {
            FailedException failed = Assert.Throws<FailedException>(() => batch.Fly(launches, new BatchFlights(Count), Count));
            Assert.Equal("ball 100", failed.Message);
        }

        // And it can be used again.
        var flights = new BatchFlights(100);
        batch.Fly(launches, flights, 100);
        Assert.Equal(BatchEnd.Impact, flights.End[99]);
    }

    [Theory]
    [ProfileData(double.NaN)]
    [ProfileData(double.PositiveInfinity)]
    public void A_force_that_is_no_number_is_refused_by_name(Profile profile, double value)
    {
        foreach (bool torque in (bool[])[false, true])
        {
            var force = new Poison(value, torque, 0.1);
            var ball = new Ball(profile.Scene() with { Forces = profile.Forces() with { CustomForces = [IForce.From(_ => Vector3d.Up), force] } });
            ball.Kick(s_velocity, s_spin);
            BallState before = ball.State;
            InvalidOperationException refused = Assert.Throws<InvalidOperationException>((Action)(() =>
            {
                for (int i = 0; i < 100; i++)
                {
                    before = ball.State;
                    ball.Step(0.03);
                }
            }));
            Assert.StartsWith("forces.customForces[1] (Poison) is (", refused.Message);
            Assert.Contains("allowed: finite components", refused.Message);
            Assert.True(Snapshot.Same(before, ball.State));
        }
    }

    /// <summary>A spring or a damper of ordinary stiffness in a step that is far too long for it, and a force that is finite but beyond everything.</summary>
    [Theory]
    [ProfileData]
    public void Forces_that_no_step_can_follow_are_refused_and_the_ball_stays_finite(Profile profile)
    {
        IForce[] forces =
        [
            IForce.From(ball => 500 * (new Vector3d(0, 3, 0) - ball.Position)),
            IForce.From(ball => -90 * ball.Velocity),
            IForce.From(_ => new Vector3d(1e300, 0, 0)),
        ];
        foreach (IForce force in forces)
        {
            foreach (Integrator integrator in Enum.GetValues<Integrator>())
            {
                foreach (double step in (double[])[0.01, 0.2, 3])
                {
                    var ball = new Ball(profile.Scene() with { Forces = profile.Forces() with { CustomForces = [force] } }, new SolverSettings { Integrator = integrator });
                    ball.Kick(s_velocity, s_spin);
                    for (int i = 0; i < 300; i++)
                    {
                        BallState before = ball.State;
                        try
                        {
                            ball.Step(step);
                        }
                        catch (InvalidOperationException refused)
                        {
                            Assert.StartsWith("forces.custom", refused.Message);
                            Assert.True(Snapshot.Same(before, ball.State));
                            break;
                        }

                        Assert.True(ball.State.Position.IsFinite && ball.State.Velocity.IsFinite && ball.State.Spin.IsFinite);
                    }
                }
            }
        }
    }

    private static FixedStepRunner Runner(Simulator simulator) =>
        Inputs.Runner(simulator, [new KickInput(0, s_velocity, s_spin), new KickInput(150, 0.5 * s_velocity, s_spin)]);

    private static void Contiguous(Trajectory path)
    {
        for (int i = 1; i < path.Count; i++)
        {
            Assert.True(path.Pieces[i].Time >= path.Pieces[i - 1].EndTime - 1e-12, $"piece {i}");
        }

        Assert.True(path.Count == 0 || path.Pieces[^1].EndTime <= path.Final.Time + 1e-12);
    }

    private sealed class FailedException(string message) : Exception(message);

    /// <summary>Throws once, after so many calls.</summary>
    private sealed class Failing : IForce
    {
        public int Left { get; private set; } = int.MaxValue;

        public void Begin(int calls) => Left = calls;

        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            if (Left-- <= 0)
            {
                throw new FailedException("on purpose");
            }

            sum.AddForce(new Vector3d(0.01, 0, 0));
        }
    }

    /// <summary>Throws for balls that were launched at some places.</summary>
    private sealed class FailingAt(params int[] places) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            double x = ball.Position.X;
            int failing = Array.FindIndex(places, place => Math.Abs(x - place) < 0.3);
            if (failing >= 0)
            {
                throw new FailedException($"ball {places[failing]}");
            }
        }
    }

    private sealed class Poison(double value, bool torque, double from) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            var poison = new Vector3d(0, ball.Time < from ? 0 : value, 0);
            if (torque)
            {
                sum.AddTorque(in poison);
            }
            else
            {
                sum.AddForce(in poison);
            }
        }
    }
}
