namespace FootballPhysics.Tests.Things;

/// <summary>Zones report the ball, and change nothing else.</summary>
public sealed class ZoneTests
{
    private const double Radius = 0.11;

    private static Zone Box(string name, double from, double to, ZonePart of) => new()
    {
        Name = name,
        Of = of,
        Shape = new BoxShape(new Vector3d(0, 2, 0.5 * (from + to)), new Vector3d(4, 4, 0.5 * Math.Abs(to - from))),
    };

    private static string[] Play(Scene scene, Vector3d position, Vector3d velocity, double dt, int steps, out BallState end)
    {
        var simulator = new Simulator(scene);
        var log = new StepLog();
        end = simulator.Launch(position, velocity, Vector3d.Zero);
        for (int i = 0; i < steps; i++)
        {
            simulator.Step(ref end, dt, log);
        }

        return [.. log.Events.Span.ToArray().Where(IsOfZone).Select(e => $"{e.Kind} {simulator.NameOf(e.ColliderIndex)} {e.Time:F9} {e.Position.Z:F9}")];
    }

    private static bool IsOfZone(BallEvent e) => e.Kind is BallEventKind.EnterZone or BallEventKind.ExitZone;

    /// <summary>In vacuum without gravity the times are known: z = −20 t.</summary>
    [Theory]
    [InlineData(0.01)]
    [InlineData(0.6)]
    public void A_straight_path_enters_and_leaves_at_the_exact_times(double dt)
    {
        Scene scene = Scene.Vacuum with
        {
            Gravity = 0,
            Zones = [Box("near", -2, -4, ZonePart.Ball), Box("far", -3, -5, ZonePart.Center)],
        };
        string[] told = Play(scene, new Vector3d(0, 2, 0), new Vector3d(0, 0, -20), dt, (int)Math.Round(0.6 / dt), out _);
        Assert.Equal(
            [
                "EnterZone near 0.094500000 -1.890000000",
                "EnterZone far 0.150000000 -3.000000000",
                "ExitZone near 0.205500000 -4.110000000",
                "ExitZone far 0.250000000 -5.000000000",
            ],
            told);
    }

    /// <summary>A thin sheet within one step: in and out.</summary>
    [Fact]
    public void A_thin_zone_is_crossed_within_a_step()
    {
        Scene scene = Scene.Vacuum with { Gravity = 0, Zones = [Box("sheet", -2, -2.001, ZonePart.Center)] };
        string[] told = Play(scene, new Vector3d(0, 2, 0), new Vector3d(0, 0, -100), 0.1, 1, out _);
        Assert.Equal(["EnterZone sheet 0.020000000 -2.000000000", "ExitZone sheet 0.020010000 -2.001000000"], told);
    }

    /// <summary>The path bends into a sphere and out of it again between the ends of one step.</summary>
    [Fact]
    public void The_top_of_an_arc_is_found_between_two_steps()
    {
        // y = 2 + 4.905 t − ½ 9.81 t²: the top is 1.22625 m higher, at 0.5 s.
        Scene scene = Scene.Vacuum with { Zones = [new Zone { Shape = new PlaneShape(new Vector3d(0, 3.2, 0), new Vector3d(0, -1, 0)), Of = ZonePart.Center }] };
        string[] told = Play(scene, new Vector3d(0, 2, 0), new Vector3d(0, 4.905, -1), 1.0, 1, out _);
        double half = Math.Sqrt(2 * 0.02625 / 9.81);
        Assert.Equal([$"EnterZone zone {0.5 - half:F9} {-(0.5 - half):F9}", $"ExitZone zone {0.5 + half:F9} {-(0.5 + half):F9}"], told);
    }

    [Fact]
    public void A_ball_that_is_placed_in_a_zone_has_not_entered_it_and_leaves_it()
    {
        Scene scene = Scene.Measured with { Zones = [new Zone { Name = "spot", Shape = new SphereShape(Vector3d.Zero, 1), Of = ZonePart.Center }] };
        string[] told = Play(scene, new Vector3d(0, Radius, 0), new Vector3d(0, 0, -5), 0.02, 40, out _);
        Assert.StartsWith("ExitZone spot", Assert.Single(told), StringComparison.Ordinal);
    }

