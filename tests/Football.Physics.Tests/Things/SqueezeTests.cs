using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>A ball that things which move leave no room: against boards, between players, under a player.</summary>
public sealed class SqueezeTests
{
    private const double Radius = 0.11;
    private const double Frame = 1.0 / 60;

    /// <summary>In a step no more is told.</summary>
    private const int MostEvents = 24;

    private static readonly IShape s_player = new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25);

    /// <summary>A squeezed ball that nothing presses any longer keeps its spin: it is stopped only if it neither moves nor spins.</summary>
    [Fact]
    public void A_ball_that_spins_on_its_spot_after_a_squeeze_goes_on_spinning()
    {
        SurfaceMaterial smooth = SurfaceMaterial.DryTurf with { TorsionalPatchRadius = 0, SpinDamping = 0 };
        var bodies = new KinematicBodies();
        bodies.Add("far", s_player).MoveTo(new Vector3d(30, 0, 0), default, 0);
        var simulator = new Simulator(new Scene { Ball = BallProperties.Tunnel, Air = new Air { Density = 0 }, Ground = Ground.Of(smooth), Bodies = bodies });
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        s.SetGroundSpin(new Vector3d(0, 20, 0));
        s.Motion = MotionState.Pinned;
        var log = new StepLog();
        simulator.Step(ref s, 0.01, log);
        Assert.NotEqual(MotionState.Pinned, s.Motion);
        Assert.InRange((s.Position - new Vector3d(0, Radius, 0)).Length, 0, 1e-9);
        Assert.Equal(20, s.Spin.Y, 1e-9);
    }

    /// <summary>Between two boards that leave too little room there is no place for the ball: a squeezed ball stays where it is, on its side or not, and stops.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.0001)]
    [InlineData(-0.0002)]
    public void A_squeezed_ball_in_a_gap_that_is_too_narrow_stays(double aside)
    {
        const double Half = Radius - 0.0005;
        Obstacle[] boards = [.. new[] { -1, 1 }.Select(side => new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(side * (Half + 0.1), 0.5, 0), new Vector3d(0.1, 0.5, 5)), Surface = SurfaceMaterial.Board })];
        var bodies = new KinematicBodies();
        bodies.Add("far", s_player).MoveTo(new Vector3d(30, 0, 0), default, 0);
        var simulator = new Simulator(new Scene { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf), Obstacles = boards, Bodies = bodies });
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var start = new Vector3d(aside, Radius, 0);
        s.Position = start;
        s.Velocity = Vector3d.Zero;
        s.SetGroundSpin(Vector3d.Zero);
        s.Motion = MotionState.Pinned;
        simulator.Step(ref s, 0.01, new StepLog());
        Assert.InRange((s.Position - start).Length, 0, 1e-9);
        Assert.InRange(s.Velocity.Length, 0, 1e-9);
    }

    /// <summary>A player pressed a ball through the boards of a corner: 254 of 400 ended behind one.</summary>
    [Theory]
    [ProfileData]
    public void A_player_presses_no_ball_into_boards(Profile profile)
    {
        var random = new Shots(51);
        Obstacle[] boards =
        [
            new() { Name = "end", Shape = new BoxShape(new Vector3d(0, 0.5, -5.05), new Vector3d(50, 0.5, 0.05)), Surface = SurfaceMaterial.Board },
            new() { Name = "side", Shape = new BoxShape(new Vector3d(-5.05, 0.5, 0), new Vector3d(0.05, 0.5, 50)), Surface = SurfaceMaterial.Board },
        ];
        int squeezed = 0;
        for (int i = 0; i < 30; i++)
        {
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", s_player);
            var ball = new Ball(profile.Scene() with { Bodies = bodies, Obstacles = boards });
            var from = new Vector3d(-4.8899 + random.Uniform(0, 0.3), Radius, -4.8899 + random.Uniform(0, 0.3));
            ball.Place(from);
            Vector3d velocity = random.Uniform(0.3, 5) * new Vector3d(-random.Uniform(0.2, 1), 0, -random.Uniform(0.2, 1)).Normalized();
            Vector3d place = new Vector3d(from.X, 0, from.Z) - (0.8 * velocity.Normalized());
            for (int frame = 0; frame < 150; frame++)
            {
                player.MoveTo(place, velocity, ball.Time);
                ball.Step(Frame);
                place += Frame * velocity;
                squeezed += ball.Motion == MotionState.Pinned ? 1 : 0;
                Vector3d at = ball.State.Position;
                Assert.True(at.Y >= Radius - 1e-9 && at.X >= -5 + Radius - 1e-9 && at.Z >= -5 + Radius - 1e-9, $"press {i}, frame {frame}: {at}");
                Assert.InRange(ball.Events.Count, 0, MostEvents);
            }
        }

        Assert.True(squeezed > 50, $"{squeezed} frames");
    }

    /// <summary>Two players of 2.7 and 2.9 m/s shot the ball away at 42 m/s: it is no faster than the faster of them, times 1 + e, or than it came.</summary>
    [Theory]
    [ProfileData]
    public void Two_players_do_not_shoot_it_away(Profile profile)
    {
        var random = new Shots(52);
        int squeezes = 0;
        for (int i = 0; i < 60; i++)
        {
            var bodies = new KinematicBodies();
            KinematicBody one = bodies.Add("one", s_player);
            KinematicBody other = bodies.Add("other", s_player);
            var ball = new Ball(profile.Scene() with { Bodies = bodies });
            double height = i % 2 == 0 ? Radius : random.Uniform(Radius, 1.2);
            ball.Place(new Vector3d(0, height, 0));
            double first = random.Uniform(0.2, 8);
            double second = i % 3 == 0 ? 0 : random.Uniform(0.2, 8);
            var from = new Vector3d(-random.Uniform(0.4, 1.5), 0, random.Uniform(-0.15, 0.15));
            var towards = new Vector3d(random.Uniform(0.4, 1.5), 0, random.Uniform(-0.15, 0.15));

            // e at 6 m/s is 0.5; at these speeds it may be a little more. What it falls is its own.
            double e = SurfaceMaterial.Boot.NormalRestitution * 1.2;
            double most = Math.Sqrt(Math.Pow((1 + e) * Math.Max(first, second), 2) + (2 * 9.81 * 1.2)) + 0.1;
            bool isIn = false;
            for (int frame = 0; frame < 150; frame++)
            {
                one.MoveTo(from + (frame * Frame * first * new Vector3d(1, 0, 0)), new Vector3d(first, 0, 0), ball.Time);
                other.MoveTo(towards - (frame * Frame * second * new Vector3d(1, 0, 0)), new Vector3d(-second, 0, 0), ball.Time);
                ball.Step(Frame);
                Assert.True(ball.State.Velocity.Length <= most, $"pinch {i}, frame {frame}: {ball.State.Velocity.Length} m/s from {first} and {second}");
                Assert.InRange(ball.Events.Count, 0, MostEvents);
                foreach (ref readonly BallEvent item in ball.Events)
                {
                    if (item.Kind == BallEventKind.Pinned)
                    {
                        // It begins with a thing, and ends without one.
                        Assert.Equal(isIn, item.ColliderIndex < 0);
                        isIn = !isIn;
                        squeezes++;
                    }
                }

                Assert.Equal(isIn, ball.Motion == MotionState.Pinned);
            }

            Assert.False(isIn && second > 1 && first > 1, "the players have passed");
        }

        Assert.True(squeezes > 10, $"{squeezes} squeezes");
    }

    /// <summary>A player who runs onto a ball from above drives it along the ground, in front of him.</summary>
    [Theory]
    [ProfileData]
    public void One_player_drives_it_before_him(Profile profile)
    {
        for (double speed = 1; speed < 8; speed += 0.7)
        {
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", s_player);
            var ball = new Ball(profile.Scene() with { Bodies = bodies });
            ball.Place(new Vector3d(0, Radius, 0.03));
            for (int frame = 0; frame < 120; frame++)
            {
                var place = new Vector3d(-0.8 + (frame * Frame * speed), 0, 0);
                player.MoveTo(place, new Vector3d(speed, 0, 0), ball.Time);
                ball.Step(Frame);
                Assert.InRange(ball.Events.Count, 0, MostEvents);
                double gap = s_player.At(ball.State.Position - place - (Frame * speed * new Vector3d(1, 0, 0))).Distance - Radius;
                Assert.True(gap > -1e-6, $"{speed} m/s, frame {frame}: {gap} m in the player");
            }
        }
    }

    /// <summary>One of two who pinched a ball runs on, and drives it along the ground before him: it has room there, and is squeezed no longer.</summary>
    [Theory]
    [ProfileData]
    public void It_has_room_before_one_who_runs_on(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody one = bodies.Add("one", s_player);
        KinematicBody other = bodies.Add("other", s_player);
        var ball = new Ball(profile.Scene() with { Bodies = bodies });
        ball.Place(new Vector3d(0, Radius, 0));
        int squeezed = 0;
        for (int frame = 0; frame < 180; frame++)
        {
            // They meet, and he who came from the left turns back as fast as he came.
            double x = 0.9 - (frame * Frame * 2);
            one.MoveTo(new Vector3d(x > 0.33 ? -x : -0.33 - (2 * (0.33 - x)), 0, 0), new Vector3d(x > 0.33 ? 2 : -4, 0, 0), ball.Time);
            other.MoveTo(new Vector3d(x, 0, 0), new Vector3d(-2, 0, 0), ball.Time);
            ball.Step(Frame);
            squeezed += ball.Motion == MotionState.Pinned ? 1 : 0;
            Assert.True(x > 0 || ball.Motion != MotionState.Pinned, $"frame {frame}");
        }

        Assert.InRange(squeezed, 0, 30);
    }

    /// <summary>While it is squeezed a look-ahead goes where the steps go, to the bit, a snapshot brings it back, and a step allocates nothing.</summary>
    [Fact]
    public void It_is_looked_ahead_restored_and_stepped_without_memory_while_it_lasts()
    {
        var bodies = new KinematicBodies();
        KinematicBody one = bodies.Add("one", s_player);
        KinematicBody other = bodies.Add("other", s_player);
        var simulator = new Simulator(new Scene { Bodies = bodies });
        BallState state = simulator.Launch(new Vector3d(0, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        var path = new Trajectory();
        byte[] bytes = new byte[Snapshot.Size];
        int squeezed = 0;
        for (int frame = 0; frame < 120; frame++)
        {
            double x = Math.Max(0.3, 0.9 - (frame * Frame * 1.5));
            one.MoveTo(new Vector3d(-x, 0, 0), new Vector3d(x > 0.3 ? 1.5 : 0, 0, 0), state.Time);
            other.MoveTo(new Vector3d(x, 0, 0), new Vector3d(x > 0.3 ? -1.5 : 0, 0, 0), state.Time);
            simulator.LookAhead(in state, new LookAheadRequest { TimeStep = Frame, Duration = 1.5 * Frame, StopAt = StopAt.Time }, path);
            Snapshot.Write(in state, bytes);
            BallState again = Snapshot.Read(bytes);
            BallState before = state;
            long allocated = Allocation.Of(() =>
            {
                log.Clear();
                state = before;
                simulator.Step(ref state, Frame, log);
            });
            Assert.Equal(0, allocated);
            Assert.True(path.IsComplete);
            Assert.Equal(state.Position, path.PositionAt(state.Time));
            log.Clear();
            simulator.Step(ref again, Frame, log);
            Assert.True(Snapshot.Same(in again, in state));
            squeezed += state.Motion == MotionState.Pinned ? 1 : 0;
        }

        Assert.True(squeezed > 30, $"{squeezed} frames");

        // Shut in by two who stand, it lies still.
        Assert.InRange(state.Velocity.Length, 0, 1e-6);
    }

    /// <summary>A player who stands still overlaps a ball in a corner, which wind pushes: the ball is still, and keeps no speed of the last part of a step.</summary>
    [Theory]
    [InlineData(1 / 240.0, 1)]
    [InlineData(1 / 30.0, 1)]
    [InlineData(0.2, 1)]
    [InlineData(1 / 60.0, 2)]
    public void A_ball_that_a_standing_player_overlaps_in_a_corner_is_still(double step, int balls)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", BodyKind.Player.Shape, SurfaceMaterial.Boot, 75);
        player.MoveTo(new Vector3d(0.2567, 0, 0.1411), Vector3d.Zero, 0);
        var thick = new Vector3d(0.05, 1, 1);
        var scene = new Scene
        {
            Air = new Air { Wind = new Vector3d(-0.54, 0, 1.53) },
            Bodies = bodies,
            Obstacles =
            [
                new Obstacle { Name = "left", Shape = new BoxShape(new Vector3d(-0.05, 1, 0), thick) },
                new Obstacle { Name = "back", Shape = new BoxShape(new Vector3d(0, 1, -0.05), new Vector3d(1, 1, 0.05)) },
            ],
        };
        var simulator = new Simulator(scene);
        var group = new BallGroup(simulator, balls);
        BallState[] states = [.. Enumerable.Range(0, balls).Select(i => simulator.Launch(new Vector3d(0.11, 0.11, 0.11) + new Vector3d(0, 0, 5 * i), Vector3d.Zero, Vector3d.Zero))];
        var log = new StepLog();
        for (int i = 0; i < 120; i++)
        {
            group.Step(states, step, log);
        }

        BallState ball = states[0];
        Assert.Equal(MotionState.Pinned, ball.Motion);
        Assert.Equal(new Vector3d(0.11, 0.11, 0.11), ball.Position);
        Assert.Equal(Vector3d.Zero, ball.Velocity);
        Assert.Equal(Vector3d.Zero, ball.Spin);
    }
}
