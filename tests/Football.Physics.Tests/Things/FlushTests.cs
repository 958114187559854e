namespace FootballPhysics.Tests.Things;

/// <summary>Surfaces that are flush, where a step begins within micrometres of the seam.</summary>
public sealed class FlushTests
{
    private const double Step = 0.01;

    /// <summary>
    /// A tile is 1e-10 m higher than the turf and moves in its own plane, along its edge. The first step ends up to 10 µm before the edge or beyond it.
    /// The ball slides sideways on the tile, and keeps its speed across the edge.
    /// </summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_step_that_begins_at_the_edge_of_a_moving_tile_keeps_the_speed(bool engine)
    {
        for (int i = -40; i <= 40; i++)
        {
            BallState over = Rolled(0.25e-6 * i, engine, out int told);
            BallState alone = Rolled(null, engine, out _);
            Assert.Equal(0, told);
            Assert.Equal(MotionState.Sliding, over.Motion);

            // Coulomb friction drags it along, and spins it up: its slip is 1.5 m/s at the edge.
            double timeOver = over.Time - Step + (0.25e-6 * i / 2.0);
            Assert.InRange(over.Velocity.Z / (0.5 * 9.81 * timeOver), 0.99, 1.01);
            Assert.InRange(Math.Abs(over.Position.X - alone.Position.X), 0, 1e-9);
            Assert.InRange(Math.Abs(over.Velocity.X - alone.Velocity.X), 0, 1e-9);
        }
    }

