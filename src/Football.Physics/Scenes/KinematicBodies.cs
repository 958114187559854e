using System.Collections;
using System.Globalization;

namespace FootballPhysics;

/// <summary>The things of a scene that the game moves: players' feet, legs and heads, a keeper's hands.</summary>
/// <remarks>
/// All are added before the first simulator of the scene is built, players who come on later too: <see cref="KinematicBody.Withdraw"/> keeps such a reserve out of play, at no cost to
/// the steps, until <see cref="KinematicBody.MoveTo(Vector3d, Vector3d, double)"/> brings him on. A scene with bodies is for one match: they are where the game has put them last, and
/// its simulators are not for several threads at once. A snapshot of the ball does not hold them: a <see cref="Rollback"/> and a <see cref="Recording"/> keep where they were, or ask
/// <see cref="FixedStepRunner.MoveBodies"/>.
/// </remarks>
public sealed class KinematicBodies : IReadOnlyList<KinematicBody>
{
    /// <summary>Nobody relies for longer than this, s, on where a body is expected.</summary>
    internal const double Foresight = 0.25;

    private readonly List<KinematicBody> _bodies = [];
    private readonly MovingSpheres _movers = new();
    private RigidMotion[] _kept = [];
    private bool _inUse;
    private double _tick = double.NaN;
    private double _before;
    private double _inTick;
    private double _earliest = double.PositiveInfinity;
    private double _latest = double.NegativeInfinity;
    private long _steps;
    private bool _lookAhead;

    /// <summary>How many there are.</summary>
    public int Count => _bodies.Count;

    /// <inheritdoc/>
    public KinematicBody this[int index] => _bodies[index];

    /// <summary>Adds a body.</summary>
    /// <param name="name">Its name, for events and messages.</param>
    /// <param name="shape">Its shape, in its own frame.</param>
    /// <param name="surface">What it is made of; default <see cref="SurfaceMaterial.Boot"/>.</param>
    /// <param name="mass">Mass behind its surface, kg; above 0; default infinite: the ball does not move it.</param>
    /// <param name="layer">Its layer: a ball that ignores it passes through. 0 … 31; default 0.</param>
    /// <returns>The body, at the origin, for the game to move.</returns>
    /// <exception cref="ArgumentNullException">Name or shape is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="mass"/> is not above 0, or <paramref name="layer"/> is out of range.</exception>
    /// <exception cref="InvalidOperationException">A simulator uses the bodies already: a player who comes on later is added before, and withdrawn.</exception>
    public KinematicBody Add(string name, IShape shape, SurfaceMaterial? surface = null, double mass = double.PositiveInfinity, int layer = 0)
    {
        Check.Given(nameof(name), name);
        Check.Given(nameof(shape), shape);
        Check.Within(nameof(mass), mass, 0, double.PositiveInfinity, exclusiveLow: true);
        Layers.Validate(nameof(layer), layer);

        // Simulators have counted them: a later one would not be in their lists, nor in snapshots of motions.
        if (_inUse)
        {
            throw new InvalidOperationException(
                "A body cannot be added after a Simulator was built with these bodies. Add all bodies before, and call Withdraw on those that enter later; MoveTo brings them back.");
        }

        var body = new KinematicBody(this, _bodies.Count, name, shape, surface ?? SurfaceMaterial.Boot, mass, layer);
        _bodies.Add(body);
        Array.Resize(ref _kept, _bodies.Count);
        _movers.Add(body.BoundsAt(0), body.Velocity);
        return body;
    }

    /// <summary>Adds a body of a kind.</summary>
    /// <param name="name">Its name, for events and messages.</param>
    /// <param name="kind">Its shape, surface and mass: <see cref="BodyKind.Boot"/>, <see cref="BodyKind.Player"/> and others.</param>
    /// <param name="layer">Its layer: a ball that ignores it passes through. 0 … 31; default 0.</param>
    /// <returns>The body, at the origin, for the game to move.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The mass of the kind is not above 0, or <paramref name="layer"/> is out of range.</exception>
    /// <exception cref="InvalidOperationException">A simulator uses the bodies already: a player who comes on later is added before, and withdrawn.</exception>
    public KinematicBody Add(string name, BodyKind kind, int layer = 0)
    {
        Check.Given(nameof(kind), kind);
        return Add(name, kind.Shape, kind.Surface, kind.Mass, layer);
    }

    /// <inheritdoc/>
    public IEnumerator<KinematicBody> GetEnumerator() => _bodies.GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>At least how far any of them can have been put from where it was expected, m, since there is this number: it only grows.</summary>
    internal double Strayed => _before + _inTick;

    /// <summary>Changes whenever one of them is moved, pushed or withdrawn; a call that leaves a body as it was changes nothing.</summary>
    internal long Version { get; private set; }

    /// <summary>From now on they are as many as they are.</summary>
    internal void Use() => _inUse = true;

    /// <summary>How long a ball goes on a straight way before it may meet any of them, s; not longer than the way.</summary>
    internal double FreeFor(in StraightWay way)
    {
        double free = way.Duration;

        // Of those whose sphere comes near the middle of the way, when the way first meets their box: broad phase, then slabs.
        double half = 0.5 * way.Duration;
        double time = way.Time + half;
        Vector3d middle = way.Middle;
        double reach = (half * way.Velocity.Length) + way.Around;
        for (int i = 0; _movers.Next(in middle, reach, time, half, ref i); i++)
        {
            free = Math.Min(free, way.SeenFrom(_bodies[i].Velocity).Meets(_bodies[i].BoundsDuring(way.Time, way.Duration)));
        }

        return free;
    }

