namespace FootballPhysics.Labs.Forces;

/// <summary>A custom force whose path has a closed form.</summary>
internal enum ForceKind
{
    /// <summary>−m λ v.</summary>
    Damping,

    /// <summary>−m ω² (p − c), in half of the plays with weight.</summary>
    Spring,

    /// <summary>A spring with a damping below the critical one.</summary>
    DampedSpring,

    /// <summary>−m k |v| v, with λ = k v at the start.</summary>
    SquareDamping,

    /// <summary>The torque −I λ ω.</summary>
    SpinDamping,

    /// <summary>A spring that acts only beyond a plane, and returns the ball.</summary>
    Cord,

    /// <summary>A damping that acts only beyond a plane.</summary>
    Water,
}

/// <summary>The error of a ball under a custom force, after one second.</summary>
/// <param name="Kind">The force.</param>
/// <param name="Stiffness">Its rate, 1/s.</param>
/// <param name="Error">The largest error of the steps, alone and in a group, m; NaN if the motion is not finite.</param>
/// <param name="LookError">The largest error of look-aheads with the default step and with the step of the game, m.</param>
/// <param name="Stiff">The steps that the log counts as stiff.</param>
/// <param name="LookStiff">Those of the look-aheads.</param>
/// <param name="Evaluations">The evaluations per step.</param>
/// <param name="Pieces">The segments of the default look-ahead.</param>
internal sealed record ForceOutcome(ForceKind Kind, double Stiffness, double Error, double LookError, long Stiff, long LookStiff, double Evaluations, int Pieces)
{
    /// <summary>The largest error after one second, m.</summary>
    public const double Largest = 0.003;

    /// <summary>The stiffness up to which every step is right and none is reported, 1/s.</summary>
    public const double Followed = 300;

    public bool Holds => Stiffness <= Followed
        ? Error <= Largest && LookError <= Largest && Stiff + LookStiff == 0
        : double.IsFinite(Error + LookError) && (Error <= Largest || Stiff > 0) && (LookError <= Largest || LookStiff > 0);
}

/// <summary>A random custom force, and a ball under it.</summary>
internal sealed class ForceDraw
{
    private const int GroupEvery = 4;

    /// <summary>The distance beyond which the force ends, m: the other ball of a group is farther away.</summary>
    private const double Apart = 1000;

    /// <summary>The games' rates, in Hz.</summary>
    private static readonly double[] s_rates = [30, 60, 100];

    private readonly ForceKind _kind;
    private readonly double _stiffness;
    private readonly double _rate;
    private readonly double _mass;
    private readonly double _inertia;
    private readonly Vector3d _center;
    private readonly Vector3d _normal;
    private readonly Vector3d _weight;
    private readonly double _damping;
    private readonly Vector3d _from;
    private readonly Vector3d _velocity;
    private readonly Vector3d _spin;
    private readonly Scene _scene;

    private ForceDraw(SeededRandom random, ForceKind kind, double low, double high)
    {
        _kind = kind;
        _stiffness = random.Log(low, high);
        _rate = random.Any<double>(s_rates);
        var ball = new BallProperties { Mass = random.Uniform(0.2, 1), Radius = 0.11 };
        _mass = ball.Mass;
        _inertia = ball.MomentOfInertia;
        _normal = random.Direction();
        _center = random.Uniform(0, 3) * random.Direction();
        bool weighs = kind == ForceKind.Spring && random.Chance(0.5);
        _weight = weighs ? new Vector3d(0, -9.81, 0) : Vector3d.Zero;
        _damping = kind == ForceKind.DampedSpring ? random.Uniform(0.05, 0.9) * _stiffness : 0;
        double speed = random.Uniform(1, 30);
        double depth = random.Uniform(0.02, 0.9) * speed;
        bool swings = kind is ForceKind.Spring or ForceKind.DampedSpring;
        bool crosses = kind is ForceKind.Cord or ForceKind.Water;
        Vector3d across = LabMath.Along(random.Direction(), _normal);
        _from = swings ? _center + (random.Uniform(0.05, 0.5) * random.Direction()) : crosses ? _center - (depth * _normal) + across : _center;
        _velocity = swings ? random.Uniform(0, Math.Min(0.3 * _stiffness, 50)) * random.Direction() : crosses ? (speed * _normal) + (3.0 * across) : speed * random.Direction();
        _spin = kind == ForceKind.SpinDamping ? random.Uniform(1, 100) * random.Direction() : Vector3d.Zero;
        _scene = new Scene
        {
            Ball = ball,
            Gravity = weighs ? 9.81 : 0,
            Air = new Air { Density = 0 },
            Ground = Ground.None,
            Forces = ForceSet.None with { CustomForces = [kind == ForceKind.SpinDamping ? new Brake(_inertia * _stiffness) : IForce.From(Force)] },
        };
    }

    /// <summary>Plays one force for one second.</summary>
    public static ForceOutcome Play(long seed, long index, double low, double high)
    {
        ForceKind[] kinds = Enum.GetValues<ForceKind>();
        return new ForceDraw(new SeededRandom(SeededRandom.Mix(seed, index)), kinds[index % kinds.Length], low, high).Play(index / kinds.Length % GroupEvery == 0);
    }

