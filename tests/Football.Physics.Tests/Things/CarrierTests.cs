using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>A ball on a carrier that moves, accelerates or turns, against closed forms: F acts at the contact point, so that only a share of the motion is passed on.</summary>
public sealed class CarrierTests
{
    private const double Radius = 0.11;
    private const double Frame = 1 / 60.0;

    /// <summary>Grips whatever the ball does, and brakes no roll.</summary>
    private static readonly SurfaceMaterial s_rough = SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = 0.5,
        ImpactFriction = 5,
        SlidingFriction = 5,
        RollingResistance = 0,
        RollingResistancePerSpeed = 0,
        TorsionalPatchRadius = 0,
        SpinDamping = 0,
    };

    private static readonly IShape s_slab = new BoxShape(new Vector3d(0, -0.5, 0), new Vector3d(60, 0.5, 60));

    public enum Carrier
    {
        Obstacle,
        Body,
        Engine,
    }

    [Theory]
    [InlineData(Carrier.Obstacle, 2.0 / 3, 1)]
    [InlineData(Carrier.Body, 2.0 / 3, 1)]
    [InlineData(Carrier.Engine, 2.0 / 3, 1)]
    [InlineData(Carrier.Obstacle, 0.4, 1)]
    [InlineData(Carrier.Body, 0.4, 1)]
    [InlineData(Carrier.Body, 2.0 / 3, -2.5)]
    [InlineData(Carrier.Engine, 0.4, 3)]
    public void On_a_turntable_it_rolls_in_circles(Carrier kind, double inertia, double spin)
    {
        var turn = new Vector3d(0, spin, 0);
        Scene scene = Still(inertia);
        PosedCollider? posed = null;
        if (kind == Carrier.Obstacle)
        {
            scene = scene with { Obstacles = [new Obstacle { Shape = s_slab, Surface = s_rough, Spin = turn }] };
        }
        else
        {
            posed = PosedCollider.In(ref scene, s_slab, s_rough, kind == Carrier.Engine);
            posed.MoveTo(default, Quaterniond.Identity, default, turn, 0);
        }

        var simulator = new Simulator(scene);
        var place = new Vector3d(1, Radius, 0);
        var velocity = new Vector3d(0.5, 0, 0);
        Vector3d rolls = Vector3d.Cross(Vector3d.Up, velocity - Vector3d.Cross(turn, place)) / Radius;
        BallState state = simulator.Launch(place, velocity, rolls);
        Play(simulator, ref state, 6, time => posed?.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, spin * time), default, turn, time));

        // v' = k/(1 + k) Ω × v
        double rate = inertia / (1 + inertia) * spin;
        double angle = rate * state.Time;
        var expected = new Vector3d(1 + (0.5 * Math.Sin(angle) / rate), Radius, -0.5 * (1 - Math.Cos(angle)) / rate);
        Near(expected, state.Position, 1e-6);
        Near(0.5 * new Vector3d(Math.Cos(angle), 0, -Math.Sin(angle)), state.Velocity, 1e-6);
    }

    /// <summary>The values that were asked for, which the closed forms of the other tests give too.</summary>
    [Fact]
    public void The_places_are_those_that_were_asked_for()
    {
        Near(new Vector3d(1.844, Radius, -2.172), OnTurntable(), 1e-3);
        Assert.Equal(2.335, Carried(false, [2], 0, out _).X, 1e-3);
        Assert.Equal(1.600, Carried(false, Ramp(), 0, out _).X, 1e-3);
        Assert.Equal(-1.400, Carried(false, Ramp(), -1, out _).X, 1e-3);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_platform_that_sets_off_drags_the_ball_along_by_two_fifths(bool isEngine)
    {
        Vector3d place = Carried(isEngine, [2], 0, out BallState state);
        Near(new Vector3d(Expected([2], 0), Radius, 0), place, 1e-6);

        // Its own velocity, in the world, which rolls without slip.
        Near(new Vector3d(0.8, 0, 0), state.Velocity, 1e-9);
        Near(new Vector3d(0, 0, -(0.8 - 2) / Radius), state.Spin, 1e-7);
        Assert.Equal(MotionState.Rolling, state.Motion);
    }

    [Theory]
    [InlineData(false, 0)]
    [InlineData(true, 0)]
    [InlineData(false, -1)]
    [InlineData(true, -1)]
    public void A_platform_that_accelerates_in_steps_drags_the_ball_along_by_two_fifths(bool isEngine, double velocity) =>
        Near(new Vector3d(Expected(Ramp(), velocity), Radius, 0), Carried(isEngine, Ramp(), velocity, out _), 1e-6);

    /// <summary>The control: rolling friction brings the ball to rest on a belt, and then it moves with that.</summary>
    /// <summary>
    /// The velocity of a turntable jumps in every step, each time in another direction, where the ball all but loses its grip. Friction turns the short slip into the
    /// direction of the push much sooner than a step ends, and the errors of that do not add up.
    /// </summary>
    [Fact]
    public void A_short_slip_that_turns_is_followed_in_long_steps_as_in_short_ones()
    {
        Vector3d coarse = Shaken(1, out long evaluations);
        Vector3d fine = Shaken(64, out _);
        Assert.Equal(0, Vector3d.Distance(coarse, fine), 2e-7);
        Assert.InRange(evaluations, 1, 30 * Shakes);
    }

    private const int Shakes = 120;

    private static Vector3d Shaken(int parts, out long evaluations)
    {
        const double Long = 0.01;
        var bodies = new KinematicBodies();
        SurfaceMaterial surface = s_rough with { SlidingFriction = 0.67 };
        KinematicBody platform = bodies.Add("platform", s_slab, surface);
        var simulator = new Simulator(Still(2.0 / 3) with { Bodies = bodies });
        var turn = new Vector3d(0, 4.7, 0);
        platform.MoveTo(default, Quaterniond.Identity, default, turn, 0);
        var start = new Vector3d(0.9, Radius, 0);
        BallState state = simulator.Launch(start, Vector3d.Cross(turn, start), turn);
        var log = new StepLog();
        Vector3d place = default;
        Vector3d velocity = default;
        const double Gain = 0.03;
        for (int i = 0; i < Shakes; i++)
        {
            double angle = 2.4 * i * i;
            velocity += Gain * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            for (int k = 0; k < parts; k++)
            {
                double since = k * Long / parts;
                platform.MoveTo(place + (since * velocity), Quaterniond.FromAxisAngle(Vector3d.Up, ((i * Long) + since) * turn.Y), velocity, turn, state.Time);
                simulator.Step(ref state, Long / parts, log);
            }

            place += Long * velocity;
        }

        evaluations = log.Evaluations;
        return state.Position;
    }

    [Fact]
    public void On_a_belt_of_constant_speed_it_comes_to_rest_in_the_frame_of_the_belt()
    {
        SurfaceMaterial turf = SurfaceMaterial.DryTurf;
        var simulator = new Simulator(Still(2.0 / 3) with { Obstacles = [new Obstacle { Shape = s_slab, Surface = turf, Velocity = new Vector3d(2, 0, 0) }] });
        BallState state = simulator.Launch(new Vector3d(0, Radius, 0), default, default);
        Play(simulator, ref state, 8, null);
        Near(new Vector3d(2, 0, 0), state.Velocity, 1e-9);
        Near(default, state.Spin, 1e-9);
        Assert.Equal(MotionState.Rest, state.Motion);
    }

    /// <summary>The control: a lift.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_lift_carries_the_ball_up(bool isEngine)
    {
        Scene scene = Still(2.0 / 3);
        var lift = PosedCollider.In(ref scene, s_slab, s_rough, isEngine);
        lift.MoveTo(default, Quaterniond.Identity, default, default, 0);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0.3, Radius, 0), default, default);
        Play(simulator, ref state, 1, time => lift.MoveTo(default, Quaterniond.Identity, default, default, time));
        double begin = state.Time;
        Play(simulator, ref state, 2, time => lift.MoveTo(new Vector3d(0, 0.15 * (time - begin), 0), Quaterniond.Identity, new Vector3d(0, 0.15, 0), default, time));
        Near(new Vector3d(0.3, Radius + (0.15 * (state.Time - begin)), 0), state.Position, 1e-6);
        Near(new Vector3d(0, 0.15, 0), state.Velocity, 1e-9);
    }

    /// <summary>A floor that is suddenly faster makes a rolling ball slip, which is reported once, if the slip outlasts the step; a slip that ends within the step is not.</summary>
    [Theory]
    [InlineData(1.5, true)]
    [InlineData(0.01, false)]
    public void A_jump_of_the_floor_is_reported_as_a_slide_if_it_lasts(double jump, bool lasts)
    {
        Scene scene = Still(2.0 / 3);
        var floor = PosedCollider.In(ref scene, s_slab, s_rough, isEngine: false);
        floor.MoveTo(default, Quaterniond.Identity, default, default, 0);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(0, 0, 1), new Vector3d(1 / Radius, 0, 0));
        Assert.Equal(MotionState.Rolling, state.Motion);
        var log = new StepLog();
        simulator.Step(ref state, 0.01, log);
        Assert.Equal(0, log.Events.Count);
        floor.MoveTo(default, Quaterniond.Identity, new Vector3d(jump, 0, 0), default, state.Time);
        simulator.Step(ref state, 0.01, log);
        Assert.Equal(lasts ? MotionState.Sliding : MotionState.Rolling, state.Motion);
        Assert.Equal(lasts ? 1 : 0, log.Events.Count);
        Assert.True(!lasts || log.Events[0].Kind == BallEventKind.Slide);
    }

    /// <summary>Rolling friction holds a ball that turns with the table where Ω² R/(1 + k) ≤ c₀ g.</summary>
    [Theory]
    [InlineData(Carrier.Obstacle, 0.97, true)]
    [InlineData(Carrier.Obstacle, 1.03, false)]
    [InlineData(Carrier.Body, 0.97, true)]
    [InlineData(Carrier.Body, 1.03, false)]
    [InlineData(Carrier.Engine, 0.97, true)]
    [InlineData(Carrier.Engine, 1.03, false)]
    public void A_turntable_holds_the_ball_up_to_a_radius(Carrier kind, double share, bool held)
    {
        const double Friction = 0.07;
        const double Spin = 1.5;
        var turn = new Vector3d(0, Spin, 0);
        double radius = share * Friction * 9.81 * (5.0 / 3) / (Spin * Spin);
        Scene scene = Still(2.0 / 3);
        SurfaceMaterial surface = s_rough with { RollingResistance = Friction };
        PosedCollider? table = null;
        if (kind == Carrier.Obstacle)
        {
            scene = scene with { Obstacles = [new Obstacle { Shape = s_slab, Surface = surface, Spin = turn }] };
        }
        else
        {
            table = PosedCollider.In(ref scene, s_slab, surface, kind == Carrier.Engine);
            table.MoveTo(default, Quaterniond.Identity, default, turn, 0);
        }

        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(radius, Radius, 0), Vector3d.Cross(turn, new Vector3d(radius, 0, 0)), turn);
        Play(simulator, ref state, 5, time => table?.MoveTo(default, Quaterniond.FromAxisAngle(Vector3d.Up, Spin * time), default, turn, time));
        Vector3d turned = Quaterniond.FromAxisAngle(Vector3d.Up, Spin * state.Time).Rotate(new Vector3d(radius, Radius, 0));
        if (held)
        {
            Near(turned, state.Position, 1e-6);
            Near(Vector3d.Cross(turn, turned), state.Velocity, 1e-6);
            Near(turn, state.Spin, 1e-6);
            Assert.InRange(Differences.Rotation(Quaterniond.FromAxisAngle(Vector3d.Up, Spin * state.Time), state.Orientation), 0, 1e-6);
        }
        else
        {
            Assert.InRange(Vector3d.Distance(turned, state.Position), 0.02, 100);
        }
    }

    /// <summary>A look-ahead records the path of a ball at rest that its carrier moves, and zones see it.</summary>
    [Theory]
    [InlineData(Carrier.Obstacle)]
    [InlineData(Carrier.Body)]
    [InlineData(Carrier.Engine)]
    public void A_look_ahead_follows_a_ball_at_rest_on_a_turntable(Carrier kind)
    {
        const double From = 0.3;
        var turn = new Vector3d(0, 0.5, 0);
        SurfaceMaterial surface = s_rough with { RollingResistance = 0.07 };
        Scene scene = Still(2.0 / 3) with { Zones = [new Zone { Of = ZonePart.Center, Shape = new BoxShape(new Vector3d(0, 0, -5), new Vector3d(5, 5, 5)) }] };
        PosedCollider? table = null;
        if (kind == Carrier.Obstacle)
        {
            scene = scene with { Obstacles = [new Obstacle { Shape = s_slab, Surface = surface, Spin = turn }] };
        }
        else
        {
            table = PosedCollider.In(ref scene, s_slab, surface, kind == Carrier.Engine);
            table.MoveTo(default, Quaterniond.Identity, default, turn, 0);
        }

        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(From, Radius, 0.1), Vector3d.Cross(turn, new Vector3d(From, 0, 0.1)), turn);
        simulator.Step(ref state, Frame, new StepLog());
        Assert.Equal(MotionState.Rest, state.Motion);
        var path = new Trajectory(256);
        simulator.LookAhead(in state, new LookAheadRequest { Duration = 2, StopAt = StopAt.Time }, path);
        foreach (double after in (double[])[0.1, 1, 1.9])
        {
            Near(Quaterniond.FromAxisAngle(Vector3d.Up, 0.5 * after).Rotate(state.Position), path.PositionAt(state.Time + after), 1e-6);
        }

        Assert.Single(Enumerable.Range(0, path.Events.Count), i => path.Events[i].Kind == BallEventKind.EnterZone);
    }

    private static Scene Still(double inertia) => new()
    {
        Ball = BallProperties.Tunnel with { InertiaFactor = inertia },
        Air = new Air { Density = 0 },
        Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = -10 },
    };

    private static Vector3d OnTurntable()
    {
        var simulator = new Simulator(Still(2.0 / 3) with { Obstacles = [new Obstacle { Shape = s_slab, Surface = s_rough, Spin = Vector3d.Up }] });
        BallState state = simulator.Launch(new Vector3d(1, Radius, 0), new Vector3d(0.5, 0, 0), new Vector3d(1 / Radius, 0, -0.5 / Radius));
        Play(simulator, ref state, 6, null);
        return state.Position;
    }

    /// <summary>The velocities of a platform in its steps: 1 m/s² up to 2 m/s, whose mean in each step makes 4 m in 3 s.</summary>
    private static double[] Ramp() => [.. Enumerable.Range(0, 180).Select(i => i < 120 ? (i + 0.5) * Frame : 2)];

    /// <summary>The way of a ball that is at rest, or rolls, before a platform moves: 3 s from when it does.</summary>
    private static Vector3d Carried(bool isEngine, double[] speeds, double velocity, out BallState state)
    {
        Scene scene = Still(2.0 / 3);
        var platform = PosedCollider.In(ref scene, s_slab, s_rough with { SlidingFriction = 0.5, ImpactFriction = 0.5 }, isEngine);
        platform.MoveTo(default, Quaterniond.Identity, default, default, 0);
        var simulator = new Simulator(scene);
        state = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(velocity, 0, 0), new Vector3d(0, 0, -velocity / Radius));
        Play(simulator, ref state, 0.5, time => platform.MoveTo(default, Quaterniond.Identity, default, default, time));
        Vector3d begin = state.Position;
        double gone = 0;
        var log = new StepLog();
        for (int i = 0; i < 180; i++)
        {
            double speed = speeds[Math.Min(i, speeds.Length - 1)];
            platform.MoveTo(new Vector3d(gone, 0, 0), Quaterniond.Identity, new Vector3d(speed, 0, 0), default, state.Time);
            simulator.Step(ref state, Frame, log);
            gone += speed * Frame;
        }

        return state.Position - new Vector3d(begin.X, 0, begin.Z);
    }

    /// <summary>Each jump ΔV is slip, which ends at v + k/(1 + k) ΔV after that by μ g.</summary>
    private static double Expected(double[] speeds, double velocity)
    {
        const double Share = 0.4;
        double way = 0;
        double before = 0;
        double v = velocity;
        for (int i = 0; i < 180; i++)
        {
            double speed = speeds[Math.Min(i, speeds.Length - 1)];
            double jump = Share * (speed - before);
            before = speed;

            // Jumps of the ramp end within their step; the one at once is followed by none.
            double slides = jump / (0.5 * 9.81);
            way += ((v + jump) * Frame) - (0.5 * jump * slides);
            v += jump;
        }

        return way;
    }

    private static void Play(Simulator simulator, ref BallState state, double duration, Action<double>? move)
    {
        var log = new StepLog();
        int steps = (int)Math.Round(duration / Frame);
        for (int i = 0; i < steps; i++)
        {
            move?.Invoke(state.Time);
            simulator.Step(ref state, Frame, log);
        }
    }

    private static void Near(in Vector3d expected, in Vector3d found, double tolerance) =>
        Assert.True(Vector3d.Distance(expected, found) <= tolerance, $"{found.ToString("R", null)}, expected {expected.ToString("R", null)}");
}
