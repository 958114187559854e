namespace FootballPhysics.Tests.Architecture;

/// <summary>The folders of the library form no circle: each knows only those below it.</summary>
public sealed class RoomTests
{
    /// <summary>A small tree in which everything is allowed, with names that look like others.</summary>
    private static readonly Dictionary<string, string> s_clean = new()
    {
        ["Polyfills/Unsafe.cs"] = "internal static class Unsafe { }",
        ["Numerics/Vector3d.cs"] = "public readonly struct Vector3d { public double Length => Unsafe.SizeOf<double>(); }",
        ["State/BallState.cs"] = """
            /// <summary>What a <see cref="Kick"/> starts.</summary>
            public struct BallState
            {
                public Vector3d Velocity; // not of a Kick
                public string Kick => "Kick kick = new Kick(); { Kick }" + $"{Kick.Length:0} Kick" + 'K';
                public void Ball() => Ball();
                private int Sum() => Kick.Length + Kick.Length;
            }
            """,
        ["Aiming/Methods/Kick.cs"] = "public sealed class Kick { private readonly BallState _from; }",
        ["Game/Ball.cs"] = "public sealed class Ball<T> where T : struct { public Kick? Last { get; set; } public Vector3d Place { get; } }",
        ["Game/Snapshot.cs"] = "public delegate void Hears(Ball<int> ball); public readonly record struct Snapshot(Kick Kick);",
    };

    [Fact]
    public void No_file_names_a_type_of_a_room_above_its_own() => Assert.Empty(Rooms.Violations(SourceFile.Library));

    [Fact]
    public void The_rooms_are_the_folders_and_their_types_are_found()
    {
        Assert.Equal(Rooms.Order.Order(), SourceFile.Library.Select(file => file.Room).Distinct().Order());
        Assert.All(Rooms.Order, room => Assert.Contains(SourceFile.Library, file => file.Room == room && file.Types.Count > 0));
        foreach ((string type, string room) in (ReadOnlySpan<(string, string)>)[
            ("Vector3d", "Numerics"), ("BallState", "State"), ("Scene", "Scenes"), ("PathSegment", "Integration"), ("DragJump", "Laws"),
            ("ImpactLaw", "Contacts"), ("BallEvent", "Events"), ("Simulator", "Simulation"), ("Trajectory", "Prediction"), ("TrackFit", "Tracks"), ("Aimer", "Aiming"), ("ThesisAimer", "Thesis"),
            ("BallBatch", "Batch"), ("Ball", "Game")])
        {
            Assert.Equal(room, SourceFile.Library.First(file => file.Types.Any(item => item.Name == type)).Room);
        }
    }

    [Fact]
    public void A_tree_in_which_each_room_knows_those_below_it_is_clean() => Assert.Empty(Violations(s_clean));

    /// <summary>Every way to name a type, one at a time, in a file of a room that must not know it.</summary>
    [Theory]
    [InlineData("private Kick _kick;")]
    [InlineData("public Kick Last { get; }")]
    [InlineData("public Kick? Last { get; }")]
    [InlineData("public Kick[] All { get; }")]
    [InlineData("public List<Kick> All { get; }")]
    [InlineData("public Dictionary<int, Kick> All { get; }")]
    [InlineData("public void Take(in Kick kick) { }")]
    [InlineData("public Kick Made() => new();")]
    [InlineData("public object Made() => new Kick();")]
    [InlineData("public object Made() => Kick.Default;")]
    [InlineData("public object Made(object o) => (Kick)o;")]
    [InlineData("public bool Is(object o) => o is Kick;")]
    [InlineData("public object Made() => typeof(Kick);")]
    [InlineData("public object Made() => nameof(Kick);")]
    [InlineData("public void Take<T>() where T : Kick { }")]
    [InlineData("public Ball<int> Ball { get; }")]
    [InlineData("public event Hears Heard;")]
    [InlineData("public void Take(Snapshot from) { }")]
    public void A_type_of_a_higher_room_is_found_however_it_is_named(string member)
    {
        var tree = new Dictionary<string, string>(s_clean)
        {
            ["Contacts/Slip.cs"] = $"namespace FootballPhysics;\n\n// A slip.\ninternal struct Slip\n{{\n    {member}\n}}\n",
        };
        Assert.StartsWith("Contacts/Slip.cs(6): Contacts names ", Assert.Single(Violations(tree)), StringComparison.Ordinal);
    }

    [Fact]
    public void A_violation_names_file_line_and_type()
    {
        var tree = new Dictionary<string, string>(s_clean)
        {
            ["Contacts/Sub/Slip.cs"] = "namespace FootballPhysics;\n\ninternal sealed class Slip : Ball<int>\n{\n    public Vector3d Of(Kick kick) => default;\n}\n",
            ["Elsewhere/Odd.cs"] = "internal sealed class Odd { }",
        };
        Assert.Equal(
            [
                "Contacts/Sub/Slip.cs(3): Contacts names Ball, which is of Game",
                "Contacts/Sub/Slip.cs(5): Contacts names Kick, which is of Aiming",
                "Elsewhere/Odd.cs: in none of the rooms",
            ],
            Violations(tree).Order());
    }

    private static IReadOnlyList<string> Violations(Dictionary<string, string> tree) =>
        Rooms.Violations([.. tree.Select(file => new SourceFile(file.Key, file.Value))]);
}
