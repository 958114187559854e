using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Laws;

/// <summary>The fused evaluation of the published laws against their plain twins, wherever it says that it holds.</summary>
public sealed class FusedLawTests
{
    private static readonly double s_radius = LawGrid.Scene.Ball.Radius;

    [Fact]
    public void All_laws_are_the_equations() => Compare<PublishedAir<Present, Present, Present>>(1, 4e-9);

    [Fact]
    public void All_laws_stay_the_equations_while_the_spin_fades_within_a_step() => Compare<PublishedAir<Present, Present, Present>>(0.98, 2e-8);

    [Fact]
    public void Drag_alone_is_the_equation() => Compare<PublishedAir<Present, Absent, Absent>>(1, 4e-9);

    [Fact]
    public void Lift_alone_is_the_equation() => Compare<PublishedAir<Absent, Present, Absent>>(1, 4e-9);

    [Fact]
    public void Decay_alone_is_the_equation() => Compare<PublishedAir<Absent, Absent, Present>>(1, 4e-9);

    /// <summary>Up to a hundred times the spin of a ball that rolls.</summary>
    [Fact]
    public void For_spins_of_any_size_all_laws_are_the_equations() => Compare<SpunAir<Present, Present, Present>>(1, 4e-9);

    [Fact]
    public void For_spins_of_any_size_each_law_alone_is_the_equation()
    {
        Compare<SpunAir<Present, Absent, Absent>>(1, 4e-9);
        Compare<SpunAir<Absent, Present, Absent>>(1, 4e-9);
        Compare<SpunAir<Absent, Absent, Present>>(1, 4e-9);
    }

    /// <summary>The lift is a difference that vanishes at Sp 1.88.</summary>
    [Fact]
    public void For_spins_of_any_size_they_stay_so_while_the_spin_fades_within_a_step() => Compare<SpunAir<Present, Present, Present>>(0.98, 5e-8);

    [Fact]
    public void It_holds_for_every_shot_of_a_match()
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        for (double speed = 3; speed <= 45; speed += 0.5)
        {
            for (double spin = 2; s_radius * spin < 0.65 * speed; spin += 2)
            {
                Assert.True(air.Covers(speed * speed, spin, 0.01), $"{speed} m/s, {spin} rad/s");
            }
        }
    }

    /// <summary>Its powers of the spin are a series about the step's start.</summary>
    [Fact]
    public void It_does_not_hold_where_a_step_takes_a_large_share_of_the_spin()
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        int refused = 0;
        foreach ((double speed, double spin, _) in LawGrid.Points.Where(point => point.Speed is > 3 and < 110 && point.SpinParameter < 0.6))
        {
            foreach (double h in new[] { 0.001, 0.01, 0.04 })
            {
                double loss = h * PlainLaws.DecayTorque(LawGrid.Scene, speed, spin) / LawGrid.Scene.Ball.MomentOfInertia / spin;
                bool covers = air.Covers(speed * speed, spin, h);
                Assert.True(!covers || loss < 0.025, $"{speed} m/s, {spin} rad/s, {h} s: {loss}");
                refused += covers ? 0 : 1;
            }
        }

        Assert.True(refused > 20);
    }

    [Fact]
    public void A_ball_without_spin_has_drag_and_no_lift()
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        foreach (double speed in LawGrid.Speeds.Where(speed => air.Covers(speed * speed, 0, 0.01)))
        {
            air.Begin(0, DragBranch.NoSpin, out AirStep step);
            air.Evaluate(in step, speed * speed, 0, speed * speed, out double drag, out double lift, out _);
            double expected = PlainLaws.Drag(LawGrid.Scene, PlainLaws.WithoutSpin(speed), new Vector3d(speed, 0, 0)).Length / LawGrid.Scene.Ball.Mass / speed;
            Assert.InRange(drag / expected, 1 - 4e-9, 1 + 4e-9);
            Assert.Equal(0, lift);
        }
    }

    /// <param name="fade">Spin at the stage, as a share of that at the step's start.</param>
    /// <param name="tolerance">Relative to the whole acceleration.</param>
    private static void Compare<TAir>(double fade, double tolerance)
        where TAir : struct, IAerodynamics
    {
        Scene scene = LawGrid.Scene;
        TAir air = default;
        air.Prepare(scene);
        var forces = new Errors("acceleration");
        var torques = new Errors("spin deceleration");
        foreach (double speed in Enumerable.Range(0, 400).Select(i => 1.06 * Math.Exp(i * Math.Log(119 / 1.06) / 399)))
        {
            foreach (double start in LawGrid.Spins)
            {
                if (!air.Covers(speed * speed, start, 0.01))
                {
                    continue;
                }

                double spin = fade * start;
                double sp = s_radius * spin / speed;
                DragBranch branch = LawGrid.BranchOf(speed, sp);
                air.Begin(start, branch, out AirStep step);
                air.Evaluate(in step, speed * speed, spin, speed * speed, out double drag, out double lift, out double decay);
                var u = new Vector3d(speed, 0, 0);
                var w = new Vector3d(0, spin, 0);
                double coefficient = PlainLaws.Published(speed, sp);
                Vector3d expected = Vector3d.Zero;
                expected += air.Drags ? PlainLaws.Drag(scene, coefficient, u) : Vector3d.Zero;
                expected += air.Lifts ? PlainLaws.Magnus(scene, PlainLaws.Lift(coefficient, sp), u, w) : Vector3d.Zero;
                Vector3d actual = default;
                actual += air.Drags ? -drag * u : Vector3d.Zero;
                actual += air.Lifts ? lift * Vector3d.Cross(new Vector3d(0, 1, 0), u) : Vector3d.Zero;
                string name = $"{speed} m/s, {start} rad/s (Sp {sp})";
                if (expected.Length > 0)
                {
                    // What the ball feels beside its weight: where lift alone acts and nearly vanishes, an error in it is nothing.
                    double scale = air.Drags ? expected.Length : Math.Max(expected.Length, PlainLaws.Drag(scene, coefficient, u).Length);
                    forces.Add(name, Vector3d.Distance(scene.Ball.Mass * actual, expected) / scale);
                }

                if (air.SpinDecays)
                {
                    torques.Add(name, Math.Abs((decay * scene.Ball.MomentOfInertia / PlainLaws.DecayTorque(scene, speed, spin)) - 1));
                }
            }
        }

        if (air.Drags || air.Lifts)
        {
            Assert.True(forces.Count > 4000);
            forces.Hold(worst: tolerance);
        }

        if (air.SpinDecays)
        {
            torques.Hold(worst: tolerance);
        }
    }
}
