using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Commands;

/// <summary>The arguments of every command that reads scenarios: FILE, --batch, --jobs, --set.</summary>
internal sealed class BatchOptions
{
    public Argument<string> File { get; } = new("FILE") { Description = "The scenario, as JSON; - is the standard input." };

    public Option<bool> Batch { get; } = new("--batch")
    {
        Description = "FILE holds one object a line, a scenario or {\"name\", \"scenario\"}; the results come one a line, in the same order.",
    };

    public Option<int> Jobs { get; } = new("--jobs")
    {
        HelpName = "N",
        Description = "Threads for a batch; default: one a processor.",
        DefaultValueFactory = _ => Environment.ProcessorCount,
        CustomParser = ParseJobs,
    };

    public Option<FieldOverride[]> Set { get; } = new("--set")
    {
        HelpName = "path=value",
        Description = "Sets a field of every scenario before anything is checked, like solver.timeStep=0.04; can be given several times.",
        CustomParser = ParseSet,
        Arity = ArgumentArity.OneOrMore,
    };

    public void AddTo(Command command)
    {
        command.Add(File);
        command.Add(Batch);
        command.Add(Jobs);
        command.Add(Set);
    }

    private static int ParseJobs(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int jobs) && jobs is >= 1 and <= 1024)
        {
            return jobs;
        }

        result.AddError($"--jobs is {Json.Quote.Short(text)}; allowed: a whole number from 1 to 1024.");
        return 1;
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
                result.AddError($"--set is {Json.Quote.Short(token.Value)}; allowed: path=value, like solver.timeStep=0.04.");
            }
        }

        return [.. overrides];
    }
}
