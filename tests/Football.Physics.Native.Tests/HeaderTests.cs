using System.Reflection;
using System.Text.RegularExpressions;
using FootballPhysics.Package.Tests;

namespace FootballPhysics.Native.Tests;

public sealed partial class HeaderTests
{
    public const string Header = "src/Football.Physics.Native/include/football_physics.h";

    [Fact]
    public void The_header_is_made_of_the_exports() => Repository.AssertCurrent(Header, CHeader.Make());

    [Fact]
    public void Every_export_is_in_the_header_and_the_other_way_round()
    {
        IEnumerable<string> exports = typeof(Exports).Assembly.GetTypes()
            .SelectMany(type => type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
            .Select(CHeader.NameOf).OfType<string>();
        Assert.Equal(exports.Order(StringComparer.Ordinal), Declaration().Matches(Repository.Text(Header)).Select(match => match.Groups[1].Value).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void The_sizes_that_a_binding_checks_are_those_of_the_structures_in_their_order()
    {
        MatchCollection structures = Structure().Matches(Repository.Text(Header));
        Assert.Equal(structures.Count, Exports.Sizes.Length);
        Assert.Equal(
            structures.Select(match => System.Runtime.InteropServices.Marshal.SizeOf(
                typeof(Exports).Assembly.GetType("FootballPhysics.Native.Native" + string.Concat(match.Groups[1].Value.Split('_').Select(word => char.ToUpperInvariant(word[0]) + word[1..])))!)),
            Exports.Sizes);
    }

    [Fact]
    public unsafe void Sizes_are_those_of_the_types()
    {
        Assert.Equal(NativeState.Size, sizeof(BallState));
        Assert.Equal(NativeState.Size, sizeof(NativeState));
        Assert.Equal(120, sizeof(NativeBall));
        Assert.Equal(160, sizeof(NativeEvent));
        Assert.Equal(
            (144, 208, 96, 72, 72, 96, 288, 232, 256),
            (sizeof(NativeBody), sizeof(NativeMatchEvent), sizeof(NativePlayer), sizeof(NativeInterception), sizeof(NativeWindow), sizeof(NativeGoalChanceResult), sizeof(NativeFitResult),
                sizeof(NativePiece), sizeof(NativeFitMatchResult)));
        Assert.Equal(16, sizeof(NativeWatch));
        Assert.Equal((64, 792), (sizeof(NativeFilterSettings), sizeof(NativeEstimate)));
        Assert.Equal((272, 104), (sizeof(NativeForcesResult), sizeof(NativeContactForce)));
    }

    [GeneratedRegex(@"^(?:typedef struct \{.*)?\} fp_(\w+);", RegexOptions.Multiline)]
    private static partial Regex Structure();

    [GeneratedRegex(@"^FOOTBALL_API .*?(fp_\w+)\(", RegexOptions.Multiline)]
    private static partial Regex Declaration();
}
