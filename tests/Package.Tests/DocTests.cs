using System.Runtime.Loader;
using Markdig;
using Markdig.Syntax;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Package.Tests;

/// <summary>
/// Compiles and runs every C# block of README.md, CONTRIBUTING.md, docs/ and docs/internals/. A block is a program of its own; <c>csharp continued</c> goes on where
/// the block before it ended; <c>csharp unity</c> and <c>csharp godot</c> are classes for the engine's project and are compiled against
/// the shims, as are the programs <c>csharp monogame</c> and <c>csharp raylib</c>. A <c>csharp recipe</c> is compiled against stand-ins of Unity's packages; RecipeTests plays it. A <c>text</c> block right after a program is what it prints.
/// </summary>
[Collection(EngineTests.Statics)]
public sealed class DocTests
{
    private static readonly string[] s_usings = ["System", "System.Collections.Generic", "System.IO", "System.Linq", "System.Threading", "System.Threading.Tasks"];

    public static TheoryData<string> Pages =>
        [.. Repository.Pages.Where(page => Blocks(page).Count > 0)];

    [Theory]
    [MemberData(nameof(Pages))]
    public void Every_code_block_compiles_runs_and_prints_what_the_page_says(string page)
    {
        var lines = Repository.Text(page).Split('\n').ToList();
        foreach (Block block in Blocks(page).AsEnumerable().Reverse())
        {
            string said = Run(block).Trim('\n');
            if (block.Prints is { } expected)
            {
                Assert.True(
                    Repository.Regenerates || expected.Trim('\n') == said,
                    $"{page}, line {block.Line}: the program prints\n{said}\nand the page says\n{expected}\nIf the program is right, run tests/regenerate.sh.");
                lines.RemoveRange(block.PrintsLine, block.PrintsLines);
                lines.InsertRange(block.PrintsLine, said.Split('\n'));
            }
        }

        if (Repository.Regenerates)
        {
            Repository.AssertCurrent(page, string.Join('\n', lines));
        }
    }

    [Fact]
    public void The_README_gets_to_a_curling_free_kick_in_ten_lines()
    {
        Block first = Blocks("README.md")[0];
        Assert.InRange(first.Code.Split('\n').Count(line => line.Trim().Length > 0), 1, 10);
        Assert.StartsWith("using FootballPhysics;", first.Code);
        Assert.NotNull(first.Prints);
    }

    [Fact]
    public void Every_page_is_linked_from_the_page_of_contents_and_no_link_is_dead()
    {
        const string Contents = "docs/contents.md";
        string contents = Repository.Text(Contents);
        Assert.Contains($"]({Contents})", Repository.Text("README.md"));
        Assert.All(Repository.Pages.Where(page => page.StartsWith("docs/", StringComparison.Ordinal) && page != Contents), page => Assert.Contains($"]({page["docs/".Length..]})", contents));

        foreach (string page in Repository.Pages)
        {
            string folder = Path.GetDirectoryName(page)!;
            foreach (Markdig.Syntax.Inlines.LinkInline link in Markdown.Parse(Repository.Text(page)).Descendants<Markdig.Syntax.Inlines.LinkInline>())
            {
                string target = link.Url!.Split('#')[0];
                if (target.Length > 0 && !target.Contains("://", StringComparison.Ordinal))
                {
                    Assert.True(Path.Exists(Path.Combine(Repository.Root, folder, target)), $"{page}: {target}");
                }
            }
        }
    }

    /// <summary>Compiles the recipe of a page that declares a type, and loads it.</summary>
    public static System.Reflection.Assembly Recipe(string page, string type)
    {
        Block block = Blocks(page).Single(item => item.Kind == "csharp recipe" && item.Code.Contains(" " + type + " ", StringComparison.Ordinal));
        using MemoryStream bytes = Compile(block);
        return new AssemblyLoadContext(null, isCollectible: true).LoadFromStream(bytes);
    }

