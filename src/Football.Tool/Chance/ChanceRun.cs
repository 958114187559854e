using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;
using Spectre.Console;

namespace FootballPhysics.Tool.Chance;

/// <summary>Computes the chance of a shot: a scenario with a member chance.</summary>
internal static class ChanceRun
{
    /// <summary>Reads a shot, and simulates its kicks.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the library's range.</exception>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static GoalChanceResult Find(InputFields fields)
    {
        InputObject root = fields.Root;
        InputObject chance = root.Object("chance");
        Scenario shot = Scenario.Take(root);
        GoalChanceRequest request = GoalChanceInput.Request(chance, shot.Scene.Goals, shot.Position, shot.Velocity, shot.Spin, shot.Orientation) with { AlwaysSimulate = true };
        fields.Check();
        return new GoalChance(shot.Scene).Find(request);
    }

    /// <summary>Returns the line of a shot.</summary>
    public static ReadOnlyMemory<byte> Line(string? name, GoalChanceResult found) => ResultWriter.Line(json =>
    {
        var shares = ChanceShares.Of(found);
        json.WriteString("name", name);
        json.WriteNumber("goal", shares.Goal.Share);
        json.WriteNumber("save", shares.Save.Share);
        json.WriteNumber("post", shares.Post.Share);
        json.WriteNumber("wide", shares.Wide.Share);
        json.WriteStartObject("errors");
        json.WriteNumber("goal", shares.Goal.Error);
        json.WriteNumber("save", shares.Save.Error);
        json.WriteNumber("post", shares.Post.Error);
        json.WriteNumber("wide", shares.Wide.Error);
        json.WriteEndObject();
        json.WriteNumber("kicks", shares.Kicks);
        json.WriteNumber("onTarget", found.OnTarget);
        json.WriteNumber("crosses", found.Crosses);
        json.WriteNumber("aside", found.Aside);
        json.WriteNumber("height", found.Height);
        json.WriteNumber("time", found.Time);
    });

    /// <summary>Prints the shares as a table.</summary>
    public static void Print(GoalChanceResult found, Terminal terminal)
    {
        var shares = ChanceShares.Of(found);
        Table table = new Table().Border(TableBorder.Simple).AddColumns("", "%", "±");
        foreach ((string name, (double share, double error)) in (ReadOnlySpan<(string, (double, double))>)[("goal", shares.Goal), ("save", shares.Save), ("post", shares.Post), ("wide", shares.Wide)])
        {
            table.AddRow(name, FormattableString.Invariant($"{100 * share:0.0}"), FormattableString.Invariant($"{100 * error:0.0}"));
        }

        terminal.PersonConsole.Write(table);
    }
}
