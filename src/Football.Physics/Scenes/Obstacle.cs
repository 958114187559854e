using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>An object that the ball can hit: a shape with a surface.</summary>
/// <remarks>An obstacle can move at a constant velocity, and its surface can spin.</remarks>
public sealed record Obstacle
{
    /// <summary>The name used in events and messages. Default "obstacle".</summary>
    public string Name { get; init; } = "obstacle";

    /// <summary>The shape, at its position at time 0.</summary>
    public required IShape Shape { get; init; }

    /// <summary>The material. Default <see cref="SurfaceMaterial.GoalFrame"/>.</summary>
    public SurfaceMaterial Surface { get; init; } = SurfaceMaterial.GoalFrame with { };

    /// <summary>The velocity, in m/s; at most 1000. Default 0.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>The spin of the surface about <see cref="Pivot"/>, in rad/s; at most 10 000. Default 0.</summary>
    /// <remarks>The spin moves the surface, as on a spinning roller, but not the shape. In sustained contact, only its velocity along the shape acts.</remarks>
    public Vector3d Spin { get; init; }

    /// <summary>The mass, in kg; above 0. Default infinite: the ball does not move the obstacle.</summary>
    /// <remarks>With a finite mass, an impact changes the velocity by the impulse divided by the mass, and the obstacle keeps the new velocity.</remarks>
    public double Mass { get; init; } = double.PositiveInfinity;

    /// <summary>The pivot of <see cref="Spin"/> at time 0, in m; components within ±1e6. Default: the origin.</summary>
    /// <remarks>The pivot moves with the obstacle.</remarks>
    public Vector3d Pivot { get; init; }

    /// <summary>The layer; a ball that ignores this layer passes through. 0 … 31; default 0.</summary>
    public int Layer { get; init; }

    internal void Validate(string field, BallProperties ball)
    {
        // A serializer or a with-expression can set a non-nullable property to null.
        _ = Name ?? throw Check.Refusal(field + ".name", "null", "a name");
        _ = Shape ?? throw Check.Refusal(field + ".shape", "null", "a shape");
        _ = Surface ?? throw Check.Refusal(field + ".surface", "null", "a surface");

        HollowSamples.Validate(field, Shape, ball.Radius);
        Surface.Validate(field + ".surface", ball.MostDamping);
        Check.Size(field + ".velocity", Velocity, Limits.Speed, "m/s");
        Check.Size(field + ".spin", Spin, Limits.Spin, "rad/s");
        Check.Place(field + ".pivot", Pivot);
        Layers.Validate(field + ".layer", Layer);
        Check.Within(field + ".mass", Mass, 0, double.PositiveInfinity, exclusiveLow: true);
    }
}
