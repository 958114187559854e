using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>The contact tolerances form a ladder: a tolerance allows the errors of the tolerances below it.</summary>
public sealed class ContactToleranceTests
{
    [Fact]
    public void Gaps_form_a_ladder() => Assert.Equal(Gaps, Gaps.Order());

    [Fact]
    public void Speeds_form_a_ladder() => Assert.Equal(Speeds, Speeds.Order());

    [Fact]
    public void A_ball_of_a_pitch_is_located_within_rounding_of_its_position()
    {
        // Half a unit in the last place of a coordinate of 64 m.
        double rounding = 0.5 * (Math.BitIncrement(64.0) - 64.0);
        Assert.InRange(rounding, ContactTolerances.ProjectionError, ContactTolerances.LocatedGap);
    }

    [Fact]
    public void A_projected_ball_touches_and_a_touching_ball_does_not_overlap()
    {
        Assert.True(100 * ContactTolerances.ClosedGap <= ContactTolerances.Touching);
        Assert.True(2 * ContactTolerances.Touching < ContactTolerances.Overlap);
        Assert.True(ContactTolerances.JumpWidth < ContactTolerances.BeyondJump);
        Assert.True(ContactTolerances.EventWidth < ContactTolerances.Beyond);
    }

    [Fact]
    public void Every_tolerance_is_a_positive_number_below_one_in_the_order_of_its_unit()
    {
        string text = File.ReadAllText(Path.Combine(RepositoryFiles.Root, "src", "Football.Physics", "Contacts", "ContactTolerances.cs"));
        string[] units = text.Split("// ----")[1..];
        Assert.Equal(7, units.Length);
        foreach (string unit in units)
        {
            double[] values = [.. unit.Split("const double ").Skip(1).Select(line => Value(line.Split(' ')[0]))];
            Assert.NotEmpty(values);
            Assert.All(values, value => Assert.InRange(value, double.Epsilon, 1));
            Assert.Equal(values, values.Order());
        }
    }

    private static readonly double[] Gaps =
    [
        ContactTolerances.ProjectionError,
        ContactTolerances.LocatedGap,
        ContactTolerances.BallsTouch,
        ContactTolerances.ClosedGap,
        ContactTolerances.Touching,
        ContactTolerances.Overlap,
        ContactTolerances.PileOverlap,
        ContactTolerances.BallOverlap,
        ContactTolerances.Rattling,
    ];

    private static readonly double[] Speeds =
    [
        ContactTolerances.Standstill,
        ContactTolerances.Approaching,
        ContactTolerances.Sticking,
        ContactTolerances.StickingAfterMany,
        ContactTolerances.Leaving,
        ContactTolerances.Pressing,
        ContactTolerances.ReportedSlip,
    ];

    private static double Value(string name) => (double)typeof(ContactTolerances).GetField(name)!.GetRawConstantValue()!;
}
