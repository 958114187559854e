namespace FootballPhysics.Labs.People;

/// <summary>The kinds of objects that a ball is pressed against.</summary>
internal enum PressKind
{
    Board,
    Corner,
    Post,
    Net,
}

/// <summary>A player presses the ball against a board, into a corner of two, against a post, or into a net. He stops when he touches them, or walks on.</summary>
internal sealed class Presses(PressKind kind) : PeopleCases($"pressed: {kind}")
{
    private const double Thick = 0.05;
    private const int Frames = 200;
    private static readonly Vector3d s_half = new(2000, 0.5, Thick);
    private static readonly Vector3d s_end = new(0, 0.5, -5 - Thick);
    private static readonly Vector3d s_side = new(-5 - Thick, 0.5, 0);
    private static readonly Vector3d s_foot = new(0, 0, -5);
    private static readonly Vector3d s_tip = new(0, 2.5, -5);

    public readonly PeopleClaim Inside = new($"pressed: {kind}: a frame ends inside what stands still, m", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);
    public readonly PeopleClaim Behind = new($"pressed: {kind}: ends behind a board");

    public override PeopleClaim[] Claims => [Inside, Behind];

    /// <summary>Simulates one press.</summary>
    public override void Play(long seed, int index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        var bodies = new KinematicBodies();
        var player = new WalkingPlayer(bodies, "player");
        bool walksOn = random.Chance(0.5);
        double frame = random.Chance(0.7) ? 1.0 / 60 : random.Uniform(0.005, 0.04);
        var standing = new StandingSolids();
        var ball = new Ball(Scene(standing, bodies));
        Vector3d from = kind switch
        {
            PressKind.Board => new Vector3d(0, Radius, -5 + Radius + 0.0001 + random.Uniform(0, 0.3)),
            PressKind.Corner => new Vector3d(-5 + Radius + 0.0001 + random.Uniform(0, 0.3), Radius, -5 + Radius + 0.0001 + random.Uniform(0, 0.3)),
            PressKind.Post => new Vector3d(random.Uniform(-0.1, 0.1), Radius, -4.6),
            _ => new Vector3d(random.Uniform(-3.4, 3.4), Radius, -5 - random.Uniform(0.5, 1.7)),
        };
        ball.Place(from);
        Vector3d heading = kind == PressKind.Corner
            ? new Vector3d(-random.Uniform(0.2, 1), 0, -random.Uniform(0.2, 1)).Normalized()
            : new Vector3d(random.Uniform(-0.4, 0.4), 0, -1).Normalized();
        player.Place = from.Horizontal - (random.Uniform(0.5, 1) * heading) + new Vector3d(random.Uniform(-0.1, 0.1), 0, random.Uniform(-0.1, 0.1));
        player.Velocity = random.Uniform(0.3, 5) * heading;
        double slowing = random.Uniform(0, 1.5);
        double deepest = 0;
        for (int i = 0; i < Frames; i++)
        {
            player.Put(ball.Time);
            Meter.Step(ball, frame, $"{kind}, press {index}, frame {i}");
            player.Walk(frame);
            double speed = player.Velocity.Length;
            player.Velocity = speed > slowing * frame ? (1 - (slowing * frame / speed)) * player.Velocity : player.Velocity;
            if (!walksOn)
            {
                Stop(player);
            }

            double deep = Radius - standing.Distance(ball.State.Position);
            deepest = Math.Max(deepest, deep);
            Inside.See(deep, $"{kind}, press {index}, frame {i}");
        }

        Vector3d end = ball.State.Position;
        Cases++;
        Inside.Case(deepest > Entered);
        Behind.Case(end.Y < 1.2 && ((kind is PressKind.Board or PressKind.Corner && end.Z < s_end.Z - Thick) || (kind == PressKind.Corner && end.X < s_side.X - Thick)));
    }

    /// <summary>Stops the player when he touches the object that the ball is pressed against.</summary>
    private void Stop(WalkingPlayer player)
    {
        Vector3d place = player.Place;
        Vector3d velocity = player.Velocity;
        double nearest = kind == PressKind.Net ? -6.7 : -5 + WalkingPlayer.Radius;
        if (kind == PressKind.Post)
        {
            player.Velocity = (place - s_foot).Length < WalkingPlayer.Radius + 0.06 ? Vector3d.Zero : velocity;
            return;
        }

        if (place.Z < nearest)
        {
            place = new Vector3d(place.X, 0, nearest);
            velocity = new Vector3d(velocity.X, 0, Math.Max(0, velocity.Z));
        }

        if (kind == PressKind.Corner && place.X < nearest)
        {
            place = new Vector3d(nearest, 0, place.Z);
            velocity = new Vector3d(Math.Max(0, velocity.X), 0, velocity.Z);
        }

        player.Place = place;
        player.Velocity = velocity;
    }

    /// <summary>Returns the scene, and adds its objects to the standing ones.</summary>
    private Scene Scene(StandingSolids standing, KinematicBodies bodies)
    {
        Scene scene = new() { Bodies = bodies };
        Obstacle End() => standing.Box("end", s_end, s_half, SurfaceMaterial.Board);
        return kind switch
        {
            PressKind.Board => scene with { Obstacles = [End()] },
            PressKind.Corner => scene with { Obstacles = [End(), standing.Box("side", s_side, new Vector3d(Thick, 0.5, 2000), SurfaceMaterial.Board)] },
            PressKind.Post => scene with { Obstacles = [standing.Rod("post", s_foot, s_tip, 0.06)] },
            _ => scene with { Goals = [new Goal { Center = s_foot, Facing = new Vector3d(0, 0, 1) }] },
        };
    }
}
