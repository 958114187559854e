using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Rows of kicks that the SIMD batch finds together.</summary>
internal sealed class BatchAimRows : RowMaker
{
    private readonly BatchAimer _aimer;
    private readonly BatchAims _aims;
    private readonly BatchKicks _kicks;

    public BatchAimRows(SweepPlan plan, int capacity)
        : base(plan, capacity)
    {
        AimRequest request = plan.Scene.Aim!.Request;
        _aimer = new BatchAimer(plan.Scene.Scene);
        _kicks = new BatchKicks(capacity);
        _aims = new BatchAims(capacity)
        {
            MinimumElevationDegrees = request.MinimumElevationDegrees,
            MaximumElevationDegrees = request.MaximumElevationDegrees,
            Tolerance = request.Tolerance,
        };
    }

    public override RowCounts Counts => new(_aimer.ScalarFallbackCount);

    protected override void Answer(int count)
    {
        SweepScene scene = Plan.Scene;
        for (int i = 0; i < count; i++)
        {
            _aims.Set(
                i,
                Draws.Vector(scene, DirectField.From, i),
                Draws.Vector(scene, DirectField.Target, i),
                Draws.Number(scene, 0, i),
                Draws.Number(scene, 1, i),
                Draws.Number(scene, 2, i));
        }

        _aimer.Find(_aims, _kicks, count);
        Fill(0, count);
    }

    protected override IEnumerable<ColumnSource> AnswerSources() =>
    [
        new(Column.Word("status", "what became of the search", AimRows.Statuses), Each((to, i) => to.Words[i] = (byte)_kicks.Status[i])),
        new(Column.Vector("velocity", "m/s", "velocity of the best kick"), Vectors(_kicks.Velocity)),
        new(Column.Vector("spin", "rad/s", "spin of the best kick"), Vectors(_kicks.Spin)),
        new(Column.Real("miss", "m", "the method's estimate of how far it passes from the target"), Numbers(_kicks.Miss)),
        new(Column.Real("time", "s", "when it is closest to the target"), Numbers(_kicks.Time)),
    ];
}
