using FootballPhysics.Mutants;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FootballPhysics.Passes;

/// <summary>The library with a switch in each of some bodies. The switch removes the body.</summary>
/// <remarks>A removed body returns the default of its type, and sets out parameters to the default. A body that does nothing else throws.</remarks>
internal static class RemovedBodies
{
    /// <summary>The environment variable with the number of the removed body; −1 for none.</summary>
    public const string Variable = "FOOTBALL_REMOVED";

    /// <summary>The environment variable with the path of the file to which a process appends the tests that reach each body. A test can load the library twice.</summary>
    public const string Reached = "FOOTBALL_REMOVED_REACHED";

    // The test is on the stack. The first calls of a body look for it, and then one call per millisecond, so that each test is seen.
    private const string Switch = $$"""
        internal static class Removed
        {
            private static readonly int Active = int.Parse(System.Environment.GetEnvironmentVariable("{{Variable}}")!);
            private static readonly string? Path = System.Environment.GetEnvironmentVariable("{{Reached}}");
            private static readonly System.Collections.Generic.Dictionary<int, (long Calls, long Last, System.Collections.Generic.HashSet<string> Tests)> Bodies = [];

            static Removed()
            {
                System.AppDomain.CurrentDomain.ProcessExit += (_, _) =>
                {
                    if (Path is not null)
                    {
                        System.IO.File.AppendAllLines(Path, System.Linq.Enumerable.Select(Bodies, body => body.Key + " " + string.Join(" ", body.Value.Tests)));
                    }
                };
            }

            public static bool Is(int number)
            {
                if (Path is not null)
                {
                    Note(number);
                }

                return Active == number;
            }

            private static void Note(int number)
            {
                lock (Bodies)
                {
                    long now = System.Diagnostics.Stopwatch.GetTimestamp();
                    (long calls, long last, System.Collections.Generic.HashSet<string> tests) = Bodies.TryGetValue(number, out var body) ? body : (0, 0, []);
                    bool looks = calls < 200 || now - last > System.Diagnostics.Stopwatch.Frequency / 1000;
                    Bodies[number] = (calls + 1, looks ? now : last, tests);
                    if (!looks)
                    {
                        return;
                    }

                    foreach (System.Diagnostics.StackFrame frame in new System.Diagnostics.StackTrace(2, false).GetFrames())
                    {
                        System.Type? type = frame.GetMethod()?.DeclaringType;
                        string method = frame.GetMethod()?.Name ?? "";
                        for (; type?.DeclaringType is not null; type = type.DeclaringType)
                        {
                            // A lambda or an iterator of a test: its name contains that of the test.
                            string text = method.StartsWith("<") ? method : type.Name;
                            method = text.StartsWith("<") && text.IndexOf('>') is > 1 and var end ? text[1..end] : method;
                        }

                        if (type is not null && type.Name.EndsWith("Tests"))
                        {
                            tests.Add(type.FullName + "." + method);
                        }
                    }
                }
            }
        }
        """;

    private static readonly string[] s_defaults = ["false", "0", "null", "null!", "default", "default!", "Vector3d.Zero"];

    /// <summary>Returns the library in which the switch of each body has its position among the bodies as its number.</summary>
    /// <param name="bodies">The numbers of the bodies.</param>
    /// <param name="methods">Gets all bodies of the library.</param>
    public static byte[] Compiled(int[] bodies, List<Method> methods)
    {
        List<SyntaxTree> trees = MarkedLibrary.Trees(methods, (number, declaration) =>
            Array.IndexOf(bodies, number) is >= 0 and int place ? $"if (global::Removed.Is({place})) {Without(declaration)}" : "");
        return MarkedLibrary.Compiled([.. trees, CSharpSyntaxTree.ParseText(Switch, LibrarySources.Parsing)]);
    }

    /// <summary>Returns the statement that replaces a body.</summary>
    private static string Without(SyntaxNode declaration)
    {
        (SyntaxNode? block, SyntaxNode? arrow, string type) = declaration switch
        {
            ConstructorDeclarationSyntax made => (made.Body, made.ExpressionBody, "void"),
            MethodDeclarationSyntax method => (method.Body, method.ExpressionBody, method.ReturnType.ToString()),
            OperatorDeclarationSyntax operation => (operation.Body, operation.ExpressionBody, operation.ReturnType.ToString()),
            ConversionOperatorDeclarationSyntax conversion => (conversion.Body, conversion.ExpressionBody, conversion.Type.ToString()),
            AccessorDeclarationSyntax accessor when accessor.IsKind(SyntaxKind.GetAccessorDeclaration) => (accessor.Body, accessor.ExpressionBody, ((BasePropertyDeclarationSyntax)accessor.Parent!.Parent!).Type.ToString()),
            AccessorDeclarationSyntax accessor => (accessor.Body, accessor.ExpressionBody, "void"),
            PropertyDeclarationSyntax property => (null, property.ExpressionBody, property.Type.ToString()),
            IndexerDeclarationSyntax indexer => (default(SyntaxNode), (SyntaxNode?)indexer.ExpressionBody, indexer.Type.ToString()),
            _ => throw new InvalidOperationException($"There is no rule to remove a {declaration.Kind()}."),
        };
        SyntaxNode body = block ?? arrow!;
        if (type.StartsWith("ref ", StringComparison.Ordinal) || DoesNothing(body))
        {
            return "throw new global::System.NotImplementedException();";
        }

        ParameterListSyntax? parameters = (declaration as BaseMethodDeclarationSyntax)?.ParameterList;
        string outs = string.Concat((parameters?.Parameters ?? []).Where(at => at.Modifiers.Any(SyntaxKind.OutKeyword)).Select(at => $"{at.Identifier.Text} = default!; "));
        bool yields = body.DescendantNodes(at => at is not (LocalFunctionStatementSyntax or AnonymousFunctionExpressionSyntax)).OfType<YieldStatementSyntax>().Any();
        return $"{{ {outs}{(yields ? "yield break;" : type == "void" ? "return;" : "return default!;")} }}";
    }

    private static bool DoesNothing(SyntaxNode body) => body switch
    {
        ArrowExpressionClauseSyntax arrow => s_defaults.Contains(arrow.Expression.ToString()),
        BlockSyntax { Statements: [] } => true,
        BlockSyntax { Statements: [ReturnStatementSyntax { Expression: { } value }] } => s_defaults.Contains(value.ToString()),
        _ => false,
    };
}
