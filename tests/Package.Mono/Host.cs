using System;
using FootballPhysics.Golden;

internal static class Host
{
    private static void Main()
    {
        Console.Error.WriteLine("Mono " + Environment.Version);
        foreach (string line in GoldenShots.Lines())
        {
            Console.WriteLine(line);
        }
    }
}
