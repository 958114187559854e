using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Game;

/// <summary>The ball's clock jumps between two steps, or is rounded, while the game moves bodies by it.</summary>
public sealed class ClockJumpTests
{
    private const double Tick = 1.0 / 60;

    [Theory]
    [InlineData("ball", 0)]
    [InlineData("ball", 1.5)]
    [InlineData("runner", 0)]
    [InlineData("runner", 1.5)]
    [InlineData("group", 0)]
    public void Bodies_moved_before_the_ball_is_placed_are_where_bodies_moved_after_it_are(string kind, double speed)
    {
        Assert.Equal(Placed(kind, speed, placesFirst: true), Placed(kind, speed, placesFirst: false));
    }

    [Theory]
    [InlineData("ball")]
    [InlineData("runner")]
    [InlineData("group")]
    public void Bodies_moved_before_a_state_is_set_are_where_bodies_moved_after_it_are(string kind)
    {
        Assert.Equal(Restored(kind, restoresFirst: true), Restored(kind, restoresFirst: false));
    }

    /// <summary>A keeper who walks on at his own pace is where he was when the ball is placed, also if the game does not move him then.</summary>
    [Fact]
    public void A_body_that_is_not_moved_goes_on_from_where_it_is()
    {
        var bodies = new KinematicBodies();
        KinematicBody keeper = bodies.Add("keeper", BodyKind.Player);
        var ball = new Ball(new Scene { Bodies = bodies });
        keeper.MoveTo(new Vector3d(-4, 0, 0), new Vector3d(1, 0, 0), 0);
        for (int i = 0; i < 120; i++)
        {
            ball.Step(Tick);
        }

        // At −2 m, with 1 m/s: he reaches a ball at −1 m within a second.
        ball.Place(new Vector3d(-1, 0.11, 0));
        int hits = 0;
        for (int i = 0; i < 60; i++)
        {
            ball.Step(Tick);
            foreach (BallEvent happened in ball.Events)
            {
                hits += happened.ColliderIndex > 0 ? 1 : 0;
            }
        }

        Assert.True(hits > 0);
    }

    /// <summary>A guess of a kick that the wire form does not hold has another path, but the same clock, by which the game moves its bodies.</summary>
    [Theory]
    [InlineData(1, 1)]
    [InlineData(6, 1)]
    [InlineData(6, 2)]
    public void A_late_kick_gives_the_bits_of_the_kick_in_time_with_rounded_states(int wireTicks, int balls)
    {
        int unheld = 0;
        for (int i = 0; i < 40; i++)
        {
            int late = 4 + (int)(36 * SplitMix64.At(i, 99));
            List<ulong> inTime = Play(i, 0, wireTicks, balls, ref unheld);
            List<ulong> delayed = Play(i, late, wireTicks, balls, ref unheld);
            Assert.Equal(inTime.Skip(10 + late), delayed.Skip(10 + late));
        }

        // Some of the states were such as the form does not hold, else nothing was tried.
        Assert.True(unheld > 0);
    }

    /// <summary>A ball at rest on what moves has its velocity and spin: the wire form, which has no room for them, leaves it as it is.</summary>
    [Fact]
    public void A_ball_at_rest_on_a_moving_carrier_is_not_rounded()
    {
        var belt = new Obstacle { Name = "belt", Shape = new BoxShape(new Vector3d(0, 0.4, 0), new Vector3d(50, 0.4, 5)), Surface = SurfaceMaterial.Wood, Velocity = new Vector3d(0.3, 0, 0) };
        var simulator = new Simulator(new Scene { Obstacles = [belt] });
        BallState ball = simulator.Launch(new Vector3d(0, 0.8 + simulator.Scene.Ball.Radius, 0), new Vector3d(0.3, 0, 0), Vector3d.Zero);
        var runner = new FixedStepRunner(simulator, Tick) { QuantizationInterval = 4 };
        runner.Restore(0, in ball);
        var plain = new FixedStepRunner(simulator, Tick);
        plain.Restore(0, in ball);
        for (int i = 0; i < 600; i++)
        {
            runner.Step();
            plain.Step();
        }

        Assert.Equal(MotionState.Rest, runner.Motion);
        Assert.Equal(0.3, runner.Velocity.X, 1e-12);
        Assert.Equal(0, (runner.State.Position - plain.State.Position).Length, 1e-9);
        Assert.False(runner.TryWriteQuantized(runner.State, new byte[Snapshot.QuantizedSize]));
    }

    private static Simulator WithPlayer(out KinematicBody player)
    {
        var bodies = new KinematicBodies();
        player = bodies.Add("keeper", BodyKind.Player);
        return new Simulator(Pitch.Standard.On(new Scene { Bodies = bodies }));
    }

