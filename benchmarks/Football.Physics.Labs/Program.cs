using Football.Physics.Labs;
using Football.Tool.Commands;

// The tool, with the laboratories in it.
return CommandLineEntry.Run(args, Terminal.OfProcess(), Laboratories.Create);
