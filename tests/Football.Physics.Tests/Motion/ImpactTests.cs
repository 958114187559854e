using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>What every impact keeps, over thousands of random balls, grounds, velocities and spins, through the simulator.</summary>
public sealed class ImpactTests
{
    private const int Impacts = 5000;

    [Fact]
    public void Slip_after_is_minus_restitution_times_slip_before() =>
        ForEachImpact(Profile.Published, (scene, impact) =>
        {
            double r = scene.Ball.Radius;
            (double before, double after) x = (impact.VelocityBefore.X + (r * impact.SpinBefore.Z), impact.Velocity.X + (r * impact.Spin.Z));
            (double before, double after) z = (impact.VelocityBefore.Z - (r * impact.SpinBefore.X), impact.Velocity.Z - (r * impact.Spin.X));
            Assert.Equal(-scene.Ground.Material.TangentialRestitution * x.before, x.after, 1e-10);
            Assert.Equal(-(scene.Ground.TangentialRestitutionZ ?? scene.Ground.Material.TangentialRestitution) * z.before, z.after, 1e-10);
        });

    [Theory]
    [ProfileData]
    public void Energy_never_grows(Profile profile) =>
        ForEachImpact(profile, (scene, impact) =>
        {
            double before = Energy(scene, impact.VelocityBefore, impact.SpinBefore);
            double after = Energy(scene, impact.Velocity, impact.Spin);
            Assert.True(after <= before * (1 + 1e-13), $"{before} J to {after} J");
        });

    [Fact]
    public void Energy_is_kept_where_every_restitution_is_one() =>
        ForEachImpact(
            Profile.Published,
            (scene, impact) =>
            {
                double before = Energy(scene, impact.VelocityBefore, impact.SpinBefore);
                Assert.Equal(1, Energy(scene, impact.Velocity, impact.Spin) / before, 1e-12);
            },
            scene => scene with
            {
                Ground = scene.Ground with
                {
                    Material = scene.Ground.Material with { NormalRestitution = 1, SpinRestitution = 1, TangentialRestitution = 1 },
                    TangentialRestitutionZ = -1,
                },
            });

    [Theory]
    [ProfileData]
    public void Angular_momentum_about_the_contact_point_is_conserved(Profile profile) =>
        ForEachImpact(profile, (scene, impact) =>
        {
            // L = r ŷ × m v + I ω, horizontal part
            Vector3d Momentum(Vector3d v, Vector3d w) =>
                Vector3d.Cross(new Vector3d(0, scene.Ball.Radius, 0), scene.Ball.Mass * v) + (scene.Ball.MomentOfInertia * w.Horizontal);
            Vector3d before = Momentum(impact.VelocityBefore, impact.SpinBefore);
            Vector3d after = Momentum(impact.Velocity, impact.Spin);
            Assert.InRange(Vector3d.Distance(before, after), 0, 1e-13 * Math.Max(1, before.Length));
        });

    [Fact]
    public void The_vertical_parts_are_scaled_by_their_restitutions() =>
        ForEachImpact(Profile.Published, (scene, impact) =>
        {
            Assert.Equal(-scene.Ground.Material.NormalRestitution * impact.VelocityBefore.Y, impact.Velocity.Y, 1e-13);
            Assert.Equal(scene.Ground.Material.SpinRestitution * impact.SpinBefore.Y, impact.Spin.Y, 1e-12);
        });

    [Fact]
    public void The_bounced_ball_flies_on_with_what_the_impact_gave_it() =>
        ForEachImpact(Profile.Published, (scene, impact) =>
        {
            var simulator = new Simulator(scene);
            BallState state = simulator.Launch(impact.Position, impact.VelocityBefore, impact.SpinBefore);
            var log = new StepLog();
            simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
            bool bounces = impact.Velocity.Y >= scene.Ground.MinimumBounceSpeed;
            Assert.Equal(bounces ? MotionState.Airborne : MotionState.Sliding, state.Motion);
            Assert.InRange(Vector3d.Distance(bounces ? impact.Velocity : impact.Velocity.Horizontal, state.Velocity), 0, 1e-13 * impact.VelocityBefore.Length);
            Assert.InRange(Vector3d.Distance(impact.Spin, state.Spin), 0, 1e-12 * Math.Max(1, impact.Spin.Length));
        });

