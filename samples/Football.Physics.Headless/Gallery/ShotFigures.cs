using System.Globalization;

namespace Football.Physics.Headless.Gallery;

/// <summary>A shot in numbers. What belongs to the first touchdown is null for a ball that never left the ground.</summary>
/// <param name="Carry">Horizontal distance to the first touchdown, m.</param>
/// <param name="Apex">Greatest height of the centre, m.</param>
/// <param name="HangTime">Time to the first touchdown, s.</param>
/// <param name="Deflection">How far left of the launch direction's vertical plane the ball first touches down, m.</param>
/// <param name="Bounces">Impacts with the ground.</param>
/// <param name="RestTime">Time until rest, s; null where it did not come to rest.</param>
/// <param name="Distance">Horizontal distance between launch and end, m.</param>
internal sealed record ShotFigures(
    double? Carry, double Apex, double? HangTime, double? Deflection, int Bounces, double? RestTime, double Distance)
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

    public static ShotFigures Of(Flight flight)
    {
        BallEvent? touchdown = First(flight, BallEventKind.Impact);
        BallEvent? rest = First(flight, BallEventKind.Rest);
        Vector3d? way = touchdown?.Position - flight.Start;
        Vector3d direction = flight.Outcome.Samples![0].Velocity.Horizontal;
        double speed = direction.Length;
        return new ShotFigures(
            way?.Horizontal.Length,
            flight.Outcome.Apex,
            touchdown?.Time,
            way is null ? null : speed > 0 ? Vector3d.Dot(way.Value, Vector3d.Cross(Vector3d.Up, direction)) / speed : 0,
            flight.Outcome.Bounces,
            rest?.Time,
            (flight.Outcome.Final.Position - flight.Start).Horizontal.Length);
    }

    private static BallEvent? First(Flight flight, BallEventKind kind)
    {
        foreach (BallEvent item in flight.Events)
        {
            if (item.Kind == kind)
            {
                return item;
            }
        }

        return null;
    }

    private static string Text(double? value, string format) => value is null ? "–" : value.Value.ToString(format, CultureInfo.InvariantCulture);
}
