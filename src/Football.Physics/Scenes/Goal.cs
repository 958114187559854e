using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>A goal: two posts, a crossbar, nets and a goal line. The default sizes follow Law 1.</summary>
/// <remarks><see cref="BallEventKind.Goal"/> defines when a goal is scored.</remarks>
public sealed record Goal
{
    /// <summary>The centre of the goal line on the ground, in m; components within ±1e6.</summary>
    public required Vector3d Center { get; init; }

    /// <summary>The horizontal direction towards the pitch; any length except 0.</summary>
    public required Vector3d Facing { get; init; }

    /// <summary>The width of the opening, in m; above 0. Default 7.32.</summary>
    public double Width { get; init; } = 7.32;

    /// <summary>The height of the opening, in m; above 0. Default 2.44.</summary>
    public double Height { get; init; } = 2.44;

    /// <summary>The radius of posts and crossbar, in m; above 0. Default 0.06.</summary>
    public double PostRadius { get; init; } = 0.06;

    /// <summary>The depth of the net at the height of the crossbar, in m; above 0. Default 0.8.</summary>
    public double DepthAtBar { get; init; } = 0.8;

    /// <summary>The depth of the net on the ground, in m; above 0. Default 2.</summary>
    public double DepthOnGround { get; init; } = 2.0;

    /// <summary>True if the goal has nets. Default true.</summary>
    public bool HasNet { get; init; } = true;

    /// <summary>The material of posts and crossbar. Default null: the goal frame of the scene's profile.</summary>
    /// <remarks>The profile's frame is <see cref="SurfaceMaterial.GoalFrame"/> under the measured laws, and <see cref="SurfaceMaterial.PublishedGoalFrame"/> otherwise.</remarks>
    public SurfaceMaterial? Surface { get; init; }

    /// <summary>The unit vector along the goal line towards the right post, as seen by a goalkeeper who faces the pitch.</summary>
    internal Vector3d Right => Vector3d.Cross(Out, Vector3d.Up);

    /// <summary><see cref="Facing"/>, normalized.</summary>
    internal Vector3d Out => Check.Direction("facing", Facing);

    /// <summary>Returns the posts and the crossbar that the simulator uses: capsules that join at the corners.</summary>
    /// <param name="laws">The forces of the scene. If <see cref="Surface"/> is null, they select the material.</param>
    public IEnumerable<Obstacle> Frame(ForceSet laws)
    {
        SurfaceMaterial surface = Surface ?? (laws.Coefficients == AerodynamicModel.Measured ? SurfaceMaterial.GoalFrame : SurfaceMaterial.PublishedGoalFrame);
        double side = (0.5 * Width) + PostRadius;

        // Width and height are measured between the inner edges, so each bar's axis lies one radius outside.
        var up = new Vector3d(0, Height + PostRadius, 0);
        Vector3d left = Center - (side * Right);
        Vector3d right = Center + (side * Right);
        yield return new Obstacle { Name = "left post", Shape = new CapsuleShape(left, left + up, PostRadius), Surface = surface };
        yield return new Obstacle { Name = "right post", Shape = new CapsuleShape(right, right + up, PostRadius), Surface = surface };
        yield return new Obstacle { Name = "crossbar", Shape = new CapsuleShape(left + up, right + up, PostRadius), Surface = surface };
    }

    /// <summary>The number of parts of the frame: two posts and the crossbar.</summary>
    internal static int FrameCount => 3;

    /// <summary>The number of nets.</summary>
    internal int NetCount => HasNet ? 4 : 0;

    /// <summary>Returns the back, roof and side nets that the simulator uses; empty if <see cref="HasNet"/> is false.</summary>
    /// <remarks>The nets end at the axes of the posts and the crossbar.</remarks>
    public IEnumerable<Net> Nets()
    {
        if (!HasNet)
        {
            yield break;
        }

        double side = (0.5 * Width) + PostRadius;
        double top = Height + PostRadius;

        // The back net slopes from its depth at the crossbar to its depth at the ground.
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

        // The side nets are rectangles as deep as the net is at the ground.
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
