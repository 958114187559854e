namespace FootballPhysics;

/// <summary>
/// What an engine's sphere casts have found, as colliders of the world: each has a place among these that it keeps for a step, and those of the last cast are looked at.
/// </summary>
/// <remarks>
/// Places follow the order in which colliders are found, so they mean nothing outside a step: states and events name an engine's collider by its number
/// (<see cref="EngineCollider.Number"/>), which knows nothing of what was found before.
/// </remarks>
internal sealed class EngineThings
{
    /// <summary>Places from the start.</summary>
    /// <remarks>
    /// If a step finds more colliders, the table grows; a step that finds as many again allocates nothing.
    /// </remarks>
    public const int Room = 256;

    /// <summary>So many numbers are remembered with who had them last, to tell their names.</summary>
    private const int MostKnown = 1 << 14;

    /// <summary>Margin beside the way within which things are found too, m: so that what touches at its end, or next to it, need not be cast for again.</summary>
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
    private readonly List<EngineCollider> _rotating = [];
    private readonly HashSet<EngineCollider> _isRotating = [];
    private Collider[] _colliders = [];
    private int[] _found = new int[Room];
    private Vector3d _from;
    private Vector3d _to;
    private double _around;
    private bool _isKnown;
    private int _used = 1;

    /// <summary>The colliders of an engine.</summary>
    /// <param name="world">The world, whose array of colliders grows with the table.</param>
    /// <param name="engine">The engine.</param>
    /// <param name="first">Index of the first place among the world's colliders.</param>
    /// <param name="passages">The number of nets and goals, whose numbers follow those of the first places.</param>
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

    /// <summary>What the ball has pushed of them.</summary>
    public EnginePushes Pushes { get; }

    /// <summary>Places for colliders, filled as they are found; the first one stays empty, and stands for a collider that the engine no longer has.</summary>
    public IReadOnlyList<Collider> Colliders => _colliders;

    /// <summary>The greatest speed of any part of them, m/s: as the engine says, and of those that were found rotating.</summary>
    public double GreatestSpeed
    {
        get
        {
            double greatest = _engine.MaximumSpeed;
            foreach (EngineCollider collider in _rotating)
            {
                greatest = Math.Max(greatest, collider.Placement.Motion.GreatestSpeed);
            }

            return greatest;
        }
    }

    /// <summary>How many the last cast has found.</summary>
    public int Count { get; private set; }

    /// <summary>Index among the world's colliders of one that was found.</summary>
    public int Found(int index) => _found[index];

    /// <summary>True when a collider of the world is one of an engine's.</summary>
    public bool Has(int collider) => collider >= _first && !_world.IsPassage(collider);

    /// <summary>True when the last cast has found a collider.</summary>
    public bool Finds(int collider) => Array.IndexOf(_found, collider, 0, Count) >= 0;

    /// <summary>The engine may have moved its colliders: what was found is out of date.</summary>
    public void Forget() => _isKnown = false;

    /// <summary>Finds what is near a path.</summary>
    public void LookAlong(in PathCubic path, double time)
    {
        Vector3d from = path.At(0);
        Vector3d to = path.At(path.Length);
        Look(in from, in to, _ballRadius + path.Deviation, time, path.Length);
    }

    /// <summary>Finds what is near a place, by a distance, m, where the last cast has not been there.</summary>
    public void LookAt(in Vector3d position, double time, double distance)
    {
        // Inside the volume of the last cast there are no new colliders to find.
        if (!_isKnown || !(DistanceFromLast(in position) + _ballRadius + Math.Max(0.5 * Beside, distance) <= _around))
        {
            Look(in position, in position, _ballRadius + distance, time, 0);
        }
    }

    /// <summary>Begins a step: nothing has a place but what carries the ball, which its number and the ball's position tell.</summary>
    /// <param name="carrier">Its number; below <see cref="EngineCollider.FirstNumber"/> where no collider of an engine carries the ball.</param>
    /// <param name="position">The ball, m.</param>
    /// <param name="time">When, s.</param>
    /// <returns>Index among the world's colliders of the carrier.</returns>
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

