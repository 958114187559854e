using System.Text.Json;
using System.Text.RegularExpressions;
using FootballPhysics.Unity;
using FootballPhysics.Unity.Editor;
using UnityEditor;
using UnityEngine;

namespace FootballPhysics.Package.Tests;

/// <summary>The package folder for Unity: what a text can show of it, and what its components do beside flying the ball.</summary>
[Collection(EngineTests.Statics)]
public sealed partial class UnityFolderTests
{
    private const string Folder = "samples/Unity/com.football.physics";

    private static string Full => Path.Combine(Repository.Root, Folder);

    [Fact]
    public void Everything_has_a_meta_file_with_an_id_of_its_own_and_no_meta_file_is_left_over()
    {
        string[] assets = [.. Directory.EnumerateFileSystemEntries(Full, "*", SearchOption.AllDirectories).Select(path => Path.GetRelativePath(Full, path).Replace('\\', '/'))
            .Where(path => !path.EndsWith(".meta", StringComparison.Ordinal) && path != "Samples~" && !path.StartsWith("Documentation~", StringComparison.Ordinal)),
            "Plugins/Football.Physics.dll", "Plugins/Football.Physics.xml"];
        string[] metas = [.. Directory.EnumerateFiles(Full, "*.meta", SearchOption.AllDirectories).Select(path => Path.GetRelativePath(Full, path).Replace('\\', '/')[..^".meta".Length])];
        Assert.Equal(assets.Distinct().Order(StringComparer.Ordinal), metas.Order(StringComparer.Ordinal));
        string[] ids = [.. metas.Select(path => Id().Match(Repository.Text($"{Folder}/{path}.meta")).Groups[1].Value)];
        Assert.All(ids, id => Assert.Equal(32, id.Length));
        Assert.Equal(ids.Length, ids.Distinct().Count());
    }

    [Fact]
    public void Its_manifest_names_what_is_there()
    {
        JsonElement manifest = JsonDocument.Parse(Repository.Text(Folder + "/package.json")).RootElement;
        Assert.Equal("com.football.physics", manifest.GetProperty("name").GetString());
        Assert.Matches(@"^\d+\.\d+\.\d+$", manifest.GetProperty("version").GetString()!);
        Assert.Contains($"## {manifest.GetProperty("version").GetString()}", Repository.Text(Folder + "/CHANGELOG.md"));
        Assert.Equal("MIT", manifest.GetProperty("license").GetString());
        Assert.Equal(Repository.Text("LICENSE"), Repository.Text(Folder + "/LICENSE.md"));
        Assert.All(manifest.GetProperty("samples").EnumerateArray(), sample => Assert.True(Directory.Exists(Path.Combine(Full, sample.GetProperty("path").GetString()!))));
        Assert.Equal(2, manifest.GetProperty("samples").GetArrayLength());
        Assert.True(File.Exists(Path.Combine(Full, "Documentation~", "index.md")));

        // A project may have switched off any built-in module that nothing asks for.
        Assert.Equal(
            ["com.unity.modules.audio", "com.unity.modules.imgui", "com.unity.modules.physics"],
            manifest.GetProperty("dependencies").EnumerateObject().Select(module => module.Name));
    }

    [Fact]
    public void Its_assemblies_refer_to_each_other_and_to_the_plugin()
    {
        JsonElement Definition(string path) => JsonDocument.Parse(Repository.Text($"{Folder}/{path}")).RootElement;
        JsonElement editor = Definition("Editor/Football.Physics.Unity.Editor.asmdef");
        Assert.Equal("Editor", editor.GetProperty("includePlatforms")[0].GetString());
        foreach (JsonElement assembly in (JsonElement[])[editor, Definition("Runtime/Football.Physics.Unity.asmdef"), Definition("Tests/Runtime/Football.Physics.Unity.Tests.asmdef")])
        {
            Assert.Equal("Football.Physics.dll", assembly.GetProperty("precompiledReferences")[0].GetString());
            Assert.All(assembly.GetProperty("references").EnumerateArray().Where(reference => reference.GetString() is not ("Unity.InputSystem" or "UnityEngine.TestRunner")), reference => Assert.True(File.Exists(Path.Combine(Full, "Runtime", reference.GetString() + ".asmdef"))));
        }
    }

    [Fact]
    public void The_script_that_packs_says_where_the_assembly_goes()
    {
        Assert.Contains("samples/Unity/pack.cs", Repository.Text("samples/Unity/build.sh"));
        string script = Repository.Text("samples/Unity/pack.cs");
        Assert.Contains("netstandard2.1", script);
        Assert.Contains("\"Plugins\"", script);
        Assert.Contains(".tgz", script);
        Assert.Contains("--branch", script);
    }

    [Fact]
    public void A_kick_before_Awake_is_refused_clearly()
    {
        FootballBall ball = new GameObject().Attach<FootballBall>();
        ball.name = "Ball 7";
        string message = Assert.Throws<InvalidOperationException>(() => ball.Kick(10f, Vector3.forward)).Message;
        Assert.Contains("\"Ball 7\" has no Awake behind it yet", message);
    }

    [Fact]
    public void Its_body_is_kinematic()
    {
        FootballBall ball = new GameObject().AddComponent<FootballBall>();
        Rigidbody body = ball.GetComponent<Rigidbody>();
        Assert.True(body.isKinematic);
        Assert.False(body.useGravity);
    }

