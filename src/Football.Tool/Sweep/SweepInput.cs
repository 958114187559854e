using System.Text.Json;
using System.Text.Json.Nodes;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Sweep;

/// <summary>Reads a sweep and checks it as far as possible, so that errors appear before the first row.</summary>
internal static class SweepInput
{
    /// <summary>The maximum number of values of a list that are tried before the first row. The last value is tried in addition.</summary>
    private const int MostTried = 200;

    private static readonly string[][] s_vectors = [["air", "wind"], ["launch", "position"], ["launch", "velocity"], ["launch", "spin"]];

    /// <summary>Reads a sweep.</summary>
    /// <param name="input">The input, including its overrides.</param>
    /// <param name="seed">The seed.</param>
    /// <exception cref="RefusedException">The input is invalid.</exception>
    public static SweepPlan Read(InputFields input, long seed)
    {
        var document = input.Document.ValueKind == JsonValueKind.Object ? JsonObject.Create(input.Document)! : [];
        List<DrawnField> drawn = [];
        bool aims = document.ContainsKey("aim");
        if (document["launch"] is null or JsonObject && !aims)
        {
            TakeKick(document, drawn);
        }

        TakeRanges(document, drawn, aims ? DirectField.OfAim : DirectField.OfLaunch);
        var fields = new InputFields(input.Document.ValueKind == JsonValueKind.Object ? JsonSerializer.SerializeToElement(document) : input.Document);
        (SweepScene scene, RowRequest row) = Arguments.Refusing(fields, () =>
        {
            SweepScene taken = SweepScene.Take(fields.Root);
            RowRequest request = RowRequest.Take(fields.Root);
            fields.Check();
            return (taken, request);
        });
        string text = JsonSerializer.Serialize(input.Document);

        // The scenes of rows do not need these members, and are read many times.
        document.Remove("ranges");
        document.Remove("row");
        var plan = new SweepPlan(text, seed, document, scene, row, [.. drawn.Where(field => !scene.HasVectors || field.Direct is < DirectField.Kick or >= DirectField.KickNumbers || aims)]);
        Arguments.Refusing(fields, () => Try(plan, scene));
        TryEnds(plan);
        return plan;
    }

    /// <summary>Converts a value to a node of an input.</summary>
    public static JsonNode? Node(FieldRange range, FieldValue value) =>
        range is ChoiceRange choice ? FieldPlace.Node(choice.Values[value.Choice]) : JsonValue.Create(value.Number);

    /// <summary>Reads the numbers of a kick: each is a number, a range, or the default range.</summary>
    private static void TakeKick(JsonObject document, List<DrawnField> drawn)
    {
        var launch = (JsonObject?)document["launch"];
        if (launch is not null && (launch.ContainsKey("velocity") || launch.ContainsKey("spin")))
        {
            return;
        }

        for (int i = DirectField.Kick; i < DirectField.KickNumbers; i++)
        {
            DirectField field = DirectField.OfLaunch[i];
            FieldRange? range = field.Range is { } range0 ? new UniformRange(range0.Low, range0.High) : null;
            if (launch?[field.Column] is { } given)
            {
                JsonElement value = JsonSerializer.SerializeToElement(given);
                range = RangeInput.Read(field.Path, value, field.Allowed);
                if (range is not null)
                {
                    launch[field.Column] = range.Ends.First().Number;
                }
            }

            if (range is not null)
            {
                drawn.Add(new DrawnField(field.Path, range, i));
            }
        }
    }

