using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace FootballPhysics.Mutants;

/// <summary>One small error: a node of a file's syntax tree is replaced.</summary>
/// <param name="Path">The file.</param>
/// <param name="Node">The node.</param>
/// <param name="Change">Returns the changed node. The argument is the node, which may already contain other switches.</param>
internal sealed record Mutant(string Path, SyntaxNode Node, Func<SyntaxNode, SyntaxNode> Change)
{
    /// <summary>The file in the library, with line and column.</summary>
    public string Place
    {
        get
        {
            LinePosition start = Node.GetLocation().GetLineSpan().StartLinePosition;
            return $"{File}:{start.Line + 1}:{start.Character + 1}";
        }
    }

    /// <summary>The file in the library.</summary>
    public string File => System.IO.Path.GetRelativePath(LibrarySources.Folder, Path);

    /// <summary>The original text and the mutated text, each in one line.</summary>
    public string What => $"{OneLine(Node)}  →  {(Node is StatementSyntax ? "(removed)" : OneLine(Change(Node.WithoutTrivia()).NormalizeWhitespace()))}";

    /// <summary>The member that contains the node, such as <c>IsHeavier</c>.</summary>
    public string Member => Node.Ancestors().OfType<MemberDeclarationSyntax>().First() switch
    {
        MethodDeclarationSyntax method => method.Identifier.Text,
        PropertyDeclarationSyntax property => property.Identifier.Text,
        BaseFieldDeclarationSyntax field => field.Declaration.Variables[0].Identifier.Text,
        BaseTypeDeclarationSyntax type => type.Identifier.Text,
        ConstructorDeclarationSyntax constructor => constructor.Identifier.Text,
        _ => "this",
    };

    private static string OneLine(SyntaxNode node) => string.Join(' ', node.ToString().Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
}

/// <summary>Finds the mutants of a file: other operators and comparisons, negated conditions, missing signs, Min and Max exchanged, and removed statements.</summary>
internal static class Mutator
{
    private static readonly Dictionary<SyntaxKind, SyntaxKind[]> Others = new()
    {
        [SyntaxKind.AddExpression] = [SyntaxKind.SubtractExpression],
        [SyntaxKind.SubtractExpression] = [SyntaxKind.AddExpression],
        [SyntaxKind.MultiplyExpression] = [SyntaxKind.DivideExpression],
        [SyntaxKind.DivideExpression] = [SyntaxKind.MultiplyExpression],
        [SyntaxKind.LessThanExpression] = [SyntaxKind.LessThanOrEqualExpression, SyntaxKind.GreaterThanExpression],
        [SyntaxKind.LessThanOrEqualExpression] = [SyntaxKind.LessThanExpression, SyntaxKind.GreaterThanExpression],
        [SyntaxKind.GreaterThanExpression] = [SyntaxKind.GreaterThanOrEqualExpression, SyntaxKind.LessThanExpression],
        [SyntaxKind.GreaterThanOrEqualExpression] = [SyntaxKind.GreaterThanExpression, SyntaxKind.LessThanExpression],
        [SyntaxKind.EqualsExpression] = [SyntaxKind.NotEqualsExpression],
        [SyntaxKind.NotEqualsExpression] = [SyntaxKind.EqualsExpression],
        [SyntaxKind.LogicalAndExpression] = [SyntaxKind.LogicalOrExpression],
        [SyntaxKind.LogicalOrExpression] = [SyntaxKind.LogicalAndExpression],
    };

    public static IEnumerable<Mutant> Of(string path, SyntaxNode root, SemanticModel model)
    {
        foreach (SyntaxNode node in root.DescendantNodes())
        {
            if (node is ExpressionSyntax expression ? IsConstant(expression, model) || Declares(expression) : node is not ExpressionStatementSyntax)
            {
                continue;
            }

            foreach (Func<SyntaxNode, SyntaxNode> change in Of(node))
            {
                yield return new Mutant(path, node, change);
            }
        }
    }

