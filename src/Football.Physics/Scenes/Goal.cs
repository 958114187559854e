namespace FootballPhysics;

/// <summary>A goal: two posts, a bar, nets, and the line that all of a ball must pass. Sizes by law 1 of the game.</summary>
/// <remarks><see cref="BallEventKind.Goal"/> says when it counts.</remarks>
public sealed record Goal
{
    /// <summary>The middle of its line on the ground, m; components within ±1e6.</summary>
    public required Vector3d Center { get; init; }

    /// <summary>The horizontal direction that it faces: towards the pitch; any length but 0.</summary>
    public required Vector3d Facing { get; init; }

    /// <summary>Width of the opening, m; above 0. Default 7.32.</summary>
    public double Width { get; init; } = 7.32;

    /// <summary>Height of the opening, m; above 0. Default 2.44.</summary>
    public double Height { get; init; } = 2.44;

    /// <summary>Radius of posts and bar, m; above 0. Default 0.06.</summary>
    public double PostRadius { get; init; } = 0.06;

    /// <summary>How far behind the line the back net begins at the height of the bar, m; above 0. Default 0.8.</summary>
    public double DepthAtBar { get; init; } = 0.8;

    /// <summary>How far behind the line it ends on the ground, m; above 0. Default 2.</summary>
    public double DepthOnGround { get; init; } = 2.0;

    /// <summary>True for a goal with nets. Default true.</summary>
    public bool HasNet { get; init; } = true;

    /// <summary>The material of posts and bar. Default null: <see cref="SurfaceMaterial.GoalFrame"/> where the scene's laws are measured, else <see cref="SurfaceMaterial.PublishedGoalFrame"/>.</summary>
    public SurfaceMaterial? Surface { get; init; }

    /// <summary>The line's direction towards the right post, seen by who stands in the goal and looks at the pitch; of length 1.</summary>
    internal Vector3d Right => Vector3d.Cross(Out, Vector3d.Up);

    /// <summary><see cref="Facing"/> with length 1.</summary>
    internal Vector3d Out => Check.Direction("facing", Facing);

    /// <summary>Posts and bar, as the simulator has them: capsules that meet at the corners.</summary>
    /// <param name="laws">The forces of the scene, whose profile's frame it has where it has no surface of its own.</param>
    public IEnumerable<Obstacle> Frame(ForceSet laws)
    {
        SurfaceMaterial surface = Surface ?? (laws.Coefficients == AerodynamicModel.Measured ? SurfaceMaterial.GoalFrame : SurfaceMaterial.PublishedGoalFrame);
        double side = (0.5 * Width) + PostRadius;

        // The opening is between the inner edges: the axes lie a radius outside and above.
        var up = new Vector3d(0, Height + PostRadius, 0);
        Vector3d left = Center - (side * Right);
        Vector3d right = Center + (side * Right);
        yield return new Obstacle { Name = "left post", Shape = new CapsuleShape(left, left + up, PostRadius), Surface = surface };
        yield return new Obstacle { Name = "right post", Shape = new CapsuleShape(right, right + up, PostRadius), Surface = surface };
        yield return new Obstacle { Name = "crossbar", Shape = new CapsuleShape(left + up, right + up, PostRadius), Surface = surface };
    }

    /// <summary>How many nets it has.</summary>
    internal int NetCount => HasNet ? 4 : 0;

    /// <summary>Back, roof and side nets, as the simulator has them, up to the axes of posts and bar; none where <see cref="HasNet"/> is false.</summary>
    public IEnumerable<Net> Nets()
    {
        if (!HasNet)
        {
            yield break;
        }

        double side = (0.5 * Width) + PostRadius;
        double top = Height + PostRadius;

        // The back net leans from bar depth at the top to its depth on the ground.
        Vector3d back = -Out;
        Vector3d highest = Center + (DepthAtBar * back) + new Vector3d(0, top, 0);
        Vector3d lowest = Center + (DepthOnGround * back);
        Vector3d slant = highest - lowest;
        yield return new Net
        {
            Name = "back net",
            Center = 0.5 * (highest + lowest),
            Normal = Vector3d.Cross(Right, in slant),
            Along = Right,
            HalfLength = side,
            HalfWidth = 0.5 * slant.Length,
        };
        yield return new Net
        {
            Name = "roof net",
            Center = Center + (0.5 * DepthAtBar * back) + new Vector3d(0, top, 0),
            Normal = Vector3d.Up,
            Along = Right,
            HalfLength = side,
            HalfWidth = 0.5 * DepthAtBar,
        };

        // Sides are rectangles, as deep everywhere as the goal is on the ground.
        Vector3d middle = Center + (0.5 * DepthOnGround * back) + new Vector3d(0, 0.5 * top, 0);
        yield return Side("left net", middle - (side * Right), in back, top);
        yield return Side("right net", middle + (side * Right), in back, top);
    }

    internal void Validate(string field, double mostDamping = 1)
    {
        Check.Place(field + ".center", Center);
        Check.Direction(field + ".facing", Facing);
        if (Math.Abs(Out.Y) > 1e-6)
        {
            throw Check.Refusal(field + ".facing", Facing.ToString(), "a horizontal direction");
        }

        Check.Within(field + ".width", Width, 0, Limits.Length, exclusiveLow: true);
        Check.Within(field + ".height", Height, 0, Limits.Length, exclusiveLow: true);
        Check.Within(field + ".postRadius", PostRadius, 0, Limits.Length, exclusiveLow: true);
        Check.Within(field + ".depth[0]", DepthAtBar, 0, Limits.Length, exclusiveLow: true);
        Check.Within(field + ".depth[1]", DepthOnGround, 0, Limits.Length, exclusiveLow: true);
        Surface?.Validate(field + ".surface", mostDamping);
    }

    private Net Side(string name, in Vector3d middle, in Vector3d back, double top) => new()
    {
        Name = name,
        Center = middle,
        Normal = Right,
        Along = back,
        HalfLength = 0.5 * DepthOnGround,
        HalfWidth = 0.5 * top,
    };
}
