namespace Football.Physics;

/// <summary>
/// The stationary surfaces that a ball touches at a position, and how far the ball may go from there before it comes to anything else. The answer is kept until the ball goes
/// farther, or something has moved. It follows from the position and the scene alone: a kept answer only says sooner what a new look would say.
/// </summary>
internal sealed class SetPlace
{
    /// <summary>Surfaces of a set at most.</summary>
    public const int Most = 3;

    /// <summary>A look sees so much farther than the step requires, m.</summary>
    private const double Farther = 0.25;

    /// <summary>A kept distance must exceed the required one by this much, m, for rounding.</summary>
    private const double Spare = 1e-9;

    private readonly World _world;
    private readonly Bodies? _bodies;
    private readonly Touched[] _touched = new Touched[Most];
    private Vector3d _center;
    private double _free = double.NegativeInfinity;
    private double _from;
    private double _until;
    private double _strayed;
    private long _obstacles;

    public SetPlace(World world)
    {
        _world = world;
        _bodies = world.Bodies;
    }

    /// <summary>The number of surfaces.</summary>
    public int Count { get; private set; }

    /// <summary>Changes when a look has found other surfaces, or the same surfaces at another position.</summary>
    public long Version { get; private set; }

    /// <summary>A surface, in the order of the scene.</summary>
    public ref readonly Touched this[int index] => ref _touched[index];

    /// <summary>True if a ball touches two or three stationary surfaces, and nothing else is within a distance, m, in a step.</summary>
    public bool Holds(in BallState s, double dt, double distance)
    {
        if (!IsKept(in s, dt, distance + Spare))
        {
            Look(in s, dt, distance);
        }

        return Count > 1 && _free > distance;
    }

