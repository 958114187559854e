using System.Text;
using System.Text.Json.Nodes;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>Scenarios as text: members with extreme numbers, of other types, missing, misspelt or repeated, and text that is not JSON.</summary>
internal sealed class ScenarioFuzz : FuzzTarget
{
    /// <summary>The number of steps for which an accepted scenario is simulated: some scenes take 50 ms per step.</summary>
    private const double MostSteps = 100;

    /// <summary>A scenario with every member.</summary>
    private const string Whole = """
        {"ball": {"mass": 0.43, "radius": 0.11, "inertiaFactor": 0.6666666666666666},
         "air": {"density": 1.2, "kinematicViscosity": 1.5e-5, "wind": [0, 0, 0]}, "gravity": 9.81,
         "forces": {"buoyancy": true, "drag": "empirical", "magnus": "empirical", "spinDecay": "empirical", "coefficients": "published",
           "dragCoefficient": 0.25, "magnusCoefficient": 0.25, "spinDecayCoefficient": 0.0},
         "ground": {"normalRestitution": 0.6, "tangentialRestitution": [0.5, 0.5], "spinRestitution": 0.8, "slidingFriction": 0.5, "rollingFriction": 0.05,
           "spinDamping": 0.002, "minimumBounceSpeed": 0.2, "restEnergy": 1e-4, "height": 0, "aerodynamics": "horizontal"},
         "launch": {"position": [0, 0.11, 0], "velocity": [22, 9, 0], "spin": [0, 40, -20], "orientation": [0, 0, 0, 1]},
         "solver": {"integrator": "rk4", "timeStep": 0.01, "collisionTiming": "exact", "collisionTolerance": 1e-6, "rollingTransition": "exact"},
         "stop": {"at": "impact", "time": 20}, "samples": false}
        """;

    private static readonly string[] s_words =
        ["empirical", "constant", "none", "published", "regularised", "euler", "semiImplicitEuler", "rk2", "rk4", "exact", "bisection", "heuristic", "impact", "rest", "time", "horizontal", "", "RK4", "\u0000", "é"];

    public override string Name => "scenarios";

    public override string Text(byte[] input) => Encoding.UTF8.GetString(input);

    public override byte[] Make(SeededRandom random, int mutations)
    {
        JsonNode root = JsonNode.Parse(Whole)!;
        for (int i = 0; i < mutations; i++)
        {
            Mutate(random, root);
        }

        if (random.Chance(0.1))
        {
            root = new JsonObject { ["name"] = "n", ["scenario"] = root };
        }

        byte[] text = Encoding.UTF8.GetBytes(root.ToJsonString());
        return random.Chance(0.2) ? FuzzBytes.Changed(random, text, 1 + random.Below(2)) : text;
    }

    public override bool Try(byte[] input)
    {
        InputCase read = InputCase.Read(new LineReader(new MemoryStream(input)).ReadToEnd(), []);
        if (read.Scenario is null)
        {
            return Refused(read.Refusal!);
        }

        Scenario scenario;
        Outcome outcome;
        try
        {
            scenario = Scenario.Read(read.Scenario);
            double longest = MostSteps * scenario.TimeStep;
            outcome = ScenarioRun.Play(scenario.Duration > longest ? scenario with { Duration = longest } : scenario);
        }
        catch (RefusedException refusal)
        {
            Must(!refusal.Message.StartsWith("the motion overflows", StringComparison.Ordinal), "accepted numbers lead to a motion that is not finite");
            return Refused(refusal);
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, read.Scenario) is { } said)
        {
            return Refused(said);
        }

        Must(outcome.Steps >= 0 && outcome.Bounces >= 0, "counts are negative");
        Must(ResultWriter.Result(read.Name, outcome).Length > 0, "nothing is written");
        return false;
    }

    private static bool Refused(RefusedException refusal)
    {
        Must(refusal.Message.Contains("allowed", StringComparison.Ordinal) && !refusal.Message.Contains('\n'), "a refusal does not say what is allowed");
        return true;
    }

    private static void Mutate(SeededRandom random, JsonNode root)
    {
        JsonNode[] leaves = [.. Leaves(root)];
        if (leaves.Length == 0)
        {
            return;
        }

        JsonNode leaf = leaves[random.Below(leaves.Length)];
        switch (random.Below(20))
        {
            case 0:
                leaf.ReplaceWith(JsonValue.Create(random.Any<string>(s_words)));
                break;
            case 1:
                leaf.ReplaceWith(random.Any<JsonNode?>(null, new JsonObject(), new JsonArray(), new JsonArray(1, 2), JsonValue.Create(true), JsonNode.Parse("1e999")));
                break;
            case 2 when leaf.Parent is JsonObject parent:
                parent.Remove(leaf.GetPropertyName());
                break;
            case 3 when leaf.Parent is JsonObject parent:
                parent[leaf.GetPropertyName() + random.Any("s", "", "X", ".")] = 1;
                break;
            case 4 when leaf.Parent is JsonArray parent:
                parent.Add(1);
                break;
            default:
                // Mostly change values that reach the library: a number becomes another number, a word another word.
                bool word = leaf.GetValueKind() == System.Text.Json.JsonValueKind.String;
                leaf.ReplaceWith(word ? JsonValue.Create(random.Any<string>(s_words)) : JsonValue.Create(FuzzNumbers.Any(random)));
                break;
        }
    }

    private static IEnumerable<JsonNode> Leaves(JsonNode? at) => at switch
    {
        JsonObject members => members.SelectMany(member => Leaves(member.Value)),
        JsonArray elements => elements.SelectMany(Leaves),
        JsonValue leaf => [leaf],
        _ => [],
    };
}
