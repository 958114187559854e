using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Shapes without bounds that rotate: a plane, and the hollow of a sphere in which the ball is.</summary>
public sealed class RotatingWallTests
{
    [Theory]
    [InlineData(Mover.Body, 60)]
    [InlineData(Mover.Body, 10)]
    [InlineData(Mover.Engine, 60)]
    [InlineData(Mover.Engine, 10)]
    public void A_plane_that_rotates_hits_wherever_the_ball_is(Mover mover, double hz)
    {
        var plane = new Hinged { Shape = new PlaneShape(Vector3d.Zero, Vector3d.Up), Axis = new Vector3d(0, 0, 1), Pivot = new Vector3d(0, -0.2, 0), Rate = 3 };
        foreach (double x in new double[] { 0.3, 2, 20 })
        {
            Check(plane, mover, hz, new Vector3d(x, 0.5, 0), default);
            Check(plane, mover, hz, new Vector3d(x, 0.5, 0), new Vector3d(-2, 1, 0.5));
        }
    }

    [Theory]
    [InlineData(Mover.Body, 60)]
    [InlineData(Mover.Body, 10)]
    [InlineData(Mover.Engine, 60)]
    [InlineData(Mover.Engine, 10)]
    public void The_hollow_of_a_sphere_that_swings_hits_the_ball_in_it(Mover mover, double hz)
    {
        foreach (double rate in new double[] { 1, 6, 30 })
        {
            var hollow = new Hinged { Shape = new Hollow(new Vector3d(0.4, 0, 0), 0.6), Axis = new Vector3d(0, 0.6, 0.8), Rate = rate };
            Check(hollow, mover, hz, new Vector3d(0.3, 0.1, 0), default);
            Check(hollow, mover, hz, new Vector3d(0.3, -0.2, 0.1), new Vector3d(1, -3, 2));
            Check(hollow, mover, hz, new Vector3d(0.75, 0, 0.2), new Vector3d(-1, 0, 0));
        }
    }

    private static void Check(Hinged thing, Mover mover, double hz, Vector3d from, Vector3d velocity)
    {
        double expected = thing.FirstTouch(from, velocity, Flight.Radius, 4, out double least);
        Assert.True(least <= 0 && expected > 0.001);
        var scene = new HingedScene(thing, mover, HingedScene.Void);
        var simulator = new Simulator(scene.Scene);
        BallState state = simulator.Launch(from, velocity, default);
        StepLog log = scene.Play(ref state, simulator, hz, expected + (1 / hz));
        Assert.Equal(expected, log.Events[0].Time, 1e-9);
        Assert.Equal(0, (from + (expected * velocity) - log.Events[0].Position).Length, 1e-8);
        Assert.True(state.Position.IsFinite && state.Velocity.IsFinite);
    }

    /// <summary>All of space but a ball.</summary>
    private sealed class Hollow(Vector3d center, double radius) : IShape
    {
        public double MaximumConcaveCurvature => 1 / radius;

        public Bounds3d Bounds => Bounds3d.Everywhere;

        public ShapePoint At(in Vector3d point)
        {
            Vector3d from = point - center;
            double l = from.Length;
            Vector3d normal = -from / l;

            // H = ∇n: the normals meet at the centre.
            return new ShapePoint(radius - l, in normal, SymmetricMatrix3d.AroundPoint(in normal, -l));
        }
    }
}
