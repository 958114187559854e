namespace Football.Physics;

/// <summary>
/// All that a ball can meet in a scene that has more than a level pitch: colliders (the ground first), nets, goals. Built once; immutable.
/// </summary>
internal sealed class World
{
    private readonly string[] _names;

    /// <summary>Boxes around all that has one and stands still.</summary>
    private readonly Bounds3d[] _boxes;

    /// <summary>What has no box, or moves; but not level ground.</summary>
    private readonly Collider[] _others;

    private World(Scene scene)
    {
        Ball = scene.Ball;
        MinimumBounceSpeed = scene.Ground.MinimumBounceSpeed;
        RestEnergy = scene.Ground.RestEnergy;
        SharesAir = scene.Ground.Aerodynamics == GroundAerodynamics.Full;
        AirActs = scene.Ground.Aerodynamics != GroundAerodynamics.None;
        var colliders = new List<Collider>();
        if (!scene.Ground.IsNone)
        {
            IShape ground = scene.Ground.Heights is { } heights ? heights.Raised(scene.Ground.Height)
                : new PlaneShape(new Vector3d(0, scene.Ground.Height, 0), scene.Ground.Normal);
            colliders.Add(new Collider("ground", ground, new ContactMaterial(scene.Ground), default, default, default));
            Ground = colliders[0];
        }

        colliders.AddRange(scene.Obstacles.Select(obstacle => new Collider(obstacle)));
        colliders.AddRange(scene.Goals.SelectMany(goal => goal.Frame()).Select(obstacle => new Collider(obstacle)));
        Colliders = [.. colliders];
        Nets = [.. scene.Nets.Concat(scene.Goals.SelectMany(goal => goal.Nets())).Select(net => new NetSheet(net, Ball))];
        Goals = [.. scene.Goals.Select(goal => new GoalMouth(goal, Ball))];
        FirstCollider = scene.Ground.IsNone ? 1 : 0;
        LevelContact = scene.Ground.IsNone || !scene.Ground.IsLevel ? double.NegativeInfinity : scene.Ground.Height + Ball.Radius;
        bool IsOther(Collider collider) =>
            (collider.Velocity != Vector3d.Zero || !(collider.Bounds.Max - collider.Bounds.Min).IsFinite) && !(collider == Ground && scene.Ground.IsLevel);
        _others = Array.FindAll(Colliders, IsOther);
        _boxes =
        [
            .. Colliders.Where(collider => !IsOther(collider) && collider != Ground).Select(collider => collider.Bounds),
            .. Nets.Select(net => net.Bounds),
            .. Goals.Select(goal => goal.Bounds),
        ];
        FastestSpeed = Colliders.Select(collider => collider.Velocity.Length).DefaultIfEmpty(0).Max();
        Moves = Array.Exists(Colliders, collider => collider.Velocity != Vector3d.Zero);
        _names =
        [
            "ground",
            .. Colliders.Where(collider => collider != Ground).Select(collider => collider.Name),
            .. Nets.Select(net => net.Name),
            .. scene.Goals.Select(_ => "goal"),
        ];
    }

    /// <summary>The ball.</summary>
    public BallProperties Ball { get; }

    /// <summary>The ground; null where there is none.</summary>
    public Collider? Ground { get; }

    /// <summary>The ground, obstacles, posts and bars.</summary>
    public Collider[] Colliders { get; }

    /// <summary>Nets.</summary>
    public NetSheet[] Nets { get; }

    /// <summary>Goals.</summary>
    public GoalMouth[] Goals { get; }

    /// <summary>Index of the first collider among the things of the scene, of which the ground is always 0.</summary>
    public int FirstCollider { get; }

    /// <summary>Whether anything moves.</summary>
    public bool Moves { get; }

    /// <summary>Height of the centre of a ball on level ground, m; −∞ where there is none.</summary>
    public double LevelContact { get; }

    /// <summary>The speed of the fastest thing, m/s.</summary>
    public double FastestSpeed { get; }

    /// <summary>A ball that leaves a contact slower than this stays, m/s.</summary>
    public double MinimumBounceSpeed { get; }

    /// <summary>A rolling ball with less energy than this, and that is held, rests, J.</summary>
    public double RestEnergy { get; }

    /// <summary>Whether all of the air's force counts for a ball that is carried, and is shared with the spin of one that rolls.</summary>
    public bool SharesAir { get; }

    /// <summary>Whether the air pushes a ball that is carried.</summary>
    public bool AirActs { get; }

    /// <summary>The world of a scene; null where the level pitch is all there is.</summary>
    public static World? Of(Scene scene)
    {
        Ground ground = scene.Ground;
        bool plain = ground.IsLevel
            && double.IsPositiveInfinity(ground.ImpactFriction)
            && double.IsPositiveInfinity(ground.RestitutionSpeed)
            && ground.RollingFrictionBySpeed == 0
            && ground.DrillingLength == 0
            && ground.Aerodynamics != GroundAerodynamics.Full;
        return plain && scene.Obstacles.Count == 0 && scene.Nets.Count == 0 && scene.Goals.Count == 0 ? null : new World(scene);
    }

    /// <summary>A distance, m, within which the ball can go without meeting anything but level ground; 0 where it touches something.</summary>
    public double ClearanceAt(in Vector3d position, double time)
    {
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < _boxes.Length; i++)
        {
            nearest = Math.Min(nearest, _boxes[i].DistanceSquared(in position));
        }

        nearest = Math.Sqrt(nearest);
        foreach (Collider other in _others)
        {
            nearest = Math.Min(nearest, other.At(in position, time).Distance);
        }

        return Math.Max(0, nearest - Ball.Radius);
    }

    /// <summary>The name of a thing.</summary>
    /// <param name="thing">Its index among the things of the scene.</param>
    public string NameOf(int thing) => _names[thing];

    /// <summary>Index among the things of the scene of a net.</summary>
    public int ThingOfNet(int net) => FirstCollider + Colliders.Length + net;

    /// <summary>Index among the things of the scene of a goal.</summary>
    public int ThingOfGoal(int goal) => ThingOfNet(Nets.Length) + goal;

    /// <summary>What carries the ball. A state of another scene may name what is not here: then it is the first thing.</summary>
    public Collider CarrierOf(in BallState s)
    {
        long index = s.Carrier - FirstCollider;
        return Colliders[(ulong)index < (ulong)Colliders.Length ? index : 0];
    }

    /// <summary>½ m |v−V|² + ½ I ω², J.</summary>
    public double Energy(in Motion at, Collider carrier) =>
        (0.5 * Ball.Mass * (at.Velocity - carrier.Velocity).LengthSquared) + (0.5 * Ball.MomentOfInertia * at.Spin.LengthSquared);

    /// <summary>What the nets that the ball is in do to it.</summary>
    public MotionRates PushOfNets(ulong nets, ulong sides, in Motion at)
    {
        Vector3d acceleration = default;
        Vector3d spinAcceleration = default;
        for (int i = 0; i < Nets.Length; i++)
        {
            if ((nets >> i & 1) != 0)
            {
                MotionRates push = Nets[i].Push(in at, SideOf(sides, i));
                acceleration += push.Acceleration;
                spinAcceleration += push.SpinAcceleration;
            }
        }

        return new MotionRates(in acceleration, in spinAcceleration);
    }

    /// <summary>σ of a net.</summary>
    public static double SideOf(ulong sides, int net) => (sides >> net & 1) != 0 ? 1.0 : -1.0;
}