    /// <summary>A ball that rolls or lies on a surface touches a zone that ends there, and is not in it.</summary>
    [Fact]
    public void A_ball_on_the_border_of_a_zone_is_outside_and_does_not_tremble()
    {
        Scene scene = Scene.Measured with { Zones = [new Zone { Shape = new PlaneShape(Vector3d.Zero, Vector3d.Up) }] };
        Assert.Empty(Play(scene, new Vector3d(0, Radius, 0), new Vector3d(1, 0, -3), 0.01, 500, out BallState end));
        Assert.Equal(MotionState.Rest, end.Motion);
        Assert.False(scene.Zones[0].Holds(end.Position, Radius));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Zones_change_no_path_and_no_other_event(bool measured)
    {
        Scene plain = (measured ? Scene.Measured : Scene.Published) with
        {
            Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) }],
            Obstacles = [new Obstacle { Shape = new BoxShape(new Vector3d(3, 0, -5), new Vector3d(1, 2, 0.3)) }],
        };
        Scene zoned = plain with { Zones = [Box("a", -1, -6, ZonePart.Ball), Box("b", -11, -13, ZonePart.Center), new Zone { Name = "turf", Shape = new PlaneShape(new Vector3d(0, 0.3, 0), Vector3d.Up) }] };
        int zones = 0;
        for (int i = 0; i < 40; i++)
        {
            var random = new Random(i);
            double At(double low, double high) => low + ((high - low) * random.NextDouble());
            var velocity = new Vector3d(At(-2, 6), At(0, 6), -At(4, 25));
            var first = new Simulator(plain);
            var second = new Simulator(zoned);
            var log = new StepLog();
            var other = new StepLog();
            BallState s = first.Launch(new Vector3d(0, Radius, 0), velocity, new Vector3d(At(-50, 50), 0, 0));
            BallState t = second.Launch(s.Position, velocity, s.Spin);
            for (int k = 0; k < 150; k++)
            {
                first.Step(ref s, 1.0 / 60, log);
                second.Step(ref t, 1.0 / 60, other);
                Assert.Equal(s, t);
            }

            Assert.Equal(log.Events.Span.ToArray(), [.. other.Events.Span.ToArray().Where(e => !IsOfZone(e))]);
            Assert.Equal(log.Steps, other.Steps);
            zones += other.Events.Span.ToArray().Count(IsOfZone);
        }

        Assert.True(zones > 200, $"{zones} events");
    }

    [Fact]
    public void A_look_ahead_tells_what_the_steps_tell()
    {
        Scene scene = Pitch.Standard.On(Scene.Measured) with { Zones = [Box("a", -2, -6, ZonePart.Ball), Box("b", -9, -9.5, ZonePart.Center)] };
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(0, 3, -15), new Vector3d(20, 0, 0));
        var path = new Trajectory();
        simulator.LookAhead(in s, new LookAheadRequest { Duration = 2, TimeStep = 0.01 }, path);
        var log = new StepLog();
        simulator.Run(ref s, 0.01, 2, StopAt.Time, log);
        Assert.Equal(log.Events.Span.ToArray(), path.Events.Span.ToArray());
        Assert.Equal(4, log.Events.Span.ToArray().Count(IsOfZone));
    }

    /// <summary>A body that is put over the ball pushes it across a border: reported once.</summary>
    [Fact]
    public void A_push_across_a_border_is_reported_once()
    {
        var bodies = new KinematicBodies();
        KinematicBody block = bodies.Add("block", new BoxShape(Vector3d.Zero, new Vector3d(0.5, 0.5, 0.5)));
        Scene scene = Scene.Measured with { Bodies = bodies, Zones = [new Zone { Name = "line", Shape = new PlaneShape(new Vector3d(0, 0, -0.2), new Vector3d(0, 0, 1)), Of = ZonePart.Center }] };
        block.MoveTo(new Vector3d(0, 0.5, 5), Vector3d.Zero, 0);
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState s = simulator.Launch(new Vector3d(0, Radius, 0), Vector3d.Zero, Vector3d.Zero);
        simulator.Step(ref s, 0.01, log);
        block.MoveTo(new Vector3d(0, 0.5, 0.1), Vector3d.Zero, s.Time);
        for (int i = 0; i < 10; i++)
        {
            simulator.Step(ref s, 0.01, log);
        }

        BallEvent told = Assert.Single(log.Events.Span.ToArray(), IsOfZone);
        Assert.Equal((BallEventKind.EnterZone, 0.01), (told.Kind, told.Time));
        Assert.Equal(-0.2, told.Position.Z, 9);
        Assert.True(scene.Zones[0].Holds(s.Position, Radius));
    }

    [Fact]
    public void Zones_keep_their_names_and_numbers_among_other_things()
    {
        Scene scene = Pitch.Standard.On(Scene.Measured) with { Zones = [Box("a", -1, -2, ZonePart.Ball), Box("b", -1, -2, ZonePart.Ball)] };
        var simulator = new Simulator(scene);
        Assert.Equal(["goal", "a", "b"], simulator.Names.Skip(simulator.Names.Count - 3));
        Assert.Equal(["ground", "a", "b"], new Simulator(Scene.Measured with { Zones = scene.Zones }).Names);
    }

    [Fact]
    public void The_scene_hash_knows_zones_and_is_as_before_without_them()
    {
        ulong Of(params Zone[] zones) => new Simulator(Scene.Measured with { Zones = zones }).SceneHash;
        ulong[] hashes = [Of(), Of(Box("a", -1, -2, ZonePart.Ball)), Of(Box("a", -1, -2, ZonePart.Center)), Of(Box("a", -1, -2.5, ZonePart.Ball))];
        Assert.Equal(4, hashes.Distinct().Count());
        Assert.Equal(new Simulator(Scene.Measured).SceneHash, hashes[0]);
    }

    [Fact]
    public void Wrong_zones_are_refused_by_field_value_and_range()
    {
        static string Refusal(params Zone[] zones) => Assert.ThrowsAny<ArgumentException>(() => new Simulator(Scene.Measured with { Zones = zones })).Message;
        Zone zone = Box("a", -1, -2, ZonePart.Ball);
        Assert.StartsWith("zones[1].name is \"a\"; allowed: a name that no other zone has.", Refusal(zone, Box("a", -3, -4, ZonePart.Ball)), StringComparison.Ordinal);
        Assert.StartsWith("zones[0].of is 7; allowed: Ball | Center.", Refusal(zone with { Of = (ZonePart)7 }), StringComparison.Ordinal);
        Assert.StartsWith("zones[0].name is null", Refusal(zone with { Name = null! }), StringComparison.Ordinal);
        Assert.StartsWith("zones[0].shape is null", Refusal(zone with { Shape = null! }), StringComparison.Ordinal);
        Assert.StartsWith("zones[0] is null", Refusal([null!]), StringComparison.Ordinal);
    }

    /// <summary>Two balls that meet in a zone, in one that presses: events of each ball, in order of time.</summary>
    [Fact]
    public void Balls_of_a_group_report_each_for_itself()
    {
        Scene scene = Scene.Measured with { Zones = [Box("a", 1, -1, ZonePart.Center)] };
        var simulator = new Simulator(scene);
        var group = new BallGroup(simulator, 3);
        var plain = new BallGroup(new Simulator(Scene.Measured), 3);
        BallState[] Launch() =>
        [
            simulator.Launch(new Vector3d(0, Radius, 3), new Vector3d(0, 0, -6), Vector3d.Zero),
            simulator.Launch(new Vector3d(0.05, Radius, 0), Vector3d.Zero, Vector3d.Zero),
            simulator.Launch(new Vector3d(1, Radius, -3), new Vector3d(0, 3, 4), Vector3d.Zero),
        ];
        BallState[] states = Launch();
        BallState[] others = Launch();
        var log = new StepLog();
        var other = new StepLog();
        for (int i = 0; i < 300; i++)
        {
            bool[] before = [.. states.Select(s => scene.Zones[0].Holds(s.Position, Radius))];
            log.Clear();
            group.Step(states, 0.01, log);
            plain.Step(others, 0.01, other);
            Assert.Equal(others, states);
            for (int ball = 0; ball < 3; ball++)
            {
                int change = log.Events.Span.ToArray().Where(e => e.Ball == ball).Sum(e => e.Kind == BallEventKind.EnterZone ? 1 : e.Kind == BallEventKind.ExitZone ? -1 : 0);
                Assert.Equal(scene.Zones[0].Holds(states[ball].Position, Radius) ? 1 : 0, (before[ball] ? 1 : 0) + change);
            }

            Assert.Equal(log.Events.Span.ToArray().OrderBy(e => e.Time).Select(e => e.Time), log.Events.Span.ToArray().Select(e => e.Time));
        }
    }
}
