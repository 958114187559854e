using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace FootballPhysics.Package.Tests;

/// <summary>Scripts of a user's project, compiled with the references that Unity gives a script without an assembly definition.</summary>
public sealed class UnityUserTests
{
    private const string Script = """
        using FootballPhysics;
        using FootballPhysics.Netcode;
        using FootballPhysics.Unity;
        using UnityEngine;

        public class Scoreboard : MonoBehaviour
        {
            public FootballPreset preset;
            private FootballBall _ball;
            private FootballAir _air;

            void Start()
            {
                TryGetComponent(out _ball);
                TryGetComponent(out _air);
                preset.integrator = Integrator.Rk2;
                _ball.Impact += (ball, happened) => Debug.Log(happened.Kind + " " + happened.Surface);
                _air.Kick(20f, Vector3.forward, 0f, 40f);
            }

            void Update()
            {
                FixedStepRunner runner = _ball.Runner;
                if (_ball.Motion == MotionState.Rest && runner.Events.Count == 0)
                {
                    Debug.Log(runner.State.Position.ToString());
                }
            }
        }
        """;

    private const string Game = """
        using FootballPhysics.Unity;
        using UnityEngine;

        namespace Football.Gameplay
        {
            public class Passing : MonoBehaviour
            {
                public FootballBall ball;

                private void FixedUpdate()
                {
                    Vector3 down = Physics.gravity;
                    if (Physics.OverlapSphereNonAlloc(transform.position + down, 1f, new Collider[4], 1, QueryTriggerInteraction.Ignore) == 0)
                    {
                        ball.Kick(12f, Vector3.forward);
                    }
                }
            }
        }
        """;

    [Theory]
    [InlineData(Script)]
    [InlineData(Game)]
    public void A_script_without_an_assembly_definition_compiles(string script) => Assert.Empty(Errors(script));

    [Fact]
    public void Without_the_plugins_it_would_not()
    {
        // The shape of the failure that explicitly referenced plugins have.
        string[] errors = Errors(Script, withPlugins: false);
        Assert.Contains(errors, error => error.Contains("CS0012", StringComparison.Ordinal));
    }

    private static string[] Errors(string script, bool withPlugins = true)
    {
        var compilation = CSharpCompilation.Create(
            "Assembly-CSharp",
            [CSharpSyntaxTree.ParseText(script, new CSharpParseOptions(LanguageVersion.CSharp9))],
            TrustedReferences.Where(file => IsReferenced(file, withPlugins)),
            new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));
        return [.. compilation.GetDiagnostics().Where(said => said.Severity == DiagnosticSeverity.Error).Select(said => said.ToString())];
    }

    /// <summary>True if Unity references an assembly from scripts without an assembly definition.</summary>
    private static bool IsReferenced(string file, bool withPlugins)
    {
        if (!file.StartsWith("Football.", StringComparison.Ordinal))
        {
            return file is "UnityEngine.dll" or "netstandard.dll" || file.StartsWith("System.", StringComparison.Ordinal);
        }

        string definition = $"{UnityAsset.Package}/Runtime/{Path.GetFileNameWithoutExtension(file)}.asmdef";
        string plugin = $"{UnityAsset.Package}/Plugins/{file}.meta";
        return File.Exists(Path.Combine(Repository.Root, definition))
            ? Repository.Text(definition).Contains("\"autoReferenced\": true", StringComparison.Ordinal)
            : withPlugins && File.Exists(Path.Combine(Repository.Root, plugin)) && Repository.Text(plugin).Contains("isExplicitlyReferenced: 0", StringComparison.Ordinal);
    }
}
