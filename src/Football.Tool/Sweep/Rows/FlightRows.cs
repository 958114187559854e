using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Rows of flights to the first impact, simulated in SIMD batches.</summary>
internal sealed class FlightRows : LaunchRows
{
    private readonly CompiledScenes<CompiledScene> _scenes;
    private readonly BatchFlights _flights;

    /// <summary>The launches of the rows that share one of several scenes.</summary>
    private readonly BatchLaunches _sceneLaunches;
    private readonly BatchFlights _sceneFlights;
    private readonly Dictionary<CompiledScene, List<int>> _rows = [];
    private long _handedOn;

    public FlightRows(SweepPlan plan, int capacity)
        : base(plan, capacity)
    {
        int several = plan.SceneFields.Length > 0 ? capacity : 0;
        _scenes = new CompiledScenes<CompiledScene>(plan, Draws, scene => new CompiledScene(scene, new BallBatch(scene.Scene, scene.BatchSettings)));
        _flights = new BatchFlights(capacity);
        _sceneLaunches = new BatchLaunches(several);
        _sceneFlights = new BatchFlights(several);
    }

    public override RowCounts Counts => new(_handedOn);

    protected override void Answer(int count)
    {
        _handedOn = 0;
        if (Plan.SceneFields.Length == 0)
        {
            for (int i = 0; i < count; i++)
            {
                Prepare(Plan.Scene, i);
            }

            Fly(_scenes.Of(0), Launches, _flights, count);
        }
        else
        {
            FlySeveral(count);
        }

        Fill(0, count);
    }

    protected override IEnumerable<ColumnSource> AnswerSources() =>
    [
        .. LaunchSources(),
        new(Column.Word("end", "what ended the flight", Ends), Each((to, i) => to.Words[i] = (byte)_flights.End[i])),
        new(Column.Real("time", "s", "when, since the launch"), Numbers(_flights.Time)),
        new(Column.Vector("position", "m", "where the centre is then"), Vectors(_flights.Position)),
        new(Column.Vector("velocity", "m/s", "velocity then, before the impact"), Vectors(_flights.Velocity)),
        new(Column.Vector("spin", "rad/s", "spin then, before the impact"), Vectors(_flights.Spin)),
        new(Column.Vector("velocityAfter", "m/s", "velocity just after the impact"), Vectors(_flights.VelocityAfter)),
        new(Column.Vector("spinAfter", "rad/s", "spin just after the impact"), Vectors(_flights.SpinAfter)),
        new(Column.Real("apex", "m", "greatest height of the centre"), Numbers(_flights.Apex)),
    ];

    private void Fly(CompiledScene scene, BatchLaunches launches, BatchFlights flights, int count)
    {
        scene.Batch.Fly(launches, flights, count, scene.Scene.Duration);
        _handedOn += scene.Batch.ScalarFallbackCount;
    }

    private void FlySeveral(int count)
    {
        _rows.Clear();
        for (int i = 0; i < count; i++)
        {
            CompiledScene scene = _scenes.Of(i);
            Prepare(scene.Scene, i);
            if (!_rows.TryGetValue(scene, out List<int>? rows))
            {
                _rows[scene] = rows = [];
            }

            rows.Add(i);
        }

        foreach ((CompiledScene scene, List<int> rows) in _rows)
        {
            for (int k = 0; k < rows.Count; k++)
            {
                _sceneLaunches.Set(k, Launches.Position[rows[k]], Launches.Velocity[rows[k]], Launches.Spin[rows[k]]);
            }

            Fly(scene, _sceneLaunches, _sceneFlights, rows.Count);
            for (int k = 0; k < rows.Count; k++)
            {
                Take(k, rows[k]);
            }
        }
    }

    private void Take(int from, int row)
    {
        _flights.End[row] = _sceneFlights.End[from];
        _flights.Time[row] = _sceneFlights.Time[from];
        _flights.Position[row] = _sceneFlights.Position[from];
        _flights.Velocity[row] = _sceneFlights.Velocity[from];
        _flights.Spin[row] = _sceneFlights.Spin[from];
        _flights.VelocityAfter[row] = _sceneFlights.VelocityAfter[from];
        _flights.SpinAfter[row] = _sceneFlights.SpinAfter[from];
        _flights.Apex[row] = _sceneFlights.Apex[from];
    }

    private sealed class CompiledScene(SweepScene scene, BallBatch batch)
    {
        public SweepScene Scene { get; } = scene;

        public BallBatch Batch { get; } = batch;
    }
}
