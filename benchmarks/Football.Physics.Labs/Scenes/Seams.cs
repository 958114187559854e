namespace FootballPhysics.Labs.Scenes;

/// <summary>Compares a ball that crosses seams between flush surfaces with the same ball on one surface.</summary>
internal sealed class Seams : SceneKind
{
    private const double Limit = 1e-6;
    private const double Far = 70;

    private enum Lie
    {
        InTurf,
        Tiles,
        Overlapping,
        Boards,
    }

    public override string Name => "seams";

    public override string Claim => "A ball that crosses flush seams ends where it ends on one surface of the same material: 1e-6 m. Steps of 4 to 100 ms, shorter where their own error is more than a fifth of that.";

    public override int Share => 10;

    protected override SceneOutcome Play(SeededRandom random)
    {
        Lie lie = random.Any(Lie.InTurf, Lie.Tiles, Lie.Overlapping, Lie.Boards);
        PieceKind kind = random.Any(PieceKind.Obstacles, PieceKind.Bodies, PieceKind.Colliders);
        bool published = lie != Lie.Boards && random.Chance(0.2);
        Ground ground = Material(random, published);
        SurfaceMaterial surface = ground.Material;
        double radius = random.Chance(0.7) ? 0.11 : random.Uniform(0.08, 0.2);
        double pressing = random.Uniform(2, 9);
        var wind = new Vector3d(random.Uniform(-4, 4), 0, random.Uniform(-4, 4));
        Scene scene = (published ? Scene.Published : Scene.Measured) with
        {
            Ball = BallProperties.Tunnel with { Radius = radius, InertiaFactor = random.Any(2.0 / 3, 2.0 / 3, 0.4) },
            Air = lie == Lie.Boards ? new Air { Wind = new Vector3d(pressing, 0, wind.Z) }
                : random.Chance(0.5) ? new Air { Wind = random.Chance(0.5) ? wind : default } : new Air { Density = 0 },
            Ground = lie is Lie.InTurf or Lie.Boards ? ground : ground with { Height = -10 },
        };

        double speed = random.Log(0.5, 25);
        Vector3d heading = lie == Lie.Boards ? new Vector3d(0, 0, random.Any(-1.0, 1.0)) : random.Heading();
        Vector3d velocity = speed * heading;
        double step = random.Log(0.004, 0.1);
        double duration = step * Math.Max(1, Math.Round(random.Uniform(0.3, 1) / step));
        Vector3d spin = Spin(random, velocity, radius);
        var position = new Vector3d(0, radius, 0);
        Vector3d along = lie is Lie.InTurf or Lie.Tiles or Lie.Overlapping && random.Chance(0.3)
            ? random.Uniform(0.1, 2) * random.Heading()
            : default;
        along = kind == PieceKind.Obstacles || lie == Lie.InTurf ? default : along;

        var pieces = new ScenePieces(kind);
        double top = lie == Lie.Boards ? 0 : random.Any(0.0, 0.0, 1e-12, 1e-10);
        Lay(pieces, random, lie, heading, speed, radius, surface, top);
        var one = new ScenePieces(kind);
        LayOne(one, lie, radius, surface);

        // Errors of single steps may cancel out by the end, while errors of a step with a seam do not: use the largest error along the path.
        List<Vector3d> path = [];
        List<Vector3d> finer = [];
        BallState On(ScenePieces floor, int share, List<Vector3d> at) => End(scene, floor, position, velocity, spin, along, step, share, duration, at);
        int parts = Divide(Limit, share =>
        {
            On(one, share, path);
            On(one, 4 * share, finer);
            return path.Zip(finer, (at, there) => Vector3d.Distance(at, there)).Max();
        });
        BallState seamed = On(pieces, parts, path);
        BallState expected = On(one, parts, path);
        double error = Vector3d.Distance(seamed.Position, expected.Position);
        return new SceneOutcome(
            FormattableString.Invariant($"{lie} of {kind}"), true, double.IsNaN(error) ? double.PositiveInfinity : error, Limit,
            FormattableString.Invariant($"{speed:0.00} m/s, steps of {1000 * step:0.0} ms / {parts}, {duration:0.00} s: {error:e1} m off; top {top:e0} m, {(published ? "published" : "measured")}, {seamed.Motion} for {expected.Motion}"));
    }

