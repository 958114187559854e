using System.Text.RegularExpressions;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Architecture;

/// <summary>What is claimed of any ball is tried with the ball that a game gets: tests of the thesis' scenes alone are counted, and each class that has some says why.</summary>
public sealed partial class ProfileRuleTests
{
    private static readonly string[] s_families = ["Things", "Motion", "Symmetry", "Stability"];

    /// <summary>Members, tests and what they share, that build a scene of the thesis and none of the default.</summary>
    private static readonly Dictionary<string, (int Count, string Reason)> s_publishedAlone = new()
    {
        ["EngineColliderTests"] = (4, "bodies on straight lines and parabolas without air; and the scene that is no world"),
        ["SurfacePatternTests"] = (2, "the impact of the thesis as numbers: what is left of speed and spin"),
        ["CustomForceTests"] = (3, "built-in laws that only the thesis' forces have, by hand or left out; a push against its rolling friction"),
        ["EventBufferTests"] = (1, "a ball that keeps all its height, without air"),
        ["EventTests"] = (4, "the thesis' bisection in vacuum; a force law that is constant; the drag law's jump"),
        ["ImpactTests"] = (1, "heights of bounces in vacuum, e the same at every speed (the default: MeasuredImpactTests)"),
        ["ManyCollidersTests"] = (1, "a flight of one piece, without air"),
        ["QueriesAreReadsTests"] = (1, "two impacts of one time of the engine, without air and ground"),
        ["RollTests"] = (6, "closed forms of constant friction and damping, laws and ground aerodynamics left out (the default: DefaultGroundTests)"),
        ["SlideAcrossJumpTests"] = (2, "the jump of the thesis' drag law"),
        ["SlideTests"] = (6, "closed forms of constant friction and damping, the thesis' heuristic (the default: DefaultGroundTests)"),
        ["SpinDecayTests"] = (3, "the thesis' torque, which is finite at rest: a spin ends at an instant"),
        ["WindFieldTests"] = (1, "what the drag law's jump costs"),
        ["ZoneTests"] = (3, "times of straight paths and parabolas, without air"),
        ["AirBoundsTests"] = (1, "the bounds of the thesis' laws and their slopes"),
        ["FoundByTheLabTests"] = (2, "spins that the thesis' torque ends"),
    };

    [Fact]
    public void Tests_of_the_published_scenes_alone_are_those_that_say_why()
    {
        var found = from project in (string[])["Football.Physics.Tests", "Football.Physics.Labs.Tests"]
                    from family in s_families
                    let folder = Path.Combine(RepositoryFiles.Root, "tests", project, family)
                    where Directory.Exists(folder)
                    from file in Directory.EnumerateFiles(folder, "*.cs")
                    let count = PublishedAlone(File.ReadAllText(file))
                    where count > 0
                    select (Name: Path.GetFileNameWithoutExtension(file), Count: count);
        Assert.Equal(
            s_publishedAlone.Select(item => $"{item.Key}: {item.Value.Count}").Order(StringComparer.Ordinal),
            found.Select(item => $"{item.Name}: {item.Count}").Order(StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("    [Fact]\n    public void A()\n    {\n        Play(Scene.Published);\n    }\n", 1)]
    [InlineData("    [Fact]\n    public void A() => Play(Scene.Vacuum with { });\n\n    [Fact]\n    public void B() => Play(Scene.Published);\n", 2)]
    [InlineData("    [Theory]\n    [ProfileData]\n    public void A(Profile profile) => Play(profile.Scene(), Scene.Vacuum);\n", 0)]
    [InlineData("    [Fact]\n    public void A() => Same(Scene.Published, new Scene { Gravity = 0 });\n", 0)]
    [InlineData("    private static readonly Scene s_scene = Scene.Published;\n", 1)]
    [InlineData("    private static readonly Scene s_scene = new();\n", 0)]
    public void A_member_of_the_published_scenes_alone_is_counted(string members, int expected) =>
        Assert.Equal(expected, PublishedAlone($"public sealed class A\n{{\n{members}}}\n"));

    private static int PublishedAlone(string text) =>
        MemberStart().Split(text).Count(member => Thesis().IsMatch(member) && !Default().IsMatch(member));

    /// <summary>Before the first line of a member: its summary, its attributes, or itself.</summary>
    [GeneratedRegex(@"\n\n(?= {4}\S)")]
    private static partial Regex MemberStart();

    [GeneratedRegex(@"\bScene\.(Published|Vacuum)\b")]
    private static partial Regex Thesis();

    [GeneratedRegex(@"\bprofile\b|\bProfile\.Default\b|\bnew Scene\b|\bScene\.(Default|Measured|Windy|HighAltitude)\b|\bnew Ball\(\)")]
    private static partial Regex Default();
}
