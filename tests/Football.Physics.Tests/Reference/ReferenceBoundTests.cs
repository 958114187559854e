using System.Globalization;
using System.Text;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Reference;

/// <summary>Every single reference case against a bound of its own, so that no other case hides it.</summary>
public sealed class ReferenceBoundTests
{
    private const string Table = "tests/Football.Physics.Tests/Reference/errors.csv";

    /// <summary>An error may be so many times that of the table.</summary>
    private const double Growth = 3;

    /// <summary>What the references themselves may be off: 1e-9 m in flight, 5e-9 after a slide, 2e-8 where a ball grazes something.</summary>
    private static readonly ReferenceErrors s_uncertainty = new(2e-8, 5e-9, 5e-9, 5e-8, 5e-7);

    /// <summary>RK4 at 10 ms, all cases but those below.</summary>
    private static readonly ReferenceErrors s_fine = new(1e-7, 5e-8, 1e-7, 1e-6, 2e-6);

    /// <summary>Shots that steps of 10 ms are long for: 79 m/s with 284 rad/s, and balls of 100 g and 36 cm.</summary>
    private static readonly Dictionary<string, ReferenceErrors> s_fineExceptions = new()
    {
        ["ref-violent-002"] = new(1e-3, 1.5e-5, 3e-6, 6e-5, 2e-3),
        ["ref-other-ball-001"] = new(6e-6, 1.5e-6, 5e-7, 1.2e-6, 5e-5),
        ["ref-other-ball-005"] = new(1.5e-6, 5e-8, 1e-7, 1e-6, 2e-6),
    };

    private static readonly (Integrator Method, double Step)[] s_settings =
        [(Integrator.Rk4, 0.01), (Integrator.Rk4, 0.04), (Integrator.Rk2, 0.01), (Integrator.Rk2, 0.04)];

    private static readonly Lazy<IReadOnlyList<(string Name, ReferenceErrors[] Errors)>> s_measured = new(Measure);

    [Fact]
    public void Every_case_keeps_to_the_accuracy_of_rk4_at_10_ms()
    {
        List<string> broken = [];
        foreach ((string name, ReferenceErrors[] errors) in s_measured.Value)
        {
            Judge(name, errors[0], s_fineExceptions.GetValueOrDefault(name, s_fine), broken);
        }

        Assert.True(broken.Count == 0, string.Join('\n', broken));
        Assert.All(s_fineExceptions.Keys, name => Assert.Contains(ReferenceCase.All, item => item.Name == name));
    }

    /// <summary>The table is made anew by tests/regenerate.sh: then its changes are to be looked at, case by case.</summary>
    [Fact]
    public void No_error_of_any_case_with_any_method_and_step_grows()
    {
        if (RepositoryFiles.Regenerates)
        {
            File.WriteAllText(Path.Combine(RepositoryFiles.Root, Table), Text());
        }

        string[] rows = RepositoryFiles.Text(Table).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(Header(), rows[0]);
        Assert.Equal(ReferenceCase.All.Select(item => item.Name), rows.Skip(1).Select(row => row.Split(',')[0]));
        List<string> broken = [];
        foreach ((string row, (string name, ReferenceErrors[] errors)) in rows.Skip(1).Zip(s_measured.Value))
        {
            string[] cells = row.Split(',');
            for (int i = 0; i < s_settings.Length; i++)
            {
                int count = ReferenceErrors.Names.Count;
                var known = ReferenceErrors.Parse(cells.Skip(1 + (i * count)).Take(count));
                Judge($"{name}, {Setting(s_settings[i])}", errors[i], s_uncertainty + (Growth * known), broken);
            }
        }

        Assert.True(broken.Count == 0, string.Join('\n', broken));
    }

    private static void Judge(string name, ReferenceErrors actual, ReferenceErrors bound, List<string> broken)
    {
        foreach (((double error, double most), string what) in actual.All.Zip(bound.All).Zip(ReferenceErrors.Names))
        {
            if (!(error <= most))
            {
                broken.Add(string.Create(CultureInfo.InvariantCulture, $"{name}: {what} off by {error:e2}, at most {most:e2}"));
            }
        }
    }

    private static IReadOnlyList<(string Name, ReferenceErrors[] Errors)> Measure()
    {
        IReadOnlyList<ReferenceRun>[] runs = [.. s_settings.Select(setting => ReferenceRun.PlayAll(setting.Method, setting.Step))];
        return [.. ReferenceCase.All.Select((item, i) => (item.Name, runs.Select(run => ReferenceErrors.Of(run[i])).ToArray()))];
    }

    private static string Text()
    {
        var text = new StringBuilder(Header()).Append('\n');
        foreach ((string name, ReferenceErrors[] errors) in s_measured.Value)
        {
            text.Append(name).Append(',').AppendJoin(',', errors.Select(item => item.ToString())).Append('\n');
        }

        return text.ToString();
    }

    private static string Header() =>
        "case," + string.Join(',', s_settings.SelectMany(_ => ReferenceErrors.Names, (setting, name) => $"{name} {Setting(setting)}"));

    private static string Setting((Integrator Method, double Step) setting) =>
        string.Create(CultureInfo.InvariantCulture, $"{setting.Method} {1000 * setting.Step} ms");
}
