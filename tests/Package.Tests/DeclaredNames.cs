using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FootballPhysics.Package.Tests;

/// <summary>The names that the C# sources of the repository declare.</summary>
internal sealed class DeclaredNames
{
    private readonly Dictionary<string, HashSet<string>> _members = [];
    private readonly Dictionary<string, HashSet<string>> _bases = [];
    private readonly HashSet<string> _all = [];

    public static DeclaredNames OfRepository { get; } = new(new[] { "src", "samples", "benchmarks", "tests", "docs" }
        .SelectMany(folder => Directory.GetFiles(Path.Combine(Repository.Root, folder), "*.cs", SearchOption.AllDirectories))
        .Where(file => !file.Contains($"{Path.DirectorySeparatorChar}obj{Path.DirectorySeparatorChar}", StringComparison.Ordinal))
        .Select(File.ReadAllText),
        Directory.GetDirectories(Path.Combine(Repository.Root, "src", "Football.Physics")).Concat(Directory.GetDirectories(Path.Combine(Repository.Root, "src"), "Football.Physics.*")).Select(folder => folder.Split('.', '/', '\\')[^1]));

    /// <summary>Collects the names.</summary>
    /// <param name="sources">Texts of files of C#.</param>
    /// <param name="folders">Names of folders, which pages may name too.</param>
    public DeclaredNames(IEnumerable<string> sources, IEnumerable<string> folders)
    {
        _all.UnionWith(folders);
        foreach (string source in sources)
        {
            foreach (SyntaxNode node in CSharpSyntaxTree.ParseText(source).GetRoot().DescendantNodes())
            {
                Add(node);
            }
        }
    }

    /// <summary>True if a type has this name.</summary>
    public bool IsType(string name) => _members.ContainsKey(name);

    /// <summary>True if a type, a member or a folder has this name.</summary>
    public bool IsDeclared(string name) => _all.Contains(name);

    /// <summary>True if a type, one of its bases or an interface of it has this member.</summary>
    public bool HasMember(string type, string member) =>
        _members.TryGetValue(type, out HashSet<string>? members) && (members.Contains(member) || _bases[type].Any(parent => parent != type && HasMember(parent, member)));

    private void Add(SyntaxNode node)
    {
        switch (node)
        {
            case BaseTypeDeclarationSyntax type:
                string name = type.Identifier.Text;
                Of(name);
                _bases[name].UnionWith(type.BaseList?.Types.Select(parent => parent.Type).Select(parent => parent is GenericNameSyntax generic ? generic.Identifier.Text : parent.ToString().Split('.')[^1]) ?? []);
                Member(type, name);
                foreach (ParameterSyntax parameter in (type as TypeDeclarationSyntax)?.ParameterList?.Parameters ?? default)
                {
                    Of(name).Add(parameter.Identifier.Text);
                    _all.Add(parameter.Identifier.Text);
                }

                break;
            case DelegateDeclarationSyntax type:
                Of(type.Identifier.Text);
                Member(type, type.Identifier.Text);
                break;
            case MethodDeclarationSyntax method:
                Member(method, method.Identifier.Text);
                if (method.ParameterList.Parameters is [var first, ..] && first.Modifiers.Any(SyntaxKind.ThisKeyword))
                {
                    // An extension is called like a member of the type.
                    Of(first.Type!.ToString()).Add(method.Identifier.Text);
                }

                break;
            case PropertyDeclarationSyntax property:
                Member(property, property.Identifier.Text);
                break;
            case EventDeclarationSyntax property:
                Member(property, property.Identifier.Text);
                break;
            case EnumMemberDeclarationSyntax member:
                Member(member, member.Identifier.Text);
                break;
            case BaseFieldDeclarationSyntax field:
                foreach (VariableDeclaratorSyntax variable in field.Declaration.Variables)
                {
                    Member(field, variable.Identifier.Text);
                }

                break;
        }
    }

    private void Member(SyntaxNode node, string name)
    {
        _all.Add(name);
        if (node.Parent is BaseTypeDeclarationSyntax owner)
        {
            Of(owner.Identifier.Text).Add(name);
        }
    }

    private HashSet<string> Of(string type)
    {
        if (!_members.TryGetValue(type, out HashSet<string>? members))
        {
            _members.Add(type, members = []);
            _bases.Add(type, []);
            _all.Add(type);
        }

        return members;
    }
}
