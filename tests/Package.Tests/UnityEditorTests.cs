using System.Collections;
using System.Reflection;
using FootballPhysics.Unity;
using FootballPhysics.Unity.Editor;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using UnityEditor;
using UnityEditor.Build;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>What the package brings to Unity's editor, and its own play-mode tests, played against the shims.</summary>
[Collection(EngineTests.Statics)]
public sealed class UnityEditorTests : IDisposable
{
    private static readonly string[] s_modern = ["UNITY_2021_3_OR_NEWER", "UNITY_2022_1_OR_NEWER", "UNITY_2023_1_OR_NEWER", "UNITY_6000_0_OR_NEWER", "UNITY_6000_4_OR_NEWER"];

    public UnityEditorTests() => Dispose();

    public static TheoryData<string> PlayModeTests =>
        [.. typeof(Unity.Tests.FootballPlayModeTests).GetMethods().Where(method => method.IsDefined(typeof(UnityEngine.TestTools.UnityTestAttribute))).Select(method => method.Name)];

    public void Dispose()
    {
        GameObject.DestroyAll();
        Debug.Warned.Clear();
        EditorGUILayout.Said.Clear();
        EditorGUILayout.Slide = null;
        GUILayout.Clicked = "";
        AssetDatabase.Assets = _ => null;
    }

