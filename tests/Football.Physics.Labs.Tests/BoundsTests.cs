using FootballPhysics.Benchmarks;

namespace FootballPhysics.Labs.Tests;

/// <summary>The bounds of the times that benchmarks/paired.sh compares.</summary>
public sealed class BoundsTests
{
    private static readonly string[] s_lines = ["row\tunit\tbound\treason", "^Contact: .*, moving\tflight steps\t30\tone law", "^Contact: \tratio\t1.1\ttwo laws"];
    private readonly Bounds _bounds = new(1.03, s_lines);

    [Theory]
    [InlineData("Kick: rolling, RK2", false, 1.03)]
    [InlineData("Contact: in a gutter, moving: RK2", true, 30)]
    [InlineData("Contact: in a gutter, at rest: RK2", false, 1.1)]
    public void TheFirstPatternThatMatchesDecides(string row, bool inFlightSteps, double most) => Assert.Equal((inFlightSteps, most), _bounds.Of(row));

    [Theory]
    [InlineData(true, 1.04, 1.2, 1.05)]
    [InlineData(false, 1.04, 1.2, 1.02)]
    [InlineData(false, 1.04, 1.2)]
    [InlineData(true, 1.04, 1.2, 1.05, 1.01, 1.04, 1.04)]
    [InlineData(false, 1.04, 1.2, 1.05, 1.01, 1.04, 1.02)]
    public void ARowFailsIfItIsAboveItsBoundInThreeRunsAndInTheMedianOfTheOthers(bool fails, params double[] ratios) =>
        Assert.Equal(fails, _bounds.Fails("Kick: rolling, RK2", ratios, [50, 50, 50], 3));

    [Fact]
    public void ABoundInFlightStepsIgnoresTheRatio()
    {
        const string Row = "Contact: in a gutter, moving: RK2";
        Assert.False(_bounds.Fails(Row, [4, 4, 4], [29, 31, 31], 3));
        Assert.True(_bounds.Fails(Row, [1, 1, 1], [31, 31, 32], 3));
    }

    [Fact]
    public void APatternThatMatchesNoRowIsReported() => Assert.Equal(["^Contact: .*, moving"], _bounds.Unused(["Contact: in a gutter, at rest: RK2", "Kick: rolling, RK2"]));

    [Theory]
    [InlineData("^Kick\tratio\t1.1")]
    [InlineData("^Kick\tratio\t1.1\t")]
    [InlineData("^Kick\tpercent\t10\tslow")]
    [InlineData("^Kick\tratio\tmuch\tslow")]
    public void ALineOfAnotherFormIsRejected(string line) => Assert.Throws<FormatException>(() => new Bounds(1.03, ["row\tunit\tbound\treason", line]));

    [Fact]
    public void TheFileOfTheRepositoryCanBeRead() => Assert.Equal((true, 30.0), new Bounds(1.03, RepositoryFiles.Text("benchmarks/bounds.tsv").TrimEnd('\n').Split('\n')).Of("Contact: in a tilted gutter, moving: RK2"));
}
