using Football.Physics.Headless.Commands;

return CommandLineEntry.Run(args, Terminal.OfProcess());
