using FootballPhysics.Tool.Gallery;
namespace FootballPhysics.Tool.Replay;

/// <summary>Converts a scene to shapes for drawings: goals, nets, obstacles, and the markings of a goal.</summary>
internal static class SceneShapes
{
    /// <summary>The size at which an infinite plane is drawn, in m.</summary>
    private const double PlaneReach = 6;

    /// <summary>The width of the meshes of a drawn net, in m, and their maximum number.</summary>
    private const double Mesh = 0.3;
    private const double MostMeshes = 40;

    /// <summary>The height of markings above the ground, in m, so that the ground does not hide them.</summary>
    private const double OnTheGround = 0.005;

    /// <summary>Returns the shapes of all objects except the ground.</summary>
    public static IReadOnlyList<SceneShape> Of(Scene scene) =>
    [
        .. scene.Goals.Where(HasMarkings).Select(goal => Markings(goal, scene.Ground)),
        .. scene.Obstacles.Select(obstacle => Shape(obstacle, SceneShapeKind.Obstacle) with { People = People.Of(obstacle) }),
        .. scene.Goals.SelectMany(goal => goal.Frame(scene.Forces)).Select(part => Shape(part, SceneShapeKind.Frame)),
        .. scene.Nets.Select(Net),
        .. scene.Goals.SelectMany(Nets),
    ];

    /// <summary>Returns the shape of a body at its last position, with its velocity.</summary>
    public static SceneShape Of(KinematicBody body)
    {
        Vector3d Placed(Vector3d own) => body.Position + body.Orientation.Rotate(own);
        IShape shape = body.Shape switch
        {
            FootballPhysics.Shapes.CapsuleShape rod => new FootballPhysics.Shapes.CapsuleShape(Placed(rod.From), Placed(rod.To), rod.Radius),
            FootballPhysics.Shapes.SphereShape ball => new FootballPhysics.Shapes.SphereShape(Placed(ball.Center), ball.Radius),
            FootballPhysics.Shapes.BoxShape box => new FootballPhysics.Shapes.BoxShape(Placed(box.Center), box.HalfSize, body.Orientation * box.Rotation),
            FootballPhysics.Shapes.PlaneShape plane => new FootballPhysics.Shapes.PlaneShape(Placed(plane.Point), body.Orientation.Rotate(plane.Normal)),
            _ => body.Shape,
        };
        return Shape(new Obstacle { Name = body.Name, Shape = shape, Velocity = body.Velocity }, SceneShapeKind.Obstacle);
    }

    /// <summary>Returns the height of the ground at a point, in m.</summary>
    public static double GroundAt(Ground ground, double x, double z)
    {
        Vector3d normal = ground.Normal;
        return ground.IsNone ? 0
            : ground.Heights is { } heights ? ground.Height + heights.HeightAt(x, z)
            : ground.Height - (((normal.X * x) + (normal.Z * z)) / normal.Y);
    }

    private static SceneShape Shape(Obstacle obstacle, SceneShapeKind kind)
    {
        var shape = new SceneShape(obstacle.Name, kind) { Velocity = obstacle.Velocity };
        return obstacle.Shape switch
        {
            FootballPhysics.Shapes.CapsuleShape rod => shape with { Lines = [[rod.From, rod.To]], Radius = rod.Radius },
            FootballPhysics.Shapes.SphereShape ball => shape with { Lines = [[ball.Center]], Radius = ball.Radius },
            FootballPhysics.Shapes.BoxShape box => shape with { Faces = Faces(box) },
            FootballPhysics.Shapes.PlaneShape plane => shape with { Faces = [Rectangle(plane.Point, plane.Normal)] },
            _ => shape,
        };
    }

    private static Vector3d[][] Faces(FootballPhysics.Shapes.BoxShape box)
    {
        Vector3d x = box.Rotation.Rotate(new Vector3d(box.HalfSize.X, 0, 0));
        Vector3d y = box.Rotation.Rotate(new Vector3d(0, box.HalfSize.Y, 0));
        Vector3d z = box.Rotation.Rotate(new Vector3d(0, 0, box.HalfSize.Z));
        Vector3d[] Face(Vector3d outward, Vector3d u, Vector3d v)
        {
            Vector3d middle = box.Center + outward;
            return [middle - u - v, middle + u - v, middle + u + v, middle - u + v];
        }

        return [Face(x, y, z), Face(-x, z, y), Face(y, z, x), Face(-y, x, z), Face(z, x, y), Face(-z, y, x)];
    }

