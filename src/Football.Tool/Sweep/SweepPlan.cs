using System.Text.Json;
using System.Text.Json.Nodes;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Sweep;

/// <summary>A sweep: the common values of its rows, the random fields and the columns.</summary>
internal sealed class SweepPlan
{
    /// <summary>The maximum number of scenes for SIMD batches. With more scenes, flights are simulated one by one.</summary>
    private const int MostLaneScenes = 64;

    private const double MostGridPoints = 1e15;

    /// <summary>The fields under stop and solver that SIMD batches support.</summary>
    private static readonly string[] s_ofLanes = ["stop.time", "solver.integrator", "solver.timeStep", "solver.precision"];

    private readonly JsonObject _document;

    public SweepPlan(string text, long seed, JsonObject document, SweepScene scene, RowRequest row, IReadOnlyList<DrawnField> fields)
    {
        Text = text;
        Seed = seed;
        _document = document;
        Scene = scene;
        Row = row;
        Fields = fields;
        SceneFields = [.. Enumerable.Range(0, fields.Count).Where(i => fields[i].Direct < 0)];
        FieldOf = [.. Enumerable.Range(0, scene.Numbers.Length).Select(number => Array.FindIndex([.. fields], field => field.Direct == number))];
        Streams = [.. fields.Select(field => CounterRandom.Stream(seed, field.Path))];
        SetStrides();
    }

    /// <summary>The input, on one line.</summary>
    public string Text { get; }

    public long Seed { get; }

    /// <summary>The scene of all rows. If ranges change the scene, it has the first value of each range.</summary>
    public SweepScene Scene { get; }

    public RowRequest Row { get; }

    /// <summary>The random fields.</summary>
    public IReadOnlyList<DrawnField> Fields { get; }

    /// <summary>The indices of fields that are not numbers of a launch or an aim. Rows with other values of these fields have other scenes.</summary>
    public int[] SceneFields { get; }

    /// <summary>For each number of a launch or an aim, the index of its random field; −1 for none.</summary>
    public int[] FieldOf { get; }

    /// <summary>The random number key of each field.</summary>
    public ulong[] Streams { get; }

    /// <summary>The number of different scenes; infinite if a field of the scene has a continuous range.</summary>
    public double Scenes => SceneFields.Aggregate(1.0, (product, i) => product * ((Fields[i].Range as ChoiceRange)?.Values.Count ?? double.PositiveInfinity));

    /// <summary>The names of all colliders in scenes of rows; those of <see cref="Scene"/> come first.</summary>
    public List<string> Things { get; } = [];

    /// <summary>True if scenes of rows contain goals.</summary>
    public bool HasGoals { get; private set; }

    /// <summary>True if flights are simulated in SIMD batches. This requires that no row needs data after the first impact.</summary>
    public bool FliesInLanes =>
        Scene.Aim is null && !SceneFields.Any(i => MayLeaveLanes(Fields[i])) && Scene.StopAt == SweepStop.Impact && Scene.Chance is null && !Row.WatchesFlight && Scene.Orientation is null && Scenes <= MostLaneScenes
        && BallBatch.SupportsSimd(Scene.Scene) && Scene.Solver == SolverSettings.Default with { Integrator = Scene.Solver.Integrator };

    /// <summary>True if kicks are found in SIMD batches. This requires low kicks at a fixed target with any time and speed of arrival.</summary>
    public bool AimsInLanes =>
        Scene.Aim is { Method: AimMethod.Direct, Slowest: false, ArrivalTime: null, ArrivalSpeed: null, After: null, Request: { Waypoint: null, SpinIsFree: false, Arc: AimArc.Low } request }
        && request.TargetVelocity == Vector3d.Zero && SceneFields.Length == 0 && BallBatch.SupportsSimd(Scene.Scene) && request.MaximumIterations == new AimRequest().MaximumIterations;

    /// <summary>Registers the colliders of a scene that rows can have.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="things">The names of its colliders.</param>
    public void Meet(SweepScene scene, IReadOnlyList<string> things)
    {
        // In the scene of all rows, colliders can share a name.
        Things.AddRange(Things.Count == 0 ? things : things.Except(Things));
        HasGoals |= scene.Scene.Goals.Count > 0;
    }

    /// <summary>Builds a scene with the given values, and calls a function with it.</summary>
    /// <param name="value">The value of each of <see cref="SceneFields"/>.</param>
    /// <param name="use">The function.</param>
    /// <exception cref="RefusedException">The scene is invalid.</exception>
    public T With<T>(Func<int, FieldValue> value, Func<SweepScene, T> use)
    {
        JsonNode document = _document.DeepClone();
        for (int i = 0; i < SceneFields.Length; i++)
        {
            DrawnField field = Fields[SceneFields[i]];
            FieldPlace.Put(document, field.Parts, SweepInput.Node(field.Range, value(i)), field.Path);
        }

        var fields = new InputFields(JsonSerializer.SerializeToElement(document));
        return Arguments.Refusing(fields, () =>
        {
            SweepScene scene = SweepScene.Take(fields.Root);
            fields.Check();
            return use(scene);
        });
    }

    private static bool MayLeaveLanes(DrawnField field) => field.Parts[0] is "stop" or "solver" ? !s_ofLanes.Contains(field.Path) : field.Parts is ["launch"] or ["launch", "orientation", ..];

    /// <summary>Sets the strides of grids: the last grid changes from row to row, each other grid when the grids after it have run through.</summary>
    private void SetStrides()
    {
        double stride = 1;
        foreach (ChoiceRange grid in Fields.Select(field => field.Range).OfType<ChoiceRange>().Where(range => range.IsGrid).Reverse())
        {
            grid.Stride = (long)stride;
            stride *= grid.Values.Count;
            if (stride > MostGridPoints)
            {
                throw new RefusedException(FormattableString.Invariant($"ranges make a grid of more than {MostGridPoints} points. Use fewer or coarser grids."));
            }
        }
    }
}
