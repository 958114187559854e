using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Sweep;

/// <summary>The arguments of football sweep.</summary>
internal sealed class SweepOptions
{
    /// <summary>Most rows of a sweep: up to there every index is exact.</summary>
    private const long MostRows = 1_000_000_000_000_000;

    public Argument<string?> File { get; } = new("FILE")
    {
        Description = "The scene and the ranges to draw from, as JSON; - is the standard input. Without it: the defaults.",
        Arity = ArgumentArity.ZeroOrOne,
    };

    public Option<long> Count { get; } = new("--count")
    {
        HelpName = "N",
        Description = "Rows of the whole sweep.",
        DefaultValueFactory = _ => 1000,
        CustomParser = result => Whole(result, "--count", 1, MostRows),
    };

    public Option<long> Seed { get; } = new("--seed")
    {
        HelpName = "S",
        Description = "What the launches are drawn from, with a row's index.",
        DefaultValueFactory = _ => 1,
        CustomParser = result => Whole(result, "--seed", 0, long.MaxValue),
    };

    public Option<(int Index, int Of)?> Shard { get; } = new("--shard")
    {
        HelpName = "i/n",
        Description = "Only the i-th of n parts; all parts one after the other are the whole, byte for byte. Without it: all rows.",
        CustomParser = ParseShard,
    };

    public Option<long> Jobs { get; } = new("--jobs")
    {
        HelpName = "N",
        Description = "Threads; default: one a processor. The rows do not depend on it.",
        DefaultValueFactory = _ => Environment.ProcessorCount,
        CustomParser = result => Whole(result, "--jobs", 1, 1024),
    };

    public Option<FieldOverride[]> Set { get; } = new("--set")
    {
        HelpName = "path=value",
        Description = "Sets a field before anything is checked, like launch.speed=[20,25]; can be given several times.",
        CustomParser = ParseSet,
        Arity = ArgumentArity.OneOrMore,
    };

    public void AddTo(Command command)
    {
        command.Add(File);
        command.Add(Count);
        command.Add(Seed);
        command.Add(Shard);
        command.Add(Jobs);
        command.Add(Set);
    }

    private static long Whole(ArgumentResult result, string name, long low, long high)
    {
        string text = result.Tokens[0].Value;
        if (long.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out long number) && number >= low && number <= high)
        {
            return number;
        }

        result.AddError(string.Create(CultureInfo.InvariantCulture, $"{name} is {Quote.Short(text)}; allowed: a whole number from {low} to {high}."));
        return low;
    }

    private static (int Index, int Of)? ParseShard(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        string[] parts = text.Split('/');
        if (parts.Length == 2
            && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int index)
            && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int of)
            && of is >= 1 and <= 1_000_000 && index >= 1 && index <= of)
        {
            return (index, of);
        }

        result.AddError($"--shard is {Quote.Short(text)}; allowed: i/n with n from 1 to 1000000 and i from 1 to n, like 3/8.");
        return null;
    }

    private static FieldOverride[] ParseSet(ArgumentResult result)
    {
        var overrides = new List<FieldOverride>();
        foreach (Token token in result.Tokens)
        {
            if (FieldOverride.Parse(token.Value) is { } item)
            {
                overrides.Add(item);
            }
            else
            {
                result.AddError($"--set is {Quote.Short(token.Value)}; allowed: path=value, like launch.speed=[20,25].");
            }
        }

        return [.. overrides];
    }
}
