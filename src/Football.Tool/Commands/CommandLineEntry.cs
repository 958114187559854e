using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using FootballPhysics.Tool.Aim;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Follow;
using FootballPhysics.Tool.Sweep;

namespace FootballPhysics.Tool.Commands;

/// <summary>The entry point: takes the arguments and returns the exit code.</summary>
internal static class CommandLineEntry
{
    private const int LongestMessage = 300;

    /// <summary>Arguments that start with @ are not replaced by the content of a file.</summary>
    private static readonly ParserConfiguration Plain = new() { ResponseFileTokenReplacer = null };

    /// <summary>Runs the command. It never throws.</summary>
    /// <param name="args">The arguments.</param>
    /// <param name="terminal">The input and output.</param>
    /// <param name="lab">Creates the command `lab`; null to start the laboratories of the checkout as a process.</param>
    public static int Run(string[] args, Terminal terminal, Func<Terminal, Command>? lab = null)
    {
        try
        {
            if (lab is null && args is ["lab", ..])
            {
                return LabCommand.Start(args, terminal);
            }

            ParseResult parsed = Root(terminal, lab ?? LabCommand.Create).Parse(args, Plain);
            return parsed.Action is ParseErrorAction ? Misused(parsed, terminal) : Invoke(parsed, terminal);
        }
        catch (OutputClosedException)
        {
            return ExitCode.OutputClosed;
        }
        catch (RefusedException refusal)
        {
            terminal.Error.WriteLine($"football: {refusal.Message}");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            terminal.Error.WriteLine($"football: {Quote.Short(e.Message)}");
        }
        catch (Exception e)
        {
            terminal.Error.WriteLine($"football: internal error, {e.GetType().Name}: {Quote.Short(e.Message)}");
        }

        return ExitCode.Refused;
    }

    /// <summary>Builds the command tree.</summary>
    public static RootCommand Root(Terminal terminal, Func<Terminal, Command> laboratories)
    {
        Command lab = laboratories(terminal);
        var of = new Argument<string[]>("COMMAND") { Description = "Command to describe; default: all commands.", Arity = ArgumentArity.ZeroOrMore };
        var help = new ExampleCommand("help", "Describe a command", "football help lab", "football help lab vacuum") { of };
        var root = new RootCommand("Simulate and analyse football shots from the command line.")
        {
            KickCommand.Create(terminal),
            SimulateCommand.Create(terminal),
            AimCommand.Create(terminal),
            InterceptCommand.Create(terminal),
            ChanceCommand.Create(terminal),
            FitCommand.Create(terminal),
            FollowCommand.Create(terminal),
            SweepCommand.Create(terminal),
            PlayCommand.Create(terminal),
            ReplayCommand.Create(terminal),
            BundleCommand.Create(terminal),
            GalleryCommand.Create(terminal),
            lab,
            help,
        };
        int Help(params string[] path)
        {
            ParseResult parsed = root.Parse([.. path, "--help"], Plain);
            return parsed.UnmatchedTokens.Count > 0 ? Misused(parsed, terminal) : Invoke(parsed, terminal);
        }

        root.SetAction(_ => Help());
        if (lab.Subcommands.Count > 0)
        {
            lab.SetAction(_ => Help(lab.Name));
        }

        help.SetAction(parsed => Help(parsed.GetValue(of) ?? []));
        HelpOption option = root.Options.OfType<HelpOption>().Single();
        option.Action = new ExampleHelp((HelpAction)option.Action!);
        return root;
    }

    private static int Invoke(ParseResult parsed, Terminal terminal) =>
        parsed.Invoke(new InvocationConfiguration { Output = terminal.Text, Error = terminal.Error, EnableDefaultExceptionHandler = false });

    private static int Misused(ParseResult parsed, Terminal terminal)
    {
        Command command = parsed.CommandResult.Command;
        foreach (string unknown in parsed.UnmatchedTokens.Take(1))
        {
            IEnumerable<Symbol> known = unknown.StartsWith('-') ? command.Options.Concat(parsed.RootCommandResult.Command.Options) : command.Subcommands;
            string hint = Spelling.Closest(unknown, known.Select(symbol => symbol.Name)) is { } meant ? $"; did you mean {meant}?" : ".";
            terminal.Error.WriteLine($"football: {Quote.Short(unknown)} is unknown to {Path(parsed.CommandResult)}{hint}");
        }

        // After an unknown argument, errors about missing ones would only distract.
        IEnumerable<string> messages = parsed.UnmatchedTokens.Count > 0 ? [] : parsed.Errors.Select(error => error.Message).Distinct();
        foreach (string message in messages)
        {
            terminal.Error.WriteLine($"football: {Quote.Short(message, LongestMessage)}");
        }

        terminal.Error.WriteLine($"{Path(parsed.CommandResult)} --help describes it.");
        return ExitCode.Usage;
    }

    private static string Path(CommandResult result) =>
        result.Parent is CommandResult parent ? $"{Path(parent)} {result.Command.Name}" : "football";
}