    private static void TakeRanges(JsonObject document, List<DrawnField> drawn, IReadOnlyList<DirectField> direct)
    {
        if (document["ranges"] is null)
        {
            return;
        }

        JsonObject ranges = document["ranges"] as JsonObject
            ?? throw new RefusedException("ranges", Quote.Short(document["ranges"]!.ToJsonString()), """an object of fields and their ranges, like {"air.wind[0]": [-5, 5]}""");
        DrawnField[] before = [.. drawn];
        foreach ((string name, JsonNode? node) in ranges)
        {
            string path = FieldPath.Plain(name);
            string label = $"ranges.{name}";
            JsonElement value = JsonSerializer.SerializeToElement(node);
            int number = direct.ToList().FindIndex(field => field.Path == path);
            FieldRange? range = RangeInput.Read(label, value, number >= 0 ? direct[number].Allowed : null);
            IReadOnlyList<JsonElement> values = range is ChoiceRange choice ? choice.Values : [value];
            drawn.RemoveAll(field => field.Path == path || (before.Contains(field) && values.Any(set => Sets(set, path, field.Path))));
            MakeVector(document, path);
            JsonNode? first = range is null ? node?.DeepClone() : Node(range, range.Ends.First());
            FieldPlace.Put(document, FieldPath.Split(path), first, label);
            if (range is not null)
            {
                drawn.Add(new DrawnField(path, range, number));
            }
        }
    }

    /// <summary>True if the value of a field contains the value of a nested field.</summary>
    private static bool Sets(JsonElement value, string path, string within)
    {
        if (!within.StartsWith(path + ".", StringComparison.Ordinal))
        {
            return false;
        }

        foreach (string part in FieldPath.Split(within[(path.Length + 1)..]))
        {
            if (value.ValueKind != JsonValueKind.Object || !value.TryGetProperty(part, out value))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Adds a missing vector as zeros, so that its components can be set.</summary>
    private static void MakeVector(JsonObject document, string path)
    {
        foreach (string[] vector in s_vectors)
        {
            if (path.StartsWith(string.Join('.', vector) + '.', StringComparison.Ordinal) && (document[vector[0]] ??= new JsonObject()) is JsonObject parent)
            {
                parent[vector[1]] ??= new JsonArray(0.0, 0.0, 0.0);
            }
        }
    }

    /// <summary>Tries the bounds of each range, with the other fields at their first bound.</summary>
    private static void TryEnds(SweepPlan plan)
    {
        for (int i = 0; i < plan.SceneFields.Length; i++)
        {
            int tried = i;
            FieldValue[] ends = [.. plan.Fields[plan.SceneFields[i]].Range.Ends];
            foreach (FieldValue end in ends.Take(MostTried).Append(ends[^1]))
            {
                plan.With(other => other == tried ? end : plan.Fields[plan.SceneFields[other]].Range.Ends.First(), scene => Try(plan, scene));
            }
        }
    }

    /// <summary>Checks everything that all launches of a scene share, without simulating a launch.</summary>
    private static bool Try(SweepPlan plan, SweepScene scene)
    {
        if (scene.Aim is { } aim)
        {
            aim.Request.Validate();
            _ = new ThesisAimer(scene.Scene, scene.Solver, scene.TimeStep);
            return true;
        }

        if (scene.Cameras.Count > 0 && plan.Row.Samples.Count == 0)
        {
            throw new RefusedException("cameras requires row.samples. Add the times at which the cameras see the ball, such as \"row\": {\"samples\": [0, 0.02, 0.04]}.");
        }

        if (scene.Cameras.Count != plan.Scene.Cameras.Count)
        {
            throw new RefusedException(FormattableString.Invariant($"cameras has {scene.Cameras.Count} items in one row and {plan.Scene.Cameras.Count} in another. Use the same number in all."));
        }

        if (plan.FliesInLanes)
        {
            new BallBatch(scene.Scene, scene.BatchSettings).Fly(new BatchLaunches(1), new BatchFlights(1), 0, scene.Duration);
        }

        var simulator = new Simulator(scene.Scene, scene.Solver);
        plan.Meet(scene, simulator.Names);
        simulator.Launch(DirectField.Vector(scene.Numbers, DirectField.Position), Vector3d.Zero, Vector3d.Zero);
        return true;
    }
}
