using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>The forces on a ball that stands between surfaces, in closed form.</summary>
public sealed unsafe class GrooveForcesTests
{
    private const double Radius = 0.11;
    private const double Gravity = 9.81;

    private static readonly Vector3d s_place = new(0.3, 0.2, -0.2);

    /// <summary>A ball in a level groove carries half of its weight on each side, straight down, if both sides are rough enough. Otherwise the sides press against each other until the smoother one grips: the force leans from the normal by the angle of its friction.</summary>
    [Theory]
    [InlineData(20, 0.5, 0.9)]
    [InlineData(40, 0.5, 0.9)]
    [InlineData(40, 0.9, 0.5)]
    [InlineData(40, 0.6, 0.6)]
    [InlineData(65, 0.3, 2)]
    [InlineData(65, 2, 0.1)]
    public void A_groove_braces_a_ball_as_little_as_its_smoother_side_needs(double degrees, double friction, double other)
    {
        double angle = degrees * Math.PI / 180;
        double lean = Math.Max(0, angle - Math.Atan(Math.Min(friction, other)));
        foreach (double resistance in new[] { 0, 0.1 })
        {
            Vector3d[] normals = [new(Math.Sin(angle), Math.Cos(angle), 0), new(-Math.Sin(angle), Math.Cos(angle), 0)];
            SetContact[] contacts = Standing(normals, [friction, other], resistance, out ContactSystem system);
            Assert.True(system.Pinned);
            for (int i = 0; i < 2; i++)
            {
                var force = new Vector3d(Math.Sign(normals[i].X) * 0.5 * Gravity * Math.Tan(lean), 0.5 * Gravity, 0);
                Assert.True(contacts[i].Sticks);
                Assert.Equal(Vector3d.Dot(force, normals[i]), contacts[i].Load, 1e-6);
                Assert.InRange((force - (contacts[i].Load * normals[i]) - contacts[i].Friction).Length, 0, 1e-6);
            }
        }
    }

    /// <summary>On three rough sides at equal angles, each carries a third of the weight, straight down: the forces with the least squares.</summary>
    [Theory]
    [InlineData(15)]
    [InlineData(35)]
    public void Three_sides_carry_a_third_of_the_weight_each(double degrees)
    {
        double angle = degrees * Math.PI / 180;
        Vector3d[] normals = [.. Enumerable.Range(0, 3).Select(i => new Vector3d(Math.Sin(angle) * Math.Cos(0.4 + (i * 2 * Math.PI / 3)), Math.Cos(angle), Math.Sin(angle) * Math.Sin(0.4 + (i * 2 * Math.PI / 3))))];
        SetContact[] contacts = Standing(normals, [1, 1, 1], 0.05, out ContactSystem system);
        Assert.InRange(system.Start.Acceleration.Length + (Radius * system.Start.SpinAcceleration.Length), 0, 1e-6);
        for (int i = 0; i < 3; i++)
        {
            Vector3d force = (contacts[i].Load * contacts[i].Normal) + contacts[i].Friction;
            Assert.InRange((force - new Vector3d(0, Gravity / 3, 0)).Length, 0, 1e-6);
        }
    }

    /// <summary>Walls on both sides that do not press a ball carry nothing, whether it falls between them or stands on a floor.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Walls_on_both_sides_carry_nothing(bool stands)
    {
        var aside = new Vector3d(0.8, 0, 0.6);
        SetContact[] contacts = Standing(stands ? [aside, -aside, Vector3d.Up] : [aside, -aside], [0.5, 0.5, 0.5], 0.05, out ContactSystem system);
        Assert.Equal(0, contacts[0].Load);
        Assert.Equal(0, contacts[1].Load);
        Assert.InRange((system.Start.Acceleration - new Vector3d(0, stands ? 0 : -Gravity, 0)).Length, 0, 1e-9);
        Assert.True(!stands || Math.Abs(contacts[2].Load - Gravity) < 1e-9);
    }

    /// <summary>Three sides around a ball in one plane: two below, and a lid that carries nothing.</summary>
    [Fact]
    public void A_lid_on_a_ball_in_a_groove_carries_nothing()
    {
        SetContact[] contacts = Standing([new(0.6, 0.8, 0), new(0, -1, 0), new(-0.6, 0.8, 0)], [1, 1, 1], 0, out ContactSystem system);
        Assert.Equal(0, contacts[1].Load);
        Assert.Equal(0.8 * Gravity / 2, contacts[0].Load, 1e-6);
        Assert.InRange(system.Start.Acceleration.Length, 0, 1e-6);
    }

    private static SetContact[] Standing(Vector3d[] normals, double[] frictions, double resistance, out ContactSystem system)
    {
        var scene = new Scene
        {
            Air = new Air { Density = 0 },
            Ball = new BallProperties { Radius = Radius },
            Gravity = Gravity,
            Ground = Ground.None,
            Obstacles = [.. normals.Select((n, i) => new Obstacle
            {
                Shape = new PlaneShape(s_place - (Radius * n), n),
                Surface = SurfaceMaterial.GoalFrame with { SlidingFriction = frictions[i], RollingResistance = resistance, TorsionalPatchRadius = 0 },
            })],
        };
        var around = new Surroundings(scene, SceneAir.Of(scene));
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        system = ContactModesTests.Prepared(around, new FootballPhysics.Motion(s_place, default, default), contacts);
        int evaluations = 0;
        Assert.True(ContactModes.Find(ref system, 0, new FootballPhysics.Motion(s_place, default, default), ContactTolerances.Sticking, -1, ref evaluations));
        var found = new SetContact[normals.Length];
        for (int i = 0; i < normals.Length; i++)
        {
            SetContact contact = contacts[i];
            found[Array.FindIndex(normals, n => (n - contact.Normal).Length < 1e-9)] = contact;
        }

        return found;
    }
}
