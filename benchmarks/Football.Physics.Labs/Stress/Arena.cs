using FootballPhysics.Labs.People;
using FootballPhysics.Labs.Stability;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Stress;

/// <summary>
/// A closed hall, drawn from a seed: boards as high as a house, two goals with nets, posts and boxes, players who run at the ball, light cones, an
/// engine's spheres, wind, one to five balls. Its actors move only between steps, so that a match is a function of the seed and the frames.
/// </summary>
internal sealed class Arena
{
    private const double High = 100;
    private const double Thick = 0.05;
    private const double PlayerMass = 75;

    /// <summary>Players that run at 8 m/s brake within this distance, m.</summary>
    private const double Near = 0.15;

    private readonly SeededRandom _random;
    private readonly StandingSolids _standing = new();
    private readonly WalkingPlayer[] _players;
    private readonly Vector3d[] _homes;
    private readonly KinematicBody[] _cones;
    private readonly StadiumSpheres _spheres;
    private readonly bool _spheresStand;
    private readonly ArenaKicks _kicks;
    private readonly BallGroup? _group;
    private readonly double _halfWidth;
    private readonly double _halfLength;
    private readonly double _crowd;
    private readonly bool _leaves;

    public Arena(ulong seed)
    {
        _random = new SeededRandom(seed);
        bool large = _random.Chance(0.2);
        Pitch pitch = (large ? Pitch.Standard : Pitch.Futsal) with { BoardHeight = High, BoardHalfThickness = Thick, BoardDistance = _random.Any(large ? 4 : 1.5, 3.0) };
        _halfWidth = (0.5 * pitch.Width) + pitch.BoardDistance;
        _halfLength = (0.5 * pitch.Length) + pitch.BoardDistance;
        foreach (int end in new[] { -1, 1 })
        {
            _standing.AddBox(new Vector3d(end * (_halfWidth + Thick), 0.5 * High, 0), new Vector3d(Thick, 0.5 * High, _halfLength + (2 * Thick)));
            _standing.AddBox(new Vector3d(0, 0.5 * High, end * (_halfLength + Thick)), new Vector3d(_halfWidth + (2 * Thick), 0.5 * High, Thick));
        }

        foreach (Goal goal in pitch.Goals)
        {
            _standing.Add(goal);
        }

        var bodies = new KinematicBodies();
        bool weighs = _random.Chance(0.5);
        _players = new WalkingPlayer[_random.Below(11)];
        _homes = new Vector3d[_players.Length];
        for (int i = 0; i < _players.Length; i++)
        {
            _homes[i] = Somewhere(1);
            _players[i] = new WalkingPlayer(bodies, FormattableString.Invariant($"player {i}"), null, weighs && i % 2 == 0 ? PlayerMass : double.PositiveInfinity) { Place = _homes[i] };
        }

        _cones = new KinematicBody[_random.Below(4)];
        for (int i = 0; i < _cones.Length; i++)
        {
            _cones[i] = bodies.Add(FormattableString.Invariant($"cone {i}"), BodyKind.Cone with { Mass = _random.Log(0.3, 30) });
            _cones[i].MoveTo(Somewhere(2), Vector3d.Zero, 0);
        }

        bool sphereWeighs = _random.Chance(0.3);
        int spheres = _random.Chance(0.5) ? 1 + _random.Below(6) : 0;
        _spheres = new StadiumSpheres(spheres, _random, _halfWidth, _halfLength, spheres > 0 && sphereWeighs ? _random.Log(0.5, 50) : double.PositiveInfinity);
        _spheresStand = !sphereWeighs;
        Scene scene = pitch.On(AnyAir());
        List<Obstacle> obstacles = Obstacles();
        _kicks = new ArenaKicks(_random, 0.5 * pitch.Width, 0.5 * pitch.Length, pitch.Goal);
        int balls = _random.Chance(0.4) ? 1 : 1 + _random.Below(5);
        bool isGroup = balls > 1 || _random.Chance(0.3);
        Scene = scene with { Obstacles = [.. scene.Obstacles, .. obstacles], Bodies = bodies, EngineColliders = spheres > 0 || isGroup ? _spheres : null };
        Simulator = new Simulator(Scene);
        Radius = Scene.Ball.Radius;
        _group = isGroup ? new BallGroup(Simulator, balls) : null;
        Balls = new BallState[balls];
        for (int i = 0; i < balls; i++)
        {
            Balls[i] = Simulator.Launch(Free(i), Vector3d.Zero, Vector3d.Zero);
        }

        _crowd = _random.Chance(0.5) ? Near : _random.Uniform(0.3, 3);
        _leaves = _random.Chance(0.5);
    }

