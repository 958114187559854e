using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Pitches that are not the same everywhere.</summary>
public sealed class SurfacePatternTests
{
    private static readonly SurfaceMaterial s_ice = SurfaceMaterial.PublishedTurf with
    {
        SlidingFriction = 0.05,
        RollingResistance = 0.002,
        NormalRestitution = 0.3,
    };

    private static readonly ISurfacePattern s_half = new SurfaceRectangles((new Vector3d(-50, 0, -50), new Vector3d(50, 0, -5), s_ice));

    public static TheoryData<string> Grounds => ["published", "measured", "tilted"];

    [Theory]
    [ProfileData(Member = nameof(Grounds))]
    public void A_ball_rolls_as_on_the_surface_under_it_and_changes_at_the_border(Profile profile, string kind)
    {
        Ground ground = kind switch
        {
            "measured" => Ground.Of(SurfaceMaterial.DryTurf),
            "tilted" => profile.Ground() with { Normal = new Vector3d(0.02, 1, 0.01) },
            _ => profile.Ground(),
        };
        Scene scene = profile.Scene() with { Ground = ground with { Pattern = s_half } };
        Scene wet = profile.Scene() with { Ground = OfSurface(ground) };
        BallState start = Rolling(new Simulator(scene, Flight.With(Integrator.Rk4)));
        foreach (double step in new[] { 0.004, 0.05 })
        {
            BallState both = To(new Simulator(scene, Flight.With(Integrator.Rk4)), start, step, 1.6);

            // The same told by hand: up to the border on the one, from there on the other.
            var dry = new Simulator(scene with { Ground = ground }, Flight.With(Integrator.Rk4));
            BallState there = start;
            double low = 0;
            double high = 1.6;
            for (int i = 0; i < 60; i++)
            {
                double middle = 0.5 * (low + high);
                there = To(dry, start, step, middle);
                (low, high) = there.Position.Z > -5 ? (middle, high) : (low, middle);
            }

            BallState after = To(new Simulator(wet, Flight.With(Integrator.Rk4)), To(dry, start, step, high), step, 1.6 - high);
            Assert.True(both.Position.Z < -6, $"{both.Position}");
            Assert.Equal(0, (both.Position - after.Position).Length, step > 0.01 ? 1e-6 : 1e-8);
            Assert.Equal(0, (both.Velocity - after.Velocity).Length, step > 0.01 ? 1e-6 : 1e-8);
        }
    }

    /// <summary>A step that could cross a whole stripe is taken in pieces, and one that cannot is taken at once.</summary>
    [Theory]
    [ProfileData]
    public void No_step_rolls_over_a_stripe_unnoticed(Profile profile)
    {
        var stripes = new SurfaceRectangles([.. Enumerable.Range(0, 40).Select(i => (new Vector3d(-5, 0, -0.3 - (0.6 * i)), new Vector3d(5, 0, -0.6 * i), s_ice))]);
        Scene scene = profile.Scene() with { Ground = profile.Ground() with { Pattern = stripes } };
        var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
        var log = new StepLog();
        BallState start = Rolling(simulator);
        BallState fine = To(simulator, start, 0.002, 1.2);
        foreach (double step in new[] { 0.02, 0.1, 0.3 })
        {
            BallState coarse = To(simulator, start, step, 1.2);
            Assert.True((coarse.Position - fine.Position).Length < 1e-6, $"{step} s: {coarse.Position}, not {fine.Position}");
        }

        log.Clear();
        simulator.Step(ref fine, 0.002, log);
        Assert.Equal(4, log.Evaluations);
    }

    [Fact]
    public void A_ball_bounces_as_on_the_surface_where_it_lands()
    {
        Scene scene = Scene.Published with { Ground = Ground.PublishedTurf with { Pattern = s_half } };
        BallEvent near = Flight.ToImpact(scene, Integrator.Rk4, 0.01, new Vector3d(0, 2, 0), Vector3d.Zero, Vector3d.Zero);
        BallEvent far = Flight.ToImpact(scene, Integrator.Rk4, 0.01, new Vector3d(0, 2, -10), Vector3d.Zero, Vector3d.Zero);
        Assert.Equal(-0.6 * near.VelocityBefore.Y, near.Velocity.Y, 1e-12);
        Assert.Equal(-0.3 * far.VelocityBefore.Y, far.Velocity.Y, 1e-12);
    }

