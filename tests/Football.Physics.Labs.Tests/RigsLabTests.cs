using System.Text.Json;

namespace FootballPhysics.Labs.Tests;

/// <summary>The rigs, and kicks that somebody told of.</summary>
public sealed class RigsLabTests
{
    private static readonly Scene Tunnel = Scene.Measured with { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf) };

    [Fact]
    public void On_dry_turf_the_rigs_measure_what_the_numbers_were_fitted_to()
    {
        Assert.Equal(0.72, RigsLab.Drop(Tunnel), 0.02 * 0.72);
        Assert.Equal(52, RigsLab.AngledShot(Tunnel), 0.02 * 52);
        Assert.Equal(6.4, RigsLab.Roll(Tunnel), 0.02 * 6.4);
    }

    [Fact]
    public void Every_window_of_the_measured_profile_is_met_and_what_the_published_one_fails_is_shown()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "rigs");
        Assert.Equal(0, done.ExitCode);
        JsonElement[] rows = [.. done.Result.GetProperty("tables")[0].GetProperty("rows").EnumerateArray()];
        Assert.Equal(13, rows.Length);
        foreach (JsonElement row in rows.Where(row => row.GetProperty("profile").GetString() == "measured" && row.GetProperty("test").ValueKind != JsonValueKind.Null))
        {
            Assert.All((string[])["drop is", "angle is", "roll is"], column => Assert.NotEqual("FAIL", row.GetProperty(column).GetString()));
        }

        Assert.Contains(rows, row => row.GetProperty("roll is").GetString() == "FAIL");
    }

    [Fact]
    public void Kicks_that_cannot_be_met_are_shown_as_such()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "kicks");
        Assert.Equal(0, done.ExitCode);
        JsonElement[] rows = [.. done.Result.GetProperty("tables")[0].GetProperty("rows").EnumerateArray()];
        JsonElement Row(string kick, string number) =>
            rows.Single(row => row.GetProperty("kick").GetString()!.StartsWith(kick, StringComparison.Ordinal) && row.GetProperty("number").GetString() == number);
        Assert.Equal(1.05, Row("Carré", "time to the goal, s").GetProperty("measured").GetDouble(), 0.02);
        Assert.Equal(21.7, Row("Carré", "speed at the goal, m/s").GetProperty("measured").GetDouble(), 0.2);
        Assert.Equal(17.9, Row("Mencke, no spin", "range, m").GetProperty("measured").GetDouble(), 0.1);
        Assert.Equal("NOT MET", Row("Mencke, S 0.25", "aside at 16.35 m, m").GetProperty("measured is").GetString());
        Assert.All(rows.Where(row => row.GetProperty("measured is").GetString() == "NOT MET"), row => Assert.NotEqual(JsonValueKind.Null, row.GetProperty("why not").ValueKind));
    }
}