    private ForceOutcome Play(bool alsoInGroup)
    {
        var simulator = new Simulator(_scene);
        BallState start = simulator.Launch(_from, _velocity, _spin);
        BallState state = start;
        var log = new StepLog();
        for (int i = 0; i < _rate; i++)
        {
            simulator.Step(ref state, 1.0 / _rate, log);
        }

        double error = ErrorOf(in state);
        var path = new Trajectory(1 << 16);
        simulator.LookAhead(in start, new LookAheadRequest { Duration = 1 }, path);
        long stiff = path.StiffSteps;
        double lookError = ErrorOf(path.Final);
        var inSteps = new Trajectory(1 << 16);
        simulator.LookAhead(in start, new LookAheadRequest { Duration = 1, TimeStep = 1.0 / _rate }, inSteps);
        stiff += inSteps.StiffSteps;
        lookError = Larger(lookError, Vector3d.Distance(inSteps.PositionAt(1), state.Position), ErrorOf(inSteps.Final));
        long ofGroup = 0;
        if (alsoInGroup)
        {
            error = Larger(error, GroupError(simulator, out ofGroup), 0);
        }

        return new ForceOutcome(_kind, _stiffness, error, lookError, log.StiffSteps + ofGroup, stiff, log.Evaluations / _rate, path.Pieces.Length);
    }

    /// <summary>Returns the error of the ball in a group, with another ball far away.</summary>
    private double GroupError(Simulator simulator, out long stiff)
    {
        var group = new BallGroup(_scene, [_scene.Ball, _scene.Ball]);
        BallState[] states = [simulator.Launch(_from, _velocity, _spin), simulator.Launch(_from + new Vector3d(2 * Apart, 0, 0), Vector3d.Zero, Vector3d.Zero)];
        var log = new StepLog();
        for (int i = 0; i < _rate; i++)
        {
            group.Step(states, 1.0 / _rate, log);
        }

        stiff = log.StiffSteps;
        return ErrorOf(in states[0]);
    }

    private static double Larger(double a, double b, double c) => double.IsNaN(a + b + c) ? double.NaN : Math.Max(a, Math.Max(b, c));

    /// <summary>Returns the error of a ball after one second, m. That of a rotation is at the surface.</summary>
    private double ErrorOf(in BallState state)
    {
        if (_kind != ForceKind.SpinDamping)
        {
            return Vector3d.Distance(state.Position, After(1));
        }

        double rate = _spin.Length;
        Quaterniond right = Quaterniond.FromAxisAngle(_spin / rate, rate * Approach(1));
        Quaterniond turned = state.Orientation;
        double same = (right.X * turned.X) + (right.Y * turned.Y) + (right.Z * turned.Z) + (right.W * turned.W);
        return 2.0 * _scene.Ball.Radius * Math.Sqrt(Math.Max(0, 1.0 - (same * same)));
    }

    private double Approach(double t) => (1.0 - Math.Exp(-_stiffness * t)) / _stiffness;

    private Vector3d Force(ForceContext ball)
    {
        Vector3d away = ball.Position - _center;
        double w = _stiffness;
        Vector3d v = ball.Velocity;
        bool beyond = Vector3d.Dot(away, _normal) > 0;
        return away.Length > Apart ? Vector3d.Zero : _mass * _kind switch
        {
            ForceKind.Damping => -w * v,
            ForceKind.Spring => -(w * w) * away,
            ForceKind.DampedSpring => (-(w * w) * away) - (2.0 * _damping * v),
            ForceKind.SquareDamping => -(w / _velocity.Length) * v.Length * v,
            ForceKind.Cord => beyond ? -(w * w) * Vector3d.Dot(away, _normal) * _normal : Vector3d.Zero,
            ForceKind.Water => beyond ? -w * v : Vector3d.Zero,
            _ => throw new InvalidOperationException($"{_kind} is no force"),
        };
    }

    /// <summary>The closed form of the position.</summary>
    private Vector3d After(double t)
    {
        double w = _stiffness;
        double normal = Vector3d.Dot(_velocity, _normal);
        double entry = Vector3d.Dot(_center - _from, _normal) / normal;
        double exit = entry + (Math.PI / w);
        switch (_kind)
        {
            case ForceKind.Damping:
                return _from + (Approach(t) * _velocity);
            case ForceKind.Spring:
                Vector3d middle = _center + (_weight / (w * w));
                return middle + (Math.Cos(w * t) * (_from - middle)) + (Math.Sin(w * t) / w * _velocity);
            case ForceKind.DampedSpring:
                double swing = Math.Sqrt((w * w) - (_damping * _damping));
                Vector3d out0 = _from - _center;
                return _center + (Math.Exp(-_damping * t) * ((Math.Cos(swing * t) * out0) + (Math.Sin(swing * t) / swing * (_velocity + (_damping * out0)))));
            case ForceKind.SquareDamping:
                return _from + (Math.Log(1.0 + (w * t)) / w * _velocity);
            case ForceKind.Cord:
                double beyond = t <= exit ? (Math.Sin(w * (t - entry)) / w * normal) : -(t - exit) * normal;
                Vector3d along = _from + (t * (_velocity - (normal * _normal)));
                return along + (((normal * entry) + beyond) * _normal);
            case ForceKind.Water:
                return _from + ((entry + Approach(t - entry)) * _velocity);
            default:
                throw new InvalidOperationException($"{_kind} moves no ball");
        }
    }

    private sealed class Brake(double perSpin) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddTorque(-perSpin * ball.Spin);
    }
}
