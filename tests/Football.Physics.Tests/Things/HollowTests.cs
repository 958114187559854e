using System.Globalization;

namespace FootballPhysics.Tests.Things;

/// <summary>Shapes of a game's own that are hollow, and state too little of it.</summary>
public sealed class HollowTests
{
    /// <summary>Without friction and with e = 1, g y + v²/2 stays, whatever curvature the ring states.</summary>
    [Theory]
    [InlineData(0.2376, 0.009, 0.11, 0)]
    [InlineData(0.2376, 0.009, 0.11, 0.5)]
    [InlineData(0.2376, 0.009, 0.11, 1)]
    [InlineData(0.1188, 0.0045, 0.055, 0)]
    [InlineData(0.6, 0.05, 0.11, 0)]
    public void A_ring_that_states_too_little_keeps_the_energy(double radius, double thickness, double ball, double stated)
    {
        double hollow = stated / (radius - thickness);
        Simulator simulator = Rim(new Ring(radius, thickness, hollow, isRounded: true), ball, Smooth(1));
        Assert.Equal(stated < 1 ? 1 : 0, simulator.Warnings.Count);
        var random = new Random(5);
        for (int i = 0; i < 150; i++)
        {
            double turn = 6.28 * random.NextDouble();
            var from = new Vector3d(radius * 1.2 * Math.Cos(turn), 3.05 + (4 * ball) + random.NextDouble(), radius * 1.2 * Math.Sin(turn));
            BallState state = simulator.Launch(from, new Vector3d(-2 * random.NextDouble() * Math.Cos(turn), 1 - random.NextDouble(), -2 * random.NextDouble() * Math.Sin(turn)), Vector3d.Zero);
            double energy = Energy(in state);
            for (int k = 0; k < 60; k++)
            {
                simulator.Step(ref state, 1 / 60.0, new StepLog());
            }

            Assert.InRange(Math.Abs(Energy(in state) - energy), 0, 1e-6);
        }
    }

    [Fact]
    public void A_replaced_value_is_reported()
    {
        Simulator simulator = Rim(new Ring(0.2376, 0.009, 0, isRounded: true), 0.11, Smooth(1));
        string warning = Assert.Single(simulator.Warnings);
        Assert.StartsWith("obstacles[0].shape.maximumConcaveCurvature is 0, but the normals of the shape turn by 4.3", warning, StringComparison.Ordinal);
        double used = double.Parse(warning.Split("turn by ")[1].Split(' ')[0], CultureInfo.InvariantCulture);
        Assert.InRange(used * 0.2286, 0.98, 1.001);

        // Bodies and zones are checked as obstacles are, and a convex shape of a game's own gets no warning.
        var bodies = new KinematicBodies();
        bodies.Add("rim", new Ring(0.2376, 0.009, 0, isRounded: true));
        Assert.StartsWith("bodies[0].", Assert.Single(new Simulator(new Scene { Bodies = bodies }).Warnings), StringComparison.Ordinal);
        Assert.Empty(new Simulator(new Scene { Obstacles = [new Obstacle { Shape = new Ball(0.3) }] }).Warnings);
    }

    /// <summary>A basketball of size 7 fits through a real ring, 45.72 cm wide, whose hollow exceeds half its curvature.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void A_basketball_fits_through_its_ring(double stated)
    {
        Simulator simulator = Rim(new Ring(0.2376, 0.009, stated / 0.2286, isRounded: false), 0.12, SurfaceMaterial.Wood);
        BallState state = simulator.Launch(new Vector3d(0.02, 3.6, -0.03), new Vector3d(0, -1, 0), Vector3d.Zero);
        for (int i = 0; i < 60; i++)
        {
            simulator.Step(ref state, 1 / 60.0, new StepLog());
        }

        Assert.True(state.Position.Y < 2.5 && Math.Abs(state.Position.X - 0.02) < 1e-9, $"{state.Position}");
    }

    /// <summary>A ball that circles on the rim takes few pieces and asks the shape seldom, however little the shape states.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void A_ball_that_circles_on_the_rim_costs_little(double stated)
    {
        var ring = new Ring(0.2376, 0.009, stated / 0.2286, isRounded: false);
        Simulator simulator = Rim(ring, 0.12, SurfaceMaterial.Boot with { NormalRestitution = 0.3 });
        var random = new Random(3);
        int circling = 0;
        for (int i = 0; i < 60; i++)
        {
            // The ball touches the rod from inside and above, and moves around the ring.
            double up = 0.2 + (0.9 * random.NextDouble());
            double speed = 1 + (2 * random.NextDouble());
            BallState state = simulator.Launch(new Vector3d(0.2376 - (0.129 * Math.Cos(up)), 3.05 + (0.129 * Math.Sin(up)), 0), new Vector3d(0, 0, speed), Vector3d.Zero);
            int on = 0;
            for (int k = 0; k < 60 && state.Position.Y > 2.8; k++)
            {
                int calls = ring.Calls;
                var log = new StepLog();
                simulator.Step(ref state, 1 / 60.0, log);
                on += state.Motion is MotionState.Sliding or MotionState.Rolling ? 1 : 0;
                Assert.InRange(log.Steps, 0, 250);
                Assert.InRange(ring.Calls - calls, 0, 10_000);
            }

            circling += on > 10 ? 1 : 0;
        }

        Assert.True(circling > 5, $"{circling}");
    }

