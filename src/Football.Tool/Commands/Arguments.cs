using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Commands;

/// <summary>Creates options and arguments whose errors name the allowed values.</summary>
internal static class Arguments
{
    /// <summary>Creates an option for a whole number.</summary>
    public static Option<long> Whole(string name, string description, long low, long high, long fallback) => new(name)
    {
        HelpName = "N",
        Description = description,
        DefaultValueFactory = _ => fallback,
        CustomParser = result => ParseWhole(result, name, low, high) ?? 0,
    };

    /// <summary>Creates an optional option for a whole number.</summary>
    public static Option<long?> Whole(string name, string description, long low, long high) => new(name)
    {
        HelpName = "N",
        Description = description,
        CustomParser = result => ParseWhole(result, name, low, high),
    };

    /// <summary>Limits an option to some words, with an error that names them.</summary>
    public static void Among(Option option, IReadOnlyList<string> words)
    {
        option.CompletionSources.Add(_ => words.Select(word => new System.CommandLine.Completions.CompletionItem(word)));
        option.Validators.Add(result =>
        {
            foreach (System.CommandLine.Parsing.Token token in result.Tokens.Where(token => !words.Contains(token.Value)))
            {
                result.AddError($"{option.Name} is {Quote.Short(token.Value)}; allowed: {string.Join(" | ", words)}.");
            }
        });
    }

    /// <summary>Creates the option --jobs, the number of threads; default: the number of processors.</summary>
    public static Option<long> Jobs(string description) => Whole("--jobs", description, 1, 1024, Environment.ProcessorCount);

    /// <summary>Creates an option for a number in a range.</summary>
    public static Option<double> Number(string name, string description, NumberRange range, double fallback) => new(name)
    {
        HelpName = range.Unit,
        Description = FormattableString.Invariant($"{description}, {range.Low} … {range.High}."),
        DefaultValueFactory = _ => fallback,
        CustomParser = result =>
            double.TryParse(result.Tokens[0].Value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) && range.Contains(number)
                ? number
                : Refuse<double>(result, name, range.ToString()),
    };

    /// <summary>Creates the option --set path=value, which can be repeated.</summary>
    public static Option<FieldOverride[]> Set(string example) => new("--set")
    {
        HelpName = "path=value",
        Description = $"Set a field of the input, like {example}; can be repeated.",
        Arity = ArgumentArity.OneOrMore,
        DefaultValueFactory = _ => [],
        CustomParser = result =>
            [.. result.Tokens.Select((token, i) => FieldOverride.Parse(token.Value) ?? Refuse<FieldOverride>(result, "--set", $"path=value, like {example}", i)!)],
    };

    /// <summary>Creates the option --profile NAME, short for --set profile=NAME.</summary>
    public static Option<FieldOverride[]> Profile() => new("--profile")
    {
        HelpName = "NAME",
        Description = "measured (default) or published, the laws of the original thesis. Short for --set profile=NAME.",
        DefaultValueFactory = _ => [],
        CustomParser = result => result.Tokens[0].Value is "measured" or "published"
            ? [FieldOverride.Parse("profile=" + result.Tokens[0].Value)!]
            : Refuse<FieldOverride[]>(result, "--profile", "measured | published") ?? [],
    };

    /// <summary>Creates the option --range path=range, which can be repeated.</summary>
    public static Option<FieldOverride[]> Range(string example) => new("--range")
    {
        HelpName = "path=range",
        Description = $"Draw a field at random from a range, like {example}; can be repeated.",
        Arity = ArgumentArity.OneOrMore,
        DefaultValueFactory = _ => [],
        CustomParser = result =>
            [.. result.Tokens.Select((token, i) => FieldOverride.ParseRange(token.Value) ?? Refuse<FieldOverride>(result, "--range", $"path=range, like {example}", i)!)],
    };

    /// <summary>Opens a file for reading; - is standard input.</summary>
    /// <exception cref="RefusedException">The file cannot be read.</exception>
    public static Stream OpenInput(string file, Terminal terminal)
    {
        try
        {
            return file == "-" ? terminal.Input : File.OpenRead(file);
        }
        catch (Exception e) when (OutputFile.IsFileFault(e))
        {
            throw new RefusedException($"FILE {Quote.File(file)} cannot be read. Pass a file that can be read, or - for standard input.");
        }
    }

    private static long? ParseWhole(ArgumentResult result, string name, long low, long high) =>
        long.TryParse(result.Tokens[0].Value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long number) && number >= low && number <= high
            ? number
            : Refuse<long?>(result, name, string.Create(CultureInfo.InvariantCulture, $"a whole number from {low} to {high}"));

    private static T? Refuse<T>(ArgumentResult result, string name, string allowed, int token = 0)
    {
        result.AddError($"{name} is {Quote.Short(result.Tokens[token].Value)}; allowed: {allowed}.");
        return default;
    }

    /// <summary>Runs a function; translates an error of the library to the names and values of the input.</summary>
    public static T Refusing<T>(InputFields fields, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, fields) is { } translated)
        {
            throw translated;
        }
    }
}
