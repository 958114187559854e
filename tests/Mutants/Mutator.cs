using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FootballPhysics.Mutants;

/// <summary>One small mistake: what is written instead of a node of a file's syntax.</summary>
/// <param name="Path">The file.</param>
/// <param name="Node">The node.</param>
/// <param name="What">What it does, in words.</param>
/// <param name="Change">The node with the mistake, of the node as it is with those inside it.</param>
internal sealed record Mutant(string Path, SyntaxNode Node, string What, Func<SyntaxNode, SyntaxNode> Change)
{
    public int Line => Node.GetLocation().GetLineSpan().StartLinePosition.Line + 1;
}

/// <summary>The mistakes that can be made in a file: other operators, comparisons, conditions and signs, least for most, and statements left out.</summary>
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

            foreach ((string what, Func<SyntaxNode, SyntaxNode> change) in Of(node))
            {
                yield return new Mutant(path, node, what, change);
            }
        }
    }

    private static IEnumerable<(string What, Func<SyntaxNode, SyntaxNode> Change)> Of(SyntaxNode node)
    {
        switch (node)
        {
            case BinaryExpressionSyntax binary when Others.TryGetValue(binary.Kind(), out SyntaxKind[]? others):
                foreach (SyntaxKind other in others)
                {
                    yield return ($"{binary} with {Name(other)}", at => SyntaxFactory.BinaryExpression(other, ((BinaryExpressionSyntax)at).Left, ((BinaryExpressionSyntax)at).Right));
                }

                break;
            case PrefixUnaryExpressionSyntax unary when unary.IsKind(SyntaxKind.UnaryMinusExpression) || unary.IsKind(SyntaxKind.LogicalNotExpression):
                yield return ($"{unary} without its sign", at => ((PrefixUnaryExpressionSyntax)at).Operand);
                break;
            case LiteralExpressionSyntax literal when literal.IsKind(SyntaxKind.TrueLiteralExpression) || literal.IsKind(SyntaxKind.FalseLiteralExpression):
                yield return ($"not {literal}", at => SyntaxFactory.LiteralExpression(
                    at.IsKind(SyntaxKind.TrueLiteralExpression) ? SyntaxKind.FalseLiteralExpression : SyntaxKind.TrueLiteralExpression));
                break;
            case InvocationExpressionSyntax { Expression: MemberAccessExpressionSyntax { Name.Identifier.Text: "Min" or "Max" } member } call when member.Expression.ToString() == "Math":
                yield return ($"{call}: least for most", at => Swapped((InvocationExpressionSyntax)at));
                break;
            case ConditionalExpressionSyntax choice:
                yield return ($"{choice}: always the first", at => ((ConditionalExpressionSyntax)at).WhenTrue);
                yield return ($"{choice}: always the second", at => ((ConditionalExpressionSyntax)at).WhenFalse);
                break;
            case ExpressionSyntax condition when condition.Parent is IfStatementSyntax branch && branch.Condition == condition:
                yield return ($"not ({condition})", at => SyntaxFactory.PrefixUnaryExpression(SyntaxKind.LogicalNotExpression, SyntaxFactory.ParenthesizedExpression((ExpressionSyntax)at)));
                break;
            case ExpressionStatementSyntax statement when statement.Expression is InvocationExpressionSyntax or AssignmentExpressionSyntax:
                yield return ($"{statement} left out", at => at);
                break;
        }
    }

    /// <summary>The node with a choice at run time: a statement that is left out, an expression that is another.</summary>
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

    private static string Name(SyntaxKind kind) => kind.ToString().Replace("Expression", "", StringComparison.Ordinal);

    // What must be known to the compiler can be no choice at run time.
    private static bool IsConstant(ExpressionSyntax expression, SemanticModel model) =>
        (model.GetConstantValue(expression).HasValue && expression is not LiteralExpressionSyntax)
        || expression.Ancestors().Any(at => at is AttributeSyntax or ParameterSyntax or CaseSwitchLabelSyntax or EnumMemberDeclarationSyntax or ThrowExpressionSyntax or ThrowStatementSyntax
            || (at is FieldDeclarationSyntax field && field.Modifiers.Any(SyntaxKind.ConstKeyword))
            || (at is LocalDeclarationStatementSyntax local && local.Modifiers.Any(SyntaxKind.ConstKeyword))
            || (at is InvocationExpressionSyntax call && call.Expression.ToString().StartsWith("Check.", StringComparison.Ordinal)));

    // A variable is declared once, and what is known to be assigned must stay so.
    private static bool Declares(ExpressionSyntax expression) => expression.DescendantNodes().Any(at =>
        at is DeclarationExpressionSyntax or DeclarationPatternSyntax or SingleVariableDesignationSyntax or RefExpressionSyntax
        || (at is ArgumentSyntax argument && argument.RefKindKeyword.IsKind(SyntaxKind.OutKeyword)));
}
