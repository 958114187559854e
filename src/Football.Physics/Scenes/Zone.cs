using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>A region that reports when the ball enters or leaves it: a penalty area, a touchline, a trigger.</summary>
/// <remarks>
/// The events are <see cref="BallEventKind.EnterZone"/> and <see cref="BallEventKind.ExitZone"/>. A zone never changes the path. Only the ball's position
/// determines whether the ball is in a zone. If you place a ball in a zone, only its later exit is reported, not an entry.
/// </remarks>
public sealed record Zone
{
    /// <summary>The minimum depth at which the ball counts as inside, in m, so that a ball may rest on the border.</summary>
    internal const double Touching = 1e-10;

    /// <summary>The name used in events and messages, unique in the scene. Default "zone".</summary>
    public string Name { get; init; } = "zone";

    /// <summary>The shape, which does not move.</summary>
    public required IShape Shape { get; init; }

    /// <summary>The part of the ball that must be in the shape. Default <see cref="ZonePart.Ball"/>.</summary>
    public ZonePart Of { get; init; } = ZonePart.Ball;

    /// <summary>The layer; a ball that ignores this layer causes no zone events. 0 … 31; default 0.</summary>
    public int Layer { get; init; }

    /// <summary>Returns true if a ball is in the zone.</summary>
    /// <param name="position">The position of the ball's centre, in m.</param>
    /// <param name="radius">The radius of the ball, in m.</param>
    public bool Holds(Vector3d position, double radius) => Shape.At(in position).Distance - LevelOf(radius) <= -Touching;

    /// <summary>Returns the distance between the ball's centre and the shape at which the ball enters, in m.</summary>
    internal double LevelOf(double radius) => Of == ZonePart.Ball ? radius : 0;

    internal void Validate(string field, BallProperties ball)
    {
        _ = Name ?? throw Check.Refusal(field + ".name", "null", "a name");
        _ = Shape ?? throw Check.Refusal(field + ".shape", "null", "a shape");
        Check.Defined(field + ".of", Of, (int)Of, 2);
        Layers.Validate(field + ".layer", Layer);

        // The search for crossings requires hollows to curve at most half as much as the ball.
        Check.Within(field + ".shape.maximumConcaveCurvature", Shape.MaximumConcaveCurvature, 0, 0.5 / ball.Radius);
    }
}
