using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Aim;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Rows of kicks that are found one by one.</summary>
internal sealed class AimRows : RowMaker
{
    private readonly CompiledScenes<CompiledScene> _scenes;
    private AimResult _found;

    public AimRows(SweepPlan plan, int capacity)
        : base(plan, capacity) => _scenes = new CompiledScenes<CompiledScene>(plan, Draws, scene => new CompiledScene(scene));

    public override RowCounts Counts => new(null);

    /// <summary>The names of the statuses, in the order of <see cref="AimStatus"/>.</summary>
    public static string[] Statuses { get; } = [.. Enum.GetValues<AimStatus>().Select(status => Words.Of(status))];

    protected override void Answer(int count)
    {
        for (int i = 0; i < count; i++)
        {
            CompiledScene scene = _scenes.Of(i);
            SweepScene about = scene.Scene;
            AimRequest request = about.Aim!.Request with
            {
                Speed = Draws.Number(about, 0, i),
                TopSpin = Draws.Number(about, 1, i),
                SideSpin = Draws.Number(about, 2, i),
                From = Draws.Vector(about, DirectField.From, i),
                Target = Draws.Vector(about, DirectField.Target, i),
            };
            _found = AimRun.Find(about.Aim with { Request = request }, scene.Aimer);
            Fill(i, 1);
        }
    }

    protected override IEnumerable<ColumnSource> AnswerSources() =>
    [
        new(Column.Word("status", "what became of the search", Statuses), (to, row, _) => to.Words[row] = (byte)_found.Status),
        new(Column.Vector("velocity", "m/s", "velocity of the best kick"), (to, row, _) => to.Set(row, _found.Velocity)),
        new(Column.Vector("spin", "rad/s", "spin of the best kick"), (to, row, _) => to.Set(row, _found.Spin)),
        new(Column.Real("miss", "m", "how far it passes from the target before its first impact"), (to, row, _) => to.Reals[row] = _found.Miss),
        new(Column.Real("throughMiss", "m", "how far it passes from the point on the way; none without one"), (to, row, _) => to.Reals[row] = _found.WaypointMiss ?? double.NaN),
        new(Column.Real("time", "s", "when it is closest to the target"), (to, row, _) => to.Reals[row] = _found.Time),
        new(Column.Vector("closest", "m", "where it is then"), (to, row, _) => to.Set(row, _found.Closest)),
        new(Column.Whole("iterations", "", "iterations of the method"), (to, row, _) => to.Wholes[row] = _found.Iterations),
        new(Column.Whole("simulations", "", "forward runs of the method"), (to, row, _) => to.Wholes[row] = _found.Simulations),
    ];

    private sealed class CompiledScene(SweepScene scene)
    {
        public SweepScene Scene { get; } = scene;

        public ThesisAimer Aimer { get; } = new(scene.Scene, scene.Solver, scene.TimeStep);
    }
}
