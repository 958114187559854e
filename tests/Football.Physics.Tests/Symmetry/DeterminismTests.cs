using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using FootballPhysics.Tests.Reference;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Symmetry;

/// <summary>The state is one value: the same bytes in give the same bytes out, and nothing is allocated on the way.</summary>
public sealed class DeterminismTests
{
    public static TheoryData<Integrator> Integrators() => Flight.EveryIntegrator();

    [Theory]
    [MemberData(nameof(Integrators))]
    public void Two_runs_give_the_same_bytes(Integrator integrator)
    {
        foreach (ReferenceCase item in ReferenceCase.All.Where((_, i) => i % 5 == 0))
        {
            byte[] Play()
            {
                var simulator = new Simulator(item.Scene, Flight.With(integrator));
                BallState state = simulator.Launch(item.Position, item.Velocity, item.Spin, item.Orientation);
                simulator.Run(ref state, 0.02, Math.Min(item.Duration, 20), item.StopAt, new StepLog());
                return Bytes(in state);
            }

            Assert.Equal(Play(), Play());
        }
    }

    [Theory]
    [ProfileData]
    public void Balls_that_share_a_simulator_do_not_disturb_each_other(Profile profile)
    {
        var simulator = new Simulator(profile.Scene() with { Air = new Air { Wind = new Vector3d(2, 0, 3) } });
        var random = new Shots(41);
        BallState[] together = [.. Enumerable.Range(0, 8).Select(_ =>
            simulator.Launch(new Vector3d(0, 0.3, 0), random.Velocity(5, 25, 5, 40), random.Uniform(0, 50) * random.Direction()))];
        BallState[] alone = [.. together];
        var log = new StepLog();
        for (int i = 0; i < 400; i++)
        {
            for (int ball = 0; ball < together.Length; ball++)
            {
                simulator.Step(ref together[ball], 0.02, log);
            }
        }

        Parallel.For(0, alone.Length, ball =>
        {
            var own = new StepLog();
            for (int i = 0; i < 400; i++)
            {
                simulator.Step(ref alone[ball], 0.02, own);
            }
        });
        Assert.Equal(together.Select(state => Bytes(in state)), alone.Select(state => Bytes(in state)));
    }

    [Fact]
    public void A_copy_is_a_snapshot_from_which_the_same_bytes_follow()
    {
        var ball = new Ball();
        ball.Place(new Vector3d(0, 1, 0));
        ball.Kick(new Vector3d(14, 7, 2), new Vector3d(3, 40, -9));
        for (int i = 0; i < 37; i++)
        {
            ball.Step(0.016);
        }

        BallState snapshot = ball.State;
        for (int i = 0; i < 300; i++)
        {
            ball.Step(0.016);
        }

        byte[] once = Bytes(ball.State);
        ball.State = snapshot;
        for (int i = 0; i < 300; i++)
        {
            ball.Step(0.016);
        }

        Assert.Equal(once, Bytes(ball.State));
    }

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void A_life_of_flight_bounces_slide_and_roll_allocates_nothing(Profile profile, Integrator integrator)
    {
        foreach (CollisionTiming timing in Enum.GetValues<CollisionTiming>())
        {
            foreach (Scene scene in new[] { profile.Scene(), Scene.Vacuum, profile.Scene() with { Forces = ForceSet.Regularized }, profile.Scene() with { Forces = ForceSet.Constant }, WithForce(profile), WithGusts() })
            {
                var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator, CollisionTiming = timing });
                var log = new StepLog(256);
                Assert.Equal(0, Allocation.Of(() => Live(simulator, log)));
                Assert.Contains("Roll Rest", Flight.Kinds(log));
            }
        }
    }

    private static Scene WithGusts() => Scene.Measured with
    {
        Air = new Air { WindField = new WindByHeight(3, 2, 1, gusts: new Gusts { Seed = 3 }) },
        Forces = ForceSet.Measured with { KnuckleSeed = 2 },
    };

    [Theory]
    [ProfileData]
    public void A_run_allocates_nothing(Profile profile)
    {
        var simulator = new Simulator(profile.Scene());
        var log = new StepLog();
        Assert.Equal(0, Allocation.Of(() =>
        {
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(9, 5, 2), new Vector3d(3, 20, -15));
            log.Clear();
            simulator.Run(ref state, 0.01, 60, StopAt.Rest, log);
        }));
    }

    [Fact]
    public void A_frame_of_the_front_allocates_nothing()
    {
        var ball = new Ball();
        static void Frames(Ball ball)
        {
            ball.Kick(18, new Vector3d(0, 0.4, -1), 10, 20);
            for (int i = 0; i < 600; i++)
            {
                ball.Step(0.016);
                foreach (ref readonly BallEvent item in ball.Events)
                {
                    _ = item.Time;
                }
            }
        }

        Assert.Equal(0, Allocation.Of(() => Frames(ball)));
    }

    [Fact]
    public void The_state_holds_no_references() => Assert.False(RuntimeHelpers.IsReferenceOrContainsReferences<BallState>());

    private static Scene WithForce(Profile profile) =>
        profile.Scene() with { Forces = profile.Forces() with { CustomForces = [IForce.From(ball => new Vector3d(0.01 * ball.Velocity.X, 0, 0.02))] } };

    private static void Live(Simulator simulator, StepLog log)
    {
        log.Clear();
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(9, 5, 2), new Vector3d(3, 20, -15));
        while (state.Motion != MotionState.Rest && state.Time < 60)
        {
            simulator.Step(ref state, 0.004, log);
        }
    }

    private static byte[] Bytes(in BallState state) => MemoryMarshal.AsBytes(new ReadOnlySpan<BallState>(in state)).ToArray();
}
