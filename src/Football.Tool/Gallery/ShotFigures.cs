using System.Globalization;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>A shot in numbers. What belongs to the first touchdown is null for a ball that never left the ground.</summary>
/// <param name="Carry">Horizontal distance to the first touchdown, m.</param>
/// <param name="Apex">Greatest height of the centre, m.</param>
/// <param name="HangTime">Time to the first touchdown, s.</param>
/// <param name="Deflection">How far left of the launch direction's vertical plane the ball first touches down, m.</param>
/// <param name="Bounces">Impacts with the ground.</param>
/// <param name="RestTime">Time until rest, s; null where it did not come to rest.</param>
/// <param name="Distance">Horizontal distance between launch and end, m.</param>
internal sealed record ShotFigures(
    double? Carry, double Apex, double? HangTime, double? Deflection, long Bounces, double? RestTime, double Distance)
{
    /// <summary>Names and units of the columns, beside the shot's name.</summary>
    public static IReadOnlyList<string> Columns { get; } =
        ["carry m", "apex m", "hang time s", "deflection m", "bounces", "rest s", "distance m"];

    /// <summary>The figures as text, in the order of the columns.</summary>
    public IReadOnlyList<string> Texts =>
    [
        Text(Carry, "0.00"), Text(Apex, "0.00"), Text(HangTime, "0.00"), Text(Deflection, "+0.00;-0.00;0.00"),
        Bounces.ToString(CultureInfo.InvariantCulture), Text(RestTime, "0.0"), Text(Distance, "0.00"),
    ];

    /// <summary>The figures of a shot whose path was kept.</summary>
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
            First(outcome, BallEventKind.Rest)?.Time,
            (outcome.Final.Position - launch.Position).Horizontal.Length);
    }

    private static BallEvent? First(Outcome outcome, BallEventKind kind) => outcome.Events.Where(item => item.Kind == kind).Cast<BallEvent?>().FirstOrDefault();

    private static string Text(double? value, string format) => value is null ? "–" : value.Value.ToString(format, CultureInfo.InvariantCulture);
}
