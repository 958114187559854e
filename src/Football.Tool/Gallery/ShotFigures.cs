using System.Globalization;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>The figures of a shot. Figures of the first touchdown are null for a ball that never left the ground.</summary>
/// <param name="Carry">The horizontal distance to the first touchdown, in m.</param>
/// <param name="Apex">The greatest height of the centre, in m.</param>
/// <param name="HangTime">The time to the first touchdown, in s.</param>
/// <param name="Deflection">The distance of the first touchdown to the left of the vertical plane of the launch direction, in m.</param>
/// <param name="Bounces">The number of impacts on the ground.</param>
/// <param name="RestTime">The time until rest, in s; null if the ball did not come to rest.</param>
/// <param name="Distance">The horizontal distance between launch and end, in m.</param>
internal sealed record ShotFigures(
    double? Carry, double Apex, double? HangTime, double? Deflection, long Bounces, double? RestTime, double Distance)
{
    /// <summary>The names and units of the columns, without the name of the shot.</summary>
    public static IReadOnlyList<string> Columns { get; } =
        ["carry m", "apex m", "hang time s", "deflection m", "bounces", "rest s", "distance m"];

    /// <summary>The figures as texts, in the order of the columns.</summary>
    public IReadOnlyList<string> Texts =>
    [
        Text(Carry, "0.00"), Text(Apex, "0.00"), Text(HangTime, "0.00"), Text(Deflection, "+0.00;-0.00;0.00"),
        Bounces.ToString(CultureInfo.InvariantCulture), Text(RestTime, "0.0"), Text(Distance, "0.00"),
    ];

    /// <summary>Returns the figures of a shot with samples.</summary>
    public static ShotFigures Of(Outcome outcome)
    {
        BallEvent? touchdown = Flight.FirstTouchdown(outcome);
        Moment launch = outcome.Samples![0];
        Vector3d? way = touchdown?.Position - launch.Position;
        Vector3d direction = launch.Velocity.Horizontal;
        double speed = direction.Length;
        return new ShotFigures(
            way?.Horizontal.Length,
            outcome.Apex,
            touchdown?.Time,
            way is null ? null : speed > 0 ? Vector3d.Dot(way.Value, Vector3d.Cross(Vector3d.Up, direction)) / speed : 0,
            outcome.Bounces,
            Flight.First(outcome, item => item.Kind == BallEventKind.Rest)?.Time,
            (outcome.Final.Position - launch.Position).Horizontal.Length);
    }

    private static string Text(double? value, string format) => value is null ? "–" : value.Value.ToString(format, CultureInfo.InvariantCulture);
}
