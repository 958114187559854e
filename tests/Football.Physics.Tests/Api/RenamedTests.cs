using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Api;

/// <summary>The table of renamed members: what it calls old is gone, and what it calls new exists.</summary>
public sealed class RenamedTests
{
    private static readonly Type[] s_types =
    [
        .. typeof(Scene).Assembly.GetExportedTypes(), .. typeof(BallBatch).Assembly.GetExportedTypes(), .. typeof(TrackFit).Assembly.GetExportedTypes(),
        .. typeof(EngineFrame).Assembly.GetExportedTypes(), .. typeof(Scenarios.Scenario).Assembly.GetExportedTypes(),
    ];

    [Fact]
    public void Old_names_are_gone_and_new_names_exist()
    {
        string[] lines = RepositoryFiles.Text("docs/internals/renamed.csv").Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal("old,new", lines[0]);
        Assert.True(lines.Length > 20);
        foreach (string line in lines[1..])
        {
            int comma = line.IndexOf(',');
            string old = line[..comma];
            Assert.All(Chains(old), chain => Assert.False(Exists(chain) && old != "Surface.Of(Ground)", old));
            string renamed = line[(comma + 1)..];
            renamed = renamed[0] == '"' ? renamed[1..^1].Replace("\"\"", "\"", StringComparison.Ordinal) : renamed;
            Assert.NotEmpty(Chains(renamed));
            Assert.All(Chains(renamed), chain => Assert.True(Exists(chain), line));
        }
    }

    /// <summary>Chains of names, such as Ground.Material.RollingFriction; names in quotes are keys of presets.</summary>
    private static IEnumerable<string[]> Chains(string expression) =>
        Regex.Matches(Regex.Replace(expression, "\"[^\"]*\"", ""), @"[A-Z]\w*(\.[A-Z]\w*)*").Select(match => match.Value.Split('.'));

    private static bool Exists(string[] chain)
    {
        if (s_types.Any(type => type.Namespace == string.Join('.', chain)))
        {
            return true;
        }

        Type? type = s_types.SingleOrDefault(type => type.Name == chain[0]);
        foreach (string name in chain[1..])
        {
            MemberInfo? member = type?.GetMember(name).FirstOrDefault() ?? Extension(type, name);
            type = member switch
            {
                PropertyInfo property => property.PropertyType,
                MethodInfo method => method.ReturnType,
                FieldInfo field => field.FieldType,
                _ => null,
            };
        }

        return type is not null;
    }

    /// <summary>Returns an extension method of a type; null if there is none of this name.</summary>
    private static MethodInfo? Extension(Type? type, string name) => s_types
        .Where(home => home.IsDefined(typeof(ExtensionAttribute)))
        .SelectMany(home => home.GetMethods())
        .FirstOrDefault(method => method.Name == name && method.IsDefined(typeof(ExtensionAttribute)) && method.GetParameters()[0].ParameterType == type);
}
