using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>A pitch as specified in Law 1: its size, its two goals, and boards around it.</summary>
/// <remarks>The origin is the centre of the pitch. The goals are at −z and +z.</remarks>
public sealed record Pitch
{
    /// <summary>The distance between the goal lines, in m; above 0. Default 105.</summary>
    public double Length { get; init; } = 105;

    /// <summary>The distance between the touchlines, in m; above 0. Default 68.</summary>
    public double Width { get; init; } = 68;

    /// <summary>The size, material and nets of both goals. Default: those of <see cref="Goal"/>, 7.32 m × 2.44 m.</summary>
    /// <remarks>The pitch sets position and direction of its goals.</remarks>
    public Goal Goal { get; init; } = new() { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1) };

    /// <summary>The height of the boards around the pitch, in m. Default 0: no boards.</summary>
    public double BoardHeight { get; init; }

    /// <summary>The distance between the lines and the boards, in m; at least 0. Default 3.</summary>
    /// <remarks>The boards leave a gap for each goal if this distance is at most <see cref="Goal.DepthOnGround"/>.</remarks>
    public double BoardDistance { get; init; } = 3;

    /// <summary>Half the thickness of the boards, in m; above 0. Default 0.05.</summary>
    public double BoardHalfThickness { get; init; } = 0.05;

    /// <summary>The material of the boards. Default <see cref="SurfaceMaterial.Board"/>.</summary>
    public SurfaceMaterial BoardSurface { get; init; } = SurfaceMaterial.Board with { };

    /// <summary>A pitch as specified in Law 1: 105 m × 68 m, goals of 7.32 m × 2.44 m, no boards.</summary>
    public static Pitch Standard { get; } = new();

    /// <summary>A pitch in a stadium: 105 m × 68 m, with advertising boards 1 m high, 4 m behind the lines.</summary>
    public static Pitch Stadium { get; } = new() { BoardHeight = 1, BoardDistance = 4 };

    /// <summary>A futsal pitch as specified in Law 1: 40 m × 20 m, goals of 3 m × 2 m with 8 cm frames, no boards.</summary>
    public static Pitch Futsal { get; } = new()
    {
        Length = 40,
        Width = 20,
        Goal = new Goal { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1), Width = 3, Height = 2, PostRadius = 0.04, DepthAtBar = 0.8, DepthOnGround = 1 },
    };

    /// <summary>A small-sided cage: 40 m × 20 m, goals of 3 m × 2 m, and 1.2 m boards on the lines.</summary>
    public static Pitch Cage { get; } = Futsal with { BoardHeight = 1.2, BoardDistance = 0, BoardSurface = SurfaceMaterial.Wood };

    /// <summary>The two goals; the goal at −z comes first.</summary>
    public IReadOnlyList<Goal> Goals =>
    [
        Goal with { Center = new Vector3d(0, 0, -0.5 * Length), Facing = new Vector3d(0, 0, 1) },
        Goal with { Center = new Vector3d(0, 0, 0.5 * Length), Facing = new Vector3d(0, 0, -1) },
    ];

    /// <summary>The boards: "left board", "right board", "far board" (−z) and "near board" (+z).</summary>
    /// <remarks>A board that would cross a goal is split into two parts with the same name.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public IReadOnlyList<Obstacle> Boards
    {
        get
        {
            Validate();
            if (BoardHeight == 0)
            {
                return [];
            }

            // The positions of the boards' middle planes.
            double x = (0.5 * Width) + BoardDistance + BoardHalfThickness;
            double z = (0.5 * Length) + BoardDistance + BoardHalfThickness;
            double reach = x + BoardHalfThickness;

            // If the net reaches the boards, leave a gap as wide as the goal including its posts.
            double mouth = BoardDistance > Goal.DepthOnGround ? 0 : (0.5 * Goal.Width) + (2.0 * Goal.PostRadius);
            var boards = new List<Obstacle> { Board("left board", -x, -z, -x, z), Board("right board", x, -z, x, z) };
            foreach ((string name, double end) in new[] { ("far board", -z), ("near board", z) })
            {
                if (mouth == 0)
                {
                    boards.Add(Board(name, -reach, end, reach, end));
                }
                else
                {
                    boards.Add(Board(name, -reach, end, -mouth, end));
                    boards.Add(Board(name, mouth, end, reach, end));
                }
            }

            return boards;
        }
    }

    /// <summary>Returns a scene with the goals and boards of this pitch added.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>. Its ground gives the height and surface of the pitch.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public Scene On(Scene? scene = null)
    {
        scene ??= Scene.Default;

        // Raise goals and boards to the height of the scene's ground.
        var up = new Vector3d(0, scene.Ground.IsNone ? 0 : scene.Ground.Height, 0);
        return scene with
        {
            Goals = [.. scene.Goals, .. Goals.Select(goal => goal with { Center = goal.Center + up })],
            Obstacles = [.. scene.Obstacles, .. Boards.Select(board => Raised(board, in up))],
        };
    }

    private static Obstacle Raised(Obstacle board, in Vector3d up)
    {
        // Board creates only axis-aligned boxes.
        var box = (BoxShape)board.Shape;
        return board with { Shape = new BoxShape(box.Center + up, box.HalfSize) };
    }

    private Obstacle Board(string name, double fromX, double fromZ, double toX, double toZ) => new()
    {
        Name = name,
        Shape = new BoxShape(
            new Vector3d(0.5 * (fromX + toX), 0.5 * BoardHeight, 0.5 * (fromZ + toZ)),
            new Vector3d(Math.Max(BoardHalfThickness, 0.5 * (toX - fromX)), 0.5 * BoardHeight, Math.Max(BoardHalfThickness, 0.5 * (toZ - fromZ)))),
        Surface = BoardSurface,
    };

    private void Validate()
    {
        Check.Within("pitch.length", Length, 0, Limits.Length, exclusiveLow: true);
        Check.Within("pitch.width", Width, 0, Limits.Length, exclusiveLow: true);
        Check.Member("pitch.goal", Goal);
        Check.Within("pitch.boardHeight", BoardHeight, 0, Limits.Length);
        Check.Within("pitch.boardDistance", BoardDistance, 0, Limits.Length);
        Check.Within("pitch.boardHalfThickness", BoardHalfThickness, 0, Limits.Length, exclusiveLow: true);
        Check.Member("pitch.boardSurface", BoardSurface);
    }
}
