using System.Text.RegularExpressions;

namespace FootballPhysics.Tests.Architecture;

/// <summary>A folder is the namespace of its internal types; public types are in the namespaces that games use.</summary>
public sealed partial class NamespaceTests
{
    private static readonly string[] s_public =
    [
        "FootballPhysics", "FootballPhysics.Aiming", "FootballPhysics.Batch", "FootballPhysics.Engines", "FootballPhysics.Laws", "FootballPhysics.Netcode",
        "FootballPhysics.Prediction", "FootballPhysics.Shapes", "FootballPhysics.Thesis", "FootballPhysics.Tracks",
    ];

    [Fact]
    public void Internal_types_are_in_the_namespace_of_their_folder() => Assert.Empty(Misplaced(SourceFile.Library));

    [Theory]
    [InlineData("Contacts/Slip.cs", "FootballPhysics.Contacts", "internal struct Slip;", false)]
    [InlineData("Contacts/Slip.cs", "FootballPhysics", "internal struct Slip;", true)]
    [InlineData("Laws/Forces/SpinDrag.cs", "FootballPhysics.Laws", "internal struct SpinDrag;", false)]
    [InlineData("Game/Ball.cs", "FootballPhysics", "public sealed class Ball { }", false)]
    [InlineData("Game/Ball.cs", "FootballPhysics.Game", "public sealed class Ball { }", true)]
    public void A_misplaced_type_is_found(string path, string space, string type, bool wrong) =>
        Assert.Equal(wrong, Misplaced([new SourceFile(path, $"namespace {space};\n\n{type}\n")]).Count > 0);

    private static IReadOnlyList<string> Misplaced(IReadOnlyList<SourceFile> tree)
    {
        HashSet<string> isPublic = [.. from file in tree from Match match in PublicType().Matches(file.Text) select match.Groups[1].Value];
        return
        [
            .. from file in tree
               where file.Room != "Polyfills" && file.Types.Count > 0
               let space = Namespace().Match(file.Text).Groups[1].Value
               where file.Types.Any(type => isPublic.Contains(type.Name)) ? !s_public.Contains(space) : space != $"FootballPhysics.{file.Room}"
               select $"{file.Path}: {space}",
        ];
    }

    [GeneratedRegex(@"^namespace ([\w.]+);", RegexOptions.Multiline)]
    private static partial Regex Namespace();

    [GeneratedRegex(@"^public (?:(?:static|sealed|abstract|readonly|ref|partial|unsafe) )*(?:class|struct|interface|enum|record struct|record|delegate [\w<>\[\]?.]+) (\w+)", RegexOptions.Multiline)]
    private static partial Regex PublicType();
}
