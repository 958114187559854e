using System;
using System.CommandLine;
using System.Globalization;

namespace Football.Physics.Headless;

internal static class Program
{
    private static int Main(string[] args)
    {
        var root = new RootCommand("The football simulation without a screen.");
        root.SetAction(_ =>
        {
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"cross section of a size 5 ball: {Sphere.CrossSection(0.11):R} m²"));
            return 0;
        });
        return root.Parse(args).Invoke();
    }
}
