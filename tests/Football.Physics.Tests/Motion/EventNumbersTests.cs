using System.Globalization;

namespace FootballPhysics.Tests.Motion;

/// <summary>What sound and effects ask of an event.</summary>
public sealed class EventNumbersTests
{
    [Fact]
    public void An_impact_tells_its_speeds_its_slip_and_its_energy()
    {
        var simulator = new Simulator();
        BallProperties ball = simulator.Scene.Ball;
        BallState state = simulator.Launch(new Vector3d(0, 3, 0), new Vector3d(0, -2, -12), new Vector3d(-40, 0, 0));
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 5, StopAt.Impact, log);
        BallEvent impact = log.Events[0];
        Assert.Equal(-impact.VelocityBefore.Y, impact.ApproachSpeed, 1e-12);

        // v_z − (−ω_x r): topspin turns the lowest point back.
        Impact outputs = simulator.ImpactOf(in impact);
        Assert.Equal(Math.Abs(impact.VelocityBefore.Z - (impact.SpinBefore.X * ball.Radius)), outputs.SlipBefore, 1e-12);
        double before = Energy(ball, impact.VelocityBefore, impact.SpinBefore);
        double after = Energy(ball, impact.Velocity, impact.Spin);
        Assert.Equal(before - after, outputs.EnergyLost, 1e-12);
        Assert.InRange(outputs.EnergyLost, 1, before);
        Assert.Equal((long)(impact.Time / 0.01), impact.TickAt(0.01));
        Assert.StartsWith("Impact at ", impact.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Vectors_and_rotations_are_printed_in_the_format_asked_for()
    {
        Assert.Equal("(1.00, -2.50, 0.33)", new Vector3d(1, -2.5, 1.0 / 3).ToString("F2", CultureInfo.InvariantCulture));
        Assert.Equal("(1.0, 0.0, 0.0)", FormattableString.Invariant($"{new Vector3d(1, 0, 0):F1}"));
        Assert.Equal("(0.0, 0.0, 0.0, 1.0)", Quaterniond.Identity.ToString("F1", CultureInfo.InvariantCulture));
        Assert.Equal("(1, 2, 3)", new Vector3d(1, 2, 3).ToString());
    }

    private static double Energy(BallProperties ball, Vector3d velocity, Vector3d spin) =>
        0.5 * ((ball.Mass * velocity.LengthSquared) + (ball.MomentOfInertia * spin.LengthSquared));
}
