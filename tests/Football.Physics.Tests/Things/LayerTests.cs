using FootballPhysics.Tests.Batch;

namespace FootballPhysics.Tests.Things;

/// <summary>A ball passes through what it ignores, and nobody is told.</summary>
public sealed class LayerTests
{
    private const double Radius = 0.11;

    private static readonly Obstacle s_wall = new() { Name = "wall", Shape = new BoxShape(new Vector3d(0, 1, -5), new Vector3d(3, 2, 0.2)), Layer = 3 };

    private static readonly BallProperties s_ghost = BallProperties.Modern with { Ignores = Layers.Of(3, 31) };

    private static BallState Play(Scene scene, out StepLog log)
    {
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(0, 3, -14), new Vector3d(20, 0, 0));
        log = new StepLog();
        simulator.Run(ref s, 0.01, 3, StopAt.Time, log);
        return s;
    }

    [Fact]
    public void An_ignored_obstacle_is_not_there_to_the_last_bit()
    {
        BallState open = Play(new Scene(), out StepLog expected);
        BallState through = Play(new Scene { Ball = s_ghost, Obstacles = [s_wall, s_wall with { Layer = 31, Mass = 2 }] }, out StepLog log);
        BallState bounced = Play(new Scene { Ball = s_ghost with { Ignores = Layers.Of(0, 2, 4) }, Obstacles = [s_wall] }, out _);
        Assert.Equal(open.Position, through.Position);
        Assert.Equal(expected.Events.Span.ToArray(), log.Events.Span.ToArray());
        Assert.True(bounced.Position.Z > -5);
    }

    /// <summary>Frames of goals, nets and the ground are in no layer.</summary>
    [Fact]
    public void Goals_and_the_ground_are_never_ignored()
    {
        Scene scene = new() { Goals = [new Goal { Center = new Vector3d(0, 0, -6), Facing = new Vector3d(0, 0, 1) }] };
        BallState all = Play(scene, out StepLog expected);
        BallState none = Play(scene with { Ball = BallProperties.Modern with { Ignores = uint.MaxValue } }, out StepLog log);
        Assert.Equal(all, none);
        Assert.Equal(expected.Events.Count, log.Events.Count);
        Assert.Contains(log.Events.Span.ToArray(), e => e.Kind == BallEventKind.Goal);
    }

    /// <summary>A body at rest in the path, put over the ball, and pressing it: of a layer that the ball ignores.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void An_ignored_body_neither_hits_nor_pushes_nor_squeezes(bool ignores)
    {
        var bodies = new KinematicBodies();
        KinematicBody hand = bodies.Add("hand", new SphereShape(Vector3d.Zero, 0.3), SurfaceMaterial.Glove, mass: 1, layer: 3);
        Scene scene = new() { Ball = ignores ? s_ghost : BallProperties.Modern, Bodies = bodies };
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState s = simulator.Launch(new Vector3d(0, 1, 0), Vector3d.Zero, Vector3d.Zero);
        bool pushed = false;
        for (int i = 0; i < 20; i++)
        {
            hand.MoveTo(new Vector3d(0, 0.9, 0.2 - (2 * s.Time)), new Vector3d(0, 0, -2), s.Time);
            simulator.Step(ref s, 0.01, log);
            pushed |= hand.Velocity != new Vector3d(0, 0, -2);
        }

        Assert.Equal(ignores, s.Position.X == 0 && s.Position.Z == 0 && log.Events.Count == 0);
        Assert.Equal(ignores, !pushed);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void An_ignored_collider_of_an_engine_is_not_met(bool ignores)
    {
        var engine = new OneCollider { Collider = new EngineCollider("wall", s_wall.Shape) { Layer = 3 } };
        BallState s = Play(new Scene { Ball = ignores ? s_ghost : BallProperties.Modern, EngineColliders = engine }, out StepLog log);
        Assert.Equal(ignores, log.Events.Span.ToArray().All(e => e.ColliderIndex <= 0));
        Assert.Equal(ignores, s.Position.Z < -5);
    }

    [Fact]
    public void An_ignored_zone_reports_nothing_and_keeps_its_number()
    {
        Zone[] zones =
        [
            new Zone { Name = "a", Shape = s_wall.Shape, Layer = 3 },
            new Zone { Name = "b", Shape = s_wall.Shape },
        ];
        var simulator = new Simulator(new Scene { Ball = s_ghost, Zones = zones });
        Play(simulator.Scene, out StepLog log);
        string[] told = [.. log.Events.Span.ToArray().Where(e => e.Kind is BallEventKind.EnterZone or BallEventKind.ExitZone).Select(e => simulator.NameOf(e.ColliderIndex)!)];
        Assert.Equal(["b", "b"], told);
    }

    /// <summary>Each ball of a group by its own layers, also where one of them pushes what another one ignores.</summary>
    [Fact]
    public void Balls_of_a_group_ignore_each_its_own()
    {
        Scene scene = new() { Obstacles = [s_wall, new Obstacle { Name = "cone", Shape = new SphereShape(new Vector3d(1, 0.11, -3), 0.2), Mass = 0.5, Layer = 31 }] };
        var group = new BallGroup(scene, [BallProperties.Modern, s_ghost]);
        BallState[] states = [.. Enumerable.Range(0, 2).Select(i => group.SimulatorOf(i).Launch(new Vector3d(i, Radius, 0), new Vector3d(0, 0, -9), Vector3d.Zero))];
        var log = new StepLog();
        for (int i = 0; i < 300; i++)
        {
            group.Step(states, 0.01, log);
        }

        Assert.True(states[0].Position.Z > -5 && states[1].Position.Z < -6, $"{states[0].Position} {states[1].Position}");
        Assert.DoesNotContain(log.Events.Span.ToArray(), e => e.Ball == 1 && e.ColliderIndex > 0);
        Assert.Contains(log.Events.Span.ToArray(), e => e.Ball == 0 && e.ColliderIndex == 1);
    }

    [Fact]
    public void Look_aheads_aims_and_batches_know_layers()
    {
        Scene scene = new() { Ball = s_ghost, Obstacles = [s_wall with { Shape = new BoxShape(new Vector3d(0, 5, -5), new Vector3d(30, 10, 0.2)) }] };
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(0, 3, -14), Vector3d.Zero);
        var path = new Trajectory();
        simulator.LookAhead(in s, new LookAheadRequest { Duration = 2 }, path);
        Assert.True(path.Final.Position.Z < -10);
        var request = new AimRequest { From = new Vector3d(0, Radius, 0), Target = new Vector3d(0, 1, -15), Speed = 20 };
        Assert.Equal(AimStatus.Hit, new Aimer(scene).Find(request).Status);
        Assert.Equal(AimStatus.Blocked, new Aimer(scene with { Ball = BallProperties.Modern }).Find(request).Status);

        BatchLaunches launches = BatchScenes.Launches(3, 200);
        foreach (BatchPrecision precision in new[] { BatchPrecision.Single, BatchPrecision.Double })
        {
            var settings = new BatchSettings { Precision = precision };
            BatchFlights open = BatchScenes.Fly(new BallBatch(scene with { Obstacles = [] }, settings), launches);
            BatchFlights through = BatchScenes.Fly(new BallBatch(scene, settings), launches);
            BatchFlights against = BatchScenes.Fly(new BallBatch(scene with { Ball = BallProperties.Modern }, settings), launches);
            Assert.Equal(open.Position.Z, through.Position.Z);
            Assert.NotEqual(open.Position.Z, against.Position.Z);
        }
    }

    [Fact]
    public void A_ball_carried_by_what_another_scene_ignores_falls_and_such_a_state_is_refused()
    {
        var shelf = new Obstacle { Name = "shelf", Shape = new BoxShape(new Vector3d(0, 1, 0), new Vector3d(1, 0.1, 1)), Layer = 3 };
        var ball = new Ball(new Scene { Obstacles = [shelf] });
        ball.Place(new Vector3d(0, 1.1 + Radius, 0));
        ball.Step(0.1);
        Assert.Equal(1.1 + Radius, ball.Position.Y, 9);
        Scene ghostly = new() { Ball = s_ghost, Obstacles = [shelf] };
        BallState carried = ball.State;
        Assert.Contains("state.carrier", Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(ghostly).Validate(in carried)).Message, StringComparison.Ordinal);
        ball.Simulator = new Simulator(ghostly);
        ball.Step(0.2);
        Assert.True(ball.Position.Y < 1.1);
    }

    [Fact]
    public void Layers_out_of_range_are_refused_and_the_hash_knows_them()
    {
        Assert.Equal(0x80000008u, Layers.Of(3, 31));
        Assert.StartsWith("layers[1] is 32; allowed: 0 … 31.", Assert.Throws<ArgumentOutOfRangeException>(() => Layers.Of(3, 32)).Message, StringComparison.Ordinal);
        static string Refusal(Scene scene) => Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(scene)).Message;
        Assert.StartsWith("obstacles[0].layer is -1; allowed: 0 … 31.", Refusal(new Scene { Obstacles = [s_wall with { Layer = -1 }] }), StringComparison.Ordinal);
        Assert.StartsWith("zones[0].layer is 40; allowed: 0 … 31.", Refusal(new Scene { Zones = [new Zone { Shape = s_wall.Shape, Layer = 40 }] }), StringComparison.Ordinal);
        Assert.StartsWith("layer is 99", Assert.Throws<ArgumentOutOfRangeException>(() => new KinematicBodies().Add("a", s_wall.Shape, layer: 99)).Message, StringComparison.Ordinal);
        Assert.StartsWith("engineCollider.layer is 99", Assert.Throws<ArgumentOutOfRangeException>(() => new EngineCollider("a") { Layer = 99 }).Message, StringComparison.Ordinal);
        ulong Of(uint ignores, int layer) => new Simulator(new Scene { Ball = s_ghost with { Ignores = ignores }, Obstacles = [s_wall with { Layer = layer }] }).SceneHash;
        Assert.Equal(3, new[] { Of(0, 3), Of(8, 3), Of(8, 4) }.Distinct().Count());
        Assert.Equal(Of(0, 3), Of(0, 4));
    }

    private sealed class OneCollider : IEngineColliders
    {
        public required EngineCollider Collider { get; init; }

        public double Time => 0;

        public double MaximumSpeed => 0;

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            Collider.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            hits.Add(Collider);
        }
    }
}
