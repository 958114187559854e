namespace FootballPhysics.Labs.Nets;

/// <summary>How a ball gets into a net.</summary>
internal enum NetPlay
{
    /// <summary>A player walks or runs through the net and pushes the ball in front of him.</summary>
    Walked,

    /// <summary>The ball is kicked into the net, and kicked again there.</summary>
    Kicked,

    /// <summary>One or two bodies press the ball into the net, hold it there, and go back.</summary>
    Pressed,
}

/// <summary>What became of a ball in nets.</summary>
/// <param name="Play">How the ball got into the net.</param>
/// <param name="Frames">The frames that ended in a net.</param>
/// <param name="AtEnd">Of these, the frames that ended at the end of a net.</param>
/// <param name="Pinned">The frames that ended with the ball pinned.</param>
/// <param name="Beyond">The largest distance beyond the give of a net at the end of a frame, m.</param>
/// <param name="Gain">The largest gain of the energy of ball and nets in a frame without a moving body near the ball, as a share.</param>
/// <param name="Rests">True if the ball came to rest after the bodies had gone.</param>
/// <param name="Stalled">The steps that reached their limit of work.</param>
/// <param name="First">The time of the first failure, and its kind; empty if there is none.</param>
internal sealed record NetOutcome(NetPlay Play, int Frames, int AtEnd, int Pinned, double Beyond, double Gain, bool Rests, long Stalled, string First)
{
    /// <summary>The distance within which a ball touches the end of a net, m.</summary>
    public const double Touching = 1e-9;

    /// <summary>The energy that a frame may gain by the error of the integrator, as a share.</summary>
    public const double Error = 1e-6;

    public bool Holds => Beyond <= Touching && Gain <= Error && Rests;
}

/// <summary>A random ball that is walked, kicked or pressed into the nets of a goal, or into a net at any angle.</summary>
internal sealed class NetDraw
{
    private const double LongestPlay = 8;

    /// <summary>The longest time until the ball rests, s: a heavy ball that spins in a net.</summary>
    private const double LongestRest = 1000;

    /// <summary>A body whose surface is nearer than this after a frame may do work in the frame, m.</summary>
    private const double Near = 0.05;

    private readonly SeededRandom _random;
    private readonly NetPlay _play;
    private readonly Scene _scene;
    private readonly Net[] _nets;
    private readonly Net _target;
    private readonly Pusher[] _pushers;
    private readonly Simulator _simulator;
    private readonly double _step;
    private readonly double _weight;
    private readonly StepLog _log = new();
    private BallState _state;
    private int _frames;
    private int _atEnd;
    private int _pinned;
    private double _beyond;
    private double _gain;
    private long _stalled;
    private string _first = "";

    private NetDraw(SeededRandom random)
    {
        _random = random;
        _play = random.Any(NetPlay.Walked, NetPlay.Kicked, NetPlay.Pressed);
        BallProperties[] presets = [.. BallProperties.Presets.Values];
        BallProperties ball = presets[random.Below(presets.Length)] with { KnuckleForce = 0 };
        Scene profile = random.Chance(0.3) ? Scene.Published : new Scene();
        profile = profile with
        {
            Ball = random.Chance(0.1) ? ball with { Mass = random.Log(0.1, 20), Radius = random.Log(0.02, 0.2) } : ball,
            Ground = random.Chance(0.3) ? Ground.Of(random.Any(SurfaceMaterial.WetTurf, SurfaceMaterial.Concrete, SurfaceMaterial.Indoor)) : profile.Ground,
        };
        _pushers = _play == NetPlay.Kicked ? [] : [.. Enumerable.Range(0, _play == NetPlay.Pressed && random.Chance(0.4) ? 2 : 1).Select(_ => new Pusher(random))];
        var bodies = new KinematicBodies();
        for (int i = 0; i < _pushers.Length; i++)
        {
            _pushers[i].Body = bodies.Add($"body {i}", _pushers[i].Shape, SurfaceMaterial.Boot, random.Chance(0.7) ? double.PositiveInfinity : random.Uniform(1.9, 90));
        }

        bool goal = random.Chance(0.6);
        _scene = profile with
        {
            Goals = goal ? [new Goal { Center = Vector3d.Zero, Facing = new Vector3d(0, 0, 1) }] : [],
            Nets = goal ? [] : [Draw(random)],
            Bodies = _pushers.Length > 0 ? bodies : null,
        };
        _nets = [.. _scene.Nets, .. _scene.Goals.SelectMany(item => item.Nets())];
        _target = _nets[random.Below(_nets.Length)];
        _simulator = new Simulator(_scene, new SolverSettings { Integrator = random.Any(Integrator.Rk4, Integrator.Rk4, Integrator.Rk2) });
        _step = random.Any(1 / 30.0, 1 / 60.0, 1 / 60.0, 1 / 100.0, 1 / 144.0);
        _weight = -_scene.Ball.Mass * FootballPhysics.Scenes.Weight.UpwardAcceleration(_scene);
    }

