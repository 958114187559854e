using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Simulation;

/// <summary>The zones of a scene, checked against each piece of the path.</summary>
/// <remarks>
/// This class is immutable: a ball's data is in its log.
/// Zones never shorten a piece: the path is searched after it was taken. Whether the ball is in a zone follows from its position, so the
/// state stores nothing.
/// If an object displaces the ball, the zones search the straight line between the two positions.
/// </remarks>
internal sealed class ZoneWatch
{
    /// <summary>A quintic deviates from the cubic with the same ends by less than this share of h² times the difference of their
    /// accelerations.</summary>
    private const double QuinticMargin = 0.1;

    private readonly Zone[] _zones;
    private readonly Bounds3d[] _bounds;
    private readonly double[] _levels;
    private readonly double[] _hollows;
    private readonly int[] _things;
    private readonly Bounds3d _all;

    private ZoneWatch(Zone[] zones, int[] things, double radius)
    {
        _zones = zones;
        _things = things;
        _levels = Array.ConvertAll(zones, zone => zone.LevelOf(radius));
        _hollows = Array.ConvertAll(zones, zone => HollowSamples.Corrected(zone.Shape, zone.LevelOf(radius)));
        _bounds = new Bounds3d[zones.Length];
        _all = Bounds3d.Nowhere;
        for (int i = 0; i < zones.Length; i++)
        {
            _bounds[i] = zones[i].Shape.Bounds.Expanded(_levels[i] + Zone.Touching);
            _all = _all.Union(in _bounds[i]);
        }
    }

    /// <summary>Returns the zones of a scene; null if there are none, so that steps have no cost.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="firstThing">Index of the first zone among the scene's objects.</param>
    public static ZoneWatch? Of(Scene scene, int firstThing)
    {
        if (scene.Zones.Count == 0)
        {
            return null;
        }

        // Zones that the ball ignores also keep their indices.
        int[] seen = [.. Enumerable.Range(0, scene.Zones.Count).Where(i => !Layers.Contains(scene.Ball.Ignores, scene.Zones[i].Layer))];
        return seen.Length == 0 ? null : new ZoneWatch(Array.ConvertAll(seen, i => scene.Zones[i]), Array.ConvertAll(seen, i => firstThing + i), scene.Ball.Radius);
    }

    /// <summary>Starts a step, or continues one that is taken in several calls.</summary>
    public void Begin(StepLog log, in BallState s)
    {
        if (log.Continues && log.Zones == this)
        {
            Jump(log, s.Position, in s);
            return;
        }

        log.Zones = this;
        log.ZonePlace = s.Position;
    }

    /// <summary>Handles a ball that may have been displaced between pieces.</summary>
    public void Moved(StepLog log, in BallState s) => Jump(log, s.Position, in s);

    /// <summary>True if a piece may cross the border of a zone, so that its path must be accurate.</summary>
    public bool IsNear(in BallState before, in BallState after, in Vector3d startAcceleration)
    {
        double h = after.Time - before.Time;
        Vector3d from = before.Position;
        Vector3d to = after.Position;
        Vector3d v = h * before.Velocity;
        Vector3d w = h * after.Velocity;
        Bounds3d box = BoundsOf(in from, from + (0.5 * v)).Union(BoundsOf(in to, to - (0.5 * w)));
        Vector3d off = (h * h * startAcceleration) - ((6.0 * (to - from)) - (4.0 * v) - (2.0 * w));
        box = box.Expanded((QuinticMargin * off.Length) + Zone.Touching);
        if (!_all.Intersects(in box))
        {
            return false;
        }

        for (int i = 0; i < _zones.Length; i++)
        {
            if (IsNear(i, in box))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Searches a piece of the path.</summary>
    public void See(StepLog log, in BallState before, in BallState after, in Vector3d startAcceleration, in Vector3d endAcceleration, int order)
    {
        Jump(log, before.Position, in before);
        if (!(after.Time > before.Time))
        {
            Jump(log, after.Position, in before);
            return;
        }

        log.ZonePlace = after.Position;
        if (IsNear(in before, in after, in startAcceleration))
        {
            var path = PathPolynomial.Between(
                before.Position,
                before.Velocity,
                in startAcceleration,
                after.Position,
                after.Velocity,
                in endAcceleration,
                after.Time - before.Time,
                PathSegment.DegreeOf(order, hasEndAcceleration: true));
            Find(log, in path);
            Report(log, in path, in before, in after);
        }
    }

    /// <summary>Searches the straight line of a displacement.</summary>
    private void Jump(StepLog log, in Vector3d to, in BallState s)
    {
        Vector3d from = log.ZonePlace;
        if (from == to)
        {
            return;
        }

        log.ZonePlace = to;
        if (_all.Intersects(BoundsOf(in from, in to)))
        {
            var path = PathPolynomial.Line(in from, in to);
            Find(log, in path);
            Report(log, in path, in s, in s);
        }
    }

    private void Find(StepLog log, in PathPolynomial path)
    {
        Bounds3d box = path.Bounds;
        for (int i = 0; i < _zones.Length; i++)
        {
            if (IsNear(i, in box))
            {
                new ZoneSearch(log, in path, i, _zones[i].Shape, _hollows[i], _levels[i]).Run();
            }
        }
    }

    /// <summary>True if the border of a zone may pass through a box.</summary>
    /// <remarks>The box must touch the zone's box, and its centre must be no farther from the border than from its corners.</remarks>
    private bool IsNear(int zone, in Bounds3d box)
    {
        if (!_bounds[zone].Intersects(in box))
        {
            return false;
        }

        Vector3d half = 0.5 * (box.Max - box.Min);
        return Math.Abs(_zones[zone].Shape.At(box.Min + half).Distance - _levels[zone]) <= half.Length + Zone.Touching;
    }

    /// <summary>Reports the crossings of a piece in order.</summary>
    private void Report(StepLog log, in PathPolynomial path, in BallState before, in BallState after)
    {
        double h = after.Time - before.Time;
        foreach (ref readonly ZoneCrossing crossing in log.TakeCrossings())
        {
            Vector3d place = path.At(crossing.At);
            Vector3d velocity = h > 0 ? path.RateAt(crossing.At) / h : before.Velocity;
            Vector3d spin = before.Spin + (crossing.At * (after.Spin - before.Spin));
            Vector3d normal = _zones[crossing.Zone].Shape.At(in place).Normal;
            log.ZoneEvents++;
            log.Events.Add(new BallEvent(
                crossing.Enters ? BallEventKind.EnterZone : BallEventKind.ExitZone,
                _things[crossing.Zone],
                in normal,
                Math.Min(before.Time + (crossing.At * h), after.Time),
                in place,
                in velocity,
                in spin,
                in velocity,
                in spin));
        }
    }

    private static Bounds3d BoundsOf(in Vector3d a, in Vector3d b) => new(
        new Vector3d(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z)), new Vector3d(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z)));
}