    public Scene Scene { get; }

    public Simulator Simulator { get; }

    /// <summary>The radius of the balls, m.</summary>
    public double Radius { get; }

    /// <summary>The current states of the balls.</summary>
    public BallState[] Balls { get; }

    /// <summary>True if the balls are stepped as a group.</summary>
    public bool IsGroup => _group is not null;

    /// <summary>True if the wind is steady, so that a ball comes to rest.</summary>
    public bool MustRest => Scene.Air.WindField is null;

    /// <summary>True if the wind along a direction drives a ball on grass for minutes at a few centimetres a second, which is not a fault.</summary>
    public bool Drives(Vector3d direction) => Vector3d.Dot(Scene.Air.Wind, direction) is > 4 and < 9;

    public double Time => Balls[0].Time;

    /// <summary>Returns the distance of a point from the objects that never move, in closed form.</summary>
    public double ToStanding(Vector3d point) =>
        Math.Min(_standing.Distance(point), _spheresStand ? _spheres.ToStanding(point) : double.PositiveInfinity);

    /// <summary>True if a point is behind a board, or above them.</summary>
    public bool IsOutside(Vector3d point) => Math.Abs(point.X) > _halfWidth || Math.Abs(point.Z) > _halfLength || point.Y > High;

    /// <summary>Returns a kick if a ball is kicked before a frame of this length, on average every 0.7 s, and null otherwise.</summary>
    public (Vector3d Velocity, Vector3d Spin)? Decide(int ball, double frame) =>
        _random.Chance(1 - Math.Exp(-frame / 0.7)) ? _kicks.Draw(Balls[ball].Position) : null;

    public void Kick(int ball, Vector3d velocity, Vector3d spin) => SimulatorOf(ball).Kick(ref Balls[ball], velocity, spin);

    /// <summary>Moves all actors to the time of the balls.</summary>
    public void Put()
    {
        foreach (WalkingPlayer player in _players)
        {
            player.Put(Time);
        }

        foreach (KinematicBody cone in _cones)
        {
            cone.MoveTo(cone.Position, cone.Velocity, Time);
        }

        _spheres.Time = Time;
    }

    /// <summary>Steps all balls once.</summary>
    public void Step(double frame, StepLog log)
    {
        _spheres.Begin();
        if (_group is not null)
        {
            _group.Step(Balls, frame, log);
        }
        else
        {
            Simulator.Step(ref Balls[0], frame, log);
        }
    }

    /// <summary>Returns the motions of the bodies, which pushes change, for a later restore.</summary>
    public RigidMotion[] Keep() => [.. Scene.Bodies!.Select(body => body.Motion)];

    /// <summary>Restores the motions of the bodies.</summary>
    public void Restore(RigidMotion[] kept)
    {
        for (int i = 0; i < kept.Length; i++)
        {
            Scene.Bodies![i].Motion = kept[i];
        }
    }

    /// <summary>Computes the paths of all balls in one step of this length.</summary>
    public void LookAhead(double frame, Trajectory[] into) => LookAhead(frame, into, 1.5 * frame);