    /// <summary>Draws and plays a ball.</summary>
    /// <param name="seed">The seed of all balls.</param>
    /// <param name="index">The number of the ball.</param>
    public static NetOutcome Play(long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));

        // The first numbers of neighbouring seeds are not independent.
        random.Next();
        return new NetDraw(random).Play();
    }

    /// <summary>Draws a net of any size, at any angle.</summary>
    private static Net Draw(SeededRandom random)
    {
        Vector3d normal = random.Chance(0.5) ? random.Heading() : random.Chance(0.5) ? Vector3d.Up : random.Direction();
        Vector3d along = Vector3d.Cross(normal, random.Direction()).Normalized();
        double half = random.Uniform(0.5, 3);
        return new Net
        {
            Center = new Vector3d(random.Uniform(-2, 2), random.Uniform(0.3, 2.5), random.Uniform(-2, 2)),
            Normal = normal,
            Along = along,
            HalfLength = half,
            HalfWidth = random.Uniform(0.3, 1) * half,
            Give = random.Chance(0.3) ? 0.6 : random.Log(0.05, 2),
            Stiffness = random.Chance(0.3) ? 400 : random.Log(50, 5000),
            Damping = random.Chance(0.3) ? 1.5 : random.Uniform(0.3, 5),
            TangentialDamping = random.Chance(0.3) ? 60 : random.Uniform(5, 300),
            SpinDamping = random.Chance(0.3) ? 0.02 : random.Uniform(0.01, 0.1),
        };
    }

    private NetOutcome Play()
    {
        Start();
        while (_state.Time < LongestPlay && Array.Exists(_pushers, pusher => !pusher.IsGone))
        {
            Frame();
        }

        int kicks = _play == NetPlay.Kicked ? 1 + _random.Below(4) : _random.Below(2);
        for (int i = 0; i < kicks; i++)
        {
            // Mostly deeper into the net, at speeds that no shot has.
            Vector3d way = _random.Chance(0.7) ? PlaceOn(_target) - _state.Position : _random.Direction();
            _simulator.Kick(ref _state, _random.Log(2, 300) * way.Normalized(), _random.Uniform(0, 80) * _random.Direction());
            for (double until = _state.Time + _random.Log(0.1, 3); _state.Time < until;)
            {
                Frame();
            }
        }

        for (double until = _state.Time + LongestRest; _state.Time < until && _state.Motion != MotionState.Rest;)
        {
            Frame();
        }

        bool rests = _state.Motion == MotionState.Rest;
        Note(!rests, "no rest");
        return new NetOutcome(_play, _frames, _atEnd, _pinned, _beyond, _gain, rests, _stalled, _first);
    }

    /// <summary>Puts the ball in front of the net, with a player behind it, or on the net with a body next to it.</summary>
    private void Start()
    {
        double r = _scene.Ball.Radius;
        Vector3d place = PlaceOn(_target);
        Vector3d off = (_random.Chance(0.5) ? 1 : -1) * _target.Normal.Normalized();
        Vector3d at = place + (_random.Uniform(0.2, 4) * off) + (_random.Uniform(0, 2) * _random.Direction());
        if (_play == NetPlay.Pressed)
        {
            at = place + (_random.Uniform(0, 1) * r * off);
        }
        else if (_play == NetPlay.Walked)
        {
            at = place + (_random.Uniform(0.3, 1.5) * _random.Heading());
            at = new Vector3d(at.X, r, at.Z);
        }

        _state = _simulator.Launch(new Vector3d(at.X, Math.Max(r, at.Y), at.Z), default, default);
        for (int i = 0; i < _pushers.Length; i++)
        {
            Vector3d way = _play == NetPlay.Walked ? (place - at).Horizontal.Normalized()
                : ((i == 0 ? -1 : 1) * off + (0.4 * _random.Direction())).Normalized();
            _pushers[i].Begin(_state.Position, way, r, _play);
        }
    }

    private Vector3d PlaceOn(Net net)
    {
        Vector3d along = net.Along.Normalized();
        Vector3d across = Vector3d.Cross(net.Normal.Normalized(), along);
        return net.Center + (_random.Uniform(-0.9, 0.9) * net.HalfLength * along) + (_random.Uniform(-0.9, 0.9) * net.HalfWidth * across);
    }

    private void Frame()
    {
        bool works = false;
        foreach (Pusher pusher in _pushers)
        {
            pusher.MoveTo(in _state, _step);
            works |= pusher.DistanceTo(_state.Position) - _scene.Ball.Radius < Near + (_step * (pusher.Speed + _state.Velocity.Length));
        }

        BallState before = _state;
        _log.Clear();
        _simulator.Step(ref _state, _step, _log);
        foreach (Pusher pusher in _pushers)
        {
            pusher.Advance(_step);
            works |= pusher.DistanceTo(_state.Position) - _scene.Ball.Radius < Near;
        }

        _stalled += _log.StalledSteps;
        _pinned += _state.Motion == MotionState.Pinned ? 1 : 0;
        Look();
        if (!works)
        {
            CompareEnergy(in before);
        }
    }

    /// <summary>Compares the depth in each net with the net's give.</summary>
    private void Look()
    {
        double most = double.NegativeInfinity;
        for (int i = 0; i < _nets.Length; i++)
        {
            if ((_state.Nets >> i & 1) != 0)
            {
                most = Math.Max(most, Depth(in _state, i) - _nets[i].Give);
            }
        }

        _frames += most > double.NegativeInfinity ? 1 : 0;
        _atEnd += most > -NetOutcome.Touching ? 1 : 0;
        _beyond = Math.Max(_beyond, most);
        Note(most > NetOutcome.Touching, "beyond the give");
    }

    /// <summary>Compares the energy of ball and nets before and after a frame. A ball that enters a net over its edge is deep in it at once: this depth is no gain.</summary>
    private void CompareEnergy(in BallState before)
    {
        double stretched = 0;
        foreach (BallEvent happened in _log.Events.Span)
        {
            if (happened.Kind == BallEventKind.Net)
            {
                Vector3d place = happened.Position;
                Net net = _nets[Array.FindIndex(_nets, item => item.Name == _simulator.NameOf(happened.ColliderIndex))];
                double depth = Math.Max(0, _scene.Ball.Radius - Vector3d.Dot(place - net.Center, happened.Normal));
                stretched += 0.5 * net.Stiffness * depth * depth;
            }
        }

        double energy = Energy(in before);
        double gain = (Energy(in _state) - energy - stretched) / (1 + energy);
        _gain = Math.Max(_gain, gain);
        Note(gain > NetOutcome.Error, "energy");
    }

    /// <summary>Returns ½ m v² + ½ I ω² + m g y + Σ ½ k δ², J.</summary>
    private double Energy(in BallState s)
    {
        double energy = (0.5 * ((_scene.Ball.Mass * s.Velocity.LengthSquared) + (_scene.Ball.MomentOfInertia * s.Spin.LengthSquared))) + (_weight * s.Position.Y);
        for (int i = 0; i < _nets.Length; i++)
        {
            double depth = (s.Nets >> i & 1) != 0 ? Math.Max(0, Depth(in s, i)) : 0;
            energy += 0.5 * _nets[i].Stiffness * depth * depth;
        }

        return energy;
    }

    /// <summary>Returns δ = r − σ (p − c)·n, m.</summary>
    private double Depth(in BallState s, int net)
    {
        double side = (s.NetSides >> net & 1) != 0 ? 1 : -1;
        return _scene.Ball.Radius - (side * Vector3d.Dot(s.Position - _nets[net].Center, _nets[net].Normal.Normalized()));
    }

    private void Note(bool failed, string what)
    {
        if (failed && _first.Length == 0)
        {
            _first = FormattableString.Invariant($"{what} at {_state.Time:0.000} s, {_state}");
        }
    }
}