    [Theory]
    [InlineData(0.5)]
    [InlineData(0.8)]
    [InlineData(1.0)]
    public void A_dropped_ball_rebounds_to_restitution_squared_of_its_height(double restitution)
    {
        const double Drop = 2;
        Scene scene = Scene.Vacuum with { Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { NormalRestitution = restitution }, MinimumBounceSpeed = 0.001 } };
        foreach (double timeStep in new[] { 0.01, 0.04, 0.3 })
        {
            var simulator = new Simulator(scene);
            BallState state = simulator.Launch(new Vector3d(0, Flight.Radius + Drop, 0), Vector3d.Zero, Vector3d.Zero);
            var log = new StepLog();
            double height = Drop;
            double time = Math.Sqrt(2 * Drop / scene.Gravity);
            simulator.Run(ref state, timeStep, 10, StopAt.Impact, log);
            for (int bounce = 1; bounce <= 4; bounce++)
            {
                Assert.Equal(time, state.Time, 1e-12);
                height *= restitution * restitution;
                time += 2 * Math.Sqrt(2 * height / scene.Gravity);
                var apex = new ApexObserver(0);
                log.Observer = apex;
                simulator.Run(ref state, timeStep, 10, StopAt.Impact, log);
                Assert.Equal(Flight.Radius + height, apex.Apex, 1e-12);
            }
        }
    }

    /// <summary>What touches may be a tenth of a nanometre off; what stays is put onto what it stays on, at once.</summary>
    [Theory]
    [ProfileData(0.0, 0.0)]
    [ProfileData(0.2, 0.0)]
    [ProfileData(0.1, 0.3)]
    public void A_ball_that_stays_is_at_contact_to_the_last_bits(Profile profile, double alongX, double alongZ)
    {
        var normal = new Vector3d(alongX, 1, alongZ).Normalized();
        var simulator = new Simulator(profile.Scene() with { Ground = profile.Ground() with { Material = profile.Ground().Material with { NormalRestitution = 0, GrazingRestitutionGain = 0 }, Normal = normal } });
        double radius = simulator.Scene.Ball.Radius;
        var log = new StepLog();
        BallState state = simulator.Launch((radius + 5e-11) * normal, new Vector3d(3, -1, 0), Vector3d.Zero);
        simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
        Assert.Equal(BallEventKind.Impact, log.Events[0].Kind);
        Assert.NotEqual(MotionState.Airborne, state.Motion);
        Assert.Equal(radius, Vector3d.Dot(state.Position, in normal), 1e-16);
        Assert.Equal(0, Vector3d.Dot(state.Velocity, in normal), 1e-15);
        Assert.Equal(0, state.Time);
    }

    private static double Energy(Scene scene, Vector3d v, Vector3d w) =>
        0.5 * ((scene.Ball.Mass * v.LengthSquared) + (scene.Ball.MomentOfInertia * w.LengthSquared));

    private static void ForEachImpact(Profile profile, Action<Scene, BallEvent> hold, Func<Scene, Scene>? change = null)
    {
        var random = new Shots(216);
        var log = new StepLog();
        for (int i = 0; i < Impacts; i++)
        {
            var scene = profile.Scene() with
            {
                Ball = new BallProperties { Mass = random.Uniform(0.05, 3), Radius = random.Uniform(0.02, 0.3), InertiaFactor = random.Uniform(0.1, 1) },
                Air = new Air { Density = random.Uniform(0, 1.3) },
                Ground = profile.Ground() with
                {
                    Material = profile.Ground().Material with
                    {
                        NormalRestitution = random.Uniform(0, 1),
                        SpinRestitution = random.Uniform(0, 1),
                        TangentialRestitution = random.Uniform(-1, 1),
                    },
                    Height = random.Uniform(-3, 3),
                },
            };
            scene = change?.Invoke(scene) ?? scene;
            Vector3d velocity = random.Velocity(1, 40, -90, -20);
            Vector3d spin = random.Uniform(0, 100) * random.Direction();
            var simulator = new Simulator(scene);
            BallState state = simulator.Launch(new Vector3d(0, simulator.ContactHeight + random.Uniform(0.001, 0.1), 0), velocity, spin);
            log.Clear();
            simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
            Assert.Equal(BallEventKind.Impact, log.Events[0].Kind);
            Assert.True(log.Events[0].VelocityBefore.Y < 0);
            hold(scene, log.Events[0]);
        }
    }
}
