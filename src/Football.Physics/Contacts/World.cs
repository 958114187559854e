using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>All objects that a ball can hit or pass in a scene: colliders (the ground first), nets, goals.</summary>
/// <remarks>Built once. Only the positions of moving objects change afterwards.</remarks>
internal sealed partial class World
{
    private readonly string[] _names;
    private readonly int _zones;
    private readonly double _halfMass;
    private readonly double _halfInertia;

    public World(Scene scene)
    {
        Obstacles = scene.Motions ?? new ObstacleMotions(scene.Obstacles);
        Ball = scene.Ball;
        _halfMass = 0.5 * Ball.Mass;
        _halfInertia = 0.5 * Ball.MomentOfInertia;
        MinimumBounceSpeed = scene.Ground.MinimumBounceSpeed;
        RestEnergy = scene.Ground.RestEnergy * scene.Ball.RestShare;
        SharesAir = scene.Ground.Aerodynamics == GroundAerodynamics.Full;
        AirLoads = SharesAir || Weight.UpwardAcceleration(scene) >= 0;
        AirActs = scene.Ground.Aerodynamics != GroundAerodynamics.None;
        IsLevel = scene.Ground.IsLevel;
        LevelContact = scene.Ground.IsNone || !IsLevel ? double.NegativeInfinity : scene.Ground.Height + Ball.Radius;
        var colliders = new List<Collider>();
        if (!scene.Ground.IsNone)
        {
            IShape ground = scene.Ground.Heights is { } heights ? heights.Raised(scene.Ground.Height)
                : new PlaneShape(new Vector3d(0, scene.Ground.Height, 0), scene.Ground.Normal);
            colliders.Add(new Collider(scene.Ground, ground, Ball) { IsLevelGround = IsLevel, LevelContact = LevelContact });
            Ground = colliders[0];
        }

        scene.Bodies?.Use();
        FirstCollider = scene.Ground.IsNone ? 1 : 0;

        // Colliders in the order of their indices: ground, obstacles and goal frames, bodies, engine slots, then nets and goals.
        if (scene.HasThings)
        {
            Bodies = scene.Bodies is { Count: > 0 } ? scene.Bodies : null;
            AddThings(scene, Obstacles, colliders);
            Nets = NetsOf(scene);
            Goals = GoalsOf(scene);
            HasPassages = Nets.Length + Goals.Length > 0;
            int passages = Nets.Length + Goals.Length + scene.Zones.Count;
            Engine = scene.EngineColliders is null ? null : new EngineThings(this, scene.EngineColliders, colliders.Count, passages + (2 * Nets.Length));
            colliders.AddRange(Engine?.Colliders ?? []);
        }

        Colliders = colliders.ToArray();
        ByIndex = Colliders;
        FirstPassage = Colliders.Length;
        _zones = scene.Zones.Count;
        foreach (Collider collider in Colliders)
        {
            foreach (ContactMaterial material in Ignores(collider) ? [] : collider.Materials)
            {
                LargestFriction = Math.Max(LargestFriction, material.Resistance.MostFriction(1));
            }
        }

        // A scene whose other objects are all ignored is as bare as a scene without them.
        IsBare = Engine is null && !HasPassages && Array.TrueForAll(Colliders, collider => collider == Ground || Ignores(collider));
        IsLevelGroundAlone = IsLevel && IsBare;
        IsPlaneAlone = IsBare && scene.Ground.Heights is null;
        GivesWay = Colliders.Any(collider => collider.GivesWay && !Ignores(collider));
        NetForces = new NetForces(Nets);
        BroadPhase = new BroadPhase(this);
        Moves = BroadPhase.Moving.Length > 0 || Engine is not null;
        _names = !scene.HasThings && _zones == 0 ? ["ground"] : NamesOf(scene);
        AddNetEnds();
    }

    /// <summary>The ball.</summary>
    public BallProperties Ball { get; }

    /// <summary>The ground; null if there is none.</summary>
    public Collider? Ground { get; }

    /// <summary>The ground, obstacles, posts and bars; then bodies, and engine colliders.</summary>
    /// <remarks>When an engine needs more slots, it becomes <see cref="ByIndex"/>.</remarks>
    public Collider[] Colliders { get; private set; }

    /// <summary>All colliders by their index: <see cref="Colliders"/>, from <see cref="FirstPassage"/> on gaps for the passages, then the ends of the nets,
    /// and further engine slots.</summary>
    public Collider[] ByIndex { get; private set; }

    /// <summary>The index of the first net. Goals follow nets, zones follow goals, and the ends of the nets follow zones.</summary>
    /// <remarks>Engine slots that were added later come after them.</remarks>
    public int FirstPassage { get; }

