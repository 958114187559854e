using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Passes.Plays;

namespace FootballPhysics.Passes;

/// <summary>The bodies of the library that no play reaches.</summary>
internal static class Reach
{
    /// <summary>Plays all plays, and prints the bodies that none reaches, by folder.</summary>
    /// <param name="only">The only plays, or null for all.</param>
    /// <returns>The numbers of these bodies.</returns>
    public static int[] Print(string[]? only)
    {
        Method[] methods = MarkedLibrary.Methods;
        int[] passed = MarkedLibrary.Passed;
        var reached = new HashSet<int>();
        foreach ((string name, Action play) in AllPlays.Named.Where(play => only is null || only.Contains(play.Name)))
        {
            Array.Clear(passed);
            var watch = Stopwatch.StartNew();
            play();
            int[] all = [.. Enumerable.Range(0, passed.Length).Where(i => passed[i] > 0)];
            int[] first = [.. all.Where(reached.Add)];
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{name,-12} {watch.Elapsed.TotalSeconds,5:0.0} s: {all.Length,5} bodies, {all.Sum(i => methods[i].Lines),6} working lines; reached first: {first.Length,5} bodies, {first.Sum(i => methods[i].Lines),6} working lines"));
        }

        int[] rest = [.. Enumerable.Range(0, methods.Length).Where(i => !reached.Contains(i))];
        foreach (IGrouping<string, int> folder in Enumerable.Range(0, methods.Length).GroupBy(i => FolderOf(methods[i])).OrderBy(folder => folder.Key, StringComparer.Ordinal))
        {
            int[] missed = [.. folder.Where(i => !reached.Contains(i))];
            Console.WriteLine();
            Console.WriteLine(Count(folder.Key, missed, [.. folder]));
            foreach (int i in missed)
            {
                Console.WriteLine($"    {NameOf(methods[i])}: {methods[i].Lines}");
            }
        }

        Console.WriteLine();
        Console.WriteLine(Count("all", rest, [.. Enumerable.Range(0, methods.Length)]));
        return rest;

        string Count(string name, int[] missed, int[] all) => string.Create(
            CultureInfo.InvariantCulture,
            $"{name}: no play reaches {missed.Length} of {all.Length} bodies, {missed.Sum(i => methods[i].Lines)} of {all.Sum(i => methods[i].Lines)} working lines");
    }

    /// <summary>Returns the file, line and name of a body.</summary>
    public static string NameOf(Method method) => $"{MarkedLibrary.PathOf(method)}:{method.Line} {method.Name}";

    private static string FolderOf(Method method) => MarkedLibrary.PathOf(method).Split('/')[0];
}