    [Fact]
    public void Its_time_step_is_the_presets_whatever_Unitys_is()
    {
        foreach (float unitys in (float[])[0.02f, 1f / 60f, 0.005f, 0.0333f])
        {
            Time.fixedDeltaTime = unitys;
            FootballBall ball = new GameObject().Attach<FootballBall>();
            ball.Preset = new FootballPreset { timeStep = 0.01 };
            ball.gameObject.Send("Awake");
            Assert.Equal(0.01, ball.Runner.TimeStep);
            int updates = (int)Math.Round(3 / (double)unitys);
            for (int i = 0; i < updates; i++)
            {
                ball.gameObject.Send("FixedUpdate");
                ball.gameObject.Send("Update");
            }

            Assert.InRange(ball.Runner.Tick, (updates * (double)unitys / 0.01) - 1, (updates * (double)unitys / 0.01) + 1);
        }

        Time.fixedDeltaTime = 0.02f;
    }

    [Fact]
    public void A_slowed_game_slows_it_for_no_clock_but_the_games_is_asked()
    {
        string source = Repository.Text(Folder + "/Runtime/FootballBall.cs");
        Assert.DoesNotContain("unscaled", source, StringComparison.OrdinalIgnoreCase);
        Assert.DoesNotContain("realtime", source, StringComparison.OrdinalIgnoreCase);
        FootballBall ball = new GameObject().AddComponent<FootballBall>();
        ball.gameObject.Send("Update");
        Assert.Equal(0, ball.Runner.Tick);
    }

    [Fact]
    public void What_the_inspector_sees_it_hears()
    {
        FootballBall ball = new GameObject().AddComponent<FootballBall>();
        var heard = new List<BallEventKind>();
        ball.Events.impact.AddListener(happened => heard.Add(happened.Kind));
        ball.Events.rest.AddListener(happened => heard.Add(happened.Kind));
        string? surface = null;
        ball.Happened += (_, happened) => surface ??= happened.Surface;
        ball.Kick(8f, new Vector3(0f, 0.5f, 1f));
        for (int i = 0; i < 2000; i++)
        {
            ball.gameObject.Send("FixedUpdate");
        }

        Assert.Equal(BallEventKind.Impact, heard[0]);
        Assert.Equal(BallEventKind.Rest, heard[^1]);
        Assert.Equal("ground", surface);
    }

    [Fact]
    public void The_gizmo_allocates_nothing_once_it_has_its_room()
    {
        FootballBall ball = new GameObject().AddComponent<FootballBall>();
        ball.Kick(20f, new Vector3(0f, 0.5f, 1f), 0f, 30f);
        ball.gameObject.Send("FixedUpdate");
        var points = new Vector3[100];
        ball.PredictPath(points);

        // The least of some runs: what the runtime allocates while it recompiles is not the gizmo's.
        long least = long.MaxValue;
        for (int i = 0; i < 5; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            ball.PredictPath(points);
            ball.PreviewPath(points);
            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, least);
    }

    [Fact]
    public void In_the_editor_the_handle_aims_the_kick_and_the_line_is_the_path_that_it_takes()
    {
        FootballBall ball = new GameObject().Attach<FootballBall>();
        ball.transform.position = new Vector3(1f, 0.11f, 2f);
        var editor = new FootballBallEditor { target = ball };
        Handles.Lines.Clear();
        Handles.Drag = new Vector3(1f, 1.11f, 4f);
        typeof(FootballBallEditor).GetMethod("OnSceneGUI", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)!.Invoke(editor, null);
        Handles.Drag = null;
        Assert.Equal(Math.Sqrt(500), ball.PreviewedKick.speed, 1e-3);
        Assert.Equal(0, ball.PreviewedKick.heading, 1e-3);
        Assert.Contains("Aim the kick", Undo.Recorded);
        Vector3[] line = [.. Handles.Lines.Skip(1).Select(piece => piece.To)];
        ball.gameObject.Send("Awake");
        ball.KickAsPreviewed();
        foreach (Vector3 at in line.Take(100))
        {
            ball.gameObject.Send("FixedUpdate");
            Assert.InRange((at - UnityFrame.ToUnity(ball.Runner.State.Position)).magnitude, 0, 1e-3);
        }
    }

    [Fact]
    public void Every_number_of_the_preset_is_kept_in_its_range()
    {
        var preset = new FootballPreset { timeStep = 7, airDensity = -1, gravity = 99, customMass = 0, customRadius = 50, wind = new Vector3(900, 0, 0), customRestitution = 3, groundHeight = 1e9f };
        typeof(FootballPreset).GetMethod("OnValidate", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)!.Invoke(preset, null);
        Assert.Equal((0.1, 0f, 30f, 0.01f, 2f, 60f), (preset.timeStep, preset.airDensity, preset.gravity, preset.customMass, preset.customRadius, preset.wind.x));
        Assert.NotNull(preset.Compile());
        System.Reflection.FieldInfo[] numbers = [.. typeof(FootballPreset).GetFields().Where(field => field.FieldType == typeof(float))];
        Assert.NotEmpty(numbers);
        Assert.All(numbers, field => Assert.True(field.IsDefined(typeof(RangeAttribute), false), field.Name));
    }

    [GeneratedRegex("^guid: ([0-9a-f]+)$", RegexOptions.Multiline)]
    private static partial Regex Id();
}
