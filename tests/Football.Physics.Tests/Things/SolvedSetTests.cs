using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>What limits the result of a contact set: no surface is entered, and a projection does no work.</summary>
public sealed class SolvedSetTests
{
    private const double Radius = 0.11;

    /// <summary>A ball that is lifted is as much slower as it would be on its way up: energy is kept.</summary>
    [Theory]
    [InlineData(0.001)]
    [InlineData(0.05)]
    public void A_lift_takes_its_energy_from_the_motion(double lift)
    {
        Simulator simulator = Wedge(Vector3d.Zero);
        BallProperties ball = simulator.Scene.Ball;
        BallState state = Sliding(simulator);
        var weight = new Vector3d(0, -9, 0);
        double before = Kinetic(in state, ball);
        SolvedSet.PayForLift(ref state, Touched(simulator, in state), ball, in weight, state.Position - new Vector3d(0.3, lift, 0));
        Assert.Equal(before - (ball.Mass * 9 * lift), Kinetic(in state, ball), 1e-12);
        Assert.Equal(0, Vector3d.Cross(state.Velocity, new Vector3d(0.4, 0.1, -1)).Length, 1e-12);
    }

    [Fact]
    public void A_lift_that_takes_more_than_the_motion_has_stops_the_ball()
    {
        Simulator simulator = Wedge(Vector3d.Zero);
        BallState state = simulator.Launch(Between(), new Vector3d(0.1, 0, 0), Vector3d.Zero);
        SolvedSet.PayForLift(ref state, Touched(simulator, in state), simulator.Scene.Ball, new Vector3d(0, -9, 0), state.Position - Vector3d.Up);
        Assert.Equal(Vector3d.Zero, state.Velocity);
    }

    /// <summary>Neither a ball that is lowered pays, nor one that a moving surface may lift.</summary>
    [Theory]
    [InlineData(0, -0.1)]
    [InlineData(2, 0.05)]
    public void Other_balls_pay_nothing(double speed, double lift)
    {
        Simulator simulator = Wedge(new Vector3d(0, 0, speed));
        BallState state = Sliding(simulator);
        BallState before = state;
        SolvedSet.PayForLift(ref state, Touched(simulator, in state), simulator.Scene.Ball, new Vector3d(0, -9, 0), state.Position - new Vector3d(0, lift, 0));
        Assert.True(Snapshot.Same(in before, in state));
    }

    /// <summary>In a part, a ball may close a gap, and no more. Without a duration, it may not approach at all.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.01)]
    public void A_velocity_enters_no_surface(double duration)
    {
        Simulator simulator = Wedge(Vector3d.Zero);
        BallState state = simulator.Launch(Between() + new Vector3d(0, 1e-4, 0), Vector3d.Zero, Vector3d.Zero);
        Span<Contact> set = Touched(simulator, in state);
        var v = new Vector3d(0.2, -3, 1);
        Assert.True(SolvedSet.KeepOff(set, simulator.World!, duration, movers: true, ref v));
        Assert.Equal(1, v.Z, 1e-12);
        Assert.Equal(2, set.Length);
        foreach (ref readonly Contact contact in set)
        {
            double room = duration > 0 ? contact.Gap / duration : 0;
            Assert.InRange(Vector3d.Dot(v, contact.Normal) + room, -1e-9, 1);
        }
    }

    private static double Kinetic(in BallState s, BallProperties ball) => 0.5 * ((ball.Mass * s.Velocity.LengthSquared) + (ball.MomentOfInertia * s.Spin.LengthSquared));

    private static BallState Sliding(Simulator simulator)
    {
        BallState state = simulator.Launch(Between(), new Vector3d(0.4, 0.1, -1), Vector3d.Zero);
        state.Motion = MotionState.Sliding;
        state.SetGroundSpin(new Vector3d(9, -4, 2));
        return state;
    }

    private static Vector3d Between() => new(0, Math.Sqrt(2) * Radius, 0);

    private static Span<Contact> Touched(Simulator simulator, in BallState state) =>
        ContactSet.Near(simulator.World!, in state, 1e-3, new Contact[ContactSet.Room], simulator.World!.Room);

    private static Simulator Wedge(Vector3d velocity) => new(new Scene
    {
        Ball = new BallProperties { Radius = Radius },
        Ground = Ground.None,
        Obstacles = [.. new[] { -1, 1 }.Select(side => new Obstacle { Name = "side", Shape = new PlaneShape(Vector3d.Zero, new Vector3d(side, 1, 0)), Velocity = velocity })],
    });
}
