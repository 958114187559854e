using FootballPhysics.Golden;

namespace FootballPhysics.Package.Tests;

/// <summary>The bits of the shots that every runtime must reproduce. A change of the physics or of its rounding shows here first.</summary>
public sealed class GoldenTests
{
    private static readonly Lazy<string[]> s_lines = new(() => [.. GoldenShots.Lines()]);

    [Fact]
    public void Golden_hashes_are_those_of_the_file() =>
        Repository.AssertCurrent("tests/Golden/golden.txt", string.Join('\n', s_lines.Value) + "\n");

    [Fact]
    public void The_golden_shots_of_the_default_touch_everything()
    {
        var met = new List<string>();
        Assert.NotEmpty(GoldenGames.Among(met).ToList());
        string[] things = ["ground", "left post", "right post", "crossbar", "goal", "back net", "left net", "right board", "leg"];
        Assert.Empty(things.Except(met.Distinct()));
    }

    [Fact]
    public void The_golden_objects_touch_everything()
    {
        var met = new HashSet<string>();
        Assert.NotEmpty(GoldenThings.Hashes(met).ToList());
        string[] kinds = [.. Enum.GetNames<BallEventKind>()];
        string[] things =
        [
            "ground", "board", "side board", "wall", "post", "kerb", "tile", "pipe", "bowl", "rail", "table", "belt", "drum", "mound", "player", "leg", "lid", "press", "crate", "collider", "mesh",
            "hammock", "roof net", "back net", "left net", "box", "sphere", "rod", "above",
        ];
        Assert.Empty(kinds.Concat(things).Except(met));
        Assert.DoesNotContain("ghost", met);
    }

    [Fact]
    public void All_golden_shots_differ() => Assert.Distinct(s_lines.Value.Select(line => line.Split(' ')[^1]));
}
