using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>Colliders found by an engine's sphere casts, as colliders of the world.</summary>
/// <remarks>
/// Each collider keeps its slot for a step; queries use those of the last cast. Slots follow the order of discovery and are meaningless
/// outside a step,
/// so states and events identify an engine collider by its number (<see cref="EngineCollider.Number"/>), which does not depend on that
/// order.
/// </remarks>
internal sealed class EngineThings
{
    /// <summary>Initial number of slots.</summary>
    /// <remarks>If a step finds more colliders, the table grows. Further steps with as many colliders allocate nothing.</remarks>
    public const int Room = 256;

    /// <summary>Maximum number of colliders remembered by number, to look up their names.</summary>
    private const int MostKnown = 1 << 14;

    /// <summary>Margin of a cast around the path, m, so that contacts at its end or next to it need no further cast.</summary>
    private const double Beside = 0.02;

    private readonly World _world;
    private readonly IEngineColliders _engine;
    private readonly double _ballRadius;
    private readonly int _first;
    private readonly int _passages;
    private readonly Placement _nowhere = new(Bounds3d.Everywhere);
    private readonly Dictionary<EngineCollider, int> _places = new(Room);
    private readonly Dictionary<int, EngineCollider> _known = new(Room);
    private readonly EngineHits _hits;
    private Collider[] _colliders = [];
    private int[] _found = new int[Room];
    private Vector3d _from;
    private Vector3d _to;
    private double _around;
    private bool _isKnown;
    private int _used = 1;

    /// <summary>Creates the table of an engine.</summary>
    /// <param name="world">The world, whose array of colliders grows with the table.</param>
    /// <param name="engine">The engine.</param>
    /// <param name="first">Index of the first slot among the world's colliders.</param>
    /// <param name="passages">Number of nets, goals, zones and ends of nets, whose indices follow those of the initial slots.</param>
    public EngineThings(World world, IEngineColliders engine, int first, int passages)
    {
        _world = world;
        _engine = engine;
        _ballRadius = world.Ball.Radius;
        _hits = new EngineHits(world.Ball.Ignores);
        _first = first;
        _passages = passages;
        Pushes = EnginePushes.Of(engine);
        Extend(Room + 1);
    }

    /// <summary>The pushed engine colliders.</summary>
    public EnginePushes Pushes { get; }

    /// <summary>The slots, filled as colliders are found. The first slot stays empty, for a collider that no longer exists.</summary>
    public IReadOnlyList<Collider> Colliders => _colliders;

    /// <summary>Upper bound of the speed of any part of a collider, m/s.</summary>
    public double GreatestSpeed => _engine.MaximumSpeed;

    /// <summary>Number of colliders found by the last cast.</summary>
    public int Count { get; private set; }

    /// <summary>Returns the world index of a found collider.</summary>
    public int Found(int index) => _found[index];

    /// <summary>True if a collider of the world is an engine collider.</summary>
    public bool Has(int collider) => collider >= _first && !_world.IsPassage(collider) && !_world.IsNetEnd(collider);

    /// <summary>True if the last cast found a collider.</summary>
    public bool Finds(int collider) => Array.IndexOf(_found, collider, 0, Count) >= 0;

    /// <summary>Marks the results as outdated, because the engine may have moved its colliders.</summary>
    public void Forget() => _isKnown = false;

    /// <summary>Finds the colliders near a path.</summary>
    public void LookAlong(in PathCubic path, double time)
    {
        Vector3d from = path.At(0);
        Vector3d to = path.At(path.Length);
        Look(in from, in to, _ballRadius + path.Deviation, time, path.Length);
    }

    /// <summary>Finds the colliders within a distance of a position, m, unless the last cast covers it.</summary>
    public void LookAt(in Vector3d position, double time, double distance)
    {
        // Within the volume of the last cast, all colliders have already been found: skip the cast.
        if (!_isKnown || !(DistanceFromLast(in position) + _ballRadius + Math.Max(0.5 * Beside, distance) <= _around))
        {
            Look(in position, in position, _ballRadius + distance, time, 0);
        }
    }

