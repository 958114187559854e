using FootballPhysics.Benchmarks;

namespace FootballPhysics.Labs.Tests;

/// <summary>The file with the ratios of all versions.</summary>
public sealed class HistoryFileTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("football-history-");

    private string Path => System.IO.Path.Combine(_folder.FullName, "history.csv");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void ALaterVersionKeepsTheLinesAndAddsColumns()
    {
        Add("0.1.0", ("a kick, RK2", 2));
        Add("0.2.0", ("a kick, RK2", 1.5), ("a \"new\" row, RK4", 0.25));
        HistoryFile read = HistoryFile.Read(Path);
        Assert.Equal(["0.1.0", "0.2.0"], read.Versions);
        Assert.Equal(["a kick, RK2", "a \"new\" row, RK4"], read.Ratios);
        Assert.Equal([(0, 2.0), (1, 1.5)], read.Of("a kick, RK2"));
        Assert.Equal([(1, 0.25)], read.Of("a \"new\" row, RK4"));
    }

    [Fact]
    public void TheThirdColumnIsTheCommitAsThePairedScriptReadsIt()
    {
        Add("0.1.0", ("a kick, RK2", 2));
        Assert.Equal("8ac81b91", File.ReadLines(Path).Last().Split(',')[2]);
    }

    private void Add(string version, params (string, double)[] ratios)
    {
        HistoryFile file = HistoryFile.Read(Path);
        file.Add(["2026-11-27", version, "8ac81b91", ".NET 10.0.12", "a processor, of 2 GHz"], ratios);
        file.Write();
    }
}
