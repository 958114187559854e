using System.Globalization;

namespace FootballPhysics.Tests.Api;

/// <summary>Values are written with the format and the culture that are asked for, and by default with the invariant one.</summary>
public sealed class FormatTests
{
    private static readonly Simulator s_simulator = new(Scene.Published);
    private static readonly BallState s_state = s_simulator.Launch(new Vector3d(0, 1.2345, 0), new Vector3d(0, 6.5432, -20), new Vector3d(0, 1.2345, 0));

    public static TheoryData<string, IFormattable> Values()
    {
        var path = new Trajectory();
        s_simulator.LookAhead(in s_state, new LookAheadRequest(), path);
        var log = new StepLog();
        BallState ball = s_state;
        s_simulator.Step(ref ball, 3, log);
        return new()
        {
            { "(0.00, 1.23, 0.00)", s_state.Position },
            { "Airborne at 0.00 s, (0.00, 1.23, 0.00), (0.00, 6.54, -20.00) m/s, (0.00, 1.23, 0.00) rad/s", s_state },
            { "0.00 s: (0.00, 1.23, 0.00)", path.ClosestApproach(s_state.Position) },
            { FormattableString.Invariant($"Impact at {log.Events[0].Time:F2} s, {log.Events[0].Position:F2}, {log.Events[0].Velocity:F2} m/s"), log.Events[0] },
            { "(0.00, 1.23, 0.00), (0.00, 0.00, 0.00, 1.00)", new BallPose(s_state.Position, s_state.Orientation) },
            { "tick 7: (0.00, 6.54, -20.00) m/s, (0.00, 1.23, 0.00) rad/s, player 3", new KickInput(7, s_state.Velocity, s_state.Spin, 3) },
            { "(0.00, 1.23, 0.00), normal (0.00, 1.00, 0.00)", new Plane3d(s_state.Position, Vector3d.Up) },
        };
    }

    [Theory]
    [MemberData(nameof(Values))]
    public void A_value_has_the_format_that_is_asked_for(string expected, IFormattable value)
    {
        Assert.Equal(expected, value.ToString("F2", null));
        Assert.Equal(value.ToString(), FormattableString.Invariant($"{value}"));
        Assert.Equal(expected.Replace('.', ';').Replace(',', ' '), value.ToString("F2", Commas()).Replace(',', ' '));
    }

    [Fact]
    public void A_result_has_the_format_that_is_asked_for()
    {
        AimResult result = new Aimer(s_simulator).Find(new AimRequest { Target = new Vector3d(0, 1, -20) });
        Assert.StartsWith("Hit: 25.0 m/s, elevation ", result.ToString("F1"), StringComparison.Ordinal);
        Assert.Equal(result.ToString(), FormattableString.Invariant($"{result}"));
    }

    [Fact]
    public void A_vector_is_normalized_mixed_taken_apart_and_converted()
    {
        var vector = new Vector3d(3, 0, -4);
        Assert.Equal(new Vector3d(0.6, 0, -0.8), vector.Normalized());
        Assert.Equal(new Vector3d(1.5, 1, -2), Vector3d.Lerp(vector, new Vector3d(0, 2, 0), 0.5));
        (double x, double y, double z) = vector;
        Assert.Equal((3.0, 0.0, -4.0), (x, y, z));
        Assert.Equal(vector, (Vector3d)(System.Numerics.Vector3)vector);
    }

    /// <summary>A culture whose decimal separator is its own.</summary>
    private static NumberFormatInfo Commas() => new() { NumberDecimalSeparator = ";" };
}