    private static Ground Material(SeededRandom random, bool published)
    {
        if (published)
        {
            return random.Any(Ground.PublishedTurf, Ground.Presets["publishedCourt"], Ground.Presets["publishedWetTurf"]);
        }

        Ground ground = random.Any(Ground.Of(SurfaceMaterial.DryTurf), Ground.Of(SurfaceMaterial.ArtificialTurf), Ground.Of(SurfaceMaterial.WetTurf), Ground.Of(SurfaceMaterial.HardGround), Ground.Of(SurfaceMaterial.LongGrass), Ground.Of(SurfaceMaterial.Indoor), Ground.Of(SurfaceMaterial.Concrete), Ground.Of(SurfaceMaterial.Snow));
        return random.Chance(0.3) ? ground with { Material = ground.Material with { SlidingFriction = random.Uniform(0, 1), RollingResistance = random.Uniform(0, 0.2) } } : ground;
    }

    /// <summary>Draws a spin: a roll, a slide with its own spin, or a slide without spin.</summary>
    private static Vector3d Spin(SeededRandom random, in Vector3d velocity, double radius)
    {
        Vector3d rolling = Vector3d.Cross(Vector3d.Up, velocity) / radius;
        return random.Below(4) switch
        {
            0 => default,
            1 => random.Log(0.5, 60) * random.Direction(),
            2 => rolling + new Vector3d(0, random.Uniform(-30, 30), 0),
            _ => rolling,
        };
    }

    /// <summary>Lays strips between parallel seams across the ball's path: turned boxes with level tops, or boards with faces in one plane.</summary>
    private static void Lay(
        ScenePieces pieces, SeededRandom random, Lie lie, in Vector3d heading, double speed, double radius, SurfaceMaterial surface, double top)
    {
        // At the boards a seam is upright; on the ground it is turned against the path by up to 80 degrees.
        double turn = lie == Lie.Boards ? 0 : random.Uniform(-1.4, 1.4);
        double angle = Math.Atan2(heading.X, heading.Z) + turn;
        int seams = 1 + random.Below(5);
        double from = -Far;
        double to = speed * random.Uniform(0.05, 0.3) * Math.Cos(turn);
        for (int i = 0; i <= seams; i++)
        {
            double end = i == seams ? Far : to;
            double overlap = lie == Lie.Overlapping && i > 0 ? random.Uniform(0, 0.3) : 0;
            bool isPiece = lie != Lie.InTurf || i % 2 == 1;
            if (isPiece)
            {
                double middle = 0.5 * (from - overlap + end);
                double half = 0.5 * (end - from + overlap);
                pieces.Add(
                    lie == Lie.Boards
                        ? new BoxShape(new Vector3d(radius + 0.25, 1, middle * heading.Z), new Vector3d(0.25, 1, half))
                        : new BoxShape(
                            new Vector3d(middle * Math.Sin(angle), top - 0.25, middle * Math.Cos(angle)),
                            new Vector3d(Far, 0.25, half),
                            Quaterniond.FromAxisAngle(Vector3d.Up, angle)),
                    surface);
            }

            from = end;
            to = end + random.Log(0.05, 5);
        }
    }

    /// <summary>Lays the same surface without seams: nothing if the turf is that surface, otherwise one piece.</summary>
    private static void LayOne(ScenePieces one, Lie lie, double radius, SurfaceMaterial surface)
    {
        if (lie != Lie.InTurf)
        {
            one.Add(
                lie == Lie.Boards
                    ? new BoxShape(new Vector3d(radius + 0.25, 1, 0), new Vector3d(0.25, 1, Far))
                    : new BoxShape(new Vector3d(0, -0.25, 0), new Vector3d(Far, 0.25, Far)),
                surface);
        }
    }

    private static BallState End(
        Scene scene, ScenePieces pieces, in Vector3d position, in Vector3d velocity, in Vector3d spin, in Vector3d along, double step, int parts, double duration, List<Vector3d> path)
    {
        path.Clear();
        pieces.MoveTo(default, Quaterniond.Identity, along, default, 0);
        var simulator = new Simulator(pieces.In(scene));

        // In the frame of the moving pieces, the motion is the same.
        BallState state = simulator.Launch(position, velocity + along, spin);
        int steps = (int)Math.Round(duration / step);
        for (int i = 0; i < steps; i++)
        {
            for (int k = 0; k < parts; k++)
            {
                pieces.Step(simulator, ref state, step / parts, state.Time * along, Quaterniond.Identity, along, default);
            }

            path.Add(state.Position);
        }

        return state;
    }
}
