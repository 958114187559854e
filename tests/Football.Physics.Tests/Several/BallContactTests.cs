using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>The impulse of two balls of different size and mass, against balances and closed forms.</summary>
public sealed class BallContactTests
{
    private static readonly BallProperties Small = new() { Mass = 0.3, Radius = 0.09, InertiaFactor = 0.6 };
    private static readonly BallProperties Large = new() { Mass = 1.1, Radius = 0.17, InertiaFactor = 0.45 };
    private static readonly Simulator Nowhere = new(Scene.Default with { Ground = Ground.None });

    public static TheoryData<int> Draws => [.. Enumerable.Range(0, 12)];

    [Fact]
    public void The_gap_is_between_the_surfaces_and_its_rate_that_of_the_centers()
    {
        BallState a = State(new Vector3d(1, 2, 3), new Vector3d(5, 1, -1), default);
        BallState b = State(new Vector3d(1, 5, -1), new Vector3d(4, 3, 1), default);
        double gap = BallContact.Gap(in a, 0.5, in b, 0.25, out Vector3d normal, out double rate);
        Assert.Equal(5 - 0.75, gap, 1e-14);
        Assert.InRange((normal - new Vector3d(0, -0.6, 0.8)).Length, 0, 1e-15);

        // One step of time on, by differences.
        BallState later = State(a.Position + (1e-6 * a.Velocity), default, default);
        BallState other = State(b.Position + (1e-6 * b.Velocity), default, default);
        Assert.Equal((BallContact.Gap(in later, 0.5, in other, 0.25, out _, out _) - gap) / 1e-6, rate, 1e-5);
        BallContact.Gap(in a, 0.5, in a, 0.25, out normal, out rate);
        Assert.Equal(new Vector3d(1, 0, 0), normal);
        Assert.Equal(0, rate);
    }

    [Theory]
    [MemberData(nameof(Draws))]
    public void Impulse_and_turning_balance_and_the_surfaces_come_apart_as_their_material_says(int seed)
    {
        var random = new Random(seed);
        SurfaceMaterial surface = SurfaceMaterial.GoalFrame with
        {
            NormalRestitution = 0.6,
            GrazingRestitutionGain = seed % 2 == 0 ? 0 : 0.5,
            TangentialRestitution = 0.2,
            SpinRestitution = seed % 3 == 0 ? 0.7 : -0.7,
            ImpactFriction = seed < 6 ? 0.15 : 5,
            SlidingFriction = 0.3,
            TorsionalPatchRadius = seed % 4 < 2 ? 0 : 0.002,
        };
        var material = new ContactMaterial(surface);
        Vector3d n = Draw(random).Normalized();
        BallState a = State((Small.Radius * n) + new Vector3d(1, 1, 1), (-4.0 * n) + (seed % 5 * Draw(random)), 30 * Draw(random));
        BallState b = State((-Large.Radius * n) + new Vector3d(1, 1, 1), Vector3d.Zero, 25 * Draw(random));
        ImpactLaw.Apply(Small, Large, in material, in n, in a, in b, out FootballPhysics.Motion first, out FootballPhysics.Motion second);
        Assert.Equal(a.Position, first.Position);
        Assert.Equal(b.Position, second.Position);

        // Impulse is conserved, and what one gets about the place of contact is what turns each ball there, but for a part about the normal.
        Vector3d impulse = Small.Mass * (first.Velocity - a.Velocity);
        Nothing((Large.Mass * (second.Velocity - b.Velocity)) + impulse);
        Vector3d turned = (Small.MomentOfInertia * (first.Spin - a.Spin)) - Vector3d.Cross(-Small.Radius * n, impulse);
        Vector3d itsTurned = (Large.MomentOfInertia * (second.Spin - b.Spin)) - Vector3d.Cross(Large.Radius * n, -impulse);
        double torque = Vector3d.Dot(in turned, in n);
        Nothing(turned - (torque * n));
        Nothing(turned + itsTurned);

        // Along the normal by e; along the surfaces by e_t where they grip, else by friction against the slip.
        Vector3d Slips(FootballPhysics.Motion one, FootballPhysics.Motion two) =>
            one.Velocity + Vector3d.Cross(one.Spin, -Small.Radius * n) - two.Velocity - Vector3d.Cross(two.Spin, Large.Radius * n);
        Vector3d before = Slips(new FootballPhysics.Motion(a.Position, a.Velocity, a.Spin), new FootballPhysics.Motion(b.Position, b.Velocity, b.Spin));
        Vector3d after = Slips(first, second);
        double came = -Vector3d.Dot(in before, in n);
        double left = Vector3d.Dot(in after, in n);
        double e = material.RestitutionAt(came, Flat(a.Velocity - b.Velocity, in n));
        Assert.Equal(e * came, left, 1e-12);
        Vector3d slip = Flat(in before, in n);
        Vector3d grips = Flat(in impulse, in n);
        double pressed = Vector3d.Dot(in impulse, in n);
        if (seed < 6)
        {
            Assert.Equal(surface.ImpactFriction * pressed, grips.Length, 1e-12);
            Nothing(grips.Normalized() + slip.Normalized());
        }
        else
        {
            Nothing(Flat(in after, in n) + (0.2 * slip));
        }

        // About the normal e_ω of what one turned against the other, less what drilling takes from both.
        double about = Vector3d.Dot(a.Spin - b.Spin, in n);
        double drills = surface.TorsionalPatchRadius * surface.SlidingFriction * pressed * ((1 / Small.MomentOfInertia) + (1 / Large.MomentOfInertia));
        double expected = surface.SpinRestitution * about;
        expected = Math.Sign(expected) * Math.Max(0, Math.Abs(expected) - drills);
        Assert.Equal(expected, Vector3d.Dot(first.Spin - second.Spin, in n), 1e-10);
    }