    /// <summary>Computes the paths of all balls for a duration.</summary>
    public void LookAhead(double step, Trajectory[] into, double duration)
    {
        _spheres.Begin();
        var request = new LookAheadRequest { TimeStep = step, Duration = duration, StopAt = StopAt.Time };
        if (_group is not null)
        {
            _group.LookAhead(Balls, request, into);
        }
        else
        {
            Simulator.LookAhead(in Balls[0], request, into[0]);
        }
    }

    /// <summary>Moves the actors by a frame, while the match is on.</summary>
    public void Walk(double frame)
    {
        for (int i = 0; i < _players.Length; i++)
        {
            _players[i].Walk(frame);
            Vector3d ball = Balls[i % Balls.Length].Position.Horizontal;
            Vector3d goal = i % 3 == 2 ? _homes[i] + (0.35 * ball) : ball;
            Run(_players[i], goal, i % 3 == 2 ? 0 : _crowd, frame);
        }

        MoveRest(frame);
    }

    /// <summary>Moves the actors by a frame after the match: players stop where they are, or leave the balls first.</summary>
    public void Leave(double frame, double since)
    {
        foreach (WalkingPlayer player in _players)
        {
            player.Walk(frame);
            Vector3d away = Vector3d.Zero;
            foreach (BallState ball in Balls)
            {
                Vector3d apart = (player.Place - ball.Position).Horizontal;
                away += apart.Length < 1 ? apart / Math.Max(apart.Length, 1e-6) : Vector3d.Zero;
            }

            player.Velocity = _leaves && since < 3 ? 3 * away : Vector3d.Zero;
        }

        MoveRest(frame);
        _spheres.Stop();
    }

    private void MoveRest(double frame)
    {
        // The grass brakes a cone that the ball has pushed.
        foreach (KinematicBody cone in _cones)
        {
            Vector3d v = cone.Velocity.Horizontal;
            double kept = Math.Max(0, v.Length - (4 * frame)) / Math.Max(v.Length, 1e-9);
            cone.MoveTo((cone.Position + (frame * v)).Horizontal, kept * v, Time);
        }

        _spheres.Move(frame);
    }

    private static void Run(WalkingPlayer player, Vector3d to, double stops, double frame)
    {
        Vector3d way = (to - player.Place).Horizontal;
        double far = way.Length - stops;
        Vector3d wanted = far > 0 ? Math.Min(8, 4 * far) / way.Length * way : Vector3d.Zero;
        player.Accelerate(wanted, 9 * frame);
    }

    private Simulator SimulatorOf(int ball) => _group?.SimulatorOf(ball) ?? Simulator;

    private Scene AnyAir()
    {
        // A wind between 4 and 9 m/s drives a ball: see Drives.
        double speed = _random.Any(0, 0, _random.Uniform(0, 4), _random.Uniform(9, 12));
        Vector3d along = _random.Any(_random.Heading(), new Vector3d(1, 0, 0), new Vector3d(0, 0, -1));
        bool gusts = speed > 0 && _random.Chance(0.2);
        var air = new Air { Wind = gusts ? Vector3d.Zero : speed * along, WindField = gusts ? new WindByHeight(speed, along.X, along.Z, gusts: new Gusts { Seed = _random.Below(1000) }) : null };
        ForceSet forces = _random.Chance(0.2) ? ForceSet.Measured with { KnuckleSeed = _random.Below(1000) } : ForceSet.Measured;
        return Scene.Default with { Air = air, Forces = forces };
    }