    private static ulong Placed(string kind, double speed, bool placesFirst)
    {
        Simulator simulator = WithPlayer(out KinematicBody player);
        IPlayed played = IPlayed.Of(kind, simulator);
        for (int i = 0; i < 300; i++)
        {
            player.MoveTo(new Vector3d(4, 0, 4), Vector3d.Zero, played.Time);
            played.Step();
        }

        // He runs into the ball that falls there.
        var place = new Vector3d(0, 1, 0);
        if (placesFirst)
        {
            played.Place(place);
        }

        player.MoveTo(new Vector3d(-0.6, 0, 0), new Vector3d(speed, 0, 0), played.Time);
        if (!placesFirst)
        {
            played.Place(place);
        }

        for (int i = 0; i < 60; i++)
        {
            played.Step();
        }

        return played.Hash;
    }

    private static ulong Restored(string kind, bool restoresFirst)
    {
        Simulator simulator = WithPlayer(out KinematicBody player);
        IPlayed played = IPlayed.Of(kind, simulator);
        BallState[] kept = [];
        for (int i = 0; i < 300; i++)
        {
            kept = i == 100 ? played.States : kept;
            player.MoveTo(new Vector3d(4, 0, 4), Vector3d.Zero, played.Time);
            played.Step();
        }

        if (restoresFirst)
        {
            played.Restore(kept);
        }

        player.MoveTo(new Vector3d(-0.6, 0, 0), new Vector3d(1.5, 0, 0), played.Time);
        if (!restoresFirst)
        {
            played.Restore(kept);
        }

        for (int i = 0; i < 60; i++)
        {
            played.Step();
        }

        return played.Hash;
    }

    private static List<ulong> Play(int seed, int late, int wireTicks, int balls, ref int unheld)
    {
        int draw = 0;
        double U(double low, double high) => low + ((high - low) * SplitMix64.At(seed, draw++));
        Vector3d Horizontal()
        {
            double angle = U(-Math.PI, Math.PI);
            return new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
        }

        var bodies = new KinematicBodies();
        var players = new KinematicBody[8];
        var positions = new Vector3d[8];
        var velocities = new Vector3d[8];
        for (int i = 0; i < 8; i++)
        {
            players[i] = bodies.Add("player " + i, BodyKind.Player.Shape, SurfaceMaterial.Boot);
            positions[i] = U(0.6, 2.5) * Horizontal();
            velocities[i] = (U(0, 3) * Horizontal()) - (0.4 * positions[i]);
        }

        var kick = new KickInput(10, new Vector3d(U(-9, 9), U(0, 2), U(-9, 9)), new Vector3d(0, U(-20, 20), 0), 1);
        var simulator = new Simulator(Pitch.Standard.On(new Scene { Bodies = bodies }));
        FixedStepRunner runner = balls == 1 ? new FixedStepRunner(simulator, Tick) : new FixedStepRunner(new BallGroup(simulator, balls), Tick);
        runner.QuantizationInterval = wireTicks;
        var rollback = new Rollback(runner, 64);
        if (late == 0)
        {
            runner.Kicks.Add(in kick);
        }

        var hashes = new List<ulong>();
        byte[] wire = new byte[Snapshot.QuantizedSize];
        for (int tick = 0; tick < 120; tick++)
        {
            for (int i = 0; i < 8; i++)
            {
                players[i].MoveTo(positions[i] + (tick * Tick * velocities[i]), velocities[i], runner.Time);
            }

            runner.Step();
            if (late > 0 && runner.Tick == 10 + late)
            {
                rollback.ApplyKick(in kick);
            }

            unheld += runner.Tick % wireTicks == 0 && !runner.TryWriteQuantized(runner.State, wire) ? 1 : 0;
            hashes.Add(rollback.HashAt(runner.Tick));
        }

        return hashes;
    }

    /// <summary>A ball, a runner or a runner of several balls, as a game has them.</summary>
    private interface IPlayed
    {
        double Time { get; }

        BallState[] States { get; }

        ulong Hash => Snapshot.Hash(States);

        static IPlayed Of(string kind, Simulator simulator) => kind switch
        {
            "ball" => new OneBall(new Ball(simulator)),
            "runner" => new Run(new FixedStepRunner(simulator, Tick)),
            _ => new Run(new FixedStepRunner(new BallGroup(simulator, 2), Tick)),
        };

        void Step();

        void Place(Vector3d position);

        void Restore(BallState[] states);
    }

    private sealed class OneBall(Ball ball) : IPlayed
    {
        public double Time => ball.Time;

        public BallState[] States => [ball.State];

        public void Step() => ball.Step(Tick);

        public void Place(Vector3d position) => ball.Place(position);

        public void Restore(BallState[] states) => ball.State = states[0];
    }

    private sealed class Run(FixedStepRunner runner) : IPlayed
    {
        public double Time => runner.Time;

        public BallState[] States => [.. Enumerable.Range(0, runner.Balls).Select(runner.StateOf)];

        public void Step() => runner.Step();

        public void Place(Vector3d position) => runner.Place(position);

        public void Restore(BallState[] states) => runner.RestoreAll(100, states);
    }
}