    /// <summary>True if an index belongs to a net, a goal or a zone, and not to a collider.</summary>
    public bool IsPassage(int thing) => (uint)(thing - FirstPassage) < (uint)(Nets.Length + Goals.Length + _zones);

    /// <summary>True if an index belongs to the end of a net. The ends follow the zones: two for each net, one for each side.</summary>
    public bool IsNetEnd(long thing) => (ulong)(thing - FirstNetEnd) < (ulong)(2 * Nets.Length);

    /// <summary>Returns the index of the end of a net for the ball's side of it.</summary>
    public int EndOfNet(int net, ulong sides) => FirstNetEnd + (2 * net) + (int)(sides >> net & 1);

    /// <summary>True if a ball is in the net of an end, on its side.</summary>
    public bool ActsOn(long netEnd, in BallState s)
    {
        int net = (int)(netEnd - FirstNetEnd) / 2;
        return (s.Nets >> net & 1) != 0 && EndOfNet(net, s.NetSides) == netEnd;
    }

    private int FirstNetEnd => FirstPassage + Nets.Length + Goals.Length + _zones;

    /// <summary>The objects by their bounds.</summary>
    public BroadPhase BroadPhase { get; }

    /// <summary>Nets.</summary>
    public NetSheet[] Nets { get; } = [];

    /// <summary>The forces of the nets.</summary>
    public NetForces NetForces { get; }

    /// <summary>Goals.</summary>
    public GoalMouth[] Goals { get; } = [];

    /// <summary>True if there are nets or goals.</summary>
    public bool HasPassages { get; }

    /// <summary>Index of the first collider among the objects of the scene; the ground is always 0.</summary>
    public int FirstCollider { get; }

    /// <summary>True if the ball ignores a collider because of its layer.</summary>
    public bool Ignores(Collider collider) => collider.Layer >= 0 && Layers.Contains(Ball.Ignores, collider.Layer);

    /// <summary>True if any object can move.</summary>
    public bool Moves { get; }

    /// <summary>The speed of the fastest moving object, m/s.</summary>
    public double FastestMover
    {
        get
        {
            double fastest = Engine?.GreatestSpeed ?? 0;
            foreach (int mover in BroadPhase.Moving)
            {
                fastest = Math.Max(fastest, ByIndex[mover].GreatestSpeed);
            }

            return fastest;
        }
    }

    /// <summary>True if an object is in motion now. Engine colliders are not checked.</summary>
    public bool IsMoving
    {
        get
        {
            foreach (int mover in BroadPhase.Moving)
            {
                if (!ByIndex[mover].StandsStill)
                {
                    return true;
                }
            }

            return false;
        }
    }

    /// <summary>Changes whenever the game moves a body, or an impact pushes a body or an obstacle.</summary>
    public long MotionVersion => (Bodies?.Version ?? 0) + Obstacles.Version;

    /// <summary>Bodies that the game moves; null if there are none.</summary>
    public KinematicBodies? Bodies { get; }

    /// <summary>Motions of the obstacles with a mass.</summary>
    public ObstacleMotions Obstacles { get; }

    /// <summary>True if the ball can push a body or an obstacle. Engine colliders are not known in advance.</summary>
    public bool GivesWay { get; }

    /// <summary>True if the ball can push any object, including engine colliders.</summary>
    public bool MayGiveWay => GivesWay || Engine is not null;

    /// <summary>The engine's colliders; null without an engine.</summary>
    public EngineThings? Engine { get; }

    /// <summary>True if the ground is level.</summary>
    public bool IsLevel { get; }

    /// <summary>True if the scene has no objects other than the ground and those that the ball ignores.</summary>
    public bool IsBare { get; }

    /// <summary>True if the bare scene has only flat ground, level or tilted, or no ground.</summary>
    public bool IsPlaneAlone { get; }

    /// <summary>True if the bare scene has only level ground, or no ground.</summary>
    public bool IsLevelGroundAlone { get; }

    /// <summary>Height of the centre of a ball on level ground, m; −∞ if there is none.</summary>
    public double LevelContact { get; }

    /// <summary>The largest sliding friction of all surfaces that the ball does not ignore.</summary>
    public double LargestFriction { get; }

    /// <summary>A ball that leaves a contact more slowly than this stays, m/s.</summary>
    public double MinimumBounceSpeed { get; }

    /// <summary>A rolling ball below this energy rests if it is held, J.</summary>
    public double RestEnergy { get; }

    /// <summary>True if all air forces act on a supported ball and are shared with the spin of a rolling ball.</summary>
    public bool SharesAir { get; }

    /// <summary>True if the normal part of air and custom forces adds to the load.</summary>
    /// <remarks>This is so if all air forces act, and for a ball that is no heavier than air, which no other force could keep on the ground.</remarks>
    public bool AirLoads { get; }

