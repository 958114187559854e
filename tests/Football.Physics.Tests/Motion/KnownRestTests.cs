namespace FootballPhysics.Tests.Motion;

/// <summary>A step of a ball at rest among bodies that stand still changes only the time and evaluates nothing, until a body or an obstacle moves.</summary>
public sealed class KnownRestTests
{
    private const double Step = 0.01;
    private const double Radius = 0.11;

    /// <summary>Contact on a slope of 10 degrees, which holds no ball by itself: up the slope, towards +x in the plane, and down.</summary>
    private static readonly Vector3d s_up = new(Math.Sin(Math.PI / 18), Math.Cos(Math.PI / 18), 0);
    private static readonly Vector3d s_down = new(Math.Cos(Math.PI / 18), -Math.Sin(Math.PI / 18), 0);

    [Fact]
    public void Rest_against_a_standing_player_is_checked_once()
    {
        var play = new Play(creeps: false);
        Assert.True(play.Take() > 0);
        for (int i = 0; i < 50; i++)
        {
            play.Player.MoveTo(play.Player.Position, default, play.State.Time);
            Assert.Equal(0, play.Take());
        }

        Assert.Equal(MotionState.Rest, play.State.Motion);
    }

    [Theory]
    [InlineData("leaves")]
    [InlineData("withdraws")]
    [InlineData("treads on it")]
    [InlineData("spins")]
    [InlineData("comes back")]
    public void A_player_who_moves_changes_what_he_changes_where_rest_is_checked_in_every_step(string how)
    {
        var known = new Play(creeps: false);
        var checkedAlways = new Play(creeps: true);
        for (int i = 0; i < 60; i++)
        {
            if (i == 20)
            {
                Move(known, how);
                Move(checkedAlways, how);
            }

            known.Take();
            Assert.True(checkedAlways.Take() > 0);
            Assert.True(Snapshot.Same(known.State, checkedAlways.State), $"step {i}: {known.State} and {checkedAlways.State}");
        }

        Assert.Equal(how is "comes back", known.State.Position == known.Start);
    }

    [Fact]
    public void An_obstacle_that_another_ball_pushes_away_lets_the_ball_go()
    {
        Vector3d center = (Radius * s_up) + (0.5 * s_down);
        var block = new Obstacle { Name = "block", Shape = new SphereShape(center, 0.5 - Radius), Surface = SurfaceMaterial.Board, Mass = 5 };
        var simulator = new Simulator(Slope() with { Obstacles = [block] });
        BallState lying = simulator.Launch(Radius * s_up, default, default);
        var log = new StepLog();
        simulator.Run(ref lying, Step, 5, StopAt.Rest, log);
        Vector3d from = lying.Position;
        for (int i = 0; i < 10; i++)
        {
            simulator.Step(ref lying, Step, log);
        }

        Assert.Equal(from, lying.Position);
        BallState other = simulator.Launch(center + new Vector3d(0, 0.2, -3), new Vector3d(0, 0, 25), default);
        other.Time = lying.Time;
        for (int i = 0; i < 50; i++)
        {
            simulator.Step(ref other, Step, log);
            simulator.Step(ref lying, Step, log);
        }

        Assert.True(Vector3d.Dot(lying.Position - from, s_down) > 0.01, $"{lying}");
    }

    private static void Move(Play play, string how)
    {
        KinematicBody player = play.Player;
        double time = play.State.Time;
        switch (how)
        {
            case "leaves":
                player.MoveTo(player.Position + (0.3 * s_down), default, time);
                break;
            case "withdraws":
                player.Withdraw();
                break;
            case "treads on it":
                player.MoveTo(player.Position - (0.02 * s_down), default, time);
                break;
            case "spins":
                player.MoveTo(player.Position, Quaterniond.Identity, default, new Vector3d(0, 0, 30), time);
                break;
            case "comes back":
                player.MoveTo(player.Position + s_down, default, time);
                player.MoveTo(player.Position - s_down, default, time);
                break;
            default:
                throw new ArgumentException(how, nameof(how));
        }
    }

    private static Scene Slope() => new() { Ground = Ground.Of(SurfaceMaterial.DryTurf) with { Normal = s_up } };

    /// <summary>A ball that leans on a player down the slope; a second one far away may creep, so that in no step everything stands still.</summary>
    private sealed class Play
    {
        private readonly Simulator _simulator;
        private readonly StepLog _log = new();
        private BallState _state;

        public Play(bool creeps)
        {
            var bodies = new KinematicBodies();
            Player = bodies.Add("player", new SphereShape(default, 0.4));
            KinematicBody far = bodies.Add("far", new SphereShape(default, 0.4));
            Player.MoveTo((Radius * s_up) + ((0.4 + Radius) * s_down), default, 0);
            far.MoveTo(new Vector3d(0, 20, 30), new Vector3d(0, 0, creeps ? 0.1 : 0), 0);
            _simulator = new Simulator(Slope() with { Bodies = bodies });
            _state = _simulator.Launch(Radius * s_up, default, default);
            _simulator.Run(ref _state, Step, 1, StopAt.Rest, _log);
            Assert.Equal(MotionState.Rest, _state.Motion);
            Start = _state.Position;
        }

        public Vector3d Start { get; }

        public KinematicBody Player { get; }

        public BallState State => _state;

        /// <summary>Takes a step.</summary>
        /// <returns>The evaluations in it.</returns>
        public long Take()
        {
            _log.Clear();
            _simulator.Step(ref _state, Step, _log);
            return _log.Evaluations;
        }
    }
}
