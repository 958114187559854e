using FootballPhysics.Labs;
using FootballPhysics.Tool.Commands;

// Run the tool together with the laboratories.
return CommandLineEntry.Run(args, Terminal.OfProcess(), Laboratories.Create);
