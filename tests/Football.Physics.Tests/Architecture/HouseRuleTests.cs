namespace FootballPhysics.Tests.Architecture;

/// <summary>The house rules that a text can show, of the library and of small trees that break them.</summary>
public sealed class HouseRuleTests
{
    [Fact]
    public void No_file_is_longer_than_450_lines() => Assert.Empty(HouseRules.LongFiles(SourceFile.Sources));

    [Fact]
    public void No_type_is_longer_than_600_lines_in_all_its_parts() => Assert.Empty(HouseRules.LongTypes(SourceFile.Library));

    [Fact]
    public void No_method_is_longer_than_80_lines() => Assert.Empty(HouseRules.LongMethods(SourceFile.Sources));

    [Fact]
    public void A_long_method_is_found()
    {
        string Method(int lines) =>
            "namespace N;\n\nclass A\n{\n    int B { get; }\n\n    [C]\n    void D<T>(T t)\n        where T : struct\n    {\n"
            + string.Concat(Enumerable.Repeat("        E(t => { });\n", lines - 5)) + "    }\n}\n";
        Assert.Empty(HouseRules.LongMethods([File("Laws/A.cs", Method(HouseRules.LongestMethod))]));
        Assert.Equal(["Laws/A.cs(7): 81 lines"], HouseRules.LongMethods([File("Laws/A.cs", Method(HouseRules.LongestMethod + 1))]));
    }

    [Fact]
    public void Nothing_asks_what_a_type_parameter_is() => Assert.Empty(HouseRules.QuestionsOfType(SourceFile.Library));

    [Fact]
    public void No_switch_takes_an_unknown_value_of_an_enumeration_for_a_known_one() => Assert.Empty(HouseRules.OpenSwitches(SourceFile.Library));

    [Fact]
    public void What_steps_a_ball_indexes_no_read_only_span() => Assert.Empty(HouseRules.ReadOnlySpans(SourceFile.Library));

    [Theory]
    [InlineData("Contacts/A.cs", "double First(ReadOnlySpan<double> items) => items[0];", true)]
    [InlineData("Contacts/A.cs", "double First(Span<double> items) => items[0]; // No ReadOnlySpan.", false)]
    [InlineData("Game/A.cs", "double First(ReadOnlySpan<double> items) => items[0];", false)]
    public void A_read_only_span_is_found(string path, string member, bool wrong) =>
        Assert.Equal(wrong, HouseRules.ReadOnlySpans([File(path, $"class A {{ {member} }}")]).Count > 0);

    [Fact]
    public void Each_contact_tolerance_is_in_one_file() => Assert.Empty(HouseRules.LooseTolerances(SourceFile.Library));

    [Fact]
    public void Each_file_with_other_small_numbers_contains_one() => Assert.All(
        HouseRules.OtherSmallNumbers.Keys, path => Assert.NotEmpty(HouseRules.LooseTolerances([File("Contacts/A.cs", SourceFile.Library.Single(file => file.Path == path).Text)])));

    [Fact]
    public void Each_constant_of_a_law_is_in_one_file() => Assert.Empty(HouseRules.RepeatedNumbers(SourceFile.Library));

    [Theory]
    [InlineData("Contacts/A.cs", "1e-12", true)]
    [InlineData("Simulation/Several/A.cs", "2.5e-7", true)]
    [InlineData("Simulation/A.cs", "0.5e-3", false)]
    [InlineData("Simulation/A.cs", "1e9", false)]
    [InlineData("Aiming/A.cs", "1e-9", false)]
    [InlineData("Simulation/ZoneSearch.cs", "1e-9", false)]
    [InlineData("Contacts/ContactTolerances.cs", "1e-9", false)]
    public void A_loose_tolerance_is_found(string path, string number, bool wrong) =>
        Assert.Equal(wrong, HouseRules.LooseTolerances([File(path, $"class A {{ const double B = {number}; }}")]).Count > 0);

    [Theory]
    [InlineData("Laws/A.cs", "287.058", "Scenes/B.cs", "287.058", true)]
    [InlineData("Numerics/A.cs", "287.058", "Numerics/B.cs", "287.058", false)]
    [InlineData("Laws/A.cs", "0.125", "Scenes/B.cs", "0.125", false)]
    [InlineData("Laws/A.cs", "287.058", "Laws/A.cs", "287.058", false)]
    public void A_repeated_number_is_found(string path, string number, string other, string same, bool wrong)
    {
        SourceFile[] tree = [File(path, $"class A {{ const double C = {number}; }}"), File(other, $"class B {{ const double C = {same}; }}")];
        Assert.Equal(wrong, HouseRules.RepeatedNumbers(tree).Count > 0);
    }

    [Fact]
    public void A_long_file_is_found()
    {
        Assert.Empty(HouseRules.LongFiles([File("Laws/A.cs", Lines(HouseRules.LongestFile))]));
        Assert.Equal(["Laws/A.cs: 451 lines"], HouseRules.LongFiles([File("Laws/A.cs", Lines(HouseRules.LongestFile + 1))]));
    }

    [Fact]
    public void A_long_type_is_found_also_in_parts()
    {
        string Part(int lines) => $"namespace N;\n\ninternal partial class A<T>\n    where T : struct\n{{\n{Lines(lines - 4)}}}\n";
        Assert.Empty(HouseRules.LongTypes([File("Laws/A.cs", Part(300)), File("Laws/A.More.cs", Part(300)), File("Game/A.cs", Part(40))]));
        Assert.Equal(["A: 601 lines in 2 parts"], HouseRules.LongTypes([File("Laws/A.cs", Part(300)), File("Laws/A.More.cs", Part(301))]));
    }

    [Theory]
    [InlineData("bool B => typeof(T) == typeof(A);", true)]
    [InlineData("bool B => x.GetType() == typeof(A);", true)]
    [InlineData("bool B => typeof(List<T>) != y;", true)]
    [InlineData("string B => Enum.GetNames(typeof(T));", false)]
    [InlineData("string B => \"typeof(T) == typeof(A)\"; // typeof(T) == typeof(A)", false)]
    public void A_question_for_a_type_is_found(string member, bool wrong) =>
        Assert.Equal(wrong, HouseRules.QuestionsOfType([File("Laws/A.cs", $"class A<T> {{ {member} }}")]).Count > 0);

    [Theory]
    [InlineData("E.One => 1, _ => 2", true)]
    [InlineData("E.One => 1, E.Two or E.Three => Two(E.Two), _ => x switch { _ => 2 }", true)]
    [InlineData("(E.One, true) => 1, _ => 2", false)] // A pair is more than its enumeration.
    [InlineData("E.One => 1, E.Two => 2, _ => throw Unknown(x)", false)]
    [InlineData("1 => E.One, _ => E.Two", false)]
    [InlineData("F.One => 1, _ => 2", false)] // Not one of ours.
    public void A_switch_that_answers_for_values_to_come_is_found(string arms, bool wrong)
    {
        SourceFile[] tree = [File("Scenes/E.cs", "public enum E { One, Two }"), File("Laws/A.cs", $"class A {{ int B(E x) => x switch {{ {arms} }}; }}")];
        Assert.Equal(wrong, HouseRules.OpenSwitches(tree).Count > 0);
    }

    private static SourceFile File(string path, string text) => new(path, text);

    private static string Lines(int count) => string.Concat(Enumerable.Repeat("// A line.\n", count));
}
