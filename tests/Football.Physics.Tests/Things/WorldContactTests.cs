using FootballPhysics.Contacts;
using FootballPhysics.Simulation;
using FootballPhysics.State;

namespace FootballPhysics.Tests.Things;

/// <summary>What becomes of a ball at a contact: one contact at a time, without air.</summary>
public sealed class WorldContactTests
{
    private const double Radius = 0.11;
    private const double Mass = 0.43;
    private const double Slowest = 0.2;

    private static readonly SurfaceMaterial Smooth = SurfaceMaterial.GoalFrame with { NormalRestitution = 0.5, RestitutionSpeedScale = 1e9, ImpactFriction = 0, SlidingFriction = 0.5 };

    private static readonly Scene Still = Scene.Default with
    {
        Gravity = 9.81,
        Ground = new Ground
        {
            Material = SurfaceMaterial.DryTurf with
            {
                NormalRestitution = 0.5,
                RestitutionSpeedScale = 1e9,
                ImpactFriction = 0,
                TorsionalPatchRadius = 0,
            },
            MinimumBounceSpeed = Slowest,
        },
        Forces = new ForceSet { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None },
    };

    /// <summary>Placed on level ground a ball is carried up to the speed of the slowest bounce, either way; on a thing, where it does not come closer.</summary>
    [Theory]
    [InlineData("ground", 0, true)]
    [InlineData("ground", 0.199, true)]
    [InlineData("ground", 0.2, false)]
    [InlineData("ground", -0.199, true)]
    [InlineData("ground", -0.2, false)]
    [InlineData("table", 0, true)]
    [InlineData("table", 0.199, true)]
    [InlineData("table", 0.2, false)]
    [InlineData("table", -1e-3, false)]
    public void A_ball_that_is_placed_is_carried_where_it_neither_bounces_nor_leaves(string name, double off, bool carried)
    {
        var simulator = new Simulator(Still with { Obstacles = [Table()] });
        double top = name == "table" ? 2 : 0;
        BallState s = simulator.Launch(new Vector3d(0, top + Radius, 0), new Vector3d(3, off, 1), new Vector3d(1, 2, 3));
        Assert.Equal(carried ? MotionState.Sliding : MotionState.Airborne, s.Motion);
        Assert.Equal(new Vector3d(3, carried ? 0 : off, 1), s.Velocity);
        Assert.Equal(new Vector3d(0, top + Radius, 0), s.Position);
        Assert.InRange((s.Spin - new Vector3d(1, 2, 3)).Length, 0, 1e-14);
        Assert.Equal(carried ? name : "none", carried ? simulator.NameOf((int)s.Carrier) : "none");

        // With the spin of rolling, ω = n × v/r, it rolls; out of touch, or on a wall, nothing carries it.
        BallState rolling = simulator.Launch(new Vector3d(0, top + Radius, 0), new Vector3d(3, off, 1), new Vector3d(1 / Radius, 7, -3 / Radius));
        Assert.Equal(carried ? MotionState.Rolling : MotionState.Airborne, rolling.Motion);
        Assert.Equal(MotionState.Airborne, simulator.Launch(new Vector3d(0, top + Radius + 1e-9, 0), new Vector3d(3, off, 1), default).Motion);
        Assert.Equal(MotionState.Airborne, simulator.Launch(new Vector3d(0, 1, 1 + Radius), new Vector3d(3, off, 0), default).Motion);
        Assert.Equal(MotionState.Airborne, simulator.Launch(new Vector3d(0, 1.9 - Radius, 0), new Vector3d(3, 0, 0), default).Motion);
    }

