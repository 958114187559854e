namespace FootballPhysics;

/// <summary>A thing that can be hit: a shape with a surface. It may move with a constant velocity, and its surface may turn.</summary>
public sealed record Obstacle
{
    /// <summary>Its name, for events and messages. Default "obstacle".</summary>
    public string Name { get; init; } = "obstacle";

    /// <summary>Its shape, where it is at time 0.</summary>
    public required IShape Shape { get; init; }

    /// <summary>The material. Default <see cref="SurfaceMaterial.GoalFrame"/>.</summary>
    public SurfaceMaterial Surface { get; init; } = SurfaceMaterial.GoalFrame with { };

    /// <summary>Velocity, m/s; at most 1000. Default 0.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>Spin of its surface about <see cref="Pivot"/>, rad/s; at most 10 000. It moves the surface, not the shape. Default 0.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>
    /// Mass, kg; above 0. Infinite, the default, for what nothing moves, or moves by its <see cref="Velocity"/> alone; else an impact of the ball changes its velocity by
    /// the impulse, and it goes on so.
    /// </summary>
    public double Mass { get; init; } = double.PositiveInfinity;

    /// <summary>The pivot that its surface turns about, at time 0, m; components within ±1e6. Moves with it. Default the origin.</summary>
    public Vector3d Pivot { get; init; }

    /// <summary>Its layer: a ball that ignores it passes through. 0 … 31; default 0.</summary>
    public int Layer { get; init; }

    internal void Validate(string field, BallProperties ball)
    {
        // A serializer, or a with-expression, may leave null where the type says there is none.
        _ = Name ?? throw Check.Refusal(field + ".name", "null", "a name");
        _ = Shape ?? throw Check.Refusal(field + ".shape", "null", "a shape");
        _ = Surface ?? throw Check.Refusal(field + ".surface", "null", "a surface");

        // The search for contact relies on it: no hollow bends more than half as much as the ball.
        Check.Within(field + ".shape.maximumConcaveCurvature", Shape.MaximumConcaveCurvature, 0, 0.5 / ball.Radius);
        Surface.Validate(field + ".surface", ball.MostDamping);
        Check.Size(field + ".velocity", Velocity, Limits.Speed, "m/s");
        Check.Size(field + ".spin", Spin, Limits.Spin, "rad/s");
        Check.Place(field + ".pivot", Pivot);
        Layers.Validate(field + ".layer", Layer);
        Check.Within(field + ".mass", Mass, 0, double.PositiveInfinity, exclusiveLow: true);
    }
}