    /// <summary>Starts a step: clears all slots except that of the carrier, which its number and the ball's position identify.</summary>
    /// <param name="carrier">Its number; below <see cref="EngineCollider.FirstNumber"/> if the carrier is not an engine collider.</param>
    /// <param name="position">Position of the ball, m.</param>
    /// <param name="time">The time, s.</param>
    /// <returns>World index of the carrier.</returns>
    public int Begin(long carrier, in Vector3d position, double time)
    {
        _isKnown = false;
        Count = 0;
        if (_used > 1)
        {
            _places.Clear();
            _used = 1;
        }

        if (carrier < EngineCollider.FirstNumber)
        {
            return -1;
        }

        return IndexOf((int)carrier, in position, time);
    }

    /// <summary>Returns the number of an engine collider; −1 for another collider.</summary>
    public int NumberOf(long collider) =>
        collider >= _first && collider < _world.ByIndex.Length && Has((int)collider) ? _world.ByIndex[(int)collider].Engine?.Number ?? EngineCollider.FirstNumber : -1;

    /// <summary>Returns the collider with a given number that is nearest to a ball; null if there is none.</summary>
    /// <remarks>It searches the last step, then the last known collider with this number.</remarks>
    public EngineCollider? Of(int number, in Vector3d position, double time) =>
        Nearest(number, in position, time, -1) is >= 0 and int place ? _colliders[place].Engine : _known.TryGetValue(number, out EngineCollider? known) ? known : null;

    /// <summary>Returns the world index of the collider with a given number that a ball touches; an empty slot if there is none.</summary>
    /// <remarks>It looks for the collider, because the slots may lack it, or may contain colliders of earlier steps.</remarks>
    public int IndexOf(int number, in Vector3d position, double time)
    {
        LookAt(in position, time, ContactTolerances.Touching);
        return Nearest(number, in position, time, Count) is >= 0 and int place ? IndexOf(place) : _first;
    }

    /// <summary>Converts a slot to a world index: nets, goals, zones and ends of nets come between the initial slots and those added later.</summary>
    private int IndexOf(int place) => _first + place + (place > Room ? _passages : 0);

    /// <summary>Returns the slot of the collider that has a given number and whose surface is nearest to a ball.</summary>
    /// <remarks>Several colliders may share a name and a number.</remarks>
    /// <param name="number">The number.</param>
    /// <param name="position">Position of the ball, m.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="found">Number of colliders of the last cast to search; negative: all of the last step.</param>
    private int Nearest(int number, in Vector3d position, double time, int found)
    {
        int nearest = -1;
        double least = double.PositiveInfinity;
        int count = found < 0 ? _used - 1 : found;
        for (int i = 0; i < count; i++)
        {
            int place = found < 0 ? i + 1 : _places[_world.ByIndex[_found[i]].Engine!];
            if (_colliders[place].Engine!.Number != number)
            {
                continue;
            }

            double gap = Math.Abs(_colliders[place].At(in position, time).Distance - _ballRadius);
            nearest = gap < least || nearest < 0 ? place : nearest;
            least = Math.Min(least, gap);
        }

        return nearest;
    }

    /// <summary>Starts a step of a group: discards the pushes of earlier times.</summary>
    public void BeginPushes() => Pushes.ForgetBefore(_engine.Time);

    /// <summary>Restores copied pushes.</summary>
    public void PutPushesBack(List<(EngineCollider Collider, EnginePush Push)> from)
    {
        Pushes.Write(from);
        _isKnown = false;
    }

    /// <summary>Discards all pushes, because the engine has placed its colliders again.</summary>
    public void ForgetPushes()
    {
        Pushes.Forget();
        _isKnown = false;
    }

    /// <summary>True if a straight path reaches no collider.</summary>
    public bool IsFree(in StraightWay way)
    {
        Vector3d from = way.From;
        Vector3d to = from + (way.Duration * way.Velocity);
        Look(in from, in to, way.Around, way.Time, way.Duration);

        // The cast finds colliders near the path. Use each collider's moving box to decide whether the path reaches it.
        for (int i = 0; i < Count; i++)
        {
            Collider collider = _world.ByIndex[_found[i]];
            if (way.SeenFrom(collider.Velocity).Meets(collider.BoundsDuring(way.Time, way.Duration)) <= way.Duration)
            {
                return false;
            }
        }

        return true;
    }

