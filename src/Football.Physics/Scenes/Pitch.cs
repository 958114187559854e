namespace FootballPhysics;

/// <summary>A pitch: its lines, its two goals, and boards round it. The middle is the origin; goals stand at −z and +z. Sizes by law 1 of the game.</summary>
public sealed record Pitch
{
    /// <summary>From goal line to goal line, m; above 0. Default 105.</summary>
    public double Length { get; init; } = 105;

    /// <summary>From touchline to touchline, m; above 0. Default 68.</summary>
    public double Width { get; init; } = 68;

    /// <summary>The goals' sizes, material and nets; their place and facing are the pitch's. Default that of <see cref="Goal"/>, 7.32 m × 2.44 m.</summary>
    public Goal Goal { get; init; } = new() { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1) };

    /// <summary>Height of the boards round the pitch, m; 0 for none. Default none.</summary>
    public double BoardHeight { get; init; }

    /// <summary>How far behind the lines the boards stand, m; not negative. Default 3. At 0 there is a gap in them for each goal.</summary>
    public double BoardDistance { get; init; } = 3;

    /// <summary>Half their thickness, m; above 0. Default 0.05.</summary>
    public double BoardHalfThickness { get; init; } = 0.05;

    /// <summary>The material of the boards. Default <see cref="SurfaceMaterial.Board"/>.</summary>
    public SurfaceMaterial BoardSurface { get; init; } = SurfaceMaterial.Board with { };

    /// <summary>Law 1: 105 m × 68 m, goals of 7.32 m × 2.44 m, no boards.</summary>
    public static Pitch Standard { get; } = new();

    /// <summary>A pitch by law 1 in a stadium: 105 m × 68 m, advertising boards of 1 m, 4 m behind the lines.</summary>
    public static Pitch Stadium { get; } = new() { BoardHeight = 1, BoardDistance = 4 };

    /// <summary>Futsal, law 1: 40 m × 20 m, goals of 3 m × 2 m with frames of 8 cm, no boards.</summary>
    public static Pitch Futsal { get; } = new()
    {
        Length = 40,
        Width = 20,
        Goal = new Goal { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1), Width = 3, Height = 2, PostRadius = 0.04, DepthAtBar = 0.8, DepthOnGround = 1 },
    };

    /// <summary>A small-sided cage: 40 m × 20 m, goals of 3 m × 2 m, and a bowl of boards of 1.2 m on the lines.</summary>
    public static Pitch Cage { get; } = Futsal with { BoardHeight = 1.2, BoardDistance = 0, BoardSurface = SurfaceMaterial.Wood };

    /// <summary>The two goals: at −z first.</summary>
    public IReadOnlyList<Goal> Goals =>
    [
        Goal with { Center = new Vector3d(0, 0, -0.5 * Length), Facing = new Vector3d(0, 0, 1) },
        Goal with { Center = new Vector3d(0, 0, 0.5 * Length), Facing = new Vector3d(0, 0, -1) },
    ];

    /// <summary>The boards: "left board", "right board", "far board" (−z) and "near board"; in two parts beside a goal that they would close.</summary>
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

            // The middle planes of the boards.
            double x = (0.5 * Width) + BoardDistance + BoardHalfThickness;
            double z = (0.5 * Length) + BoardDistance + BoardHalfThickness;
            double reach = x + BoardHalfThickness;

            // Boards that stand in the net's way leave a gap for the goal with its posts.
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

    /// <summary>A scene with the goals and boards of this pitch added.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>. Height and surface of the pitch are those of its ground.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public Scene On(Scene? scene = null)
    {
        scene ??= Scene.Default;

        // A pitch lies on the ground of its scene, which may be higher.
        var up = new Vector3d(0, scene.Ground.IsNone ? 0 : scene.Ground.Height, 0);
        return scene with
        {
            Goals = [.. scene.Goals, .. Goals.Select(goal => goal with { Center = goal.Center + up })],
            Obstacles = [.. scene.Obstacles, .. Boards.Select(board => Raised(board, in up))],
        };
    }

    private static Obstacle Raised(Obstacle board, in Vector3d up)
    {
        // All boards are boxes along the axes: made above.
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
