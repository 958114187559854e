using System.Reflection;
using System.Text.RegularExpressions;
using FootballPhysics.GodotAddon;
using Godot;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Package.Tests;

/// <summary>The add-on and the demo project for Godot: what a text can show of them, and what the node does beside flying the ball.</summary>
[Collection(EngineTests.Statics)]
public sealed partial class GodotFolderTests
{
    private const string Folder = "samples/Godot";
    private const string Addon = Folder + "/addons/football_physics";

    [Theory]
    [InlineData(NullableContextOptions.Disable)]
    [InlineData(NullableContextOptions.Enable)]
    public void It_compiles_without_a_warning_whatever_the_project_says_of_null(NullableContextOptions nullable)
    {
        var options = new CSharpParseOptions(LanguageVersion.CSharp11, preprocessorSymbols: ["TOOLS", "GODOT"]);
        string[] files =
        [
            .. Directory.GetFiles(Path.Combine(Repository.Root, Addon), "*.cs"),
            .. Directory.GetFiles(Path.Combine(Repository.Root, "tests", "EngineShims", "Godot.Adapter", "Generated"), "*.cs"),
        ];
        var compilation = CSharpCompilation.Create(
            "Addon",
            files.Select(file => CSharpSyntaxTree.ParseText(File.ReadAllText(file), options)),
            TrustedReferences.Where(file => file != "Football.Physics.Godot.dll"),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary, nullableContextOptions: nullable));
        Assert.Empty(compilation.GetDiagnostics().Where(said => said.Severity >= DiagnosticSeverity.Warning && said.Id != "CS1701").Select(said => said.ToString()));
    }

    [Fact]
    public void Its_global_classes_are_registered_once()
    {
        Assert.DoesNotContain("AddCustomType", Repository.Text(Addon + "/FootballPlugin.cs"));
        Type[] global = [.. typeof(FootballBall).Assembly.GetTypes().Where(type => type.IsDefined(typeof(GlobalClassAttribute)))];
        Assert.Equal(
            ["FootballAir", "FootballBall", "FootballForces", "FootballGoal", "FootballKeeper", "FootballPath", "FootballPitch", "FootballPreset", "FootballScore", "FootballShooter", "FootballSound", "FootballWall"],
            global.Select(type => type.Name).Order(StringComparer.Ordinal));
        foreach (Type type in global)
        {
            string icon = type.GetCustomAttribute<IconAttribute>()!.Path;
            Assert.True(File.Exists(Path.Combine(Repository.Root, Folder, icon["res://".Length..])), icon);
        }
    }

    [Fact]
    public void GDScript_finds_every_method_by_its_name()
    {
        foreach (Type type in (Type[])[typeof(FootballBall), typeof(FootballAir), typeof(FootballPreset)])
        {
            string[] names = [.. type.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly).Where(method => !method.IsSpecialName).Select(method => method.Name)];
            Assert.Equal(names.Length, names.Distinct().Count());
        }

        string readme = Repository.Text(Addon + "/README.md");
        Assert.Contains("$Ball.Kick(27.0, Vector3(-0.1, 0.3, -1.0), -10.0, 55.0)", readme);
        Assert.Contains("4.1 or later", readme);

        // A callable of GDScript must take as many arguments as the signal has.
        foreach ((Type node, string signal) in ((Type, string)[])[(typeof(FootballBall), "Impact"), (typeof(FootballGoal), "Scored")])
        {
            string[] arguments = Regex.Match(readme, @$"\.{signal}\.connect\(func\(([^)]*)\)").Groups[1].Value.Split(", ");
            Assert.Equal(node.GetNestedType(signal + "EventHandler")!.GetMethod("Invoke")!.GetParameters().Length, arguments.Length);
        }

        Assert.Equal(4, typeof(FootballBall).GetMethod(nameof(FootballBall.Kick))!.GetParameters().Length);
    }

    [Fact]
    public void Every_number_of_the_preset_has_its_range()
    {
        PropertyInfo[] numbers = [.. typeof(FootballPreset).GetProperties().Where(property => property.PropertyType == typeof(float))];
        Assert.NotEmpty(numbers);
        Assert.All(numbers, property =>
        {
            ExportAttribute export = property.GetCustomAttribute<ExportAttribute>()!;
            Assert.Equal(PropertyHint.Range, export.Hint);
            float[] ends = [.. export.HintString.Split(',').Take(2).Select(end => float.Parse(end, System.Globalization.CultureInfo.InvariantCulture))];
            Assert.InRange((float)property.GetValue(new FootballPreset())!, ends[0], ends[1]);
        });
    }

    [Fact]
    public void Its_signals_are_emitted_by_their_typed_names()
    {
        Assert.DoesNotMatch("EmitSignal\\(\"", Repository.Text(Addon + "/FootballBall.Signals.cs"));
        string[] declared = [.. typeof(FootballBall).GetNestedTypes().Where(type => type.IsDefined(typeof(SignalAttribute))).Select(type => type.Name.Replace("EventHandler", "", StringComparison.Ordinal))];
        Assert.Equal(Enum.GetNames<BallEventKind>().Order(StringComparer.Ordinal), declared.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Scale_and_start_rotation_are_kept()
    {
        var ball = new FootballBall
        {
            GlobalTransform = new Transform3D(new Basis(new Godot.Vector3(0, 0, -2), new Godot.Vector3(0, 2, 0), new Godot.Vector3(2, 0, 0)), new Godot.Vector3(1, 0.11f, 2)),
        };
        ball._Ready();
        Assert.Equal(-2f, ball.GlobalTransform.Basis.X.Z, 1e-5f);
        ball.Kick(20, new Godot.Vector3(0, 0.5f, -1), -20, 30);
        for (int i = 0; i < 30; i++)
        {
            ball._PhysicsProcess(1 / 60.0);
        }

        ball._Process(0);
        foreach (Godot.Vector3 column in (Godot.Vector3[])[ball.GlobalTransform.Basis.X, ball.GlobalTransform.Basis.Y, ball.GlobalTransform.Basis.Z])
        {
            Assert.Equal(4f, (column.X * column.X) + (column.Y * column.Y) + (column.Z * column.Z), 1e-4f);
        }

        Assert.NotEqual(-2f, ball.GlobalTransform.Basis.X.Z, 1e-3f);
    }

    [Fact]
    public void Godot_s_own_interpolation_is_switched_off_for_it()
    {
        var ball = new FootballBall();
        ball._Ready();
        Assert.Equal(2, ball.Properties["physics_interpolation_mode"].Value);
    }

    [Fact]
    public void A_kick_before_ready_is_refused_clearly() =>
        Assert.Contains("The football is not ready", Assert.Throws<InvalidOperationException>(() => new FootballBall().Kick(10, Godot.Vector3.Forward)).Message);

    [Fact]
    public void The_path_ahead_is_an_array_too()
    {
        var ball = new FootballBall();
        ball._Ready();
        ball.Kick(12, new Godot.Vector3(0, 0.4f, -1));
        ball._PhysicsProcess(ball.Runner.TimeStep);
        Godot.Vector3[] path = ball.PathAhead(30);
        Assert.Equal(30, path.Length);
        Assert.True(path[^1].Z < path[0].Z);
    }

    [Fact]
    public void The_demo_project_has_all_that_its_files_name()
    {
        foreach (string file in (string[])["project.godot", "demo/Demo.tscn", "addons/football_physics/plugin.cfg"])
        {
            foreach (string resource in Resource().Matches(Repository.Text($"{Folder}/{file}")).Select(match => match.Groups[1].Value))
            {
                Assert.True(File.Exists(Path.Combine(Repository.Root, Folder, resource)), $"{file}: {resource}");
            }
        }

        string scene = Repository.Text(Folder + "/demo/Demo.tscn");
        foreach (string used in Used().Matches(scene).Select(match => match.Groups[1].Value))
        {
            Assert.Contains($"id=\"{used}\"", scene);
        }

        // Before the first build Godot cannot load a C# plugin, and says so: the user switches it on.
        Assert.DoesNotContain("[editor_plugins]", Repository.Text(Folder + "/project.godot"));
        Assert.Contains("value=\"../../../feed\"", Repository.Text(Folder + "/NuGet.config"));
        Assert.Contains("script=\"FootballPlugin.cs\"", Repository.Text(Addon + "/plugin.cfg"));
        Assert.Equal(Repository.Text("LICENSE"), Repository.Text(Addon + "/LICENSE.md"));
    }

    [GeneratedRegex("\"\\*?res://([^\"]+)\"")]
    private static partial Regex Resource();

    [GeneratedRegex("(?:Ext|Sub)Resource\\(\"([^\"]+)\"\\)")]
    private static partial Regex Used();
}