    /// <summary>True if the material of every surface stays the same on a displacement.</summary>
    public bool KeepsMaterials(in Vector3d end, double displacement)
    {
        for (int i = 0; i < Count; i++)
        {
            Collider collider = _world.Colliders[_touched[i].Collider];
            if (collider.HasPatches && (collider.PatchAt(in end) != _touched[i].Patch || !(collider.LeastWidth >= 2.0 * displacement)))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if the last look still tells what the ball touches.</summary>
    private bool IsKept(in BallState s, double dt, double distance)
    {
        if (_world.Engine is not null || !(s.Time >= _from && s.Time + dt <= _until) || _obstacles != _world.Obstacles.Version)
        {
            return false;
        }

        double gone = (s.Position - _center).Length + (_bodies is null ? 0 : _bodies.Strayed - _strayed);
        if (!(_free - gone > distance))
        {
            return false;
        }

        for (int i = 0; i < Count; i++)
        {
            ref readonly Touched touched = ref _touched[i];
            Collider collider = _world.Colliders[touched.Collider];
            if (collider.StandingPlane is { } plane ? !(Math.Abs(plane.DistanceTo(s.Position) - _world.Ball.Radius) <= ContactSearch.Touching) : !IsSame(in touched, collider, in s))
            {
                return false;
            }

            if (collider.HasPatches && collider.PatchAt(s.Position) != touched.Patch)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if a surface that may have moved, or whose normal may turn, is as it was.</summary>
    private bool IsSame(in Touched touched, Collider collider, in BallState s)
    {
        ShapePoint at = collider.At(s.Position, s.Time);
        return Math.Abs(at.Distance - _world.Ball.Radius) <= ContactSearch.Touching && at.Normal == touched.Normal && IsStill(collider);
    }

    private static bool IsStill(Collider collider) => collider.Velocity == Vector3d.Zero && collider.Spin == Vector3d.Zero && !collider.Rotates;

    /// <summary>Looks at everything near the ball.</summary>
    private void Look(in BallState s, double dt, double distance)
    {
        Count = 0;
        Version++;
        _center = s.Position;
        _from = s.Time;
        _until = s.Time + Math.Max(dt, Bodies.Foresight);
        _strayed = _bodies?.Strayed ?? 0;
        _obstacles = _world.Obstacles.Version;

        // For the step, and farther for those to come: the answer for the step alone decides.
        double radius = _world.Ball.Radius;
        double reach = distance + Farther;
        double later = reach;
        _free = reach;
        _world.Engine?.LookAt(s.Position, s.Time, reach);
        var near = new NearThings(_world, new Bounds3d(s.Position, s.Position).Grown(radius + reach), s.Time, _until - s.Time);
        while (near.Next(out int thing))
        {
            if (_world.IsPassage(thing))
            {
                double away = Away(_world.BoundsOf(thing), s.Position) - radius;
                _free = Math.Min(_free, away);
                later = Math.Min(later, away);
                continue;
            }

            Collider collider = _world.Colliders[thing];
            if (!IsStill(collider))
            {
                _free = Math.Min(_free, AwayDuring(collider, in s, dt) - radius);
                later = Math.Min(later, AwayDuring(collider, in s, _until - s.Time) - radius);
                continue;
            }

            ShapePoint at = collider.At(s.Position, s.Time);
            double gap = at.Distance - radius;
            double free = Math.Abs(gap) <= ContactSearch.Touching ? Add(thing, collider, in at, in s) : gap;
            _free = Math.Min(_free, free);
            later = Math.Min(later, free);
        }

        // What is free in this step but not in the next ones is good for this step alone.
        _until = later > distance ? _until : double.NegativeInfinity;
        _free = later > distance ? later : _free;
    }

    /// <summary>Adds a surface that the ball touches.</summary>
    /// <returns>How far the ball may go until the surface is another one, m; not positive if the set cannot hold it.</returns>
    private double Add(int index, Collider collider, in ShapePoint at, in BallState s)
    {
        if (Count == Most)
        {
            return double.NegativeInfinity;
        }

        int place = Count++;
        for (; place > 0 && _world.ComesFirst(index, at.Normal, _touched[place - 1].Collider, in _touched[place - 1].Normal); place--)
        {
            _touched[place] = _touched[place - 1];
        }

        double margin = at.IsFlat && collider.HasFaces ? collider.FaceMargin(s.Position, s.Time) : double.PositiveInfinity;
        _touched[place] = new Touched(index, collider, in at, in s, _world.Ball);

        // Surfaces with one normal act as one: which of them does is not decided here.
        for (int i = 0; i < Count; i++)
        {
            margin = i != place && Vector3d.Dot(in _touched[i].Normal, at.Normal) > 1.0 - Flush.SameNormal ? double.NegativeInfinity : margin;
        }

        return margin;
    }

    /// <summary>How far the box around something that moves is from a position in a time, m.</summary>
    private static double AwayDuring(Collider collider, in BallState s, double duration)
    {
        Bounds3d box = collider.BoundsDuring(s.Time, duration);
        return Away(box.With(box.Moved(duration * collider.Velocity)), s.Position);
    }

    private static double Away(in Bounds3d box, in Vector3d position)
    {
        double x = Math.Max(0, Math.Max(box.Min.X - position.X, position.X - box.Max.X));
        double y = Math.Max(0, Math.Max(box.Min.Y - position.Y, position.Y - box.Max.Y));
        double z = Math.Max(0, Math.Max(box.Min.Z - position.Z, position.Z - box.Max.Z));
        return Math.Sqrt((x * x) + (y * y) + (z * z));
    }
}

/// <summary>A stationary surface that a ball touches.</summary>
internal readonly struct Touched
{
    /// <summary>Index of the collider.</summary>
    public readonly int Collider;

    /// <summary>The part of its pattern under the ball; −1 for none.</summary>
    public readonly int Patch;

    /// <summary>True if its normal stays the same when the ball moves.</summary>
    public readonly bool IsFixed;

    /// <summary>n, towards the ball.</summary>
    public readonly Vector3d Normal;

    /// <summary>μ_s, c₀, c₁, c_ω/I and b μ_s m/I of the surface.</summary>
    public readonly double Sliding;
    public readonly double Rolling;
    public readonly double RollingBySpeed;
    public readonly double Damping;
    public readonly double Drilling;

    public Touched(int index, Collider collider, in ShapePoint at, in BallState s, BallProperties ball)
    {
        ref readonly ContactMaterial material = ref collider.MaterialAt(s.Position);
        Collider = index;
        Patch = collider.PatchAt(s.Position);
        IsFixed = at.IsFlat && (collider.HasFaces || collider.IsPlane);
        Normal = at.Normal;
        Sliding = material.SlidingFriction;
        Rolling = material.RollingFriction;
        RollingBySpeed = material.RollingFrictionBySpeed;
        Damping = material.SpinDamping / ball.MomentOfInertia;
        Drilling = material.DrillingLength * material.SlidingFriction * ball.Mass / ball.MomentOfInertia;
    }
}
