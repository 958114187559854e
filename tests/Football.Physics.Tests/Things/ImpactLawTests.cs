using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>Impacts in the frame of the contact.</summary>
public sealed class ImpactLawTests
{
    private static readonly BallProperties s_ball = BallProperties.Tunnel;

    [Fact]
    public void Without_a_limit_on_level_ground_it_is_the_thesis_impact()
    {
        var random = new Random(1);
        for (int i = 0; i < 1000; i++)
        {
            Ground ground = Ground.PublishedTurf with
            {
                Material = SurfaceMaterial.PublishedTurf with
                {
                    TangentialRestitution = random.NextDouble(),
                },
                TangentialRestitutionZ = -random.NextDouble(),
            };
            (Vector3d v, Vector3d w) = Draw(random);
            v = new Vector3d(v.X, -Math.Abs(v.Y), v.Z);
            (Vector3d velocity, Vector3d spin) = ThesisImpact(ground, in v, in w);
            ImpactLaw.Apply(s_ball, new ContactMaterial(ground), Vector3d.Up, default, in v, in w, out Vector3d sameVelocity, out Vector3d sameSpin);
            Assert.True(Vector3d.Distance(velocity, sameVelocity) < 1e-13 * 50 && Vector3d.Distance(spin, sameSpin) < 1e-12 * 100);
        }
    }

    /// <summary>Four coefficients of restitution on level ground (thesis 2.16 to 2.18).</summary>
    private static (Vector3d Velocity, Vector3d Spin) ThesisImpact(Ground ground, in Vector3d v, in Vector3d w)
    {
        double a = s_ball.InertiaFactor;
        double r = s_ball.Radius;
        double ex = ground.Material.TangentialRestitution;
        double ez = ground.TangentialRestitutionZ ?? ex;
        var velocity = new Vector3d(
            (((1 - (a * ex)) * v.X) - (a * (1 + ex) * r * w.Z)) / (1 + a),
            -ground.Material.NormalRestitution * v.Y,
            (((1 - (a * ez)) * v.Z) + (a * (1 + ez) * r * w.X)) / (1 + a));
        var spin = new Vector3d(
            (((a - ez) * w.X) + ((1 + ez) * v.Z / r)) / (1 + a),
            ground.Material.SpinRestitution * w.Y,
            (((a - ex) * w.Z) - ((1 + ex) * v.X / r)) / (1 + a));
        return (velocity, spin);
    }

    [Fact]
    public void Energy_never_grows_and_what_the_contact_cannot_touch_is_kept()
    {
        var random = new Random(2);
        for (int i = 0; i < 20_000; i++)
        {
            SurfaceMaterial surface = SurfaceMaterial.GoalFrame with
            {
                NormalRestitution = random.NextDouble(),
                TangentialRestitution = (2 * random.NextDouble()) - 1,
                SpinRestitution = 1,
                ImpactFriction = i % 3 == 0 ? double.PositiveInfinity : 1.5 * random.NextDouble(),
                TorsionalPatchRadius = i % 2 == 0 ? 0.02 : 0,
            };
            Vector3d n = Direction(random);
            (Vector3d v, Vector3d w) = Draw(random);
            v -= (Vector3d.Dot(v, n) + (20 * random.NextDouble())) * n;
            ImpactLaw.Apply(s_ball, new ContactMaterial(surface), in n, default, in v, in w, out Vector3d velocity, out Vector3d spin);
            Assert.True(Energy(velocity, spin) <= Energy(v, w) * (1 + 1e-12));

            // Angular momentum about the contact point: only its part along the normal may change.
            Vector3d before = Momentum(v, w, n);
            Vector3d after = Momentum(velocity, spin, n);
            Vector3d turned = after - before;
            Assert.True((turned - (Vector3d.Dot(turned, n) * n)).Length < 1e-12 * (1 + before.Length));

            Vector3d slip = Slip(v, w, n);
            Vector3d left = Slip(velocity, spin, n);
            double grip = (left + (surface.TangentialRestitution * slip)).Length;
            Vector3d change = velocity - v;
            double normal = Vector3d.Dot(change, n);
            bool slides = Math.Abs((change - (normal * n)).Length - (surface.ImpactFriction * normal)) < 1e-9;
            Assert.True(grip < 1e-9 * (1 + slip.Length) || slides, $"{grip}");
        }
    }

    [Fact]
    public void A_moving_wall_gives_what_a_resting_one_gives_in_its_own_frame()
    {
        var material = new ContactMaterial(SurfaceMaterial.PublishedGoalFrame);
        var wall = new Vector3d(0, 0, 7);
        var v = new Vector3d(3, 1, -12);
        var w = new Vector3d(10, 20, 30);
        var n = new Vector3d(0, 0, 1);
        ImpactLaw.Apply(s_ball, in material, in n, in wall, in v, in w, out Vector3d velocity, out Vector3d spin);
        ImpactLaw.Apply(s_ball, in material, in n, default, v - wall, in w, out Vector3d own, out Vector3d ownSpin);
        Assert.True(Vector3d.Distance(velocity, own + wall) < 1e-14);
        Assert.Equal(ownSpin, spin);
    }

    private static (Vector3d Velocity, Vector3d Spin) Draw(Random random) => (30 * random.NextDouble() * Direction(random), 80 * random.NextDouble() * Direction(random));

    private static Vector3d Direction(Random random)
    {
        while (true)
        {
            var v = new Vector3d((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
            if (v.LengthSquared is > 0.01 and < 1)
            {
                return v / v.Length;
            }
        }
    }

    private static double Energy(Vector3d v, Vector3d w) => (0.5 * s_ball.Mass * v.LengthSquared) + (0.5 * s_ball.MomentOfInertia * w.LengthSquared);

    private static Vector3d Momentum(Vector3d v, Vector3d w, Vector3d n) =>
        (s_ball.MomentOfInertia * w) + (s_ball.Mass * Vector3d.Cross(s_ball.Radius * n, v));

    private static Vector3d Slip(Vector3d v, Vector3d w, Vector3d n) => v - (Vector3d.Dot(v, n) * n) + (s_ball.Radius * Vector3d.Cross(n, w));
}