    /// <summary>Drilling friction stops what one turns against the other, and turns nothing back.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void Drilling_friction_ends_a_slow_turn_about_the_normal(double sign)
    {
        var material = new ContactMaterial(SurfaceMaterial.GoalFrame with { TorsionalPatchRadius = 0.5, SlidingFriction = 1 });
        BallState a = State(new Vector3d(Small.Radius, 0, 0), new Vector3d(-3, 0, 0), new Vector3d(sign * 8, 0, 0));
        BallState b = State(new Vector3d(-Large.Radius, 0, 0), default, new Vector3d(sign * -2, 0, 0));
        ImpactLaw.Apply(Small, Large, in material, new Vector3d(1, 0, 0), in a, in b, out FootballPhysics.Motion first, out FootballPhysics.Motion second);
        Assert.Equal(0, first.Spin.X - second.Spin.X, 1e-12);
        Assert.Equal((Small.MomentOfInertia * a.Spin.X) + (Large.MomentOfInertia * b.Spin.X), (Small.MomentOfInertia * first.Spin.X) + (Large.MomentOfInertia * second.Spin.X), 1e-14);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void Balls_that_do_not_come_closer_get_nothing(double speed)
    {
        var material = new ContactMaterial(SurfaceMaterial.Ball);
        BallState a = State(new Vector3d(Small.Radius, 0, 0), new Vector3d(speed, 3, 0), new Vector3d(1, 2, 3));
        BallState b = State(new Vector3d(-Large.Radius, 0, 0), default, new Vector3d(5, 5, 5));
        ImpactLaw.Apply(Small, Large, in material, new Vector3d(1, 0, 0), in a, in b, out FootballPhysics.Motion first, out FootballPhysics.Motion second);
        Assert.Equal((a.Position, a.Velocity, a.Spin), (first.Position, first.Velocity, first.Spin));
        Assert.Equal((b.Position, b.Velocity, b.Spin), (second.Position, second.Velocity, second.Spin));
    }

    [Fact]
    public void Whichever_is_called_the_first_the_bits_are_the_same()
    {
        var material = new ContactMaterial(SurfaceMaterial.Ball);
        for (int seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            Vector3d n = Draw(random).Normalized();
            BallState a = State(default, -5.0 * n, 20 * Draw(random));
            BallState b = State(default, Draw(random), 20 * Draw(random));
            ImpactLaw.Apply(Small, Large, in material, in n, in a, in b, out FootballPhysics.Motion first, out FootballPhysics.Motion second);
            ImpactLaw.Apply(Large, Small, in material, -n, in b, in a, out FootballPhysics.Motion its, out FootballPhysics.Motion own);
            Assert.Equal((first.Velocity, first.Spin, second.Velocity, second.Spin), (own.Velocity, own.Spin, its.Velocity, its.Spin));
        }
    }

    private static void Nothing(Vector3d vector) => Assert.InRange(vector.Length, 0, 1e-12);

    private static Vector3d Flat(in Vector3d vector, in Vector3d n) => vector - (Vector3d.Dot(in vector, in n) * n);

    private static Vector3d Draw(Random random) => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);

    private static BallState State(Vector3d position, Vector3d velocity, Vector3d spin)
    {
        BallState state = Nowhere.Launch(position, velocity, spin);
        return state;
    }
}