    [Theory]
    [InlineData(false, false)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(true, true)]
    public void It_compiles_without_a_warning_for_old_and_new_Unity_and_either_input_system(bool modern, bool newInput)
    {
        var options = new CSharpParseOptions(
            LanguageVersion.CSharp9,
            preprocessorSymbols: [.. modern ? s_modern : [], .. newInput ? (string[])["ENABLE_INPUT_SYSTEM", "FOOTBALL_INPUT_SYSTEM"] : []]);
        var compilation = CSharpCompilation.Create(
            "Package",
            Directory.GetFiles(Path.Combine(Repository.Root, UnityAsset.Package), "*.cs", SearchOption.AllDirectories).Select(file => CSharpSyntaxTree.ParseText(File.ReadAllText(file), options)),
            TrustedReferences.Where(file => file != "Football.Physics.Unity.dll"),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
        Assert.Empty(compilation.GetDiagnostics().Where(said => said.Severity >= DiagnosticSeverity.Warning && said.Id != "CS1701").Select(said => said.ToString()));
    }

    [Theory]
    [MemberData(nameof(PlayModeTests))]
    public void A_play_mode_test_of_the_package_passes(string name)
    {
        var tests = new Unity.Tests.FootballPlayModeTests();
        var run = (IEnumerator)tests.GetType().GetMethod(name)!.Invoke(tests, null)!;
        int updates = 0;
        while (run.MoveNext())
        {
            Assert.IsType<WaitForFixedUpdate>(run.Current);
            GameObject.SendAll("FixedUpdate");
            GameObject.SendAll("Update");
            updates++;
        }

        Assert.InRange(updates, 100, 1000);
        tests.CleanUp();
        Assert.DoesNotContain(GameObject.All, item => item.TryGetComponent(out FootballBall? _) || item.TryGetComponent(out FootballGoal? _));
    }

    [Fact]
    public void Every_menu_entry_makes_its_prefab()
    {
        MethodInfo[] entries = [.. typeof(FootballMenu).GetMethods().Where(method => method.IsDefined(typeof(MenuItem)))];
        Assert.True(entries.Length >= 7);
        var made = new HashSet<string>();
        AssetDatabase.Assets = path =>
        {
            Assert.True(made.Add(path), path);
            return UnityAsset.Load(path["Packages/com.football.physics/".Length..]).Values.First();
        };
        foreach (MethodInfo entry in entries)
        {
            Assert.StartsWith("GameObject/Football/", entry.GetCustomAttribute<MenuItem>()!.menuItem, StringComparison.Ordinal);
            entry.Invoke(null, [new MenuCommand(null)]);
            Assert.Contains("Add " + Selection.activeObject!.name, Undo.Recorded);
        }

        // And every prefab has an entry.
        Assert.Equal(UnityAsset.Files.Count(file => file.EndsWith(".prefab", StringComparison.Ordinal)), made.Count);
    }

    [Fact]
    public void The_inspector_of_a_preset_shows_its_drag_curve_and_where_its_numbers_come_from()
    {
        string documentation = Path.ChangeExtension(typeof(Simulator).Assembly.Location, ".xml");
        AssetDatabase.Assets = path => path.EndsWith(".xml", StringComparison.Ordinal) ? new TextAsset(File.ReadAllText(documentation)) : null;
        var preset = new FootballPreset { ball = FootballPreset.BallChoice.Jabulani };
        Handles.Curves.Clear();
        new FootballPresetEditor { target = preset }.OnInspectorGUI();
        Assert.Equal(2, Handles.Curves.Count);
        Vector3[] curve = Handles.Curves[1];

        // Down the window is up in numbers: high at walking pace, low beyond the crisis at 18.7 m/s.
        Assert.True(curve[10].y < curve[60].y - 30f);
        Assert.Contains(EditorGUILayout.Said, said => said.Contains("Jabulani (2010). Mass and radius: law. Drag: measured", StringComparison.Ordinal));
        Assert.Contains(EditorGUILayout.Said, said => said.StartsWith("MatchTurf: ", StringComparison.Ordinal) && said.Contains("Measured", StringComparison.Ordinal));
        EditorGUILayout.Said.Clear();
        preset.gravity = 2000f;
        new FootballPresetEditor { target = preset }.OnInspectorGUI();
        Assert.Contains(EditorGUILayout.Said, said => said.Contains("gravity", StringComparison.Ordinal));
    }

    [Fact]
    public void The_replay_window_plays_scrubs_and_validates_a_recording()
    {
        FootballBall ball = UnityAsset.Load("Prefabs/Football.prefab")["Football"].GetComponent<FootballBall>();
        UnityAsset.Load("Prefabs/Goal.prefab");
        GameObject.SendAll("FixedUpdate");
        Netcode.Recording segment = ball.Runner.Record();
        ball.KickAsPreviewed();
        for (int i = 0; i < 100; i++)
        {
            GameObject.SendAll("FixedUpdate");
        }

        BallState end = ball.Runner.State;
        FootballReplayWindow window = EditorWindow.GetWindow<FootballReplayWindow>("");
        Tell(window, "OnEnable");
        window.Load(segment.ToBytes(), ball);
        Assert.Contains("2.00 s, 100 ticks", window.Said, StringComparison.Ordinal);
        EditorGUILayout.Slide = (int)segment.EndTick;
        Tell(window, "OnGUI");
        EditorGUILayout.Slide = null;
        Assert.True(Netcode.Snapshot.Same(end, window.Player.State));
        GUILayout.Clicked = "Play";
        EditorApplication.timeSinceStartup = 10;
        Tell(window, "OnGUI");
        GUILayout.Clicked = "";
        EditorApplication.timeSinceStartup = 11.005;
        Handles.Discs.Clear();
        Tell(window, "Update");
        Assert.Equal(50, window.Player.Tick - segment.StartTick);
        Assert.Equal(UnityFrame.ToUnity(window.Player.Pose.Position), Handles.Discs[0].Center);
        GUILayout.Clicked = "Validate";
        Tell(window, "OnGUI");
        Assert.Contains("bit for bit", window.Said, StringComparison.Ordinal);

        // Another scene, and another file, are said.
        GUILayout.Clicked = "";
        UnityAsset.Load("Prefabs/Wall.prefab");
        window.Load(segment.ToBytes(), ball);
        Assert.Contains("the same scene", window.Said, StringComparison.Ordinal);
        window.Load([1, 2, 3], ball);
        Assert.Null(window.Player);
        Tell(window, "OnGUI");
        Tell(window, "OnDisable");
    }

    [Theory]
    [InlineData(ScriptingImplementation.IL2CPP, Il2CppCodeGeneration.OptimizeSize, true)]
    [InlineData(ScriptingImplementation.IL2CPP, Il2CppCodeGeneration.OptimizeSpeed, false)]
    [InlineData(ScriptingImplementation.Mono2x, Il2CppCodeGeneration.OptimizeSize, false)]
    public void A_build_with_shared_generic_code_is_warned_of(ScriptingImplementation backend, Il2CppCodeGeneration generation, bool warns)
    {
        (PlayerSettings.Backend, EditorUserBuildSettings.il2CppCodeGeneration) = (backend, generation);
        new FootballBuildCheck().OnPreprocessBuild(new UnityEditor.Build.Reporting.BuildReport());
        Assert.Equal(warns, Debug.Warned.Any(said => said.Contains("Faster runtime", StringComparison.Ordinal)));
    }

    private static void Tell(object window, string message) =>
        window.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic)!.Invoke(window, null);
}