    private void Look(in Vector3d from, in Vector3d to, double around, double time, double duration)
    {
        _from = from;
        _to = to;
        _around = around + Beside;
        _isKnown = true;

        // The engine reports positions at a single time, and colliders may move until the ball passes: expand the cast by this motion.
        double now = _engine.Time;
        double apart = Math.Max(Math.Abs(time - now), Math.Abs(time + duration - now));
        double requested = apart * _engine.MaximumSpeed;
        Cast(in from, in to, requested);

        // A rotating collider may move farther than the engine's bound allows for: cast again with the larger margin.
        if (MovedByRotating(apart) is var farther && farther > requested)
        {
            Cast(in from, in to, farther);
            requested = farther;
        }

        Count = 0;
        if (_found.Length < _hits.Count)
        {
            Array.Resize(ref _found, _hits.Count);
        }

        // An engine may return more colliders than necessary, even all: skip those outside the box of the cast.
        Bounds3d box = new Bounds3d(in from, in from).Union(new Bounds3d(in to, in to)).Expanded(_around + requested);
        for (int i = 0; i < _hits.Count; i++)
        {
            EngineCollider hit = _hits.At(i);
            hit.FoundAt(now);
            if (!hit.Placement.BoundsAt(now).Intersects(in box) && !hit.Placement.BoundsDuring(time, duration).Intersects(in box))
            {
                continue;
            }

            // A collider keeps its index from cast to cast, so the carrier's index stays valid.
            _found[Count++] = IndexOf(PlaceOf(hit));
        }
    }

    private void Cast(in Vector3d from, in Vector3d to, double moved)
    {
        _hits.Clear();
        _engine.Cast(new SphereCast(in from, in to, _around + moved, _ballRadius), _hits);
    }

    /// <summary>Returns how far any part of a rotating collider that the cast has hit may move in a time, m.</summary>
    /// <remarks>A rotation moves it by at most the diameter of its circle.</remarks>
    private double MovedByRotating(double apart)
    {
        double most = 0;
        for (int i = 0; i < _hits.Count; i++)
        {
            Placement placement = _hits.At(i).Placement;
            double across = 2.0 * placement.Reach;
            if (placement.Motion.Rotates && across < double.PositiveInfinity)
            {
                most = Math.Max(most, (apart * placement.Motion.Velocity.Length) + Math.Min(apart * placement.Motion.Swing, across));
            }
        }

        return most;
    }

    /// <summary>Returns the slot of a collider: its own if this step has found it before, or the next free one.</summary>
    private int PlaceOf(EngineCollider hit)
    {
        if (_places.TryGetValue(hit, out int place))
        {
            return place;
        }

        if (_used == _colliders.Length)
        {
            Extend(2 * _used);
        }

        // If the slot still contains this collider from an earlier step, its number has already been recorded.
        place = _used++;
        _places.Add(hit, place);
        if (!ReferenceEquals(_colliders[place].Engine, hit))
        {
            _colliders[place].Become(hit);
            Know(hit);
        }

        return place;
    }

    /// <summary>Adds slots, also as colliders of the world.</summary>
    private void Extend(int count)
    {
        int before = _colliders.Length;
        Array.Resize(ref _colliders, count);
        for (int i = before; i < count; i++)
        {
            _colliders[i] = new Collider(_nowhere, Pushes, _world.Ball);
        }

        if (before > 0)
        {
            _world.Extend(_colliders, before, IndexOf(before));
        }
    }

    /// <summary>Records which collider has a number.</summary>
    private void Know(EngineCollider collider)
    {
        // An engine may create new colliders endlessly: clear the cache when it is full. Later casts find the colliders in use again.
        if (_known.Count >= MostKnown && !_known.ContainsKey(collider.Number))
        {
            _known.Clear();
        }

        _known[collider.Number] = collider;
    }

    private double DistanceFromLast(in Vector3d position)
    {
        Vector3d way = _to - _from;
        double square = way.LengthSquared;

        // The nearest point on the segment of the last cast.
        double share = square > 0 ? Vector3d.Dot(position - _from, in way) / square : 0;
        return (position - (_from + (Math.Min(1, Math.Max(0, share)) * way))).Length;
    }
}