    private static List<Block> Blocks(string page)
    {
        var blocks = new List<Block>();
        Markdig.Syntax.Block? before = null;
        foreach (Markdig.Syntax.Block element in Markdown.Parse(Repository.Text(page)))
        {
            if (element is FencedCodeBlock fenced)
            {
                string code = fenced.Lines.ToString();
                string kind = $"{fenced.Info} {fenced.Arguments}".Trim();
                if (fenced.Info == "csharp")
                {
                    bool goesOn = fenced.Arguments == "continued";
                    blocks.Add(new Block(kind, goesOn ? blocks[^1].Code + "\n" + code : code, fenced.Line + 1, null, 0, 0));
                }
                else if (kind == "text" && before is FencedCodeBlock { Info: "csharp" })
                {
                    blocks[^1] = blocks[^1] with { Prints = code, PrintsLine = fenced.Line + 1, PrintsLines = fenced.Lines.Count };
                }
            }

            before = element;
        }

        return blocks;
    }

    private static string Run(Block block)
    {
        using MemoryStream bytes = Compile(block);
        string said = block.Kind switch
        {
            "csharp recipe" => "",
            "csharp unity" or "csharp godot" => Load(bytes, block),
            _ => Execute(bytes, block),
        };
        if (block.Kind == "csharp monogame")
        {
            CheckMonoGame();
        }
        else if (block.Kind == "csharp raylib")
        {
            CheckRaylib();
        }

        return said;
    }

    private static MemoryStream Compile(Block block)
    {
        bool engine = block.Kind is "csharp unity" or "csharp godot" or "csharp recipe";
        var options = new CSharpParseOptions(block.Kind is "csharp unity" or "csharp recipe" ? LanguageVersion.CSharp9 : LanguageVersion.CSharp13);
        var trees = new List<SyntaxTree> { CSharpSyntaxTree.ParseText(block.Code, options) };
        if (!engine)
        {
            trees.Add(CSharpSyntaxTree.ParseText(string.Concat(s_usings.Select(name => $"global using {name};\n")), options));
        }

        var compilation = CSharpCompilation.Create(
            "Doc" + Guid.NewGuid().ToString("N"),
            trees,
            References(block.Kind),
            new CSharpCompilationOptions(engine ? OutputKind.DynamicallyLinkedLibrary : OutputKind.ConsoleApplication, nullableContextOptions: engine ? NullableContextOptions.Disable : NullableContextOptions.Enable, allowUnsafe: block.Kind == "csharp recipe"));
        var bytes = new MemoryStream();
        var result = compilation.Emit(bytes);
        var problems = result.Diagnostics.Where(d => d.Severity >= DiagnosticSeverity.Warning && d.Id != "CS1701").ToList();
        Assert.True(problems.Count == 0, $"line {block.Line}:\n{string.Join('\n', problems)}\n{block.Code}");
        bytes.Position = 0;
        return bytes;
    }

    private static string Execute(MemoryStream bytes, Block block)
    {
        bytes.Position = 0;
        System.Reflection.MethodInfo main = new AssemblyLoadContext(null, isCollectible: true).LoadFromStream(bytes).EntryPoint!;
        TextWriter console = Console.Out;
        using var said = new StringWriter { NewLine = "\n" };
        System.Globalization.CultureInfo culture = System.Globalization.CultureInfo.CurrentCulture;
        try
        {
            Console.SetOut(said);
            System.Globalization.CultureInfo.CurrentCulture = System.Globalization.CultureInfo.InvariantCulture;
            main.Invoke(null, main.GetParameters().Length == 0 ? null : [Array.Empty<string>()]);
        }
        catch (System.Reflection.TargetInvocationException thrown)
        {
            Assert.Fail($"line {block.Line}: {thrown.InnerException}");
        }
        finally
        {
            System.Globalization.CultureInfo.CurrentCulture = culture;
            Console.SetOut(console);
        }

        return said.ToString();
    }

