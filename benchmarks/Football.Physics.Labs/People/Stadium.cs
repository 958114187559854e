namespace FootballPhysics.Labs.People;

/// <summary>
/// A stadium closed by boards as high as a house: two goals with nets, flags, 22 players with human speed and acceleration, four swinging feet, an
/// engine's spheres. A match is a function of its seed alone. In the last third of each minute nobody touches the ball, and at its end all actors stand
/// still.
/// </summary>
internal sealed class Stadium
{
    public const double BallRadius = 0.11;
    public const int Players = 22;
    public const int Feet = 4;

    /// <summary>Half the width and half the length of the pitch, m, and how far behind the lines the boards stand.</summary>
    private const double HalfWidth = 34;
    private const double HalfLength = 52.5;
    private const double Behind = 4;
    private const double Thick = 0.05;
    private const double High = 60;

    private static readonly Vector3d s_footCenter = new(0, 0, -0.1);
    private static readonly Vector3d s_footHalf = new(0.05, 0.05, 0.15);

    private readonly SeededRandom _random;
    private readonly WalkingPlayer[] _players = new WalkingPlayer[Players];
    private readonly Vector3d[] _homes = new Vector3d[Players];
    private readonly double[] _waits = new double[Players];
    private readonly KinematicBody[] _feet = new KinematicBody[Feet];
    private readonly double[] _swings = new double[Feet];
    private readonly Quaterniond[] _turns = new Quaterniond[Feet];
    private readonly StandingSolids _standing = new();

    public Stadium(ulong seed)
    {
        _random = new SeededRandom(seed);
        var pitch = new Pitch { BoardHeight = High, BoardDistance = Behind, BoardHalfThickness = Thick };
        var flags = new List<Obstacle>();
        foreach ((int x, int z) in new[] { (-1, -1), (-1, 1), (1, -1), (1, 1) })
        {
            var foot = new Vector3d(x * HalfWidth, 0, z * HalfLength);
            flags.Add(_standing.Rod("flag", foot, new Vector3d(foot.X, 1.5, foot.Z), 0.025));
        }

        foreach (int end in new[] { -1, 1 })
        {
            _standing.Add(new Goal { Center = new Vector3d(0, 0, end * HalfLength), Facing = new Vector3d(0, 0, -end) });
            _standing.AddBox(new Vector3d(end * (HalfWidth + Behind + Thick), 0.5 * High, 0), new Vector3d(Thick, 0.5 * High, HalfLength + Behind + Thick));
            _standing.AddBox(new Vector3d(0, 0.5 * High, end * (HalfLength + Behind + Thick)), new Vector3d(HalfWidth + Behind + (2 * Thick), 0.5 * High, Thick));
        }

        var bodies = new KinematicBodies();
        for (int i = 0; i < Players; i++)
        {
            int side = i < 11 ? -1 : 1;
            int line = i % 11;
            _homes[i] = line == 0 ? new Vector3d(0, 0, side * 51) : new Vector3d((((line - 1) % 4) - 1.5) * 14, 0, side * (8 + ((line - 1) / 4 * 14)));
            _players[i] = new WalkingPlayer(bodies, FormattableString.Invariant($"player {i}"), line == 0 ? SurfaceMaterial.Glove : SurfaceMaterial.Boot)
            {
                Place = _homes[i] + (_random.Uniform(0, 2) * _random.Heading()),
            };
        }

        for (int i = 0; i < Feet; i++)
        {
            _feet[i] = bodies.Add(FormattableString.Invariant($"foot {i}"), new BoxShape(s_footCenter, s_footHalf), SurfaceMaterial.Boot);
        }

        Spheres = new StadiumSpheres(8, _random);
        Scene scene = pitch.On();
        Scene = scene with { Obstacles = [.. scene.Obstacles, .. flags], Bodies = bodies, EngineColliders = Spheres };
        Ball = new Ball(Scene);
        Ball.Place(new Vector3d(0, BallRadius, 0));
    }

    public Scene Scene { get; }

    public Ball Ball { get; }

    public StadiumSpheres Spheres { get; }

