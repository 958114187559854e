namespace FootballPhysics.Package.Tests;

/// <summary>docs/api.md is made from the assemblies and their XML documentation, and is kept current.</summary>
public sealed class ApiReferenceTests
{
    private static readonly System.Reflection.Assembly[] s_assemblies = [.. ((Type[])[typeof(Ball), typeof(ThesisAimer), typeof(TrackFit)]).Select(type => type.Assembly)];

    [Fact]
    public void The_API_reference_is_current() => Repository.AssertCurrent("docs/api.md", ApiReference.Make(s_assemblies));

    /// <summary>A member whose documentation is not found has no line, so compare the page with the types themselves.</summary>
    [Fact]
    public void Every_public_constructor_with_parameters_has_a_line_with_its_parameters()
    {
        Dictionary<string, string[]> sections = ApiReference.Make(s_assemblies).Split("\n## ").Skip(1).GroupBy(section => section.Split('\n')[0]).ToDictionary(same => same.Key, same => same.ToArray());
        int count = 0;
        foreach (Type type in s_assemblies.SelectMany(assembly => assembly.GetExportedTypes()).Where(type => type.BaseType != typeof(MulticastDelegate) && type.Namespace!.StartsWith("Football", StringComparison.Ordinal)))
        {
            string name = type.Name.Split('`')[0];
            foreach (System.Reflection.ConstructorInfo constructor in type.GetConstructors().Where(constructor => constructor.GetParameters().Length > 0))
            {
                string[] names = [.. constructor.GetParameters().Select(parameter => parameter.Name!)];
                bool listed = sections.Where(section => section.Key.Split('.')[^1].Split('<')[0] == name).SelectMany(section => section.Value)
                    .SelectMany(section => section.Split('\n')).Any(line => line.StartsWith("- `new ", StringComparison.Ordinal) && Parameters(line).SequenceEqual(names));
                Assert.True(listed, $"docs/api.md has no line for new {type.FullName}({string.Join(", ", names)})");
                count++;
            }
        }

        Assert.InRange(count, 20, 1000);
    }

    private static IEnumerable<string> Parameters(string line)
    {
        string list = line[(line.IndexOf('(', StringComparison.Ordinal) + 1)..line.IndexOf(")`", StringComparison.Ordinal)];

        // Commas also separate the arguments of generic types and the dimensions of arrays, which have no space, or no name, behind them.
        return list.Split(", ").Select(part => part.Split(" = ")[0].Split(' ')).Where(words => words.Length > 1).Select(words => words[^1]);
    }
}
