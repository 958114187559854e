using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Motion;

/// <summary>How long a piece may be for its slip or roll: by the turn of the direction, and by the share that it changes.</summary>
public sealed class TurnLimitTests
{
    private static readonly Vector3d s_along = new Vector3d(2, 1, -2) / 3;
    private static readonly Vector3d s_across = new Vector3d(1, 2, 2) / 3;

    /// <summary>A slip that friction ends more than twice within the piece: locked if it does not turn, and shortened to twice its end if it does.</summary>
    [Theory]
    [InlineData(0.02, 3, -3, 0, false, 1)]
    [InlineData(1, 3, -3, 5, false, 1)]
    [InlineData(0.001, 3, -3, 0, true, 1)]
    [InlineData(0.001, 3, -3, 0.5, false, 0.0666666666666666667)]
    [InlineData(0.001, 3, 100, 9e-6, true, 1)]
    [InlineData(0.001, 3, 100, 2e-5, false, 0.0666666666666666667)]
    [InlineData(0.001, 3, -100, 9e-6, false, 0.0666666666666666667)]
    public void A_slow_slip_is_locked_or_followed(double size, double friction, double along, double across, bool locks, double share)
    {
        double h = TurnLimit.Follow(0.01, s_along, size, (along * s_along) + (across * s_across), friction, out bool isLocked);
        Assert.Equal(locks, isLocked);
        Assert.Equal(0.01 * share, h, 1e-12);
    }

    /// <summary>Across the direction an eighth of the size may change, against it three quarters; between them the share grows with the root of the angle, if the surface hardly turns.</summary>
    [Theory]
    [InlineData(0, 4, 0, 0.02, 0.125)]
    [InlineData(7, 4, 0, 0.01, 0.125)]
    [InlineData(7, 0.001, 0, 0.02, 0.125)]
    [InlineData(-4, 0, 0, 0.02, 0.75)]
    [InlineData(-4, 0, 100, 0.02, 0.125)]
    [InlineData(-4, 0, 0.1, 0.02, 0.75)]
    [InlineData(-4, 3, 0, 0.02, 0.125)]
    [InlineData(0, 4, 0, 0.08, 0.25)]
    [InlineData(0, 4, 0, 5, 0.4)]
    [InlineData(-4, 0.004, 0, 0.02, 0.75)]
    [InlineData(-4, 0.1, 0, 0.02, 0.25)]
    public void A_piece_changes_a_share_of_a_slip(double along, double across, double turning, double step, double share)
    {
        const double Size = 0.03;
        Vector3d rate = (along * s_along) + (across * s_across);
        double closing = Math.Sqrt((across * across) + (along < 0 ? along * along : 0));
        double longest = share * Size / closing;
        Assert.Equal(longest, TurnLimit.Shorten(100, step, s_along, Size, rate, turning), 1e-3 * longest);
        Assert.Equal(0.9 * longest, TurnLimit.Shorten(0.9 * longest, step, s_along, Size, rate, turning));
    }

    [Fact]
    public void The_share_doubles_if_a_slip_turns_by_a_quarter()
    {
        double Of(double across) => TurnLimit.Shorten(100, 0.02, s_along, 1, (-1 * s_along) + (across * s_across), 0);
        double before = Of(0.05);
        Assert.Equal(2, Of(0.0125) / before, 0.02);
        Assert.True(Of(1e-9) > before);
        Assert.Equal(0.75, Of(0), 1e-12);
    }

    /// <summary>The part of a piece in which friction turns the direction back faster than the method follows: change across times (λ h)⁴.</summary>
    [Theory]
    [InlineData(0.02)]
    [InlineData(0.06)]
    public void A_stiff_piece_is_shortened(double step)
    {
        var random = new Random(5);
        int shortened = 0;
        double most = 2.5e-7 * Math.Pow(Math.Max(1, step / 0.02), 4);
        for (int i = 0; i < 200; i++)
        {
            double h = 0.001 + (0.05 * random.NextDouble());
            double size = 0.05 + random.NextDouble();
            double friction = 10 * random.NextDouble();
            double across = random.NextDouble();
            Vector3d rate = (((10 * random.NextDouble()) - 5) * s_along) + (across * s_across);
            double off = across * h * Math.Pow(friction / size * h, 4);
            double expected = off > most ? h * Math.Pow(most / off, 0.25) : h;
            Assert.Equal(expected, TurnLimit.ShortenStiff(h, step, s_along, size, rate, friction), 1e-9 * h);
            shortened += off > most ? 1 : 0;
        }

        Assert.InRange(shortened, 40, 199);
    }

    /// <summary>A turn of at most an eighth, and at most 1e-5 of turn times the fourth power of the changed share of the rest.</summary>
    [Fact]
    public void A_piece_is_allowed_by_its_turn_and_its_change()
    {
        var random = new Random(6);
        int allowed = 0;
        for (int i = 0; i < 2000; i++)
        {
            double size = 0.1 + random.NextDouble();
            double along = size * ((2.4 * random.NextDouble()) - 1.4) * Math.Pow(random.NextDouble(), 2);
            double across = size * Math.Pow(random.NextDouble(), 6);
            double left = size + along;
            double turn = across / left;
            double share = Math.Sqrt((along * along) + (across * across)) / left;
            bool expected = left > 0 && turn <= 0.125 && turn * Math.Pow(share, 4) <= 1e-5;
            Assert.Equal(expected, TurnLimit.Allows(size, along, across));
            allowed += expected ? 1 : 0;
        }

        Assert.InRange(allowed, 400, 1900);
    }
}
