using FootballPhysics.Tool.Commands;

return CommandLineEntry.Run(args, Terminal.OfProcess());
