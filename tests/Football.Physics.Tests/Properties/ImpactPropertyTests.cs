using CsCheck;
using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Properties;

/// <summary>The laws of every impact: restitution along the normal, Coulomb's cone, momentum, and no gain of energy.</summary>
public sealed class ImpactPropertyTests
{
    private const int Impacts = 10_000;

    /// <summary>Rounding, relative to the largest number of the draw.</summary>
    private const double Rounding = 1e-11;

    /// <summary>The mass of the object that the ball hits; one in three does not give way.</summary>
    private static readonly Gen<double> s_mass = Gen.Select(Gen.Double[-3, 3], Gen.Int[0, 2], (power, fixedOne) => fixedOne == 0 ? double.PositiveInfinity : Math.Pow(10, power));

    private static readonly Simulator s_nowhere = new(Scene.Default with { Ground = Ground.None });

    [Fact]
    public void An_impact_with_an_object_obeys_restitution_and_friction_and_gains_no_energy() =>
        Gen.Select(Drawn.Ball, Drawn.Surface, s_mass, Drawn.Direction, Drawn.Vector(20), Drawn.Vector(40), Drawn.Vector(300)).Sample(
            (ball, surface, mass, n, wall, v, w) =>
            {
                var material = new ContactMaterial(surface);
                ImpactLaw.Apply(ball, in material, in n, in wall, in v, in w, out Vector3d velocity, out Vector3d spin, ball.Mass / mass);
                double approach = -Vector3d.Dot(v - wall, n);
                Vector3d impulse = ball.Mass * (velocity - v);
                if (approach <= 0)
                {
                    // The ball recedes.
                    Assert.Equal(v, velocity);
                    Assert.Equal(w, spin);
                    return;
                }

                // Newton's third law moves the object: it does not rotate.
                Vector3d recoil = -1.0 / mass * impulse;
                double speed = 1 + v.Length + wall.Length + (ball.Radius * w.Length);
                double leaves = Vector3d.Dot(velocity - wall - recoil, n);
                Assert.Equal(material.RestitutionAt(approach, Across(v - wall, n)) * approach, leaves, Rounding * speed);

                Cone(surface, impulse, n, ball.Mass * speed);
                Vector3d turned = (ball.MomentOfInertia * (spin - w)) - Vector3d.Cross(-ball.Radius * n, impulse);
                Assert.InRange(Across(turned, n).Length, 0, Rounding * ball.Mass * ball.Radius * speed);

                // In the frame of the object before the impact.
                double before = Energy(ball, v - wall, w);
                double after = Energy(ball, velocity - wall, spin) + (double.IsInfinity(mass) ? 0 : 0.5 * mass * recoil.LengthSquared);
                Assert.True(after <= before + (Rounding * ball.Mass * speed * speed), $"{before} J to {after} J");
            },
            iter: Impacts);

    [Fact]
    public void An_impact_of_two_balls_keeps_momentum_and_gains_no_energy() =>
        Gen.Select(Drawn.Ball, Drawn.Ball, Drawn.Surface, Drawn.Direction, Gen.Select(Drawn.Vector(40), Drawn.Vector(40)), Gen.Select(Drawn.Vector(300), Drawn.Vector(300))).Sample(
            (ball, other, surface, n, velocities, spins) =>
            {
                // The normal points from the second ball to the first.
                var material = new ContactMaterial(surface);
                BallState a = State(ball.Radius * n, velocities.Item1, spins.Item1);
                BallState b = State(-other.Radius * n, velocities.Item2, spins.Item2);
                double approach = -Vector3d.Dot(a.Velocity - b.Velocity, n);
                if (approach <= 0)
                {
                    return;
                }

                ImpactLaw.Apply(ball, other, in material, in n, in a, in b, out FootballPhysics.Motion first, out FootballPhysics.Motion second);
                double speed = 1 + a.Velocity.Length + b.Velocity.Length + (ball.Radius * a.Spin.Length) + (other.Radius * b.Spin.Length);
                double mass = ball.Mass + other.Mass;
                Vector3d impulse = ball.Mass * (first.Velocity - a.Velocity);
                Assert.InRange((impulse + (other.Mass * (second.Velocity - b.Velocity))).Length, 0, Rounding * mass * speed);
                Assert.Equal(material.RestitutionAt(approach, Across(a.Velocity - b.Velocity, n)) * approach, Vector3d.Dot(first.Velocity - second.Velocity, n), Rounding * speed);
                Cone(surface, impulse, n, mass * speed);

                // The angular momentum about the contact changes by opposite amounts.
                Vector3d turned = (ball.MomentOfInertia * (first.Spin - a.Spin)) - Vector3d.Cross(-ball.Radius * n, impulse);
                Vector3d itsTurned = (other.MomentOfInertia * (second.Spin - b.Spin)) - Vector3d.Cross(other.Radius * n, -impulse);
                Assert.InRange((turned + itsTurned).Length, 0, Rounding * mass * speed);

                double before = Energy(ball, a.Velocity, a.Spin) + Energy(other, b.Velocity, b.Spin);
                double after = Energy(ball, first.Velocity, first.Spin) + Energy(other, second.Velocity, second.Spin);
                Assert.True(after <= before + (Rounding * mass * speed * speed), $"{before} J to {after} J");
            },
            iter: Impacts);

    /// <summary>The impulse presses, and its part across the normal is within Coulomb's cone.</summary>
    private static void Cone(SurfaceMaterial surface, Vector3d impulse, Vector3d n, double size)
    {
        double pressed = Vector3d.Dot(impulse, n);
        Assert.True(pressed >= -Rounding * size, $"pressed by {pressed} N s");
        if (double.IsFinite(surface.ImpactFriction))
        {
            Assert.True(Across(impulse, n).Length <= (surface.ImpactFriction * pressed) + (Rounding * size), $"{Across(impulse, n).Length} N s of friction, {pressed} N s pressed");
        }
    }

    private static BallState State(Vector3d position, Vector3d velocity, Vector3d spin) => s_nowhere.Launch(position, velocity, spin);

    private static double Energy(BallProperties ball, Vector3d v, Vector3d w) => (0.5 * ball.Mass * v.LengthSquared) + (0.5 * ball.MomentOfInertia * w.LengthSquared);

    private static Vector3d Across(Vector3d v, Vector3d n) => v - (Vector3d.Dot(v, n) * n);
}