    public int Kicks { get; private set; }

    /// <summary>True if nobody is to touch the ball.</summary>
    public bool IsDead => Ball.Time % 60 > 38;

    /// <summary>True if the dead time is nearly over: an untouched ball has come to rest.</summary>
    public bool HasHadTime => Ball.Time % 60 > 57;

    /// <summary>Decides how every actor moves on, and whether one kicks.</summary>
    public (Vector3d Velocity, Vector3d Spin)? Decide(double duration)
    {
        Vector3d ball = Ball.State.Position;
        int ours = Nearest(0, ball);
        int theirs = Nearest(11, ball);
        for (int i = 0; i < Players; i++)
        {
            Run(i, i == ours || i == theirs, ball, duration);
            _waits[i] -= duration;
        }

        for (int k = 0; k < Feet; k++)
        {
            _swings[k] += duration * (k % 2 == 0 ? 5 : -7);
            double swing = (_swings[k] % 2) - 1;
            Vector3d beside = new(k % 2 == 0 ? -0.4 : 0.4, 0.12 + (0.1 * (k / 2)), 0);
            WalkingPlayer owner = _players[k < 2 ? ours : theirs];
            _turns[k] = new Quaterniond(swing * (1 - (swing * swing)), 0, 0, 1).Normalized();
            _feet[k].MoveTo(owner.Place + beside, _turns[k], owner.Velocity, new Vector3d(3, 0, 0), Ball.Time);
        }

        double first = (_players[ours].Place - ball).Horizontal.Length;
        double second = (_players[theirs].Place - ball).Horizontal.Length;
        int who = first < second ? ours : theirs;
        if (IsDead || Math.Min(first, second) >= 0.75 || _waits[who] > 0 || ball.Y >= 2.2)
        {
            return null;
        }

        _waits[who] = 0.6;
        Kicks++;
        return Kick(who < 11 ? 1 : -1, ball);
    }

    /// <summary>Sets all moving objects for the next step.</summary>
    public void Put()
    {
        foreach (WalkingPlayer player in _players)
        {
            player.Put(Ball.Time);
        }

        Spheres.Time = Ball.Time;
    }

    /// <summary>Moves all actors by a frame, after a step.</summary>
    public void Walk(double duration)
    {
        foreach (WalkingPlayer player in _players)
        {
            player.Walk(duration);
        }

        Spheres.Move(duration);
    }

    /// <summary>Returns the distance from the nearest standing surface, in closed form; negative inside.</summary>
    public double ToStanding(Vector3d place) => _standing.Distance(place);

    /// <summary>Returns the distance from the nearest moving surface, a time after the frame began.</summary>
    public double ToMoving(Vector3d place, double after)
    {
        double nearest = Spheres.Distance(place, after);
        foreach (WalkingPlayer player in _players)
        {
            nearest = Math.Min(nearest, player.Distance(place, after));
        }

        foreach (KinematicBody foot in _feet)
        {
            nearest = Math.Min(nearest, Solid.Box(place, foot.Position + (after * foot.Velocity), foot.Orientation, s_footCenter, s_footHalf));
        }

        return nearest;
    }

    /// <summary>True if a point is outside the boards, or above them.</summary>
    public static bool IsOutside(Vector3d place) => Math.Abs(place.X) > HalfWidth + Behind || Math.Abs(place.Z) > HalfLength + Behind || place.Y > High;

    /// <summary>True if a point is in a goal or close to one, where nets absorb and return energy of a ball.</summary>
    public static bool IsInGoal(Vector3d place) => Math.Abs(place.X) < 5 && Math.Abs(place.Z) > HalfLength - 1 && place.Y < 3.5;

    /// <summary>Returns the positions of all moving objects, for a later restore.</summary>
    public Placement Keep() => new(
        [.. _players.Select(player => (player.Place, player.Velocity))],
        [.. _feet.Select((foot, k) => (foot.Position, _turns[k], foot.Velocity, foot.Spin))],
        Spheres.Keep());