    /// <summary>True if air forces act on a supported ball.</summary>
    public bool AirActs { get; }

    /// <summary>Shared memory for contact sets outside the phases of a step.</summary>
    public ContactRoom Room { get; } = new();

    /// <summary>The same for copies of sets.</summary>
    public ContactRoom Spare { get; } = new();

    /// <summary>Evaluations of gaps by searches for contacts that no step has counted yet.</summary>
    public long SearchEvaluations;

    /// <summary>True if the first of two touched colliders has priority.</summary>
    /// <remarks>
    /// Bodies and engine colliders are ordered by their contact normals: the order in which they were added or found must not matter.
    /// All others are in the order of the scene.
    /// </remarks>
    public bool ComesFirst(int first, in Vector3d normal, int second, in Vector3d other) =>
        IsByside(first, second) ? NearThings.IsBefore(in normal, first, in other, second) : first < second;

    /// <summary>True if the contact normals, and not the indices, decide the order of two colliders.</summary>
    public bool IsByside(int first, int second) => ByIndex[first].IsBody && ByIndex[second].IsBody;

    /// <summary>True if an index belongs to a collider.</summary>
    public bool IsCollider(long index) => (ulong)index < (ulong)ByIndex.Length && !IsPassage((int)index);

    /// <summary>Adds new slots of an engine's table as colliders.</summary>
    /// <param name="places">All slots of the engine.</param>
    /// <param name="from">The first new slot.</param>
    /// <param name="index">Its index among the colliders. The indices between the last collider and this one belong to nets and
    /// goals.</param>
    public void Extend(Collider[] places, int from, int index)
    {
        int before = ByIndex.Length;
        var colliders = new Collider[index + places.Length - from];
        Array.Copy(ByIndex, colliders, before);
        Array.Fill(colliders, places[0], before, index - before);
        Array.Copy(places, from, colliders, index, places.Length - from);
        ByIndex = colliders;
        Colliders = colliders;
    }

    /// <summary>Adds the ends of the nets as colliders. The indices of nets, goals and zones before them stay without a collider of their own.</summary>
    private void AddNetEnds()
    {
        if (Nets.Length == 0)
        {
            return;
        }

        Collider[] ends = [.. Nets.SelectMany(net => new[] { net.EndOn(-1), net.EndOn(1) })];
        ByIndex = [.. Colliders, .. Enumerable.Repeat(ends[0], FirstNetEnd - FirstPassage), .. ends];
    }

    // Keep code that a bare pitch does not need in a separate method, so that games without obstacles need not compile it.
    private static void AddThings(Scene scene, ObstacleMotions motions, List<Collider> colliders)
    {
        colliders.AddRange(scene.Obstacles.Select((obstacle, i) => motions.Of(i) is { } placement ? new Collider(obstacle, scene.Ball, motions, placement) : new Collider(obstacle, scene.Ball)));
        colliders.AddRange(scene.Goals.SelectMany(goal => goal.Frame(scene.Forces)).Select(obstacle => new Collider(obstacle, scene.Ball) { Layer = -1 }));
        colliders.AddRange((scene.Bodies ?? Enumerable.Empty<KinematicBody>()).Select(body => new Collider(body, scene.Ball)));
    }

    private static NetSheet[] NetsOf(Scene scene) =>
        [.. scene.Nets.Concat(scene.Goals.SelectMany(goal => goal.Nets())).Select(net => new NetSheet(net, scene.Ball))];

    private static GoalMouth[] GoalsOf(Scene scene) => [.. scene.Goals.Select(goal => new GoalMouth(goal))];

    private string[] NamesOf(Scene scene) =>
    [
        "ground",
        .. Colliders.Where(collider => collider != Ground).Select(collider => collider.Name),
        .. Nets.Select(net => net.Name),
        .. Goals.Select(_ => "goal"),
        .. scene.Zones.Select(zone => zone.Name),
    ];

    /// <summary>The names of all objects, the ground first.</summary>
    public IReadOnlyList<string> Names => _names;

    /// <summary>Returns the name of an object.</summary>
    /// <param name="thing">Its index in the scene.</param>
    public string NameOf(int thing)
    {
        if (Engine?.Of(thing, Vector3d.Zero, 0) is { } collider)
        {
            return collider.Name;
        }

        Check.Index(nameof(thing), thing, _names.Length);
        return _names[thing];
    }

    /// <summary>Starts a step: replaces the number of an engine collider in the state by its index.</summary>
    public void Enter(ref BallState s)
    {
        if (Engine is { } engine && engine.Begin(s.Motion == MotionState.Airborne ? 0 : s.Carrier, s.Position, s.Time) is >= 0 and int carrier)
        {
            s.Carrier = carrier + FirstCollider;
        }
    }

