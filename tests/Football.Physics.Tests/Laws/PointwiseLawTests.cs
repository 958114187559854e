using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Laws;

/// <summary>The published laws fused at a single point, and at a step's start, against the laws one by one: every speed and spin, every branch.</summary>
public sealed class PointwiseLawTests
{
    private const double Slowest = 0.5;
    private const double Fastest = 120;

    /// <summary>Sp of a ball whose spin's polynomial ends: from there on the plates are asked one by one.</summary>
    private static readonly double s_fast = 2 * Math.Sqrt(0.27);

    [Fact]
    public void All_laws_are_the_laws_one_by_one() => Compare<Present, EmpiricalDrag, Present, EmpiricalMagnus, Present, EmpiricalSpinDecay>();

    [Fact]
    public void Without_decay_they_are_the_laws_one_by_one() => Compare<Present, EmpiricalDrag, Present, EmpiricalMagnus, Absent, NoAirLaw>();

    [Fact]
    public void Drag_alone_is_the_law() => Compare<Present, EmpiricalDrag, Absent, NoAirLaw, Absent, NoAirLaw>();

    [Fact]
    public void Drag_and_decay_are_the_laws() => Compare<Present, EmpiricalDrag, Absent, NoAirLaw, Present, EmpiricalSpinDecay>();

    [Fact]
    public void Lift_alone_is_the_law() => Compare<Absent, NoAirLaw, Present, EmpiricalMagnus, Absent, NoAirLaw>();

    [Fact]
    public void Lift_and_decay_are_the_laws() => Compare<Absent, NoAirLaw, Present, EmpiricalMagnus, Present, EmpiricalSpinDecay>();

    [Fact]
    public void Decay_alone_is_the_law() => Compare<Absent, NoAirLaw, Absent, NoAirLaw, Present, EmpiricalSpinDecay>();

    [Theory]
    [InlineData(0.5, 30)]
    [InlineData(0.01, 30)]
    [InlineData(0, 30)]
    [InlineData(120, 30)]
    [InlineData(200, 30)]
    [InlineData(1e6, 30)]
    [InlineData(20, 0)]
    [InlineData(20, -1e-3)]
    [InlineData(20, double.NaN)]
    [InlineData(double.NaN, 30)]
    public void Elsewhere_it_does_not_answer(double speed, double spin)
    {
        PublishedAir<Present, Present, Present> air = default;
        air.Prepare(LawGrid.Scene);
        foreach (DragBranch branch in Enum.GetValues<DragBranch>())
        {
            Assert.False(air.EvaluateAt(branch, speed * speed, spin, speed * speed, out double drag, out double lift, out double decay));
            Assert.Equal((0, 0, 0), (drag, lift, decay));
        }
    }

    /// <summary>Where the fused laws do not answer, to the bit the laws one by one.</summary>
    [Fact]
    public void Either_way_every_point_has_its_forces()
    {
        EitherAir<PublishedAir<Present, Present, Present>, Aerodynamics<PublishedDragFit, EmpiricalDrag, EmpiricalMagnus, EmpiricalSpinDecay>> either = default;
        PublishedAir<Present, Present, Present> fused = default;
        Aerodynamics<PublishedDragFit, EmpiricalDrag, EmpiricalMagnus, EmpiricalSpinDecay> laws = default;
        either.Prepare(LawGrid.Scene);
        fused.Prepare(LawGrid.Scene);
        laws.Prepare(LawGrid.Scene);
        Assert.True(either.Drags && either.Lifts && either.Jumps && either.SpinDecays);
        int byLaws = 0;
        foreach (double speed in LawGrid.Speeds.Append(0))
        {
            foreach (double spin in LawGrid.Spins.Append(0).Append(-1e-3))
            {
                foreach (DragBranch branch in Enum.GetValues<DragBranch>())
                {
                    double square = speed * speed;
                    either.Begin(spin, branch, out AirStep step);
                    either.Evaluate(in step, square, spin, square, out double drag, out double lift, out double decay);
                    either.EvaluateStart(ref step, square, spin, square, out double startDrag, out double startLift, out double startDecay);
                    Assert.Equal((drag, lift, decay), (startDrag, startLift, startDecay));
                    Assert.False(either.Expand(in step, 0, 0, out _));
                    if (!fused.EvaluateAt(branch, square, spin, square, out double fusedDrag, out double fusedLift, out double fusedDecay))
                    {
                        laws.Begin(spin, branch, out AirStep once);
                        laws.Evaluate(in once, square, spin, square, out fusedDrag, out fusedLift, out fusedDecay);
                        byLaws++;
                    }

                    Assert.Equal((fusedDrag, fusedLift, fusedDecay), (drag, lift, decay));
                }
            }
        }

        Assert.InRange(byLaws, 500, 5000);
    }