    /// <summary>A bowl is hollow in both directions: beyond half of the ball's curvature, the ball does not fit.</summary>
    [Fact]
    public void A_bowl_needs_twice_the_radius_of_a_ring()
    {
        var scene = new Scene { Obstacles = [new Obstacle { Shape = new Bowl(0.2) }] };
        Assert.Contains("hollow in two directions", Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(scene)).Message, StringComparison.Ordinal);
        Assert.Empty(new Simulator(new Scene { Obstacles = [new Obstacle { Shape = new Bowl(0.3) }] }).Warnings);
        var tight = new Scene { Obstacles = [new Obstacle { Shape = new Ring(0.11, 0.01, 1 / 0.1, isRounded: false) }] };
        Assert.Contains("the curvature of the ball", Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(tight)).Message, StringComparison.Ordinal);
    }

    private static Simulator Rim(Ring ring, double radius, SurfaceMaterial surface) => new(new Scene
    {
        Ball = new BallProperties { Mass = 0.43, Radius = radius, InertiaFactor = 2 / 3.0 },
        Air = new Air { Density = 0 },
        Ground = Ground.None,
        Obstacles = [new Obstacle { Name = "rim", Shape = ring, Surface = surface }],
    });

    private static double Energy(in BallState state) => (0.5 * state.Velocity.LengthSquared) + (9.81 * state.Position.Y);

    private static SurfaceMaterial Smooth(double restitution) => SurfaceMaterial.Boot with
    {
        NormalRestitution = restitution,
        RestitutionSpeedScale = double.PositiveInfinity,
        ImpactFriction = 0,
        SlidingFriction = 0,
        GrazingRestitutionGain = 0,
        TorsionalPatchRadius = 0,
    };

    /// <summary>A ring that lies flat at 3.05 m. If it is rounded, its curvature is only about that of a sphere around the nearest point.</summary>
    private sealed class Ring(double radius, double thickness, double hollow, bool isRounded) : IShape
    {
        private static readonly Vector3d s_center = new(0, 3.05, 0);

        public int Calls { get; private set; }

        public double MaximumConcaveCurvature => hollow;

        public Bounds3d Bounds => Bounds3d.Around(s_center, radius + thickness, thickness, radius + thickness);

        public ShapePoint At(in Vector3d point)
        {
            Calls++;
            Vector3d from = point - s_center;
            double across = Math.Max(from.Horizontal.Length, 1e-9);
            Vector3d outward = from.Horizontal.Length > 0 ? from.Horizontal / across : new Vector3d(1, 0, 0);
            Vector3d away = from - (radius * outward);
            double distance = Math.Max(away.Length, 1e-9);
            Vector3d normal = away.Length > 0 ? away / distance : Vector3d.Up;
            if (isRounded)
            {
                return new ShapePoint(distance - thickness, normal, SymmetricMatrix3d.AroundPoint(normal, distance));
            }

            Vector3d along = Vector3d.Cross(Vector3d.Up, outward);
            SymmetricMatrix3d aroundRod = SymmetricMatrix3d.AroundAxis(normal, along, distance);
            return new ShapePoint(distance - thickness, normal, aroundRod - (-Vector3d.Dot(in normal, in outward) / across * SymmetricMatrix3d.OuterProduct(along)));
        }
    }

    /// <summary>The inside of a sphere, whose lowest point is at the origin.</summary>
    private sealed class Bowl(double radius) : IShape
    {
        public double MaximumConcaveCurvature => 1 / radius;

        public Bounds3d Bounds => Bounds3d.Everywhere;

        public ShapePoint At(in Vector3d point)
        {
            Vector3d from = point - new Vector3d(0, radius, 0);
            double distance = Math.Max(from.Length, 1e-12);
            Vector3d normal = -from / distance;
            return new ShapePoint(radius - distance, normal, -1.0 * SymmetricMatrix3d.AroundPoint(normal, distance));
        }
    }

    private sealed class Ball(double radius) : IShape
    {
        public double MaximumConcaveCurvature => 0;

        public Bounds3d Bounds => Bounds3d.Around(Vector3d.Zero, radius, radius, radius);

        public ShapePoint At(in Vector3d point)
        {
            double distance = Math.Max(point.Length, 1e-12);
            return new ShapePoint(distance - radius, point / distance, SymmetricMatrix3d.AroundPoint(point / distance, distance));
        }
    }
}