    private static Vector3d[] Rectangle(Vector3d middle, Vector3d normal)
    {
        Vector3d u = PlaneReach * Vector3d.Cross(Math.Abs(normal.Y) < 0.9 ? Vector3d.Up : new Vector3d(1, 0, 0), normal).Normalized();
        Vector3d v = Vector3d.Cross(normal, u);
        return [middle - u - v, middle + u - v, middle + u + v, middle - u + v];
    }

    /// <summary>Returns the nets of a goal; the sides extend only as far as back and roof.</summary>
    private static IEnumerable<SceneShape> Nets(Goal goal)
    {
        foreach (Net net in goal.Nets())
        {
            double side = Vector3d.Dot(net.Center - goal.Center, goal.Right());
            Vector3d line = goal.Center + (side * goal.Right());
            Vector3d top = new(0, goal.Height + goal.PostRadius, 0);
            yield return Math.Abs(side) < 0.1 * goal.Width ? Net(net)
                : Meshes(net.Name, line, line - (goal.DepthOnGround * goal.Outward()), line + top - (goal.DepthAtBar * goal.Outward()), line + top);
        }
    }

    private static SceneShape Net(Net net)
    {
        Vector3d along = net.Along.Normalized();
        Vector3d across = Vector3d.Cross(net.Normal.Normalized(), along);
        Vector3d u = net.HalfLength * along;
        Vector3d v = net.HalfWidth * across;
        return Meshes(net.Name, net.Center - u - v, net.Center + u - v, net.Center + u + v, net.Center - u + v);
    }

    /// <summary>Returns a net between four corners.</summary>
    private static SceneShape Meshes(string name, Vector3d a, Vector3d b, Vector3d c, Vector3d d)
    {
        int columns = Meshes((b - a).Length);
        int rows = Meshes((d - a).Length);
        return new SceneShape(name, SceneShapeKind.Net)
        {
            Lines =
            [
                .. Enumerable.Range(0, columns + 1).Select(i => (double)i / columns).Select(s => (Vector3d[])[Vector3d.Lerp(a, b, s), Vector3d.Lerp(d, c, s)]),
                .. Enumerable.Range(0, rows + 1).Select(i => (double)i / rows).Select(s => (Vector3d[])[Vector3d.Lerp(a, d, s), Vector3d.Lerp(b, c, s)]),
            ],
            Corners = [a, b, c, d],
        };
    }

    /// <summary>Returns the number of meshes of a net along a length in m.</summary>
    public static int Meshes(double length) => (int)Math.Clamp(Math.Ceiling(length / Mesh), 1, MostMeshes);

    /// <summary>True if the goal has the regular width. Only such a goal has markings.</summary>
    private static bool HasMarkings(Goal goal) => Math.Abs(goal.Width - PitchSize.GoalWidth) < 0.1;

    /// <summary>Returns the goal line, areas, penalty mark and arc in front of a goal.</summary>
    private static SceneShape Markings(Goal goal, Ground ground)
    {
        Vector3d At(double right, double outward)
        {
            Vector3d flat = goal.Center + (right * goal.Right()) + (outward * goal.Outward());
            return new Vector3d(flat.X, GroundAt(ground, flat.X, flat.Z) + OnTheGround, flat.Z);
        }

        // Use several points per line, because the ground may be uneven.
        Vector3d[] Line(double fromRight, double fromOut, double toRight, double toOut) =>
            [.. Enumerable.Range(0, 9).Select(i => At(fromRight + (i / 8.0 * (toRight - fromRight)), fromOut + (i / 8.0 * (toOut - fromOut))))];

        Vector3d[][] Area(double half, double depth) => [Line(-half, 0, -half, depth), Line(-half, depth, half, depth), Line(half, depth, half, 0)];

        double widest = Math.Acos((PitchSize.PenaltyAreaDepth - PitchSize.PenaltyMark) / PitchSize.CircleRadius);
        Vector3d[] arc = [.. Enumerable.Range(0, 17).Select(i => ((i / 8.0) - 1) * widest).Select(
            angle => At(PitchSize.CircleRadius * Math.Sin(angle), PitchSize.PenaltyMark + (PitchSize.CircleRadius * Math.Cos(angle))))];
        return new SceneShape("penalty area", SceneShapeKind.Marking)
        {
            Lines =
            [
                Line(-PitchSize.PenaltyAreaHalfWidth - 4, 0, PitchSize.PenaltyAreaHalfWidth + 4, 0),
                .. Area(PitchSize.PenaltyAreaHalfWidth, PitchSize.PenaltyAreaDepth),
                .. Area(PitchSize.GoalAreaHalfWidth, PitchSize.GoalAreaDepth),
                [At(-0.15, PitchSize.PenaltyMark), At(0.15, PitchSize.PenaltyMark)],
                arc,
            ],
        };
    }
}