    [Theory]
    [ProfileData]
    public void No_stripe_is_stepped_over(Profile profile)
    {
        // Stripes of 10 cm, each other of them rough: in long steps and short ones the ball comes as far.
        Scene scene = profile.Scene() with { Ground = profile.Ground() with { Pattern = new Stripes() } };
        BallState start = Rolling(new Simulator(scene, Flight.With(Integrator.Rk4)));
        BallState fine = To(new Simulator(scene, Flight.With(Integrator.Rk4)), start, 0.001, 0.6);
        BallState coarse = To(new Simulator(scene, Flight.With(Integrator.Rk4)), start, 0.6, 0.6);
        Assert.True(fine.Position.Z < start.Position.Z - 1);
        Assert.Equal(0, (fine.Position - coarse.Position).Length, 1e-7);
    }

    [Fact]
    public void Many_balls_bounce_each_on_its_surface()
    {
        Scene scene = Scene.Published with { Ground = Ground.PublishedTurf with { Pattern = s_half } };
        var launches = new BatchLaunches(2);
        var flights = new BatchFlights(2);
        launches.Position[0] = new Vector3d(0, 2, 0);
        launches.Position[1] = new Vector3d(0, 2, -10);
        new BallBatch(scene).Fly(launches, flights, 2);
        Assert.Equal(0.6, -flights.VelocityAfter[0].Y / flights.Velocity[0].Y, 1e-6);
        Assert.Equal(0.3, -flights.VelocityAfter[1].Y / flights.Velocity[1].Y, 1e-6);
    }

    [Theory]
    [ProfileData]
    public void A_wrong_pattern_is_refused_by_name(Profile profile)
    {
        SurfaceMaterial bad = SurfaceMaterial.GoalFrame with { SlidingFriction = -1 };
        Scene scene = profile.Scene() with { Ground = profile.Ground() with { Pattern = new SurfaceRectangles((Vector3d.Zero, new Vector3d(1, 0, 1), bad)) } };
        Assert.Contains("ground.pattern.surfaces[0].slidingFriction is -1", Assert.Throws<ArgumentOutOfRangeException>(scene.Validate).Message, StringComparison.Ordinal);
        Assert.Contains(
            "rectangles[0].max[2] is 0",
            Assert.Throws<ArgumentOutOfRangeException>(() => new SurfaceRectangles((Vector3d.Zero, new Vector3d(1, 0, 0), s_ice))).Message,
            StringComparison.Ordinal);
    }

    private static BallState Rolling(Simulator simulator) =>
        simulator.Launch(new Vector3d(0, Flight.Radius, -2), new Vector3d(0.5, 0, -6), new Vector3d(-30, 5, 0));

    private static BallState To(Simulator simulator, BallState state, double step, double duration)
    {
        if (duration > 0)
        {
            simulator.Run(ref state, step, duration, StopAt.Time, new StepLog());
        }

        return state;
    }

    private static Ground OfSurface(Ground ground) => ground with
    {
        Material = ground.Material with
        {
            NormalRestitution = s_ice.NormalRestitution,
            RestitutionSpeedScale = s_ice.RestitutionSpeedScale,
            SpinRestitution = s_ice.SpinRestitution,
            ImpactFriction = s_ice.ImpactFriction,
            SlidingFriction = s_ice.SlidingFriction,
            RollingResistance = s_ice.RollingResistance,
            RollingResistancePerSpeed = s_ice.RollingResistancePerSpeed,
            SpinDamping = s_ice.SpinDamping,
            TorsionalPatchRadius = s_ice.TorsionalPatchRadius,
            TangentialRestitution = s_ice.TangentialRestitution,
        },
    };

    /// <summary>Explicit Euler comes down from a hop faster than it went up: its pieces follow the most elastic part of the ground.</summary>
    [Theory]
    [InlineData("concrete")]
    [InlineData("matchTurf")]
    public void A_ball_with_Euler_s_method_comes_to_rest_on_an_elastic_part(string material)
    {
        var part = new SurfaceRectangles((new Vector3d(-200, 0, -200), new Vector3d(200, 0, 200), SurfaceMaterial.Presets[material]));
        var scene = new Scene { Ground = new Ground { Material = SurfaceMaterial.Snow, Pattern = part } };
        BallState end = Flight.Play(scene, Flight.With(Integrator.Euler), 1.0 / 60, 60, StopAt.Rest, new Vector3d(0, 1, 0), new Vector3d(6, 2, 3), Vector3d.Zero, out _);
        Assert.Equal(MotionState.Rest, end.Motion);
    }

    private sealed class Stripes : ISurfacePattern
    {
        public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [SurfaceMaterial.PublishedTurf with { RollingResistance = 0.3, SlidingFriction = 0.9 }];

        public double MinimumWidth => 0.1;

        public int At(double x, double z) => ((long)Math.Floor(z / 0.1) & 1) == 0 ? 0 : -1;
    }
}
