using System.Text.Json;
using System.Xml.Linq;
using FootballPhysics.Aiming;

namespace FootballPhysics.Labs.Tests;

/// <summary>football lab aim: tables, files, and verdicts that the dense scan does not contradict.</summary>
public sealed class AimLabTests
{
    [Fact]
    public void It_writes_tables_kicks_and_plots()
    {
        string folder = Directory.CreateDirectory(Path.Combine(AppContext.BaseDirectory, "aim-lab-test")).FullName;
        string json = Path.Combine(folder, "aim.json");
        string csv = Path.Combine(folder, "aim.csv");
        string plot = Path.Combine(folder, "aim.svg");
        FootballCommand done = FootballCommand.Run("", "lab", "aim", "--quick", "--seed", "7", "--json", json, "--csv", csv, "--plot", plot);
        JsonElement result = done.Result;
        Assert.Equal(result.GetRawText(), JsonDocument.Parse(File.ReadAllText(json)).RootElement.GetRawText());
        Assert.Equal(7, result.GetProperty("seed").GetInt32());
        JsonElement[] tables = [.. result.GetProperty("tables").EnumerateArray()];
        JsonElement verdicts = tables[^1].GetProperty("rows")[0];
        Assert.Equal(500, verdicts.GetProperty("requests").GetInt32());
        Assert.Equal(0, verdicts.GetProperty("without an answer").GetInt32());
        Assert.Equal(0, verdicts.GetProperty("can be hit").GetInt32());
        int kicks = tables[..^1].Sum(section => section.GetProperty("rows").EnumerateArray().Sum(row => row.GetProperty("kicks").GetInt32()));
        Assert.Equal(kicks + 1, File.ReadAllLines(csv).Count(line => line.Length > 0));
        Assert.DoesNotContain("NaN", XDocument.Load(plot).ToString());
        foreach (string thesis in (string[])["4.1.3", "4.2.3", "4.3.2"])
        {
            Assert.Contains(thesis, done.Error);
        }
    }

    [Fact]
    public void The_scan_finds_what_can_be_hit_and_not_what_cannot()
    {
        var scan = new AimScan(Scene.Published);
        foreach (AimRequest request in AimSets.Thesis(3, 10))
        {
            Assert.InRange(scan.Best(request, 91), 0, 1e-3);
        }

        foreach (AimRequest request in AimSets.TooFar(3, 10))
        {
            Assert.InRange(scan.Best(request, 91), 0.05, 10);
        }
    }

    [Fact]
    public void The_sets_are_the_same_in_every_run()
    {
        Assert.Equal(AimSets.Thesis(5, 20), AimSets.Thesis(5, 20));
        Assert.Equal(AimSets.TwoPoint(5, 20), AimSets.TwoPoint(5, 20));
        Assert.NotEqual(AimSets.Studio(5, 20), AimSets.Studio(6, 20));
    }
}
