using FootballPhysics.Labs;
using FootballPhysics.Tool.Commands;

// The tool, with the laboratories in it.
return CommandLineEntry.Run(args, Terminal.OfProcess(), Laboratories.Create);
