using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>The measured laws against values worked out with another calculator.</summary>
public sealed class MeasuredLawTests
{
    private static readonly double[] s_reynolds = [0, 5e4, 1e5, 1.5e5, 2e5, 2.5e5, 3e5, 4e5, 5e5];
    private static readonly double[] s_spinParameters = [0, 0.05, 0.1, 0.2, 0.4, 1];

    private static readonly Scene s_scene = Scene.Published with { Ball = BallProperties.Tunnel, Air = new Air { Density = 1.2, KinematicViscosity = 1.5e-5 } };

    public static TheoryData<string, double[]> Balls => new()
    {
        { nameof(BallProperties.Tango12), [.545180, .544922, .541354, .497671, .291744, .179855, .173414, .183522, .194366] },
        { nameof(BallProperties.Teamgeist), [.492697, .492631, .491003, .454930, .230783, .148570, .144003, .147621, .153499] },
        { nameof(BallProperties.Jabulani), [.483900, .483895, .483835, .483112, .474562, .396778, .206964, .154549, .176136] },
        { nameof(BallProperties.Brazuca), [.473999, .473976, .473259, .452510, .257900, .175279, .179270, .194522, .209878] },
        { nameof(BallProperties.Tunnel), [.489994, .489887, .487879, .453946, .256710, .164225, .162789, .173215, .183929] },
    };

    [Theory]
    [MemberData(nameof(Balls))]
    public void Without_spin_every_ball_has_its_drag_coefficient(string ball, double[] expected)
    {
        var drag = new ReynoldsDrag(((BallProperties)typeof(BallProperties).GetProperty(ball)!.GetValue(null)!).DragCurve);
        Assert.All(s_reynolds.Zip(expected), pair => Assert.Equal(pair.Second, drag.Coefficient(pair.First), 1.1e-6));
    }

    /// <summary>The rows of the tunnel are in m/s, at its own viscosity.</summary>
    [Fact]
    public void The_Reynolds_numbers_of_the_balls_are_those_of_the_tunnel()
    {
        Row(DragCurve.Tango12, 186_878, 18_949.3, 235_704);
        Row(DragCurve.Teamgeist, 182_809, 15_563.4, 336_699);
        Row(DragCurve.Jabulani, 271_597, 20_010.1, 338_443);
        Row(DragCurve.Brazuca, 187_749, 14_531.7, 212_308);
        Assert.Equal((186_000, 17_000, 230_000, 510_000), (DragCurve.Generic.CriticalReynolds, DragCurve.Generic.Width, DragCurve.Generic.RiseFrom, DragCurve.Generic.RiseTo));

        static void Row(DragCurve curve, double critical, double width, double riseFrom)
        {
            Assert.Equal(critical, curve.CriticalReynolds, 0.5);
            Assert.Equal(width, curve.Width, 0.05);
            Assert.Equal(riseFrom, curve.RiseFrom, 0.5);
            Assert.Equal(508_609, curve.RiseTo, 0.5);
        }
    }

    [Fact]
    public void Every_preset_of_a_ball_has_its_own_curve_and_knuckle_force()
    {
        (BallProperties Ball, DragCurve Curve, double Force)[] balls =
        [
            (BallProperties.Tunnel, DragCurve.Generic, 1.2), (BallProperties.Tango12, DragCurve.Tango12, 1.3), (BallProperties.Teamgeist, DragCurve.Teamgeist, 0.6),
            (BallProperties.Jabulani, DragCurve.Jabulani, 1.65), (BallProperties.Brazuca, DragCurve.Brazuca, 1.2),
        ];
        Assert.All(balls, item => Assert.Equal((0.43, 0.11, item.Curve, item.Force), (item.Ball.Mass, item.Ball.Radius, item.Ball.DragCurve, item.Ball.KnuckleForce)));
    }

    [Theory]
    [InlineData(1e5, new[] { .487879, .500910, .513655, .537314, .573877, .618622 }, new[] { 0, .043459, .075103, .105855, .121958, .127964 })]
    [InlineData(2.5e5, new[] { .164225, .189832, .214875, .261364, .333208, .421130 }, new[] { 0, .106165, .183469, .258592, .297930, .312603 })]
    [InlineData(4e5, new[] { .173215, .199114, .224444, .271466, .344133, .433061 }, new[] { 0, .107627, .185996, .262154, .302034, .316909 })]
    public void With_spin_across_the_motion_drag_and_lift_have_theirs(double reynolds, double[] drags, double[] lifts)
    {
        double r = s_scene.Ball.Radius;
        double speed = reynolds * s_scene.Air.KinematicViscosity / (2 * r);
        double scale = AirScale.DynamicArea(s_scene) * speed;
        foreach (AirLaws air in Forms())
        {
            for (int i = 0; i < s_spinParameters.Length; i++)
            {
                double spin = s_spinParameters[i] * speed / r;
                air.Factors(speed * speed, spin, speed * speed, DragBranch.NoSpin, out double drag, out double lift, out _);
                Assert.Equal(drags[i], drag / scale, 1.1e-6);
                Assert.Equal(lifts[i], lift / scale, 1.1e-6);
            }
        }
    }

