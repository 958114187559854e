using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>Rows of launches.</summary>
internal abstract class LaunchRows(SweepPlan plan, int capacity) : RowMaker(plan, capacity)
{
    /// <summary>The names of the ends of a flight; those of <see cref="BatchEnd"/> come first.</summary>
    protected static string[] Ends { get; } = ["impact", "time", "ground", "plane", "rest"];

    protected BatchLaunches Launches { get; } = new(capacity);

    protected void Prepare(SweepScene scene, int row)
    {
        Vector3d velocity;
        Vector3d spin;
        if (scene.HasVectors)
        {
            velocity = Draws.Vector(scene, DirectField.Velocity, row);
            spin = Draws.Vector(scene, DirectField.Spin, row);
        }
        else
        {
            double Kick(int number) => Draws.Number(scene, DirectField.Kick + number, row);
            new KickNumbers(Kick(0), Kick(1), Kick(2), Kick(3), Kick(4)).Vectors(out velocity, out spin);
        }

        Launches.Set(row, Draws.Vector(scene, DirectField.Position, row), velocity, spin);
    }

    /// <summary>Returns the columns of the launch as vectors.</summary>
    protected IEnumerable<ColumnSource> LaunchSources() =>
    [
        new(Column.Vector("launch.position", "m", "where the centre of the ball is launched"), Vectors(Launches.Position), IsDefault: false),
        new(Column.Vector("launch.velocity", "m/s", "velocity of the launch"), Vectors(Launches.Velocity), IsDefault: false),
        new(Column.Vector("launch.spin", "rad/s", "spin of the launch"), Vectors(Launches.Spin), IsDefault: false),
    ];
}