    /// <summary>Restores the positions of all moving objects at a time.</summary>
    public void Restore(Placement kept, double time)
    {
        for (int i = 0; i < Players; i++)
        {
            (_players[i].Place, _players[i].Velocity) = kept.Players[i];
            _players[i].Put(time);
        }

        for (int k = 0; k < Feet; k++)
        {
            (Vector3d place, Quaterniond turned, Vector3d velocity, Vector3d spin) = kept.Feet[k];
            _feet[k].MoveTo(place, turned, velocity, spin, time);
        }

        Spheres.Restore(kept.Spheres);
        Spheres.Time = time;
    }

    private int Nearest(int first, Vector3d ball) => Enumerable.Range(first + 1, 10).MinBy(i => (_players[i].Place - ball).Horizontal.Length);

    /// <summary>Moves a player towards his target, at most at 7 m/s² and 8 m/s.</summary>
    private void Run(int index, bool isNearest, Vector3d ball, double duration)
    {
        WalkingPlayer player = _players[index];
        Vector3d place = player.Place;
        Vector3d away = (place - ball).Horizontal;
        bool stands = IsDead && Ball.Time % 60 > 46;
        bool leaves = IsDead && !stands && away.Length < 6;
        int side = index < 11 ? -1 : 1;
        Vector3d goal = IsDead ? (leaves ? place + (3 / Math.Max(away.Length, 1e-6) * away) : place)
            : index % 11 == 0 ? new Vector3d(Math.Clamp(ball.X, -3.5, 3.5), 0, side * 51)
            : isNearest ? ball.Horizontal
            : _homes[index] + (0.35 * ball.Horizontal);
        Vector3d way = (goal - place).Horizontal;
        double far = way.Length;
        Vector3d wanted = stands || far < 1e-9 ? Vector3d.Zero : Math.Min(IsDead ? 4 : 8, 2.5 * far) / far * way;
        player.Accelerate(wanted, 7 * duration);
        player.Velocity = player.Velocity.Length < 1e-3 ? Vector3d.Zero : player.Velocity;
    }

    /// <summary>Draws a pass, a cross, a drive, a lob, a shot or a touch.</summary>
    private (Vector3d Velocity, Vector3d Spin) Kick(int towards, Vector3d ball)
    {
        Vector3d to = new Vector3d(_random.Uniform(-6, 6), 0, towards * HalfLength) - ball.Horizontal;
        Vector3d ahead = to.Length < 1 ? new Vector3d(0, 0, towards) : to.Normalized();
        Vector3d atGoal = new Vector3d(_random.Uniform(-4, 4), 0, (_random.Chance(0.5) ? -1 : 1) * HalfLength) - ball.Horizontal;
        Vector3d anywhere = _random.Heading();
        (double slow, double fast, double low, double high, Vector3d heading) = _random.Below(8) switch
        {
            0 => (3.0, 6.0, 0.0, 0.0, ahead),
            1 => (8, 18, 0, 8, anywhere),
            2 => (20, 30, 20, 50, anywhere),
            3 => (22, 36, 2, 20, ahead),
            4 => (15, 25, 0, 25, anywhere),
            5 => (10, 16, 45, 65, ahead),
            6 => (20, 34, 3, 14, atGoal.Length > 0.1 ? atGoal.Normalized() : ahead),
            _ => (1, 4, 0, 80, anywhere),
        };
        double speed = _random.Uniform(slow, fast);
        double elevation = _random.Uniform(low, high) * Math.PI / 180;
        double top = _random.Chance(0.4) ? 0 : _random.Uniform(-70, 70);
        double aside = _random.Chance(0.4) ? 0 : _random.Uniform(-70, 70);
        return (speed * ((Math.Cos(elevation) * heading) + new Vector3d(0, Math.Sin(elevation), 0)), new Vector3d(top * heading.Z, aside, -top * heading.X));
    }

    /// <summary>The positions and motions of all moving objects.</summary>
    internal sealed record Placement(
        (Vector3d Place, Vector3d Velocity)[] Players,
        (Vector3d Place, Quaterniond Turned, Vector3d Velocity, Vector3d Spin)[] Feet,
        (Vector3d[] Places, Vector3d[] Velocities) Spheres);
}
