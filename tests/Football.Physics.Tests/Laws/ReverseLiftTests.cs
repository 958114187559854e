using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>The lift of a smooth ball, which reverses near its crisis.</summary>
public sealed class ReverseLiftTests
{
    private const double Viscosity = 1.5e-5;

    [Theory]
    [InlineData(0.30, -0.163)]
    [InlineData(0, 0.131)]
    public void A_beach_ball_bends_the_wrong_way_near_its_crisis(double reverseLift, double coefficient) =>
        Assert.Equal(coefficient, LiftCoefficient(BallProperties.BeachBall with { ReverseLift = reverseLift }, 10, 30), 0.0005);

    /// <summary>The force is smooth through the spin at which the quotient takes its limit, and vanishes with the spin.</summary>
    [Fact]
    public void It_is_proportional_to_a_small_spin()
    {
        double slow = LiftCoefficient(BallProperties.BeachBall, 12, 1e-3) / 1e-3;
        foreach (double spin in new[] { 5e-3, 2e-2, 0.05, 0.07 })
        {
            Assert.Equal(1, LiftCoefficient(BallProperties.BeachBall, 12, spin) / spin / slow, 1e-4);
        }
    }

    /// <summary>Every form of the laws has the same lift: the table, the functions, the force on a rigid body.</summary>
    [Fact]
    public void Every_form_of_the_laws_has_it()
    {
        Scene scene = SceneOf(BallProperties.BeachBall);
        foreach (double speed in new[] { 4.0, 9, 12.3, 14, 20 })
        {
            foreach (double spin in new[] { 0.3, 5.0, 30, 80 })
            {
                var table = new FieldAir<MeasuredLaw>(scene, SceneAir.Of(scene));
                double across = 0.8 * speed * speed;
                table.Factors(speed * speed, spin, across, DragBranch.Unknown, out _, out double lift, out _, out _);
                AirLaws.Of(scene).Factors(speed * speed, spin, across, DragBranch.Unknown, out _, out double byFunctions, out _);
                table.FactorsPerSpin(speed * speed, spin * spin, spin * spin * across, DragBranch.Unknown, out _, out double perSpin, out _);
                var flow = new AirFlow { Speed = speed, SpeedSquared = speed * speed, SpinRate = spin, AcrossSquared = across };
                double alone = SceneLaws.Magnus(scene).Factor(in flow);
                Assert.Equal(alone, lift, 1e-8);
                Assert.Equal(alone, byFunctions, 1e-8);
                Assert.Equal(alone, spin * perSpin, 1e-8);
                Assert.InRange(Math.Abs(alone) * Math.Sqrt(across), 0, SceneLaws.Magnus(scene).Bound.At(speed, spin) * speed);
            }
        }
    }

    [Fact]
    public void Match_balls_have_none() =>
        Assert.All(BallProperties.Presets.Where(preset => preset.Key != "beachBall"), preset => Assert.Equal(0, preset.Value.ReverseLift));

    private static double LiftCoefficient(BallProperties ball, double speed, double spin)
    {
        var air = new Aerodynamics(SceneOf(ball));
        Vector3d force = air.Evaluate(Vector3d.Zero, new Vector3d(speed, 0, 0), new Vector3d(0, 0, spin)).Force;
        return force.Y / (0.5 * 1.2 * Math.PI * ball.Radius * ball.Radius * speed * speed);
    }

    private static Scene SceneOf(BallProperties ball) => new() { Ball = ball, Air = new Air { Density = 1.2, KinematicViscosity = Viscosity } };
}
