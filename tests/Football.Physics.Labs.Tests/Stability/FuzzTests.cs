using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Yardsticks;
using FsCheck;
using FsCheck.Fluent;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>Inputs that are bytes or text, changed with what they mean in mind: refused, or answered rightly.</summary>
public sealed class FuzzTests
{
    public static TheoryData<int> Kinds() => [.. Enumerable.Range(0, FuzzTarget.All.Count)];

    /// <summary>FsCheck draws the seed and how much is changed; of an input that fails it looks for one with fewer changes that fails too.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void Whatever_is_made_of_an_input_it_is_refused_or_answered_rightly(int kind)
    {
        FuzzTarget target = FuzzTarget.All[kind];
        int refused = 0;
        int right = 0;
        var inputs = Gen.Choose(0, int.MaxValue).SelectMany(seed => Gen.Choose(0, 6).Select(changes => (Seed: seed, Changes: changes)));
        Arbitrary<(int Seed, int Changes)> shrinking = Arb.From(inputs, input => Enumerable.Range(0, input.Changes).Select(fewer => (input.Seed, fewer)));
        Prop.ForAll(shrinking, input =>
        {
            bool isRefused = target.Try(target.Make(new SeededRandom(input.Seed), input.Changes));
            refused += isRefused ? 1 : 0;
            right += isRefused ? 0 : 1;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(3000));

        // Neither all nor none: the changes reach beyond the first check.
        Assert.True(refused > 300 && right > 100, $"{refused} refused, {right} right");
    }

    /// <summary>An input that nothing was changed in must be accepted, or the others say nothing.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void An_input_without_a_change_is_accepted(int kind)
    {
        FuzzTarget target = FuzzTarget.All[kind];
        int refused = Enumerable.Range(0, 100).Count(seed => target.Try(target.Make(new SeededRandom(seed), 0)));

        // A few of the bytes and texts are changed beside; wild numbers make half of the segments ones that are refused.
        Assert.InRange(refused, 0, 60);
    }

    [Fact]
    public void What_must_not_be_is_found_with_its_first_input()
    {
        var run = new FuzzRun(new Faulty(), 1);
        for (int i = 0; i < 40; i++)
        {
            run.Try(i);
        }

        Assert.Equal(2, run.Findings.Count);
        Assert.Equal(40, run.Counts["refused"] + run.Counts["right"] + run.Findings.Values.Sum(found => found.Times));
        Assert.All(run.Findings, found => Assert.Equal(found.Key.StartsWith("DivideByZero", StringComparison.Ordinal) ? 3 : 2, run.Input(found.Value.Index)[0] % 4));
    }

    [Fact]
    public void The_lab_reports_every_kind_whatever_the_number_of_threads()
    {
        string[] Rows(string jobs) =>
        [
            .. FootballCommand.Run("", "lab", "fuzz", "--count", "200", "--seed", "5", "--jobs", jobs).Result.GetProperty("tables")[0].GetProperty("rows").EnumerateArray()
                .Select(row => $"{row.GetProperty("kind")} {row.GetProperty("refused")} {row.GetProperty("right")} {row.GetProperty("verdict")}"),
        ];
        string[] rows = Rows("1");
        Assert.All(FuzzTarget.All.Zip(rows), pair => Assert.StartsWith(pair.First.Name, pair.Second));
        Assert.All(rows, row => Assert.EndsWith("reached", row));
        Assert.Equal(rows, Rows("3"));
    }

    /// <summary>Refuses, answers, finds and throws.</summary>
    private sealed class Faulty : FuzzTarget
    {
        public override string Name => "faulty";

        public override byte[] Make(SeededRandom random, int mutations) => [(byte)random.Below(256)];

        public override bool Try(byte[] input)
        {
            Must(input[0] % 4 != 2, "a two");
            return input[0] % 4 == 3 ? throw new DivideByZeroException() : input[0] % 4 == 1;
        }
    }
}