    /// <summary>A body was moved, pushed or withdrawn: what a quick look needs is kept in one place.</summary>
    /// <param name="body">The body.</param>
    /// <param name="before">How it moved before.</param>
    internal void Update(KinematicBody body, in RigidMotion before)
    {
        Version += body.Placement.Motion.IsSame(in before) ? 0 : 1;
        if (body.IsWithdrawn)
        {
            _movers.Remove(body.Index);
        }
        else
        {
            _movers.Set(body.Index, body.Placement.BoundsAlways(0), body.Velocity);
        }
    }

    /// <summary>Refuses a step at a time for which the game did not move its bodies: they would not be where it says.</summary>
    /// <param name="time">The ball's time before the step, s.</param>
    /// <exception cref="ArgumentOutOfRangeException">A body was moved since the last step for a time more than <see cref="Foresight"/> from it.</exception>
    internal void CheckTimes(double time)
    {
        // Positions of a quarter of a second ago are what a network has; a body that was not moved since the last step goes on as it went.
        if (_earliest < time - Foresight || _latest > time + Foresight)
        {
            RefuseTime(time);
        }

        ForgetTimes();
    }

    /// <summary>The steps that follow are of another time than the game's moves, as those of a rollback are.</summary>
    internal void ForgetTimes()
    {
        _earliest = double.PositiveInfinity;
        _latest = double.NegativeInfinity;
        _steps++;
    }

    /// <summary>The ball's clock jumps: what the game has said for the time before the jump is of the time after it.</summary>
    /// <param name="from">The clock before, s.</param>
    /// <param name="to">The clock after, s.</param>
    /// <param name="isNew">Whether the clock begins anew, and all bodies go on from where they are; else the time is one of the same clock, and only those that were moved for the step to come.</param>
    internal void MoveClock(double from, double to, bool isNew)
    {
        if (from == to)
        {
            return;
        }

        _earliest = double.PositiveInfinity;
        _latest = double.NegativeInfinity;
        for (int i = 0; i < Count; i++)
        {
            // A body may have been moved for the time after the jump already.
            KinematicBody body = _bodies[i];
            bool isTold = IsTold(i);
            if (isTold ? Math.Abs(body.Time - from) < Math.Abs(body.Time - to) : isNew)
            {
                RigidMotion motion = body.Motion;
                motion.Time = to + (motion.Time - from);
                body.Motion = motion;
            }

            if (isTold && !body.IsWithdrawn)
            {
                _earliest = Math.Min(_earliest, body.Time);
                _latest = Math.Max(_latest, body.Time);
            }
        }
    }

    /// <summary>A body was moved: for a step to come, or within a look-ahead, after which it is put back.</summary>
    internal void Told(KinematicBody body, double time)
    {
        // What a look-ahead moves is put back: no step is told of it.
        if (_lookAhead)
        {
            return;
        }

        _earliest = Math.Min(_earliest, time);
        _latest = Math.Max(_latest, time);
        body.ToldAt = _steps;
    }

    /// <summary>A body was withdrawn: that is of no time, and holds from the step to come on.</summary>
    internal void Told(KinematicBody body) => body.ToldAt = _lookAhead ? body.ToldAt : _steps;

    /// <summary>True when the game has moved a body since the last step.</summary>
    internal bool IsTold(int body) => _bodies[body].ToldAt == _steps;

    /// <summary>The game has put a body there for the step to come.</summary>
    internal void Tell(int body, in RigidMotion motion)
    {
        _bodies[body].Motion = motion;
        _bodies[body].ToldAt = _steps;
    }

    private void RefuseTime(double now)
    {
        for (int i = 0; i < Count; i++)
        {
            // The first that is at fault is named.
            if (_bodies[i].ToldAt == _steps && !_bodies[i].IsWithdrawn && !(Math.Abs(_bodies[i].Time - now) <= Foresight))
            {
                throw Check.Refusal(
                    Check.Item("bodies", i) + ".time",
                    _bodies[i].Time.ToString("R", CultureInfo.InvariantCulture),
                    FormattableString.Invariant($"the ball's time before the step, {now:R} s, ± {Foresight:R} s"));
            }
        }
    }

    /// <summary>Remembers where all are, for a look-ahead that moves them.</summary>
    internal void Keep()
    {
        for (int i = 0; i < _kept.Length; i++)
        {
            _kept[i] = _bodies[i].Placement.Motion;
        }

        _lookAhead = true;
    }

    /// <summary>Puts all back to where they were when that was remembered.</summary>
    internal void PutBack()
    {
        // Through Motion, so that what was relied on meanwhile is known to have moved.
        for (int i = 0; i < _kept.Length; i++)
        {
            _bodies[i].Motion = _kept[i];
        }

        _lookAhead = false;
    }

    internal void Validate(BallProperties ball)
    {
        for (int i = 0; i < Count; i++)
        {
            string field = Check.Item("bodies", i);
            Check.Within(field + ".shape.hollowCurvature", _bodies[i].Shape.MaximumConcaveCurvature, 0, 0.5 / ball.Radius);
            _bodies[i].Surface.Validate(field + ".surface", ball.MostDamping);
        }
    }

    /// <summary>A body was moved.</summary>
    /// <param name="jump">How far from where it was expected, and goes on to stray by its new velocity, m.</param>
    /// <param name="time">When, s.</param>
    /// <param name="again">Whether it was moved at that time before: then it may have strayed twice.</param>
    internal void Moved(double jump, double time, bool again)
    {
        // All that are moved at one time have strayed no further than the one that strayed furthest.
        bool sameTick = time == _tick;
        _before += sameTick ? 0 : _inTick;
        _inTick = !sameTick ? jump : again ? _inTick + jump : Math.Max(_inTick, jump);
        _tick = time;
    }
}