    /// <summary>Plays a component for two seconds beside a ball, as the engine would.</summary>
    private static string Load(MemoryStream bytes, Block block)
    {
        bytes.Position = 0;
        System.Reflection.Assembly assembly = new AssemblyLoadContext(null, isCollectible: true).LoadFromStream(bytes);
        Type type = assembly.GetExportedTypes().Single(t => !t.IsNested);
        if (block.Kind == "csharp unity")
        {
            var owner = new UnityEngine.GameObject();
            bool isRigidbody = block.Code.Contains("FootballAir", StringComparison.Ordinal);
            if (isRigidbody)
            {
                owner.AddComponent<Unity.FootballAir>();
            }
            else
            {
                owner.AddComponent<Unity.FootballBall>();
            }

            typeof(UnityEngine.GameObject).GetMethod(nameof(owner.AddComponent))!.MakeGenericMethod(type).Invoke(owner, null);
            for (int frame = 0; frame < 100; frame++)
            {
                owner.Send("FixedUpdate");
                owner.Send("Update");
                if (isRigidbody)
                {
                    owner.GetComponent<UnityEngine.Rigidbody>().Simulate(0.02f);
                }
            }

            Assert.NotEqual(0, owner.transform.position.z);
        }
        else
        {
            Godot.Engine.PhysicsTicksPerSecond = 60;
            var node = (Godot.Node)Activator.CreateInstance(type)!;
            node._Ready();
            for (int frame = 0; frame < 120; frame++)
            {
                foreach (Godot.Node each in node.GetChildren().Append(node))
                {
                    each._PhysicsProcess(1.0 / 60.0);
                    each._Process(1.0 / 60.0);
                }
            }

            Assert.All(node.GetChildren(), child => Assert.NotEqual(0, ((Godot.Node3D)child).GlobalPosition.Z));
            Assert.NotEmpty(node.GetChildren());
        }

        return "";
    }

    /// <summary>The ball is on the screen in every frame and moves after the kick; the pitch, its lines and a goal are there too.</summary>
    private static void CheckMonoGame()
    {
        Microsoft.Xna.Framework.Game game = Microsoft.Xna.Framework.Game.Last!;
        List<List<Microsoft.Xna.Framework.Graphics.DrawnMesh>> frames = game.GraphicsDevice.Frames;
        Assert.Equal("Goal!", game.Window.Title);
        Assert.All(frames, frame => Assert.True(frame.Count(mesh => mesh.Triangles > 0) >= 6));
        System.Numerics.Vector3[] ball = [.. frames.Select(frame => frame.Single(mesh => mesh.IsTextured && mesh.Triangles > 100).Middle)];
        Assert.All(ball, middle => Assert.True(Math.Abs(middle.X) < 1 && Math.Abs(middle.Y) < 1 && middle.Z is > 0 and < 1));
        Assert.Single(ball.Take(10).Distinct());
        Assert.Equal(60, ball.Skip(15).Take(60).Distinct().Count());
    }

    /// <summary>Every frame has the ball, its six marks, the frame of the goal and the shadow; the ball moves after the kick and the marks with it.</summary>
    private static void CheckRaylib()
    {
        List<Raylib_cs.Raylib.Frame> frames = Raylib_cs.Raylib.Drawn;
        Assert.False(Raylib_cs.Raylib.IsOpen);
        Assert.Equal("Goal!", frames[^1].Text);
        Assert.All(frames, frame => Assert.Equal((1, 3, 1, 7), (frame.Planes, frame.Capsules.Count, frame.Cylinders.Count, frame.Spheres.Count)));
        Assert.All(frames, frame => Assert.All(frame.Spheres.Skip(1), mark => Assert.Equal(0.09, (mark.Center - frame.Spheres[0].Center).Length(), 4)));
        Assert.All(frames, frame => Assert.True(Math.Abs(frame.Spheres[0].Center.X - frame.Cylinders[0].X) < 1e-4));
        Assert.Single(frames.Take(10).Select(frame => frame.Spheres[0].Center).Distinct());
        Assert.Equal(60, frames.Skip(15).Take(60).Select(frame => frame.Spheres[0].Center).Distinct().Count());
        Assert.True(frames.Skip(15).Take(60).Select(frame => frame.Spheres[1].Center - frame.Spheres[0].Center).Distinct().Count() > 30);
        Assert.InRange(frames[83].Spheres[0].Center.Z, -24.2f, -21.5f);
    }

    private static IEnumerable<MetadataReference> References(string kind)
    {
        bool engine = kind is "csharp unity" or "csharp godot" or "csharp recipe";
        bool framework = kind is "csharp monogame" or "csharp raylib";
        return TrustedReferences.Where(file => TrustedReferences.IsOfRuntime(file)
            || file is "Football.Physics.dll" or "Football.Physics.Thesis.dll" or "Football.Physics.Tracks.dll"
            || (framework && file is "Frameworks.dll")
            || (engine && (file.StartsWith("Football.Physics.", StringComparison.Ordinal) || file is "GodotSharp.dll" or "UnityEngine.dll"))
            || (kind == "csharp recipe" && file is "Netcode.dll"));
    }

    private sealed record Block(string Kind, string Code, int Line, string? Prints, int PrintsLine, int PrintsLines);
}
