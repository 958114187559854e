namespace FootballPhysics;

/// <summary>A part of space that the ball passes freely: it only reports when the ball enters and leaves it. A penalty area, a touch line, a trigger of a level.</summary>
/// <remarks>
/// The events are <see cref="BallEventKind.EnterZone"/> and <see cref="BallEventKind.ExitZone"/>. A zone never changes the path. Whether the ball is in a zone depends only on
/// its position, so a ball that is placed in a zone has not entered it, and reports when it leaves.
/// </remarks>
public sealed record Zone
{
    /// <summary>A distance at which the ball does not count as in a zone yet, m: it may lie on a border.</summary>
    internal const double Touching = 1e-10;

    /// <summary>Its name, for events and messages; no other zone of the scene has it. Default "zone".</summary>
    public string Name { get; init; } = "zone";

    /// <summary>Its shape, which does not move.</summary>
    public required IShape Shape { get; init; }

    /// <summary>The part of the ball that must be in the shape. Default <see cref="ZonePart.Ball"/>.</summary>
    public ZonePart Of { get; init; } = ZonePart.Ball;

    /// <summary>Its layer: a ball that ignores it reports nothing. 0 … 31; default 0.</summary>
    public int Layer { get; init; }

    /// <summary>True if a ball is in the zone.</summary>
    /// <param name="position">Position of the ball's centre, m.</param>
    /// <param name="radius">Radius of the ball, m.</param>
    public bool Holds(Vector3d position, double radius) => Shape.At(in position).Distance - LevelOf(radius) <= -Touching;

    /// <summary>The distance of the ball's centre from the shape at which the ball enters, m.</summary>
    internal double LevelOf(double radius) => Of == ZonePart.Ball ? radius : 0;

    internal void Validate(string field, BallProperties ball)
    {
        _ = Name ?? throw Check.Refusal(field + ".name", "null", "a name");
        _ = Shape ?? throw Check.Refusal(field + ".shape", "null", "a shape");
        Check.Defined(field + ".of", Of, (int)Of, 2);
        Layers.Validate(field + ".layer", Layer);

        // The search for the crossing relies on it, as that for contacts does.
        Check.Within(field + ".shape.maximumConcaveCurvature", Shape.MaximumConcaveCurvature, 0, 0.5 / ball.Radius);
    }
}
