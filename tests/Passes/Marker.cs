using FootballPhysics.Tests.Architecture;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FootballPhysics.Passes;

/// <summary>Inserts a statement at the start of each body. The rest of the text, with its directives, stays.</summary>
internal static class Marker
{
    /// <summary>Returns the text with the statements, and adds its bodies to the list.</summary>
    /// <param name="root">The syntax of a file.</param>
    /// <param name="file">The index of the file.</param>
    /// <param name="methods">The bodies so far. The index of a body is its number.</param>
    /// <param name="mark">Returns the statement for the number and the declaration of a body; empty for none.</param>
    public static string Marked(SyntaxNode root, int file, List<Method> methods, Func<int, SyntaxNode, string> mark)
    {
        string text = root.ToFullString();
        var changes = new List<(int From, int To, string With)>();
        foreach (SyntaxNode node in root.DescendantNodes())
        {
            string with = "";
            switch (node)
            {
                case BaseMethodDeclarationSyntax { ExpressionBody: { } body } method:
                    Add();
                    Replace(body, method.SemicolonToken, method is not ConstructorDeclarationSyntax && (method as MethodDeclarationSyntax)?.ReturnType.ToString() != "void", "");
                    break;
                case AccessorDeclarationSyntax { ExpressionBody: { } body } accessor:
                    Add();
                    Replace(body, accessor.SemicolonToken, accessor.IsKind(SyntaxKind.GetAccessorDeclaration), "");
                    break;
                case BaseMethodDeclarationSyntax { Body: { } block }:
                    Add();
                    changes.Add((block.OpenBraceToken.Span.End, block.OpenBraceToken.Span.End, with));
                    break;
                case AccessorDeclarationSyntax { Body: { } block }:
                    Add();
                    changes.Add((block.OpenBraceToken.Span.End, block.OpenBraceToken.Span.End, with));
                    break;
                case PropertyDeclarationSyntax { ExpressionBody: { } body } property:
                    Add();
                    Replace(body, property.SemicolonToken, true, "get");
                    break;
                case IndexerDeclarationSyntax { ExpressionBody: { } body } indexer:
                    Add();
                    Replace(body, indexer.SemicolonToken, true, "get");
                    break;
            }

            void Add()
            {
                with = $" {mark(methods.Count, node)} ";
                int line = node.SyntaxTree.GetLineSpan(node.Span).StartLinePosition.Line + 1;
                methods.Add(new Method(file, line, node.ToString().Split('\n').Count(CodeSize.IsWorking), NameOf(node)));
            }

            void Replace(ArrowExpressionClauseSyntax body, SyntaxToken end, bool returns, string accessor)
            {
                string block = $"{{{with}{(returns && body.Expression is not ThrowExpressionSyntax ? "return " : "")}{body.Expression}; }}";
                changes.Add((body.SpanStart, end.Span.End, accessor == "" ? block : $"{{ {accessor} {block} }}"));
            }
        }

        foreach ((int from, int to, string with) in changes.OrderByDescending(change => change.From))
        {
            text = text[..from] + with + text[to..];
        }

        return text;
    }

    /// <summary>Returns the type and the name of a declaration.</summary>
    public static string NameOf(SyntaxNode node)
    {
        string type = node.FirstAncestorOrSelf<TypeDeclarationSyntax>()!.Identifier.Text;
        SyntaxNode member = node is AccessorDeclarationSyntax ? node.Parent!.Parent! : node;
        string name = member switch
        {
            MethodDeclarationSyntax method => method.Identifier.Text,
            PropertyDeclarationSyntax property => property.Identifier.Text,
            ConstructorDeclarationSyntax => "new",
            OperatorDeclarationSyntax operation => operation.OperatorToken.Text,
            _ => member.Kind().ToString(),
        };
        return $"{type}.{name}";
    }
}
