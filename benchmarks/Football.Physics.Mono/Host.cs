using System;
using FootballPhysics.Mono;

internal static class Host
{
    private static void Main(string[] args)
    {
        MonoSteps.Print(args.Length > 0 ? double.Parse(args[0]) : 2.0);
    }
}