        LookAt(in position, time, ContactSearch.Touching);
        return Nearest((int)carrier, in position, time, Count) is >= 0 and int place ? IndexOf(place) : _first;
    }

    /// <summary>The number of one of the world's colliders, if it is an engine's; else −1.</summary>
    public int NumberOf(long collider) =>
        collider >= _first && collider < _world.Colliders.Length && Has((int)collider) ? _world.Colliders[(int)collider].Engine?.Number ?? EngineCollider.FirstNumber : -1;

    /// <summary>The collider of a number that is nearest to a ball: of those of the last step, else the one that had the number last; null where none had.</summary>
    public EngineCollider? Of(int number, in Vector3d position, double time) =>
        Nearest(number, in position, time, -1) is >= 0 and int place ? _colliders[place].Engine : _known.TryGetValue(number, out EngineCollider? known) ? known : null;

    /// <summary>Index among the world's colliders of one of the last step.</summary>
    public int IndexOf(int number, in Vector3d position, double time) => Nearest(number, in position, time, -1) is >= 0 and int place ? IndexOf(place) : _first;

    /// <summary>Index among the world's colliders of a place: the numbers of nets and goals come between the first places and those that were added.</summary>
    private int IndexOf(int place) => _first + place + (place > Room ? _passages : 0);

    /// <summary>The place of the collider of a number whose surface is nearest to a ball: several may have one name, and with it one number.</summary>
    /// <param name="number">The number.</param>
    /// <param name="position">The ball, m.</param>
    /// <param name="time">When, s.</param>
    /// <param name="found">So many of the last cast are asked; negative: all of the last step.</param>
    private int Nearest(int number, in Vector3d position, double time, int found)
    {
        int nearest = -1;
        double least = double.PositiveInfinity;
        int count = found < 0 ? _used - 1 : found;
        for (int i = 0; i < count; i++)
        {
            int place = found < 0 ? i + 1 : _places[_world.Colliders[_found[i]].Engine!];
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

    /// <summary>Remembers what the ball has pushed so far, in one of the memories of <see cref="EnginePushes"/>.</summary>
    public void KeepPushes(int memory) => Pushes.Keep(memory);

    /// <summary>Puts that back.</summary>
    public void PutPushesBack(int memory)
    {
        Pushes.PutBack(memory);
        _isKnown = false;
    }

    /// <summary>The engine has placed its colliders anew: what pushed them before is over.</summary>
    public void ForgetPushes()
    {
        Pushes.Forget();
        _isKnown = false;
    }

    /// <summary>True when nothing can be met on a straight way.</summary>
    public bool IsFree(in StraightWay way)
    {
        Vector3d from = way.From;
        Vector3d to = from + (way.Duration * way.Velocity);
        Look(in from, in to, way.Around, way.Time, way.Duration);

        // The cast finds colliders near the path. Whether the path reaches one is tested against its moving box.
        for (int i = 0; i < Count; i++)
        {
            Collider collider = _world.Colliders[_found[i]];
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

        // The engine's colliders have their positions at one time, and may have moved when the ball passes. Expand the cast by that motion.
        double now = _engine.Time;
        double apart = Math.Max(Math.Abs(time - now), Math.Abs(time + duration - now));
        double moved = Moved(apart);
        Cast(in from, in to, moved);
        double asked = moved;

        // A newly found rotating collider may have moved farther than the cast allowed for, so cast again with the larger margin.
        if (NoteRotating() && Moved(apart) is var farther && farther > moved)
        {
            Cast(in from, in to, farther);
            NoteRotating();
            asked = farther;
        }

        Count = 0;
        if (_found.Length < _hits.Count)
        {
            Array.Resize(ref _found, _hits.Count);
        }

        // An engine may return all its colliders. One outside the box of the cast is optional in its answer, so skip it.
        Bounds3d box = new Bounds3d(in from, in from).Union(new Bounds3d(in to, in to)).Expanded(_around + asked);
        for (int i = 0; i < _hits.Count; i++)
        {
            EngineCollider hit = _hits.At(i);
            hit.FoundAt(now);
            if (!hit.Placement.BoundsAt(now).Intersects(in box) && !hit.Placement.BoundsDuring(time, duration).Intersects(in box))
            {
                continue;
            }

            // A collider keeps its index from cast to cast, so that the index of a carrier stays valid.
            _found[Count++] = IndexOf(PlaceOf(hit));
        }
    }

    private void Cast(in Vector3d from, in Vector3d to, double moved)
    {
        _hits.Clear();
        _engine.Cast(new SphereCast(in from, in to, _around + moved, _ballRadius), _hits);
    }

    /// <summary>How far any part of them may have moved in a time, m: what rotates no farther than across the circle that it moves in.</summary>
    private double Moved(double apart)
    {
        double most = apart * _engine.MaximumSpeed;
        for (int i = _rotating.Count - 1; i >= 0; i--)
        {
            ref RigidMotion motion = ref _rotating[i].Placement.Motion;
            if (!motion.Rotates)
            {
                _isRotating.Remove(_rotating[i]);
                _rotating.RemoveAt(i);
                continue;
            }

            double across = 2.0 * _rotating[i].Placement.Reach;
            most = across < double.PositiveInfinity ? Math.Max(most, (apart * motion.Velocity.Length) + Math.Min(apart * motion.Swing, across)) : most;
        }

        return most;
    }

    /// <summary>Remembers the found colliders that rotate.</summary>
    /// <returns>True if any of them was not known.</returns>
    private bool NoteRotating()
    {
        bool isNew = false;
        for (int i = 0; i < _hits.Count; i++)
        {
            EngineCollider hit = _hits.At(i);
            if (hit.Placement.Motion.Rotates && _isRotating.Add(hit))
            {
                // An engine may create new colliders without end, so drop the oldest one beyond twice the size of an answer.
                if (_rotating.Count >= Math.Max(Room, 2 * _hits.Count))
                {
                    _isRotating.Remove(_rotating[0]);
                    _rotating.RemoveAt(0);
                }

                _rotating.Add(hit);
                isNew = true;
            }
        }

        return isNew;
    }

    /// <summary>The place of a collider: its own if an earlier cast of the step has found it, or the next free one.</summary>
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

        // The slot may still contain the same collider from an earlier step, which is then known.
        place = _used++;
        _places.Add(hit, place);
        if (!ReferenceEquals(_colliders[place].Engine, hit))
        {
            _colliders[place].Become(hit);
            Know(hit);
        }

        return place;
    }

    /// <summary>Adds places. The world gets them as colliders too.</summary>
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

    /// <summary>Remembers who has a number.</summary>
    private void Know(EngineCollider collider)
    {
        // An engine may create new colliders without end, so clear the cache when it is full. Colliders in use are found again.
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