    /// <summary>Ends a step: replaces the index of an engine collider in the state by its number.</summary>
    public void Exit(ref BallState s)
    {
        if (Engine?.NumberOf(s.Carrier - FirstCollider) is >= 0 and int carrier)
        {
            s.Carrier = carrier;
        }
    }

    /// <summary>Returns the index of a thing in events: the end of a net counts as the net.</summary>
    public long Reported(long thing) => IsNetEnd(thing - FirstCollider) ? ThingOfNet((int)(thing - FirstCollider - FirstNetEnd) / 2) : thing;

    /// <summary>Returns the index of the collider of an impact event. An impact with a net hits its end on the ball's side.</summary>
    public int Struck(int thing, in BallState s) =>
        thing - ThingOfNet(0) is >= 0 and int net && net < Nets.Length ? EndOfNet(net, s.NetSides) : (int)ColliderOf(thing, s.Position, s.Time);

    /// <summary>Returns the index of a collider in states and events: an engine collider has its own number.</summary>
    public int ThingOf(int collider) => Engine?.NumberOf(collider) is >= 0 and int number ? number : collider + FirstCollider;

    /// <summary>Converts the carrier in a state or event to a collider index; out of range if it is not a collider.</summary>
    /// <remarks>An engine collider has an index only within a step.</remarks>
    public long ColliderOf(long thing, in Vector3d position, double time) =>
        Engine is not null && thing >= EngineCollider.FirstNumber ? Engine.IndexOf((int)thing, in position, time) : thing - FirstCollider;

    /// <summary>Returns the index of a net in the scene.</summary>
    public int ThingOfNet(int net) => FirstCollider + FirstPassage + net;

    /// <summary>Returns the index of a goal in the scene.</summary>
    public int ThingOfGoal(int goal) => ThingOfNet(Nets.Length) + goal;

    /// <summary>Returns the index of a zone in the scene.</summary>
    public int ThingOfZone(int zone) => ThingOfGoal(Goals.Length) + zone;

    /// <summary>Returns the carrier of the ball; the first collider if a state of another scene names an unknown one.</summary>
    public Collider CarrierOf(in BallState s)
    {
        // Between steps, identify an engine collider by its own number.
        long index = ColliderOf(s.Carrier, s.Position, s.Time);
        return ByIndex[(ulong)index < (ulong)FirstPassage || IsCollider(index) ? index : 0];
    }

    /// <summary>Projects a ball onto a collider that it touches, to remove the integrator's error.</summary>
    /// <remarks>Heights on level ground are exact.</remarks>
    /// <returns>The normal there.</returns>
    public Vector3d Hold(ref BallState s, Collider collider)
    {
        ShapePoint at = collider.At(s.Position, s.Time);
        Vector3d n = at.Normal;

        // The position on the surface, p + (r − d) n, with zero separation speed.
        s.Position += (Ball.Radius - at.Distance) * n;
        s.Velocity -= Vector3d.Dot(s.Velocity - collider.ShapeVelocity(s.Position, s.Time), in n) * n;
        s.Position = collider.Snap(s.Position);
        return n;
    }

    /// <summary>Energy of the motion relative to the carrier, ½ m |v−V_p|² + ½ I |ω−Ω|², J.</summary>
    public double Energy(in Motion at, Collider carrier, double time) => Energy(at.Velocity - carrier.MaterialVelocity(in at.Position, time), at.Spin - carrier.Spin);

    /// <summary>Returns a margin of the energy above that of rest: the difference of the square roots, because the root falls almost linearly.</summary>
    public double AboveRest(in Motion at, Collider carrier, double time) => Math.Sqrt(Energy(in at, carrier, time)) - Math.Sqrt(RestEnergy);

    /// <summary>½ m |v|² + ½ I |ω|², J.</summary>
    public double Energy(in Vector3d velocity, in Vector3d spin) => (_halfMass * velocity.LengthSquared) + (_halfInertia * spin.LengthSquared);

    /// <summary>Returns V_c, the velocity of a touched surface at the contact point, m/s.</summary>
    /// <param name="collider">The surface.</param>
    /// <param name="position">The ball's centre, m.</param>
    /// <param name="normal">n.</param>
    /// <param name="time">The time, s.</param>
    public Vector3d SurfaceVelocity(Collider collider, in Vector3d position, in Vector3d normal, double time) =>
        collider.SurfaceVelocity(position - (Ball.Radius * normal), in normal, time);

    /// <summary>True if the ball rests in a net and on no other object.</summary>
    public bool HangsInNet(in BallState s) => s.Motion == MotionState.Rest && s.Carrier >= ThingOfNet(0) && s.Carrier < ThingOfGoal(0) && s.Nets != 0;
}