    [Fact]
    public void A_shot_with_spin_has_its_force_and_torque()
    {
        var u = new Vector3d(24, 7, 1);
        var w = new Vector3d(1, 20, 15);
        foreach (AirLaws air in Forms())
        {
            double across = Vector3d.Cross(w / w.Length, in u).LengthSquared;
            air.Factors(u.LengthSquared, w.Length, across, DragBranch.NoSpin, out double drag, out double lift, out double decay);
            Vector3d force = s_scene.Ball.Mass * ((lift * Vector3d.Cross(w / w.Length, in u)) - (drag * u));
            Vector3d torque = -s_scene.Ball.MomentOfInertia * decay / w.Length * w;
            Near(new Vector3d(-3.45161595, 0.75150132, -2.29449527), force, 5e-8);
            Near(new Vector3d(-1.4645e-4, -2.92898e-3, -2.19674e-3), torque, 1e-8);
        }
    }

    [Fact]
    public void Spin_along_the_motion_neither_lifts_nor_drags()
    {
        foreach (AirLaws air in Forms())
        {
            air.Factors(400, 60, 0, DragBranch.NoSpin, out double gyro, out _, out double decay);
            air.Factors(400, 0, 400, DragBranch.NoSpin, out double none, out _, out double still);
            Assert.Equal(none, gyro, 1e-9 * none);
            Assert.True(decay > 0);
            Assert.Equal(0, still);
        }
    }

    [Fact]
    public void Spin_decays_by_speed_and_density_and_at_rest_too()
    {
        var air = new TableAir<MeasuredLaw>(s_scene);
        air.ByFunctions(0, 30, 0, DragBranch.NoSpin, out double drag, out double lift, out double decay);
        Assert.Equal((0, 0), (drag, lift));
        Assert.Equal(0.004 * 30, decay, 1e-9);
        air.ByFunctions(400, 30, 400, DragBranch.NoSpin, out _, out _, out decay);

        // β π ρ r²/(α m) is 1.53e-3 1/m for a football.
        Assert.Equal((0.004 + (1.5276e-3 * 20)) * 30, decay, 1e-4);
    }

    [Fact]
    public void No_speed_and_no_spin_gives_a_number_that_is_not_finite()
    {
        var air = new TableAir<MeasuredLaw>(s_scene);
        foreach (double speed in new[] { 0, double.Epsilon, 1e-160, 1e-10, 1e-9, 1, 1000, 2000 })
        {
            foreach (double spin in new[] { 0, double.Epsilon, 1e-160, 1, 10_000, -1e-12, -1 })
            {
                air.ByFunctions(speed * speed, spin, speed * speed, DragBranch.NoSpin, out double drag, out double lift, out double decay);
                Assert.True(double.IsFinite(drag) && double.IsFinite(lift) && double.IsFinite(decay), $"{speed} m/s, {spin} rad/s");
                Assert.True(drag >= 0);
            }
        }
    }

    /// <summary>What steps are divided by.</summary>
    [Fact]
    public void No_force_is_stronger_than_its_bound()
    {
        Scene scene = LawGrid.Scene with { Forces = ForceSet.Measured };
        var table = new TableAir<MeasuredLaw>(scene);
        AirLaws air = AirLaws.Of(scene);
        Assert.Equal(air.Bound, SceneLaws.Drag(scene).Bound + SceneLaws.Magnus(scene).Bound + SceneLaws.SpinDecay(scene).Bound);
        foreach ((double speed, double spin, _) in LawGrid.Points)
        {
            table.ByFunctions(speed * speed, spin, speed * speed, DragBranch.NoSpin, out double drag, out double lift, out double decay);
            Assert.InRange(drag + lift + (decay / spin), 0, (air.Bound.PerSpeed * speed) + (air.Bound.PerSpin * spin) + air.Bound.Constant);
        }
    }

    /// <summary>By table, and one by one.</summary>
    private static IEnumerable<AirLaws> Forms()
    {
        Scene scene = s_scene with { Forces = ForceSet.Measured };
        return [AirLaws.Of(scene), new MixedLaws(scene, 1, 1)];
    }

    private static void Near(Vector3d expected, Vector3d actual, double tolerance) => Assert.InRange(Vector3d.Distance(actual, expected), 0, tolerance);
}
