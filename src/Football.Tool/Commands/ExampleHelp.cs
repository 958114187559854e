using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace FootballPhysics.Tool.Commands;

/// <summary>The help of a command with its examples below.</summary>
internal sealed class ExampleHelp(HelpAction help) : SynchronousCommandLineAction
{
    public static readonly IReadOnlyList<string> OfRoot =
    [
        "football",
        "football kick --speed 27 --elevation 12 --side-spin 60",
        "football lab vacuum",
        "football help simulate",
    ];

    public override int Invoke(ParseResult parseResult)
    {
        int exitCode = help.Invoke(parseResult);
        TextWriter output = parseResult.InvocationConfiguration.Output;
        output.WriteLine("Examples:");
        foreach (string example in (parseResult.CommandResult.Command as ExampleCommand)?.Examples ?? OfRoot)
        {
            output.WriteLine($"  {example}");
        }

        return exitCode;
    }
}
