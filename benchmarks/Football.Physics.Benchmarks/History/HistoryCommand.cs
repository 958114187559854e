using System.Globalization;
using System.Reflection;
using System.Runtime.InteropServices;

namespace FootballPhysics.Benchmarks;

/// <summary>`quick --history FILE`: adds the ratios of this build to the history, and draws it next to the file.</summary>
internal static class HistoryCommand
{
    public static void Run(string path, double seconds)
    {
        HistoryFile file = HistoryFile.Read(path);
        HistoryRow[] rows = HistoryRow.All();
        Stopwatching.WarmUp([.. rows.SelectMany(row => new[] { row.Subject, row.Yardstick })]);
        var ratios = new List<(string, double)>();
        foreach (HistoryRow row in rows)
        {
            double ratio = Stopwatching.Measure(row.Subject, row.Yardstick, seconds / rows.Length).Ratio;
            ratios.Add((row.Name, ratio));
            Console.WriteLine($"{Text.Number(ratio)}  {row.Name}");
        }

        // The compiler wrote both into the library's version: "0.1.0+8ac81b91…".
        string[] built = typeof(Simulator).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion.Split('+');
        string date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
        file.Add([date, built[0], built.ElementAtOrDefault(1) ?? "", RuntimeInformation.FrameworkDescription, Machine.Processor], ratios);
        file.Write();
        string picture = Path.ChangeExtension(path, ".svg");
        File.WriteAllText(picture, HistoryPicture.Draw(file) + "\n");
        Console.WriteLine($"Written to {path} and {picture}.");
    }
}
