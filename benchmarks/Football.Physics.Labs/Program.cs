using Football.Physics.Labs;
using Football.Tool.Commands;

// The tool with the laboratories in it: its arguments are those of `football lab`.
string[] lab = args is ["lab", ..] ? args : ["lab", .. args];
return CommandLineEntry.Run(lab, Terminal.OfProcess(), Laboratories.Create);
