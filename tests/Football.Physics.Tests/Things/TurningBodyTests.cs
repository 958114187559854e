namespace FootballPhysics.Tests.Things;

/// <summary>Objects that a game turns about their pivot hit a ball that lies still: a leg by its hip, a flipper, a bat, a door.</summary>
/// <remarks>The expected velocities are v + (1 + e) u n at the first contact, from a dense sampling of the exact rotation; they hold to 3 %.</remarks>
public sealed class TurningBodyTests
{
    private const double Share = 0.03;

    /// <summary>Rubber without friction.</summary>
    private static readonly SurfaceMaterial s_rubber = SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = 0.5,
        RestitutionSpeedScale = double.PositiveInfinity,
        ImpactFriction = 0,
        SlidingFriction = 0,
    };

    private static readonly Scene s_void = new() { Ball = BallProperties.Tunnel, Gravity = 0, Ground = Ground.None, Forces = ForceSet.None };

    private static readonly IShape s_leg = new CapsuleShape(new Vector3d(0, -0.85, 0), new Vector3d(0, -0.4, 0), 0.06);

    /// <summary>Kind of object, frames a second, velocity that turns it, rad/s.</summary>
    public static TheoryData<bool, double, double> Legs() => Rows([2, 10, 20]);

    public static TheoryData<bool, double, double> Flippers() => Rows([1, 3, 10, 40]);

    public static TheoryData<bool, double> Kinds => new() { { false, 60 }, { false, 240 }, { true, 60 }, { true, 240 } };

    [Theory]
    [MemberData(nameof(Legs))]
    public void A_leg_that_turns_about_its_hip_kicks_the_ball(bool isEngine, double rate, double spin)
    {
        Vector3d expected = spin / 10 * new Vector3d(0, -4.108924, -11.935454);
        BallEvent impact = Hit(s_leg, new Vector3d(0, 1, 0), new Vector3d(spin, 0, 0), -1.2, new Vector3d(0, 0.11, 0), default, isEngine, rate, 1.3 / spin, out BallState end);
        Near(expected, end.Velocity);
        Assert.Equal(1.0097475 / spin, impact.Time, Share / spin);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_leg_kicks_a_ball_that_moves_away(bool isEngine, double rate)
    {
        Hit(s_leg, new Vector3d(0, 1, 0), new Vector3d(10, 0, 0), -1.2, new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -0.5), isEngine, rate, 0.14, out BallState end);
        Near(new Vector3d(0, -3.294157, -11.917994), end.Velocity);
    }

    [Theory]
    [MemberData(nameof(Flippers))]
    public void A_flipper_throws_the_ball(bool isEngine, double rate, double spin)
    {
        var flipper = new CapsuleShape(default, new Vector3d(1.2, 0, 0), 0.05);
        var place = new Vector3d(0.8 * Math.Cos(Math.PI / 6), 0.8 * Math.Sin(Math.PI / 6), 0);
        Hit(flipper, default, new Vector3d(0, 0, spin), 0, place, default, isEngine, rate, 0.6 / spin, out BallState end);
        Near(spin * new Vector3d(-0.372358, 1.115236, 0), end.Velocity);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_bat_hits_the_ball(bool isEngine, double rate)
    {
        var bat = new CapsuleShape(new Vector3d(0.5, 0, 0), new Vector3d(1.1, 0, 0), 0.035);
        Hit(bat, new Vector3d(-0.8, 0.11, 0), new Vector3d(0, 20, 0), -0.7, new Vector3d(0, 0.11, 0), default, isEngine, rate, 0.05, out BallState end);
        Near(new Vector3d(4.277898, 0, -23.211583), end.Velocity);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_revolving_door_takes_the_ball_along(bool isEngine, double rate)
    {
        var door = new BoxShape(new Vector3d(0.75, 1, 0), new Vector3d(0.75, 1, 0.02));
        Hit(door, new Vector3d(-0.8, 0, 0), new Vector3d(0, 3, 0), -0.5, new Vector3d(0, 0.11, 0), default, isEngine, rate, 0.15, out BallState end);
        Near(new Vector3d(0.577222, 0, -3.504938), end.Velocity);
    }

    /// <summary>On the default pitch, whichever way the ball came to lie there.</summary>
    [Theory]
    [InlineData("new", 60)]
    [InlineData("new", 240)]
    [InlineData("kicked with 0", 60)]
    [InlineData("rolls away", 60)]
    public void A_leg_kicks_the_ball_along_the_ground(string ball, double rate)
    {
        var bodies = new KinematicBodies();
        KinematicBody leg = bodies.Add("leg", s_leg, s_rubber);
        var subject = new Ball(new Scene { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf), Bodies = bodies });
        if (ball != "new")
        {
            subject.Kick(ball == "rolls away" ? new Vector3d(0, 0, -0.5) : default, ball == "rolls away" ? new Vector3d(-0.5 / 0.11, 0, 0) : default);
        }

        for (int i = 0; i < 0.2 * rate; i++)
        {
            leg.MoveTo(new Vector3d(0, 1, 0), Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), (10 * subject.Time) - 1.2), default, new Vector3d(10, 0, 0), subject.Time);
            subject.Step(1 / rate);
        }

        Assert.InRange(Math.Sqrt((subject.Velocity.X * subject.Velocity.X) + (subject.Velocity.Z * subject.Velocity.Z)), 8.5, 13);
    }

    /// <summary>The control: an object that moves along without turning.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void An_object_that_does_not_turn_hits_as_its_velocity_says(bool isEngine, double rate)
    {
        Scene scene = s_void;
        var wall = PosedCollider.In(ref scene, new BoxShape(default, new Vector3d(0.5, 0.5, 0.02)), s_rubber, isEngine);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(default, default, default);
        var log = new StepLog();
        for (int i = 0; i < 0.2 * rate; i++)
        {
            wall.MoveTo(new Vector3d(0, 0, 0.5 - (5 * state.Time)), Quaterniond.Identity, new Vector3d(0, 0, -5), default, state.Time);
            simulator.Step(ref state, 1 / rate, log);
        }

        Assert.Equal(0, Vector3d.Distance(state.Velocity, new Vector3d(0, 0, -7.5)), 1e-9);
        Assert.Equal(0.37 / 5, log.Events[0].Time, 1e-9);
    }

    private static TheoryData<bool, double, double> Rows(double[] spins)
    {
        var rows = new TheoryData<bool, double, double>();
        foreach (TheoryDataRow<bool, double> kind in Kinds)
        {
            foreach (double spin in spins)
            {
                rows.Add(kind.Data.Item1, kind.Data.Item2, spin);
            }
        }

        return rows;
    }

    /// <summary>Turns an object at a constant rate past the ball and gives the impact, of which there is exactly one.</summary>
    private static BallEvent Hit(
        IShape shape, Vector3d pivot, Vector3d spin, double angle, Vector3d place, Vector3d velocity, bool isEngine, double rate, double duration, out BallState end)
    {
        Scene scene = s_void;
        var posed = PosedCollider.In(ref scene, shape, s_rubber, isEngine);
        var simulator = new Simulator(scene);
        end = simulator.Launch(place, velocity, default);
        var log = new StepLog();
        while (end.Time < duration)
        {
            double turned = angle + (spin.Length * end.Time);
            posed.MoveTo(pivot, Quaterniond.FromAxisAngle(spin / spin.Length, turned), default, spin, end.Time);
            simulator.Step(ref end, 1 / rate, log);
        }

        BallEvent[] impacts = [.. log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Impact)];
        Assert.Single(impacts);
        return impacts[0];
    }

    private static void Near(in Vector3d expected, in Vector3d found) =>
        Assert.True(Vector3d.Distance(expected, found) <= Share * expected.Length, $"{found} m/s, expected {expected} m/s");
}
