using Football.Tool.Commands;

return CommandLineEntry.Run(args, Terminal.OfProcess());