    /// <summary>A ball rolls onto a conveyor, or a disc that spins, set into the turf: it slips there, with the spin that it had.</summary>
    [Theory]
    [InlineData(1.5, 0)]
    [InlineData(0, 0.3)]
    public void A_surface_that_moves_makes_a_rolling_ball_slip(double speed, double spin)
    {
        var belt = new Obstacle
        {
            Shape = new BoxShape(new Vector3d(6, -0.25, 0), new Vector3d(5, 0.25, 50)),
            Surface = SurfaceMaterial.DryTurf,
            Velocity = new Vector3d(0, 0, speed),
            Spin = new Vector3d(0, spin, 0),
            Pivot = new Vector3d(6, 0, 0),
        };
        var simulator = new Simulator(new Scene { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf), Forces = ForceSet.None, Obstacles = [belt] });
        BallState s = simulator.Launch(new Vector3d(0.985, 0.11, 0), new Vector3d(2, 0, 0), new Vector3d(0, 0, -2 / 0.11));
        var log = new StepLog();
        simulator.Step(ref s, Step, log);
        Assert.Equal(MotionState.Sliding, s.Motion);
        BallEvent slide = Assert.Single(log.Events.Span.ToArray());
        Assert.Equal(BallEventKind.Slide, slide.Kind);
        double timeOver = s.Time - slide.Time;
        Assert.InRange(timeOver, 0.0020, 0.0030);
        Assert.InRange(s.Velocity.Z / (0.5 * 9.81 * timeOver), 0.999, 1.001);
        Assert.InRange(s.Spin.X / (-1.5 / 0.11 * 0.5 * 9.81 * timeOver), 0.999, 1.001);
    }

    /// <summary>A ball slides along a wall, and the wind stops pressing it there; the wall has a seam just where its load ends. It leaves the wall, and is not hit by it.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_seam_where_a_wall_stops_bearing_is_as_a_wall_without_one(bool bodies)
    {
        BallState alone = Along(null, bodies, out string events);
        for (int i = 0; i < 200; i++)
        {
            BallState over = Along(-3.25702 - (5e-7 * i), bodies, out string told);
            Assert.Equal(events, told);
            Assert.InRange(Vector3d.Distance(over.Position, alone.Position), 0, 1e-9);
        }
    }

    /// <summary>Wind presses a ball onto a wall of bodies that stand still. It has just hit the wall, and crosses a seam: the first body is behind it, and no contact any more.</summary>
    [Fact]
    public void A_standing_body_that_was_hit_is_left_at_the_seam()
    {
        BallState alone = Hit(null, out long evaluations);
        for (int i = 0; i < 20; i++)
        {
            BallState over = Hit(-0.05 - (0.005 * i), out long spent);
            Assert.Equal(0, Vector3d.Distance(over.Position, alone.Position), 1e-7);
            Assert.InRange(spent, 1, 3 * evaluations);
        }
    }

    private static BallState Hit(double? seam, out long evaluations)
    {
        const double Radius = 0.11;
        const double Step = 0.01;
        SurfaceMaterial material = SurfaceMaterial.DryTurf;
        double end = seam ?? -40;
        var bodies = new KinematicBodies();
        bodies.Add("first", new BoxShape(new Vector3d(Radius + 0.25, 1, 0.5 * (20 + end)), new Vector3d(0.25, 1, 0.5 * (20 - end))), material);
        bodies.Add("second", new BoxShape(new Vector3d(Radius + 0.25, 1, end - 20), new Vector3d(0.25, 1, 20)), material);
        Scene scene = new() { Ball = BallProperties.Tunnel, Air = new Air { Wind = new Vector3d(8, 0, 0) }, Ground = Ground.Of(material), Bodies = bodies };
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(new Vector3d(-0.005, Radius, 0), new Vector3d(0.3, 0, -1), Vector3d.Cross(Vector3d.Up, new Vector3d(0.3, 0, -1)) / Radius);
        var log = new StepLog();
        for (int i = 0; i < 40; i++)
        {
            simulator.Step(ref s, Step, log);
        }

        evaluations = log.Evaluations;
        return s;
    }

    private static BallState Along(double? seam, bool asBodies, out string events)
    {
        const double Radius = 0.08925614023727141;
        SurfaceMaterial material = SurfaceMaterial.Concrete with
        {
            NormalRestitution = 0.77,
            SlidingFriction = 0.8448745337326229,
            RollingResistance = 0.16837158431216415,
            RollingResistancePerSpeed = 0.001,
            TorsionalPatchRadius = 0.006,
        };
        double end = seam ?? -40;
        BoxShape[] walls =
        [
            new(new Vector3d(Radius + 0.25, 1, 0.5 * (20 + end)), new Vector3d(0.25, 1, 0.5 * (20 - end))),
            new(new Vector3d(Radius + 0.25, 1, end - 20), new Vector3d(0.25, 1, 20)),
        ];
        var bodies = new KinematicBodies();
        Scene scene = new()
        {
            Ball = BallProperties.Tunnel with { Radius = Radius, InertiaFactor = 0.4 },
            Air = new Air { Wind = new Vector3d(3.9568399345388854, 0, -2.9499214557178837) },
            Ground = Ground.Of(material),
        };
        foreach (BoxShape wall in asBodies ? walls : [])
        {
            bodies.Add("wall", wall, material);
        }

        scene = asBodies ? scene with { Bodies = bodies } : scene with { Obstacles = [.. walls.Select(wall => new Obstacle { Shape = wall, Surface = material })] };
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(
            new Vector3d(0, Radius, -3.2558656445015814), new Vector3d(0, 0, -7.465530830835643), new Vector3d(-82.37242343276147, 0, 0.07694023929003722));
        var log = new StepLog();
        simulator.Step(ref s, 0.0079, log);
        events = string.Join(' ', log.Events.Span.ToArray().Select(item => item.Kind));
        return s;
    }

    /// <summary>Rolls for five steps; the edge is so far from where the first one ends, m.</summary>
    private static BallState Rolled(double? beyond, bool engine, out int told)
    {
        const double Radius = 0.11;
        Ground turf = Ground.Of(SurfaceMaterial.DryTurf with { RollingResistance = 0, RollingResistancePerSpeed = 0 });
        Scene scene = new() { Ball = BallProperties.Tunnel, Ground = turf, Forces = ForceSet.None };
        const double Speed = 2;
        double edge = (Speed * Step) - (beyond ?? 0);
        var along = new Vector3d(0, 0, 1.5);
        var box = new BoxShape(new Vector3d(edge + 5, 1e-10 - 0.25, 0), new Vector3d(5, 0.25, 50));
        var bodies = new KinematicBodies();
        KinematicBody? body = beyond is null || engine ? null : bodies.Add("tile", box, turf.Material);
        var crate = beyond is null || !engine ? null : new Tile(new EngineCollider("tile", box, turf.Material));
        var simulator = new Simulator(scene with { Bodies = body is null ? null : bodies, EngineColliders = crate });
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(Speed, 0, 0), new Vector3d(0, 0, -Speed / Radius));
        var log = new StepLog();
        for (int i = 0; i < 5; i++)
        {
            body?.MoveTo(s.Time * along, along, s.Time);
            crate?.MoveTo(s.Time * along, along, s.Time);
            simulator.Step(ref s, Step, log);
        }

        told = log.Events.Span.ToArray().Count(item => item.Kind is BallEventKind.Pinned or BallEventKind.Impact or BallEventKind.ContactEnd);
        return s;
    }

    /// <summary>An engine with one tile.</summary>
    private sealed class Tile(EngineCollider collider) : IEngineColliders
    {
        public double Time { get; private set; }

        public double MaximumSpeed { get; private set; }

        public void Cast(in SphereCast cast, EngineHits hits) => hits.Add(collider);

        public void MoveTo(in Vector3d position, in Vector3d velocity, double time)
        {
            Time = time;
            MaximumSpeed = velocity.Length;
            collider.MoveTo(position, Quaterniond.Identity, velocity, Vector3d.Zero);
        }
    }
}