    private List<Obstacle> Obstacles()
    {
        var all = new List<Obstacle>();
        for (int i = _random.Below(5); i > 0; i--)
        {
            Vector3d foot = Somewhere(2);
            if (_random.Chance(0.5))
            {
                var half = new Vector3d(_random.Uniform(0.05, 1), _random.Uniform(0.1, 1), _random.Uniform(0.05, 1));
                Vector3d center = foot + new Vector3d(0, half.Y, 0);
                all.Add(_standing.Box("box", center, half, SurfaceMaterial.Wood));
            }
            else
            {
                Vector3d tip = foot + new Vector3d(_random.Uniform(-0.5, 0.5), _random.Uniform(0.5, 2), _random.Uniform(-0.5, 0.5));
                all.Add(_standing.Rod("rod", foot, tip, _random.Uniform(0.02, 0.2)));
            }
        }

        return all;
    }

    private Vector3d Somewhere(double margin) =>
        new(_random.Uniform(margin - _halfWidth, _halfWidth - margin), 0, _random.Uniform(margin - _halfLength, _halfLength - margin));

    /// <summary>Returns a position at which a ball touches neither standing objects nor players, cones or the balls before it.</summary>
    private Vector3d Free(int index)
    {
        while (true)
        {
            Vector3d at = Somewhere(0.5) + new Vector3d(0, _random.Chance(0.5) ? Radius : _random.Uniform(Radius, 2), 0);
            bool isFree = ToStanding(at) >= Radius && _spheres.Distance(at, 0) > Radius && Balls.Take(index).All(ball => (ball.Position - at).Length > 3 * Radius)
                && _players.All(player => player.Distance(at, 0) > Radius) && _cones.All(cone => (cone.Position - at).Horizontal.Length > 1);
            if (isFree)
            {
                return at;
            }
        }
    }
}

/// <summary>Draws the kicks of an arena: at goals, into nets and corners, touches, lobs, and launches of hostile scenes at speeds of a game.</summary>
internal sealed class ArenaKicks(SeededRandom random, double halfWidth, double halfLength, Goal goal)
{
    private const double Fastest = 45;

    /// <summary>The spin of a hostile launch is cut to this size, rad/s.</summary>
    private const double MostSpin = 200;

    /// <summary>A kick of a ball at a position.</summary>
    public (Vector3d Velocity, Vector3d Spin) Draw(Vector3d ball)
    {
        double end = random.Chance(0.5) ? -1 : 1;
        Vector3d spin = random.Chance(0.4) ? Vector3d.Zero : random.Uniform(0, 80) * random.Direction();
        return random.Below(8) switch
        {
            0 or 1 => (At(ball, new Vector3d(random.Uniform(-0.7, 0.7) * goal.Width, random.Uniform(0.11, 1.2) * goal.Height, end * halfLength), random.Uniform(4, 36)), spin),
            2 => (At(ball, new Vector3d((random.Chance(0.5) ? -1 : 1) * halfWidth, 0.11, end * halfLength), random.Uniform(2, 30)), spin),
            3 => (At(ball, new Vector3d((random.Chance(0.5) ? -0.5 : 0.5) * goal.Width, random.Uniform(0.11, goal.Height), end * halfLength), random.Uniform(3, 30)), spin),
            4 => (random.Uniform(0.1, 4) * random.Heading(), spin),
            5 => (random.Velocity(6, 20, 30, 75), spin),
            6 => Hostile(),
            _ => (random.Uniform(0.5, 25) * random.Direction(), spin),
        };
    }

    private static Vector3d At(Vector3d ball, Vector3d target, double speed)
    {
        Vector3d way = target - ball;
        double lift = way.Length > 1 ? Math.Min(8, 0.5 * 9.81 * way.Length / speed) : 0;
        return (speed / Math.Max(way.Length, 0.1) * way) + new Vector3d(0, target.Y > 0.2 ? lift : 0, 0);
    }

    private (Vector3d Velocity, Vector3d Spin) Hostile()
    {
        StressScene scene = HostileGenerator.Make((ulong)random.Below(int.MaxValue));
        return (Cut(scene.Velocity, Fastest), Cut(scene.Spin, MostSpin));
    }

    private static Vector3d Cut(Vector3d vector, double most) => vector.Length > most ? most / vector.Length * vector : vector;
}