    private static void Compare<TDrag, TDragLaw, TMagnus, TMagnusLaw, TDecay, TDecayLaw>()
        where TDrag : struct, IPresence
        where TDragLaw : struct, IAirLaw
        where TMagnus : struct, IPresence
        where TMagnusLaw : struct, IAirLaw
        where TDecay : struct, IPresence
        where TDecayLaw : struct, IAirLaw
    {
        PublishedAir<TDrag, TMagnus, TDecay> air = default;
        Aerodynamics<PublishedDragFit, TDragLaw, TMagnusLaw, TDecayLaw> laws = default;
        Aerodynamics<PublishedDragFit, EmpiricalDrag, NoAirLaw, NoAirLaw> drags = default;
        air.Prepare(LawGrid.Scene);
        laws.Prepare(LawGrid.Scene);
        drags.Prepare(LawGrid.Scene);
        var forces = new Errors("forces");
        var decays = new Errors("decay");
        int starts = 0;
        foreach ((double speed, double spin) in Points())
        {
            double square = speed * speed;
            double sp = LawGrid.Scene.Ball.Radius * spin / speed;
            foreach (DragBranch branch in Enum.GetValues<DragBranch>())
            {
                Assert.True(air.EvaluateAt(branch, square, spin, square, out double drag, out double lift, out double decay));
                laws.Begin(spin, branch, out AirStep once);
                laws.Evaluate(in once, square, spin, square, out double expectedDrag, out double expectedLift, out double expectedDecay);
                drags.Evaluate(in once, square, spin, square, out double anyDrag, out _, out _);
                string name = $"{speed} m/s, {spin} rad/s (Sp {sp}), {branch}";

                // Of two forces that nearly cancel in a law, or of one beside another that is far larger, an error is nothing.
                double scale = anyDrag * Math.Max(1, Math.Pow(sp, 0.83));
                if (default(TDrag).Is)
                {
                    forces.Add(name, Math.Abs(drag - expectedDrag) / scale);
                }

                Assert.True(lift >= 0 || branch != DragBranch.Spinning, name);
                forces.Add(name, Math.Abs(lift - expectedLift) / scale);
                if (default(TDecay).Is)
                {
                    decays.Add(name, Math.Abs((decay / expectedDecay) - 1));
                }
                else
                {
                    Assert.Equal(0, decay);
                }

                if (sp < s_fast * (1 - 1e-9))
                {
                    // The same expressions, so the same bits.
                    starts++;
                    air.Begin(spin, branch, out AirStep step);
                    air.EvaluateStart(ref step, square, spin, square, out double startDrag, out double startLift, out double startDecay);
                    Assert.Equal((drag, lift, decay), (startDrag, startLift, startDecay));
                }
            }
        }

        Assert.True(starts > 10_000);
        forces.Hold(worst: 5e-10);
        if (default(TDecay).Is)
        {
            decays.Hold(worst: 1e-10);
        }
    }

    /// <summary>A dense grid of the whole domain, the plain grid with its jumps, the ends, and points at random.</summary>
    private static IEnumerable<(double Speed, double Spin)> Points()
    {
        var random = new Random(12);
        var dense = from speed in Enumerable.Range(0, 60).Select(i => 0.5001 * Math.Pow(119.99 / 0.5001, i / 59.0))
                    from spin in Enumerable.Range(0, 60).Select(i => 1e-6 * Math.Pow(1e9, i / 59.0))
                    select (speed, spin);
        var plain = LawGrid.Points.Select(point => (point.Speed, point.Spin)).Where(point => point.Speed is > Slowest and < Fastest);
        var drawn = Enumerable.Range(0, 5000).Select(_ => (0.51 * Math.Pow(119 / 0.51, random.NextDouble()), 1e-3 * Math.Pow(1e6, random.NextDouble())));
        return [.. dense, .. plain, .. drawn];
    }
}
