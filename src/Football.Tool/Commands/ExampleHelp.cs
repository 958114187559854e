using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace FootballPhysics.Tool.Commands;

/// <summary>The help of a command, with its examples at the end; for the root, a list of the commands on one screen.</summary>
internal sealed class ExampleHelp(HelpAction help) : SynchronousCommandLineAction
{
    private const string RootExample = "football kick --speed 27 --elevation 12 --side-spin 60";

    public override int Invoke(ParseResult parseResult)
    {
        TextWriter output = parseResult.InvocationConfiguration.Output;
        Command command = parseResult.CommandResult.Command;
        if (command is RootCommand)
        {
            WriteRoot(command, output);
            return ExitCode.Done;
        }

        var described = command as ExampleCommand;
        if (described?.Details is { } details)
        {
            // Each run builds its own command tree, so this changes nothing else.
            described.Description = $"{described.Description}. {details}";
        }

        int exitCode = Describe(parseResult, output);
        output.WriteLine("Examples:");
        foreach (string example in described?.Examples ?? [])
        {
            output.WriteLine($"  {example}");
        }

        return exitCode;
    }

    /// <summary>Writes the help of a command; its usage names the tool, even if another program contains the command.</summary>
    private int Describe(ParseResult parseResult, TextWriter output)
    {
        using var text = new StringWriter();
        parseResult.InvocationConfiguration.Output = text;
        int exitCode = help.Invoke(parseResult);
        parseResult.InvocationConfiguration.Output = output;
        output.Write(text.ToString().Replace($"  {RootCommand.ExecutableName} ", "  football ", StringComparison.Ordinal));
        return exitCode;
    }

    private static void WriteRoot(Command root, TextWriter output)
    {
        output.WriteLine(root.Description);
        output.WriteLine("Results are tables in a terminal and JSON when redirected or with --json.");
        foreach (Command command in root.Subcommands)
        {
            output.WriteLine($"  {command.Name,-12} {command.Description}");
        }

        output.WriteLine($"Example: {RootExample}");
    }
}