    /// <summary>On a dome the ball follows only up to v² = g R: faster nothing presses it there.</summary>
    [Fact]
    public void A_dome_carries_what_is_not_too_fast_for_it()
    {
        var simulator = new Simulator(Still with { Obstacles = [new Obstacle { Name = "dome", Shape = new SphereShape(new Vector3d(0, 1, 0), 1 - Radius), Surface = Smooth }] });
        double fastest = Math.Sqrt(9.81);
        Assert.Equal(MotionState.Sliding, simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(fastest - 1e-3, 0, 0), default).Motion);
        Assert.Equal(MotionState.Airborne, simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(fastest + 1e-3, 0, 0), default).Motion);
    }

    [Fact]
    public void An_impact_leaves_with_what_the_restitution_says_and_is_told()
    {
        var table = new Asked(Still);
        BallState s = table.Ball(new Vector3d(1, Radius - 1e-8, 2), new Vector3d(3, -4, 1), new Vector3d(5, 6, 7));
        s.Branch = DragBranch.NoSpin;
        var log = new StepLog { StopAt = StopAt.Impact };
        var run = new StepRun(0, 0, log) { Part = 1 };
        table.Contact.Impact(ref s, table.Of("ground"), ref run);
        Assert.Equal(new Vector3d(1, Radius, 2), s.Position);
        Assert.InRange((s.Velocity - new Vector3d(3, 2, 1)).Length, 0, 1e-6);
        Assert.Equal((MotionState.Airborne, DragBranch.Unknown, 0L), (s.Motion, s.Branch, s.Carrier));
        Assert.Equal((1, 0.0, 1), (run.Spent.Quick, run.Part, run.Spent.AllImpacts));
        BallEvent told = log.Events[0];
        Assert.Equal((BallEventKind.Impact, new Vector3d(3, -4, 1), s.Velocity), (told.Kind, told.VelocityBefore, told.Velocity));
        Assert.Equal("ground", table.Simulator.NameOf(told.ColliderIndex));
        Assert.Equal((1, 0L, true), (log.Events.Count, log.UnreportedImpacts, log.Halted));

        // Slower than the slowest bounce it stays, and slides; what climbs there already was rounding.
        foreach ((double down, MotionState motion) in new[] { (0.41, MotionState.Airborne), (0.39, MotionState.Sliding), (-0.1, MotionState.Sliding) })
        {
            s = table.Ball(new Vector3d(0, Radius, 0), new Vector3d(3, -down, 0), default);
            log = new StepLog();
            run = new StepRun(0, 0, log);
            table.Contact.Impact(ref s, table.Of("ground"), ref run);
            Assert.Equal(motion, s.Motion);
            Assert.Equal(motion == MotionState.Airborne ? down / 2 : 0, s.Velocity.Y, 1e-9);
            Assert.False(log.Halted);
            Assert.Equal(motion == MotionState.Airborne ? 1 : 2, log.Events.Count);
        }
    }

    /// <summary>m (v − v') goes to what has a mass, in the steps of a game alone; a step that is to end there ends.</summary>
    [Theory]
    [InlineData(true, true)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    public void What_is_hit_gets_the_opposite_impulse(bool pushes, bool halts)
    {
        var table = new Asked(Still with { Obstacles = [new Obstacle { Name = "bin", Shape = new BoxShape(new Vector3d(-1, 5, 0), new Vector3d(1, 1, 1)), Surface = Smooth, Mass = 2 }] });
        BallState s = table.Ball(new Vector3d(Radius, 5, 0), new Vector3d(-6, 1, 0), default);
        var log = new StepLog { Pushes = pushes, HaltsAtPush = halts };
        var run = new StepRun(0, 0, log);
        int bin = table.Of("bin");
        table.Contact.Impact(ref s, bin, ref run);

        // J = (1 + e) u/(1/m + 1/M)
        double impulse = 1.5 * 6 / ((1 / Mass) + 0.5);
        Assert.Equal(-6 + (impulse / Mass), s.Velocity.X, 1e-7);
        Assert.Equal(pushes ? -impulse / 2 : 0, table.World.Colliders[bin].Velocity.X, 1e-7);
        Assert.Equal(pushes && halts, log.Halted);
    }

    /// <summary>A bat at 1 m/s meets a ball at 2 m/s again and again: each time it leaves at 1 + ½ · 3. The ninth time in a step it is squeezed, but only if the bat leaves it no room.</summary>
    [Theory]
    [InlineData(0.3, false)]
    [InlineData(0.2, true)]
    [InlineData(0, false)]
    public void Batted_again_it_obeys_the_same_law_until_it_is_squeezed(double length, bool squeezes)
    {
        var wall = new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d((2 * Radius) + 0.25, 0, 0), new Vector3d(-1, 0, 0)), Surface = Smooth };
        var bat = new Obstacle { Name = "bat", Shape = new BoxShape(new Vector3d(-1, 5, 0), new Vector3d(1, 5, 5)), Surface = Smooth, Velocity = new Vector3d(1, 0, 0) };
        var table = new Asked(Still with { Obstacles = length == 0.3 ? [bat] : [bat, wall] });
        var log = new StepLog();
        var run = new StepRun(length + 0.1, 0, log) { Spent = new StepBudget { Arrival = 2 } };
        BallState s = default;
        for (int k = 1; k <= 10; k++)
        {
            s = table.Ball(new Vector3d(Radius + (0.01 * k), 5, 0), new Vector3d(-2, 5, 0), default);
            s.Time = 0.01 * k;
            table.Contact.Impact(ref s, table.Of("bat"), ref run);
            Assert.Equal(squeezes && k >= 9 ? MotionState.Pinned : MotionState.Airborne, s.Motion);

            // Squeezed it keeps the speed of its arrival: 2 m/s, and 2 m/s is what the bat gives at most.
            Vector3d law = new(2.5, 5, 0);
            Assert.InRange((s.Velocity - (squeezes && k >= 9 ? 2 / law.Length * law : law)).Length, 0, 1e-6);
        }

        Assert.Equal(squeezes ? BallEventKind.Pinned : BallEventKind.Impact, log.Events[log.Events.Count - 1].Kind);
        if (squeezes)
        {
            Assert.Equal("bat", table.Simulator.NameOf((int)s.Carrier));
            table.Contact.EndSqueeze(ref s, ref run);
            Assert.Equal((MotionState.Airborne, BallEventKind.Pinned, -1), (s.Motion, log.Events[log.Events.Count - 1].Kind, log.Events[log.Events.Count - 1].ColliderIndex));
        }
    }

    /// <summary>After the tenth impact of an instant the rest is without restitution, at all contacts together; and not told one by one.</summary>
    [Theory]
    [InlineData(9, 5.0)]
    [InlineData(10, 0.0)]
    public void The_eleventh_impact_of_an_instant_is_without_restitution(int before, double away)
    {
        var table = new Asked(Still with { Obstacles = [Wall()] });
        BallState s = table.Ball(new Vector3d(Radius, 3, 0), new Vector3d(-10, 2, 0), default);
        var log = new StepLog();
        var run = new StepRun(0, 0, log) { Spent = new StepBudget { Quick = before } };
        table.Contact.Impact(ref s, table.Of("wall"), ref run);
        Assert.Equal(away, s.Velocity.X, 1e-6);
        Assert.Equal(2, s.Velocity.Y, 1e-6);
        Assert.Equal(MotionState.Airborne, s.Motion);
        Assert.Equal((before + 1, away > 0 ? 1 : 0, away > 0 ? 0L : 1L), (run.Spent.Quick, log.Events.Count, log.UnreportedImpacts));

        // In the corner with the ground the ground bears it, and carries it.
        s = table.Ball(new Vector3d(Radius, Radius, 0), new Vector3d(-10, -2, 3), default);
        run.Spent.Quick = 10;
        table.Contact.Impact(ref s, table.Of("wall"), ref run);
        Assert.InRange((s.Velocity - new Vector3d(0, 0, s.Velocity.Z)).Length, 0, 1e-6);
        Assert.InRange(s.Velocity.Z, 1, 3);
        Assert.Equal("ground", table.Simulator.NameOf((int)s.Carrier));

        // The fourth time in one step there is no answer any more; but objects that stand still never squeeze a ball.
        run.Spent.MergedImpacts = 3;
        run.Spent.Quick = 10;
        s.Velocity = new Vector3d(-10, 0, 0);
        table.Contact.Impact(ref s, table.Of("wall"), ref run);
        Assert.NotEqual(MotionState.Pinned, s.Motion);
        Assert.InRange(s.Velocity.Length, 0, 1e-6);
    }

    /// <summary>In a crowd of events what trembles slower than the slowest bounce is not told.</summary>
    [Theory]
    [InlineData(13, 0.1, 1)]
    [InlineData(14, 0.1, 0)]
    [InlineData(14, 0.2, 1)]
    [InlineData(14, 0.19, 0)]
    public void A_tremble_is_not_told(int events, double speed, int told)
    {
        var table = new Asked(Still with { Obstacles = [Wall()] });
        BallState s = table.Ball(new Vector3d(Radius, 3, 0), new Vector3d(-speed, 2, 0), default);
        var log = new StepLog();
        var run = new StepRun(0, 0, log);
        for (int k = 0; k < events; k++)
        {
            BallState other = s;
            table.Contact.Leave(ref other, default, default, ref run);
        }

        table.Contact.Impact(ref s, table.Of("wall"), ref run);
        Assert.Equal((events + told, 1L - told), (log.Events.Count, log.UnreportedImpacts));
    }

    /// <summary>A ball that something carries and that something else hits.</summary>
    [Theory]
    [InlineData(0.25, MotionState.Airborne, 0.25)]
    [InlineData(0.2, MotionState.Airborne, 0.2)]
    [InlineData(0.15, MotionState.Sliding, 0)]
    [InlineData(-1e-10, MotionState.Sliding, 0)]
    [InlineData(-0.3, MotionState.Sliding, 0)]
    [InlineData(-2, MotionState.Airborne, 1)]
    public void Struck_it_keeps_its_carrier_unless_the_impulse_lifts_it(double up, MotionState motion, double left)
    {
        var table = new Asked(Still);
        BallState s = table.Simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(3, 0, 0), default);
        s.ClearUntil = 5;
        var log = new StepLog();
        table.Simulator.Struck(ref s, new Vector3d(4, up, 0), new Vector3d(1, 2, 3), new Vector3d(1, 0, 0), log);
        Assert.Equal(motion, s.Motion);
        Assert.InRange((s.Velocity - new Vector3d(4, left, 0)).Length, 0, 1e-6);
        Assert.InRange((s.Spin - new Vector3d(1, 2, 3)).Length, 0, 1e-12);
        Assert.Equal((0.0, DragBranch.Unknown), (s.ClearUntil, s.Branch));
        Assert.Equal(up >= Slowest ? BallEventKind.ContactEnd : up < -0.1 ? BallEventKind.Impact : BallEventKind.Slide, log.Events[0].Kind);
    }

    /// <summary>Squeezed it stays squeezed, at the speed of the impact: on what carries it if it touches that, otherwise where it is.</summary>
    [Theory]
    [InlineData(0.0, 0.0)]
    [InlineData(0.01, 0.5)]
    public void Struck_while_it_is_squeezed_it_stays_squeezed(double above, double up)
    {
        var table = new Asked(Still);
        var log = new StepLog();
        BallState s = table.Simulator.Launch(new Vector3d(0, Radius, 0), default, default);
        s.Motion = MotionState.Pinned;
        s.Position = new Vector3d(0, Radius + above, 0);
        s.SetGroundSpin(new Vector3d(0, 5, 0));
        table.Simulator.Struck(ref s, new Vector3d(1, 0.5, 2), new Vector3d(9, 9, 9), new Vector3d(1, 0, 0), log);
        Assert.Equal((MotionState.Pinned, Radius + above, new Vector3d(1, up, 2), new Vector3d(0, 5, 0)), (s.Motion, s.Position.Y, s.Velocity, s.Spin));
        Assert.Equal(0, log.Events.Count);
    }

    /// <summary>Let go by a pile, it goes on by what bears it: told where that is another motion.</summary>
    [Theory]
    [InlineData(MotionState.Rolling, 1.0, 0.0, true, MotionState.Rolling, null)]
    [InlineData(MotionState.Rolling, 1.0, 0.5, true, MotionState.Sliding, BallEventKind.Slide)]
    [InlineData(MotionState.Sliding, 1.0, 0.0, true, MotionState.Rolling, BallEventKind.Roll)]
    [InlineData(MotionState.Sliding, 0.04, 0.0, true, MotionState.Rolling, BallEventKind.Roll)]
    [InlineData(MotionState.Rest, 0.04, 0.0, true, MotionState.Rolling, BallEventKind.Roll)]
    [InlineData(MotionState.Rest, 0.04, 0.0, false, MotionState.Airborne, BallEventKind.ContactEnd)]
    [InlineData(MotionState.Rolling, 1.0, 0.0, false, MotionState.Airborne, BallEventKind.ContactEnd)]
    [InlineData(MotionState.Rolling, 0.04, 0.0, false, MotionState.Airborne, BallEventKind.ContactEnd)]
    [InlineData(MotionState.Airborne, 1.0, 0.0, false, MotionState.Airborne, null)]
    [InlineData(MotionState.Pinned, 1.0, 0.0, false, MotionState.Airborne, BallEventKind.Pinned)]
    public void A_pile_lets_a_ball_go(MotionState before, double speed, double slip, bool borne, MotionState after, BallEventKind? told)
    {
        var table = new Asked(Still);
        var log = new StepLog();
        BallState s = table.Simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(speed, 0, 0), default);
        s.Motion = before;
        s.ClearUntil = 5;
        s.SetGroundSpin(new Vector3d(0, 3, -(speed + slip) / Radius));
        table.Simulator.Pile.Release(ref s, borne ? 0 : -1, log);
        Assert.Equal((after, 0.0, 0L), (s.Motion, s.ClearUntil, s.Carrier));
        Assert.InRange((s.Spin - new Vector3d(0, 3, -(speed + slip) / Radius)).Length, 0, 1e-12);
        Assert.Equal(told is { } kind ? [kind] : [], log.Events.Span.ToArray().Select(item => item.Kind));
        Simulator simulator = table.Simulator;
        simulator.Validate(in s);
    }

    /// <summary>Along the ground up a steep wall, too slowly to bounce: neither off the ground nor into the wall.</summary>
    [Fact]
    public void A_rolling_ball_against_a_steep_wall_stays_on_the_ground()
    {
        Vector3d n = new Vector3d(1, 0.5, 0).Normalized();
        var table = new Asked(Still with { Obstacles = [new Obstacle { Name = "lean", Shape = new PlaneShape(default, n), Surface = Smooth }] });
        double x = (Radius - (Radius * n.Y)) / n.X;
        BallState s = table.Ball(new Vector3d(x, Radius, 0), new Vector3d(-0.2, 0, 1), default);
        s.Motion = MotionState.Sliding;
        s.Carrier = table.Of("ground") + table.World.FirstCollider;
        s.SetGroundSpin(new Vector3d(1, 2, 3));
        var log = new StepLog();
        var run = new StepRun(0, 0, log);
        table.Contact.Impact(ref s, table.Of("lean"), ref run);
        Assert.Equal(MotionState.Sliding, s.Motion);
        Assert.Equal("ground", table.Simulator.NameOf((int)s.Carrier));
        Assert.Equal(0, s.Velocity.Y, 1e-12);
        Assert.True(Vector3d.Dot(s.Velocity, in n) >= -1e-9, $"it goes into the wall at {s.Velocity}");
        Assert.Equal(1, s.Velocity.Z, 1e-9);
    }

    [Fact]
    public void Rolling_sliding_leaving_and_rest_are_told_once_with_what_they_change()
    {
        var table = new Asked(Still);
        BallState s = table.Simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(2, 0, -1), new Vector3d(1, 7, 3));
        var log = new StepLog();
        var run = new StepRun(0, 0, log) { Part = 1 };
        table.Contact.StartRolling(ref s, ref run);
        Assert.Equal(MotionState.Rolling, s.Motion);
        Assert.InRange((s.Spin - new Vector3d(-1 / Radius, 7, -2 / Radius)).Length, 0, 1e-12);
        table.Contact.StartSliding(ref s, ref run);
        Assert.Equal(MotionState.Sliding, s.Motion);
        s.Branch = DragBranch.NoSpin;
        table.Contact.Leave(ref s, new Vector3d(1, 2, 3), new Vector3d(4, 5, 6), ref run);
        Assert.Equal((MotionState.Airborne, 0.0, DragBranch.Unknown, new Vector3d(1, 2, 3)), (s.Motion, run.Part, s.Branch, s.Velocity));
        Assert.InRange((s.Spin - new Vector3d(4, 5, 6)).Length, 0, 1e-12);
        s = table.Simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(1e-3, 0, 0), default);
        table.Contact.Rest(ref s, ref run);
        Assert.Equal((MotionState.Rest, default, default, false), (s.Motion, s.Velocity, s.Spin, log.Halted));
        log.StopAt = StopAt.Rest;
        table.Contact.Rest(ref s, ref run);
        Assert.True(log.Halted);
        Assert.Equal([BallEventKind.Roll, BallEventKind.Slide, BallEventKind.ContactEnd, BallEventKind.Rest, BallEventKind.Rest], log.Events.Span.ToArray().Select(item => item.Kind));
        Assert.Equal(["ground", "ground", null, null, null], log.Events.Span.ToArray().Select(item => table.Simulator.NameOf(item.ColliderIndex)));
    }

    /// <summary>Taken up with slip it slides; without, where friction can hold it, it rolls; what slid there at this instant slides on untold.</summary>
    [Fact]
    public void What_is_taken_up_slides_or_rolls()
    {
        var table = new Asked(Still);
        var log = new StepLog();
        var run = new StepRun(0, 0, log);
        BallState s = table.Ball(new Vector3d(0, Radius + 1e-11, 0), new Vector3d(2, 0, 0), default);
        table.Contact.TakeUp(ref s, table.Of("ground"), ref run);
        Assert.Equal((MotionState.Sliding, Radius, 1, 0L), (s.Motion, s.Position.Y, log.Events.Count, log.Evaluations));
        run.Spent.Quick = 1;
        table.Contact.TakeUp(ref s, table.Of("ground"), ref run);
        Assert.Equal(2, log.Events.Count);
        run.Spent.Quick = 2;
        table.Contact.TakeUp(ref s, table.Of("ground"), ref run);
        Assert.Equal(2, log.Events.Count);
        s.SetGroundSpin(new Vector3d(0, 0, -2 / Radius));
        table.Contact.TakeUp(ref s, table.Of("ground"), ref run);
        Assert.Equal((MotionState.Rolling, 3, 1L), (s.Motion, log.Events.Count, log.Evaluations));
        Assert.Equal(BallEventKind.Roll, log.Events[2].Kind);
    }

    /// <summary>Out of the ground: straight up, until it touches; what overlaps by a rounding stays.</summary>
    [Fact]
    public void A_ball_inside_the_ground_is_raised_to_it()
    {
        Vector3d n = new Vector3d(0.3, 1, 0.2).Normalized();
        var tilted = new Asked(Still with { Ground = Still.Ground with { Normal = n } });
        BallState s = tilted.Ball((Radius - 0.05) * n + new Vector3d(0, 0, 0), default, default);
        s.Position = GroundPlace.Raised(tilted.World, s.Position);
        Assert.InRange((s.Position - (((Radius - 0.05) * n) + new Vector3d(0, 0.05 / n.Y, 0))).Length, 0, 1e-12);
        foreach (double over in new[] { 1e-10, -0.01 })
        {
            s = tilted.Ball((Radius - over) * n, default, default);
            Vector3d before = s.Position;
            s.Position = GroundPlace.Raised(tilted.World, s.Position);
            Assert.Equal(before, s.Position);
        }

        var level = new Asked(Still);
        foreach ((double y, double raised) in new[] { (0.05, Radius), (Radius, Radius), (0.2, 0.2) })
        {
            s = level.Ball(new Vector3d(1, y, 2), default, default);
            s.Position = GroundPlace.Raised(level.World, s.Position);
            Assert.Equal(new Vector3d(1, raised, 2), s.Position);
        }
    }

    [Fact]
    public void What_weighs_on_a_surface_is_pressed_there_and_what_a_ceiling_is_over_is_not()
    {
        var table = new Asked(Still with { Obstacles = [Table()] });
        BallState s = table.Ball(new Vector3d(0, 2 + Radius, 0), default, default);
        Assert.True(table.Contact.Load.IsPressed(in s, table.Of("table")));
        s.Position = new Vector3d(0, 1.9 - Radius, 0);
        Assert.False(table.Contact.Load.IsPressed(in s, table.Of("table")));
        s.Position = new Vector3d(0, 1.95, 1 + Radius);
        Assert.False(table.Contact.Load.IsPressed(in s, table.Of("table")));
    }

    private static Obstacle Table() => new() { Name = "table", Shape = new BoxShape(new Vector3d(0, 1.95, 0), new Vector3d(1, 0.05, 1)), Surface = Smooth };

    private static Obstacle Wall() => new() { Name = "wall", Shape = new PlaneShape(default, new Vector3d(1, 0, 0)), Surface = Smooth with { SlidingFriction = 0 } };

    /// <summary>A scene whose contacts are asked one by one.</summary>
    private sealed class Asked
    {
        public Asked(Scene scene)
        {
            Simulator = new Simulator(scene);
            var around = new Surroundings(scene, SceneAir.Of(scene));
            World = around.World;
            Contact = new WorldContact(around, gainsByHops: false);
        }

        public Simulator Simulator { get; }

        public World World { get; }

        public WorldContact Contact { get; }

        public int Of(string name) => Enumerable.Range(0, World.Colliders.Length).First(i => World.NameOf(i + World.FirstCollider) == name);

        public BallState Ball(Vector3d position, Vector3d velocity, Vector3d spin)
        {
            BallState s = new Simulator(Scene.Default with { Ground = Ground.None }).Launch(position, velocity, spin);
            return s;
        }
    }
}