    private static IEnumerable<Func<SyntaxNode, SyntaxNode>> Of(SyntaxNode node)
    {
        switch (node)
        {
            case BinaryExpressionSyntax binary when Others.TryGetValue(binary.Kind(), out SyntaxKind[]? others):
                foreach (SyntaxKind other in others)
                {
                    yield return at => SyntaxFactory.BinaryExpression(other, ((BinaryExpressionSyntax)at).Left, ((BinaryExpressionSyntax)at).Right);
                }

                break;
            case PrefixUnaryExpressionSyntax unary when unary.IsKind(SyntaxKind.UnaryMinusExpression) || unary.IsKind(SyntaxKind.LogicalNotExpression):
                yield return at => ((PrefixUnaryExpressionSyntax)at).Operand;
                break;
            case LiteralExpressionSyntax literal when literal.IsKind(SyntaxKind.TrueLiteralExpression) || literal.IsKind(SyntaxKind.FalseLiteralExpression):
                yield return at => SyntaxFactory.LiteralExpression(
                    at.IsKind(SyntaxKind.TrueLiteralExpression) ? SyntaxKind.FalseLiteralExpression : SyntaxKind.TrueLiteralExpression);
                break;
            case InvocationExpressionSyntax { Expression: MemberAccessExpressionSyntax { Name.Identifier.Text: "Min" or "Max" } member } call when member.Expression.ToString() == "Math":
                yield return at => Swapped((InvocationExpressionSyntax)at);
                break;
            case ConditionalExpressionSyntax choice:
                yield return at => ((ConditionalExpressionSyntax)at).WhenTrue;
                yield return at => ((ConditionalExpressionSyntax)at).WhenFalse;
                break;
            case ExpressionSyntax condition when condition.Parent is IfStatementSyntax branch && branch.Condition == condition:
                yield return at => SyntaxFactory.PrefixUnaryExpression(SyntaxKind.LogicalNotExpression, SyntaxFactory.ParenthesizedExpression((ExpressionSyntax)at));
                break;
            case ExpressionStatementSyntax statement when statement.Expression is InvocationExpressionSyntax or AssignmentExpressionSyntax:
                yield return at => at;
                break;
        }
    }

    /// <summary>Returns the node with a switch for each mutant. The switch selects the original or the mutant at run time.</summary>
    public static SyntaxNode Switched(SyntaxNode node, IReadOnlyList<(int Number, Mutant Mutant)> mutants)
    {
        if (node is StatementSyntax statement)
        {
            return SyntaxFactory.ParseStatement($"if (!global::Mutation.Is({mutants[0].Number})) {{ {statement.WithoutTrivia()} }}").WithTriviaFrom(statement);
        }

        var switched = (ExpressionSyntax)node.WithoutTrivia();
        foreach ((int number, Mutant mutant) in mutants)
        {
            SyntaxNode changed = mutant.Change(node.WithoutTrivia());
            switched = SyntaxFactory.ParseExpression($"(global::Mutation.Is({number}) ? ({changed.NormalizeWhitespace()}) : ({switched.NormalizeWhitespace()}))");
        }

        return switched.WithTriviaFrom(node);
    }

    private static InvocationExpressionSyntax Swapped(InvocationExpressionSyntax call)
    {
        var member = (MemberAccessExpressionSyntax)call.Expression;
        string other = member.Name.Identifier.Text == "Min" ? "Max" : "Min";
        return call.WithExpression(member.WithName(SyntaxFactory.IdentifierName(other)));
    }

    // The compiler needs the value of a constant, so a constant cannot contain a switch.
    private static bool IsConstant(ExpressionSyntax expression, SemanticModel model) =>
        (model.GetConstantValue(expression).HasValue && expression is not LiteralExpressionSyntax)
        || expression.Ancestors().Any(at => at is AttributeSyntax or ParameterSyntax or CaseSwitchLabelSyntax or EnumMemberDeclarationSyntax or ThrowExpressionSyntax or ThrowStatementSyntax
            || (at is FieldDeclarationSyntax field && field.Modifiers.Any(SyntaxKind.ConstKeyword))
            || (at is LocalDeclarationStatementSyntax local && local.Modifiers.Any(SyntaxKind.ConstKeyword))
            || (at is InvocationExpressionSyntax call && call.Expression.ToString().StartsWith("Check.", StringComparison.Ordinal)));

    // A switch repeats its expression. It must not declare a variable twice, or assign one in one branch only.
    private static bool Declares(ExpressionSyntax expression) => expression.DescendantNodes().Any(at =>
        at is DeclarationExpressionSyntax or DeclarationPatternSyntax or SingleVariableDesignationSyntax or RefExpressionSyntax
        || (at is ArgumentSyntax argument && argument.RefKindKeyword.IsKind(SyntaxKind.OutKeyword)));
}
