namespace FootballPhysics.Tests.Things;

/// <summary>A shape that rotates steadily about its pivot, which may move, and a second model of it: exact rotation by the library of the runtime, distances from the shape itself.</summary>
internal sealed record Hinged
{
    public required IShape Shape { get; init; }

    public Vector3d Pivot { get; init; }

    public Vector3d Velocity { get; init; }

    /// <summary>Of length 1.</summary>
    public required Vector3d Axis { get; init; }

    /// <summary>Angle about the axis at time 0, rad.</summary>
    public double Start { get; init; }

    /// <summary>Rad/s about the axis.</summary>
    public required double Rate { get; init; }

    /// <summary>Rubber without friction.</summary>
    public static SurfaceMaterial Rubber { get; } =
        SurfaceMaterial.GoalFrame with { NormalRestitution = 0.5, RestitutionSpeedScale = double.PositiveInfinity, ImpactFriction = 0, SlidingFriction = 0 };

    public Vector3d PivotAt(double time) => Pivot + (time * Velocity);

    public Quaterniond At(double time) => Quaterniond.FromAxisAngle(Axis, Start + (Rate * time));

    public void Place(KinematicBody body, double time) => body.MoveTo(PivotAt(time), At(time), Velocity, Rate * Axis, time);

    public void Place(EngineCollider collider, double time) => collider.MoveTo(PivotAt(time), At(time), Velocity, Rate * Axis);

    /// <summary>Distance of a point from the shape at a time.</summary>
    public double Distance(Vector3d point, double time) => Shape.At(Turned(point - PivotAt(time), -(Start + (Rate * time)))).Distance;

    /// <summary>Outward normal at a point.</summary>
    public Vector3d Normal(Vector3d point, double time)
    {
        double angle = Start + (Rate * time);
        return Turned(Shape.At(Turned(point - PivotAt(time), -angle)).Normal, angle);
    }

    /// <summary>V + Ω × (c − o).</summary>
    public Vector3d SurfaceVelocity(Vector3d point, double time) => Velocity + Vector3d.Cross(Rate * Axis, point - PivotAt(time));

    /// <summary>When a ball on a straight path first comes so near that it touches, and the least gap before that or until the end: by samples, then bisection.</summary>
    public double FirstTouch(Vector3d from, Vector3d velocity, double radius, double until, out double least)
    {
        const double Sample = 1e-5;
        least = double.PositiveInfinity;
        double Gap(double t) => Distance(from + (t * velocity), t) - radius;
        for (int i = 0; i * Sample <= until; i++)
        {
            double gap = Gap(i * Sample);
            least = Math.Min(least, gap);
            if (gap <= 0)
            {
                double low = Math.Max(0, (i - 1) * Sample);
                double high = i * Sample;
                while (high - low > 1e-14)
                {
                    double middle = 0.5 * (low + high);
                    (low, high) = Gap(middle) > 0 ? (middle, high) : (low, middle);
                }

                return high;
            }
        }

        return double.PositiveInfinity;
    }

    /// <summary>Rodrigues' formula.</summary>
    private Vector3d Turned(Vector3d v, double angle) =>
        (Math.Cos(angle) * v) + (Math.Sin(angle) * Vector3d.Cross(Axis, v)) + ((1 - Math.Cos(angle)) * Vector3d.Dot(Axis, v) * Axis);
}

/// <summary>Who moves a hinged shape.</summary>
public enum Mover
{
    /// <summary>The game: a body.</summary>
    Body,

    /// <summary>An engine that finds all it has.</summary>
    Engine,

    /// <summary>An engine whose cast finds no more than it must.</summary>
    ExactEngine,
}

/// <summary>A hinged shape in a scene, moved before each step.</summary>
internal sealed class HingedScene
{
    private readonly Hinged _thing;
    private readonly KinematicBody? _body;
    private readonly HingedEngine? _engine;

    public HingedScene(Hinged thing, Mover mover, Scene scene, SurfaceMaterial? surface = null, double mass = double.PositiveInfinity)
    {
        _thing = thing;
        if (mover == Mover.Body)
        {
            var bodies = new KinematicBodies();
            _body = bodies.Add("thing", thing.Shape, surface ?? Hinged.Rubber, mass);
            Scene = scene with { Bodies = bodies };
        }
        else
        {
            _engine = new HingedEngine(thing, surface ?? Hinged.Rubber, mass, mover == Mover.ExactEngine);
            Scene = scene with { EngineColliders = _engine };
        }
    }

    public Scene Scene { get; }

    public KinematicBody Body => _body!;

    /// <summary>Nothing but the ball: no gravity, no ground, no air.</summary>
    public static Scene Void { get; } = new() { Ball = BallProperties.Tunnel, Forces = ForceSet.None, Gravity = 0, Ground = Ground.None };

    public void Move(double time)
    {
        if (_body is not null)
        {
            _thing.Place(_body, time);
        }
        else
        {
            _engine!.Time = time;
        }
    }

    /// <summary>Steps a ball, the thing placed before each step.</summary>
    public StepLog Play(ref BallState state, Simulator simulator, double hz, double duration)
    {
        var log = new StepLog();
        int steps = (int)Math.Round(duration * hz);
        for (int i = 0; i < steps; i++)
        {
            Move(state.Time);
            simulator.Step(ref state, 1 / hz, log);
        }

        return log;
    }

    private sealed class HingedEngine(Hinged thing, SurfaceMaterial surface, double mass, bool isExact) : IEngineColliders
    {
        private readonly EngineCollider _collider = new("thing", thing.Shape, surface) { Mass = mass };

        public double Time { get; set; }

        /// <summary>Of the fastest point.</summary>
        public double MaximumSpeed { get; } = !isExact ? thing.Velocity.Length
            : thing.Velocity.Length + (Math.Abs(thing.Rate) * new Vector3d(
                Math.Max(-thing.Shape.Bounds.Min.X, thing.Shape.Bounds.Max.X),
                Math.Max(-thing.Shape.Bounds.Min.Y, thing.Shape.Bounds.Max.Y),
                Math.Max(-thing.Shape.Bounds.Min.Z, thing.Shape.Bounds.Max.Z)).Length);

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            const int Samples = 50;
            double least = double.PositiveInfinity;
            for (int k = 0; k <= Samples; k++)
            {
                least = Math.Min(least, thing.Distance(cast.From + (cast.Distance * k / Samples * cast.Direction), Time));
            }

            if (!isExact || least <= cast.Radius + (cast.Distance / Samples))
            {
                thing.Place(_collider, Time);
                hits.Add(_collider);
            }
        }
    }
}
