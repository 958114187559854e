using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>The closed forms of a ball on a line, on its spot, or in a slide between planes, against the linear system of all contacts with the same modes.</summary>
public sealed unsafe class LineForcesTests
{
    private const double Radius = 0.11;

    private static readonly Vector3d s_place = new(0.3, 0.2, -0.2);

    /// <summary>One plane without slip and one with: at any speed and spin, held or not.</summary>
    [Theory]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    [InlineData(true, true)]
    public void A_roll_along_a_second_plane_has_the_forces_of_the_general_law(bool pinned, bool holdsSpin)
    {
        var random = new Random(40);
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        Touched* set = stackalloc Touched[Touched.Most];
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int draw = 0; draw < 60; draw++)
        {
            Surroundings around = Around(random, 2, set);
            LineForces forces = default;
            Assert.True(forces.Prepare(in set[0], in set[1], around.World.Ball));
            double speed = pinned ? 0 : Any(-5, 5);
            double about = holdsSpin ? 0 : Any(-30, 30);
            forces.Pinned = pinned;
            forces.HoldsSpin = holdsSpin;
            forces.Direction = speed < 0 ? -1 : 1;
            forces.SpinSign = holdsSpin ? 0 : Math.Sign(about);
            forces.SlipSign = forces.Slip(speed, about) < 0 ? -1 : 1;
            Vector3d spin = (speed * forces.SpinPerSpeed) + (about * forces.Normal);
            ContactSystem system = SystemOf(around, contacts, speed * forces.Along, spin, 1);
            contacts[1].Direction = forces.SlipSign * forces.Along;
            system.Pinned = pinned;
            system.HoldsSpin = holdsSpin;
            system.SpinSign = forces.SpinSign;
            system.Along = (speed < 0 ? -1 : 1) * forces.Along;
            Vector3d push = Draw(random, 10);
            Vector3d torque = Draw(random, 50);
            Vector3d acceleration = push;
            Vector3d turning = torque;
            ContactForces.Solve(ref system, in spin, ref acceleration, ref turning);
            forces.Evaluate(in push, in torque, speed, about, out LineRates rates);
            Same(Vector3d.Dot(acceleration, forces.Along), rates.Along);
            Same(holdsSpin ? 0 : Vector3d.Dot(turning, forces.Normal), rates.About);
            Same(contacts[0].Load, rates.Load);
            Same(contacts[1].Load, rates.Other);
            Same(contacts[0].Grip, rates.Grip);
            Assert.True(rates.Third > 0 && rates.OtherGrip > 0);
            if (pinned)
            {
                Same((set[0].Rolling * contacts[0].Load) - Math.Abs(system.Held), rates.Hold);
            }
            else
            {
                Assert.True(rates.Hold > 0);
            }

            if (holdsSpin)
            {
                Same((set[0].Drilling * contacts[0].Load) - Math.Abs(system.HeldSpin), rates.HoldSpin);
            }
            else
            {
                Assert.True(rates.HoldSpin > 0);
            }

            Limits(in rates);
        }
    }

    /// <summary>Both planes without slip, in a gutter.</summary>
    [Fact]
    public void A_roll_in_a_gutter_has_the_forces_of_the_general_law()
    {
        var random = new Random(41);
        Touched* set = stackalloc Touched[Touched.Most];
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int draw = 0; draw < 70; draw++)
        {
            Surroundings around = Around(random, 2, set);
            LineForces forces = default;
            Assert.True(forces.Prepare(in set[0], in set[1], around.World.Ball));
            forces.StickBoth();
            double speed = (10 * random.NextDouble()) - 5;
            forces.Direction = Math.Sign(speed);
            double about = forces.AboutNormal(speed, 0);
            forces.SpinSign = Math.Sign(about);
            Vector3d spin = speed * forces.SpinPerSpeed;
            ContactSystem system = SystemOf(around, contacts, speed * forces.Along, spin, 2);
            system.SpinSign = forces.SpinSign;
            system.Along = forces.Direction * forces.Along;
            Vector3d push = (8 * -(contacts[0].Normal + contacts[1].Normal)) + Draw(random, 3);
            Vector3d torque = Draw(random, 20);
            Vector3d acceleration = push;
            Vector3d turning = torque;
            ContactForces.Solve(ref system, in spin, ref acceleration, ref turning);
            forces.Evaluate(in push, in torque, speed, 0, out LineRates rates);
            Same(Vector3d.Dot(acceleration, forces.Along), rates.Along, 1e-6);
            Same(contacts[0].Load, rates.Load, 1e-6);
            Same(contacts[1].Load, rates.Other, 1e-6);
            Same(contacts[0].Grip, rates.Grip, 1e-6);
            Same(contacts[1].Grip, rates.OtherGrip, 1e-6);
            Limits(in rates);
        }
    }

    /// <summary>A ball that spins on its spot between three planes.</summary>
    [Fact]
    public void A_ball_on_its_spot_has_the_forces_of_the_general_law()
    {
        var random = new Random(42);
        int tried = 0;
        Touched* set = stackalloc Touched[Touched.Most];
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int draw = 0; draw < 70; draw++)
        {
            Surroundings around = Around(random, 3, set);
            LineForces forces = default;
            double about = (60 * random.NextDouble()) - 30;
            Assert.True(forces.Prepare(in set[0], in set[1], around.World.Ball));
            if (!forces.Close(in set[2], Math.Sign(about)))
            {
                continue;
            }

            forces.SpinSign = Math.Sign(about);
            Vector3d spin = about * forces.Normal;
            ContactSystem system = SystemOf(around, contacts, Vector3d.Zero, spin, 1);
            system.SpinSign = forces.SpinSign;
            Vector3d push = Draw(random, 10);
            Vector3d torque = Draw(random, 20);
            Vector3d acceleration = push;
            Vector3d turning = torque;
            ContactForces.Solve(ref system, in spin, ref acceleration, ref turning);
            forces.Evaluate(in push, in torque, 0, about, out LineRates rates);
            double size = 1e-8 * (1 + Math.Abs(contacts[0].Load) + Math.Abs(contacts[1].Load) + Math.Abs(contacts[2].Load));
            Same(Vector3d.Dot(turning, forces.Normal), rates.About, 1000 * size);
            Same(contacts[0].Load, rates.Load, size);
            Same(contacts[1].Load, rates.Other, size);
            Same(contacts[2].Load, rates.Third, size);
            Same(contacts[0].Grip, rates.Grip, size);
            Same(contacts[2].Slip.Length, forces.ThirdSlip(about), 1e-12);
            Limits(in rates);
            tried++;
        }

        Assert.InRange(tried, 50, 70);
    }

    /// <summary>Both planes with slip, at any spin; drilling friction at either of them, or holding the spin.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_slide_along_two_planes_has_the_forces_of_the_general_law(bool holdsSpin)
    {
        var random = new Random(43);
        int determined = 0;
        Touched* set = stackalloc Touched[Touched.Most];
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int draw = 0; draw < 70; draw++)
        {
            Surroundings around = Around(random, 2, set, drills: draw % 4 > 0);
            SlideForces forces = default;
            Assert.True(forces.Prepare(in set[0], in set[1], around.World.Ball));
            double speed = (10 * random.NextDouble()) - 5;
            bool isSecond = random.Next(2) == 0;
            Vector3d n = set[isSecond ? 1 : 0].Normal;
            Vector3d spin = Draw(random, 30);
            spin -= holdsSpin ? Vector3d.Dot(spin, n) * n : Vector3d.Zero;
            Vector3d given = spin;
            forces.Bear(isSecond, in set[isSecond ? 1 : 0], ref spin);
            Assert.InRange((given - spin).Length, 0, 1e-12);
            double about = holdsSpin ? 0 : Vector3d.Dot(spin, n);
            bool drills = set[isSecond ? 1 : 0].Drilling > 0;
            Assert.Equal(Math.Sign(about), forces.SpinSign);
            Assert.Equal(drills && !holdsSpin, forces.Drills);
            Vector3d first = forces.FirstSlip(speed, in spin);
            Vector3d second = forces.SecondSlip(speed, in spin);
            forces.FirstDirection = first / first.Length;
            forces.SecondDirection = second / second.Length;
            ContactSystem system = SystemOf(around, contacts, speed * forces.Along, spin, 0);
            Assert.InRange((contacts[0].Slip - first).Length + (contacts[1].Slip - second).Length, 0, 1e-12);
            system.Bearer = isSecond ? 1 : 0;
            system.SpinSign = forces.SpinSign;
            system.HoldsSpin = holdsSpin && drills;
            Vector3d push = Draw(random, 10);
            Vector3d torque = Draw(random, 50);
            Vector3d acceleration = push;
            Vector3d turning = torque;
            ContactForces.Solve(ref system, in spin, ref acceleration, ref turning);
            forces.Evaluate(in push, in torque, speed, in spin, out SlideRates rates);
            if (double.IsNaN(rates.First))
            {
                continue;
            }

            double size = 1e-8 * (1 + Math.Abs(contacts[0].Load) + Math.Abs(contacts[1].Load));
            Same(Vector3d.Dot(acceleration, forces.Along), rates.Along, size);
            Same(contacts[0].Load, rates.First, size);
            Same(contacts[1].Load, rates.Second, size);
            Assert.InRange((turning - rates.Spin).Length, 0, 1000 * size);
            if (system.HoldsSpin)
            {
                Same((set[system.Bearer].Drilling * contacts[system.Bearer].Load) - Math.Abs(system.HeldSpin), rates.HoldSpin, 1000 * size);
            }
            else
            {
                Assert.True(rates.HoldSpin > 0);
            }

            determined++;
        }

        Assert.InRange(determined, 50, 70);
    }

    /// <summary>Modes hold if every load and margin is positive, and are kept if each keeps its share.</summary>
    private static void Limits(in LineRates rates)
    {
        double[] all = [rates.Load, rates.Other, rates.Third, rates.Grip, rates.OtherGrip, rates.Hold, rates.HoldSpin];
        if (all.All(at => Math.Abs(at) > 1e-6))
        {
            Assert.Equal(all.All(at => at > 0), rates.IsValid);
            LineRates start = new() { Load = 1, Other = 1, Third = 1, Grip = 1, OtherGrip = 1, Hold = 1, HoldSpin = 1 };
            Assert.True(start.Keeps(in start, 0.9));
            Assert.Equal(all.All(at => at > 0.25), rates.Keeps(in start, 0.25));
        }
    }

    private static void Same(double expected, double actual, double within = 1e-8) => Assert.Equal(expected, actual, within * (1 + Math.Abs(expected)));

    /// <summary>The contacts with given modes: so many of the first ones stick, and the first is the bearer.</summary>
    private static ContactSystem SystemOf(Surroundings around, SetContact* contacts, Vector3d velocity, Vector3d spin, int sticking)
    {
        var at = new FootballPhysics.Motion(s_place, in velocity, in spin);
        ContactSystem system = ContactModesTests.Prepared(around, in at, contacts);
        for (int i = 0; i < system.Count; i++)
        {
            contacts[i].Look(system.World, 0, in at);
            contacts[i].Bears = true;
            contacts[i].Sticks = i < sticking;
            contacts[i].Direction = contacts[i].Slip.Length > 0 ? contacts[i].Slip / contacts[i].Slip.Length : default;
        }

        system.Bearer = 0;
        return system;
    }

    private static Surroundings Around(Random random, int count, Touched* set, bool drills = true)
    {
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        var scene = new Scene
        {
            Air = new Air { Density = 0 },
            Ball = new BallProperties { Radius = Radius, InertiaFactor = Any(0.4, 0.9) },
            Ground = Ground.None,
            Obstacles = [.. Enumerable.Range(0, count).Select(i =>
            {
                Vector3d n = (Draw(random, 1) + new Vector3d(0, 0.6, 0)).Normalized();
                return new Obstacle
                {
                    Name = $"{i}",
                    Shape = new PlaneShape(s_place - (Radius * n), n),
                    Surface = SurfaceMaterial.Board with
                    {
                        SlidingFriction = Any(0.05, 0.6),
                        RollingResistance = Any(0.01, 0.1),
                        RollingResistancePerSpeed = Any(0, 0.01),
                        SpinDamping = Any(0, 1e-3),
                        TorsionalPatchRadius = drills ? Any(0.001, 0.02) : 0,
                    },
                };
            })],
        };
        var around = new Surroundings(scene, SceneAir.Of(scene));
        BallState s = new() { Position = s_place };
        Assert.Equal(count, Touched.Find(around.World, in s, 0.01, 1e-9, set));
        return around;
    }

    private static Vector3d Draw(Random random, double size) => size * new Vector3d((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
}
