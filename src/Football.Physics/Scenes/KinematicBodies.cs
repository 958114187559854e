using System.Collections;
using System.Globalization;
using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>The bodies of a scene that your game moves: players' feet, legs and heads, a keeper's hands.</summary>
/// <remarks>
/// Add all bodies before you build the first simulator of the scene, including players who come on later. <see cref="KinematicBody.Withdraw"/> keeps a
/// substitute out of play, at no cost per step, until <see cref="KinematicBody.MoveTo(Vector3d, Vector3d, double)"/> brings him on.
/// <para>Use one scene with bodies per match, and do not share its simulators between threads. A snapshot of the ball does not store the bodies.
/// A <see cref="Rollback"/> or a <see cref="Recording"/> either stores the motions of the bodies or calls <see cref="FixedStepRunner.MoveBodies"/>.</para>
/// </remarks>
public sealed class KinematicBodies : IReadOnlyList<KinematicBody>
{
    /// <summary>The longest time for which a search relies on the expected motion of a body, in s.</summary>
    internal const double Foresight = 0.25;

    private KinematicBody[] _bodies = [];
    private readonly MovingSpheres _movers = new();
    private bool _inUse;
    private double _earliest = double.PositiveInfinity;
    private double _latest = double.NegativeInfinity;
    private double _recorded = double.NaN;
    private long _moves;
    private long _checked;
    private long _counted = -1;
    private long _version;
    private long _since;
    private bool _lookAhead;
    private long _claims;

    /// <summary>The number of bodies.</summary>
    public int Count => _bodies.Length;

    /// <inheritdoc/>
    public KinematicBody this[int index]
    {
        get
        {
            KinematicBody[] bodies = _bodies;
            return (uint)index < (uint)bodies.Length ? bodies[index] : throw NoBody(index);
        }
    }

    /// <summary>Adds a body.</summary>
    /// <param name="name">The name used in events and messages.</param>
    /// <param name="shape">The shape, in the body's frame.</param>
    /// <param name="surface">The material; default <see cref="SurfaceMaterial.Boot"/>.</param>
    /// <param name="mass">The effective mass at the surface, in kg; above 0; default infinite: the ball does not move the body.</param>
    /// <param name="layer">The layer; a ball that ignores this layer passes through. 0 … 31; default 0.</param>
    /// <returns>The body, at the origin; move it with <see cref="KinematicBody.MoveTo(Vector3d, Vector3d, double)"/>.</returns>
    /// <exception cref="ArgumentNullException">Name or shape is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="mass"/> is not above 0, or <paramref name="layer"/> is out of range.</exception>
    /// <exception cref="InvalidOperationException">A simulator already uses the bodies. Add substitutes earlier, and withdraw them until they come
    /// on.</exception>
    public KinematicBody Add(string name, IShape shape, SurfaceMaterial? surface = null, double mass = double.PositiveInfinity, int layer = 0)
    {
        Check.Given(nameof(name), name);
        Check.Given(nameof(shape), shape);
        Check.Within(nameof(mass), mass, 0, double.PositiveInfinity, exclusiveLow: true);
        Layers.Validate(nameof(layer), layer);

        // The number of bodies is fixed once simulators or snapshots use it.
        if (_inUse)
        {
            throw new InvalidOperationException(
                "A body cannot be added after a Simulator was built with these bodies. Add all bodies before, and call Withdraw on those that enter later; MoveTo brings them back.");
        }

        var body = new KinematicBody(this, name, shape, surface ?? SurfaceMaterial.Boot, mass, layer, _movers.Add());
        _bodies = [.. _bodies, body];
        return body;
    }

    /// <summary>Adds a body of the given kind.</summary>
    /// <param name="name">The name used in events and messages.</param>
    /// <param name="kind">The shape, surface and mass: <see cref="BodyKind.Boot"/>, <see cref="BodyKind.Player"/> and others.</param>
    /// <param name="layer">The layer; a ball that ignores this layer passes through. 0 … 31; default 0.</param>
    /// <returns>The body, at the origin; move it with <see cref="KinematicBody.MoveTo(Vector3d, Vector3d, double)"/>.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The mass of the kind is not above 0, or <paramref name="layer"/> is out of range.</exception>
    /// <exception cref="InvalidOperationException">A simulator already uses the bodies. Add substitutes earlier, and withdraw them until they come
    /// on.</exception>
    public KinematicBody Add(string name, BodyKind kind, int layer = 0)
    {
        Check.Given(nameof(kind), kind);
        return Add(name, kind.Shape, kind.Surface, kind.Mass, layer);
    }

    /// <inheritdoc/>
    public IEnumerator<KinematicBody> GetEnumerator() => ((IEnumerable<KinematicBody>)_bodies).GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>A counter that changes with the first move or push after each call. Searches for bodies are valid until then.</summary>
    internal long Moves
    {
        get
        {
            // Count the next move, too.
            _recorded = double.NaN;
            return _moves;
        }
    }

    /// <summary>A counter that changes whenever a body is moved, pushed or withdrawn. Calls without an effect do not change it.</summary>
    internal long Version
    {
        get
        {
            if (_counted != _moves)
            {
                _counted = Moves;
                _version = 0;
                foreach (KinematicBody body in _bodies)
                {
                    _version += body.Placement.Changes;
                }
            }

            return _version;
        }
    }

    /// <summary>Counts a push, or a motion that is restored.</summary>
    internal void CountMove() => _moves++;

    /// <summary>Fixes the number of bodies.</summary>
    internal void Use() => _inUse = true;

    /// <summary>Gives the bodies to a new runner, because only one runner at a time can move them. Returns the number of its claim.</summary>
    internal long Claim() => ++_claims;

    /// <summary>Throws if a later runner has claimed the bodies.</summary>
    /// <param name="claim">The runner's claim.</param>
    /// <exception cref="InvalidOperationException">There is a later claim.</exception>
    internal void CheckClaim(long claim)
    {
        if (claim != _claims)
        {
            throw new InvalidOperationException("A FixedStepRunner that was created later uses the bodies of this scene. Create a scene with bodies of its own for each runner.");
        }
    }

    /// <summary>Returns the time for which a ball on a straight path cannot hit any body, in s; at most the duration of the path.</summary>
    /// <remarks>It depends only on the motions of the bodies, and not on earlier searches.</remarks>
    /// <param name="from">The start, in m.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    /// <param name="time">The start time, in s.</param>
    /// <param name="duration">The duration, in s.</param>
    /// <param name="around">The margin, in m.</param>
    /// <param name="ignores">The layers that the ball ignores.</param>
    internal double FreeFor(in Vector3d from, in Vector3d velocity, double time, double duration, double around, uint ignores)
    {
        double free = duration;

        // The broad phase tests bounding spheres; then a slab test checks each candidate's box.
        double half = 0.5 * duration;
        Vector3d middle = from + (half * velocity);
        double reach = (half * velocity.Length) + around;
        for (int i = 0; _movers.Next(in middle, reach, time + half, half, ref i); i++)
        {
            if (!Layers.Contains(ignores, _bodies[i].Layer))
            {
                free = Math.Min(free, _bodies[i].FreeFor(in from, in velocity, time, duration, around));
            }
        }

        return free;
    }

    /// <summary>Throws if a body was moved for a time that is too far from the time of the step.</summary>
    /// <param name="time">The ball's time before the step, in s.</param>
    /// <exception cref="ArgumentOutOfRangeException">A body was moved since the last step for a time more than <see cref="Foresight"/> from it.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void CheckTimes(double time)
    {
        if (_checked != _moves)
        {
            CheckMoves(time);
        }
    }

    private void CheckMoves(double time)
    {
        // Networked positions can be a quarter of a second old. A body that the game did not move continues its motion.
        if (_earliest < time - Foresight || _latest > time + Foresight)
        {
            RefuseTime(time);
        }

        EndMoves();
    }

    /// <summary>Discards the moves and their times, because the next steps replay other times, as in a rollback.</summary>
    internal void ForgetTimes()
    {
        EndMoves();
        BeginMoves();
    }

    /// <summary>Starts the moves for the next step of a runner.</summary>
    /// <remarks>Until that step, the recorder of the runner records them, even if the game steps a copy of the ball before.</remarks>
    internal void BeginMoves() => _since = Steps;

    private void EndMoves()
    {
        _earliest = double.PositiveInfinity;
        _latest = double.NegativeInfinity;
        _recorded = double.NaN;
        _checked = _moves;
        Steps++;
    }

    /// <summary>Adjusts the times of the bodies when the ball's clock jumps.</summary>
    /// <param name="from">The clock before, in s.</param>
    /// <param name="to">The clock after, in s.</param>
    /// <param name="isNew">True if the clock restarts, so that all bodies shift with it. False for another time of the same clock: only moved bodies do.</param>
    internal void MoveClock(double from, double to, bool isNew)
    {
        if (from == to)
        {
            return;
        }

        _earliest = double.PositiveInfinity;
        _latest = double.NegativeInfinity;
        _recorded = double.NaN;
        for (int i = 0; i < Count; i++)
        {
            // The game may already have moved a body for the time after the jump.
            KinematicBody body = _bodies[i];
            bool wasMoved = body.MovedAt == Steps;
            if (wasMoved ? Math.Abs(body.Time - from) < Math.Abs(body.Time - to) : isNew)
            {
                RigidMotion motion = body.Motion;
                motion.Time = to + (motion.Time - from);
                body.Motion = motion;
            }

            if (wasMoved && !body.IsWithdrawn)
            {
                _earliest = Math.Min(_earliest, body.Time);
                _latest = Math.Max(_latest, body.Time);
            }
        }
    }

    /// <summary>The number of steps with moves so far.</summary>
    internal long Steps { get; private set; }

    /// <summary>True if the last move was recorded for this time, and nothing has read the counter of moves since, so that another move needs no record.</summary>
    internal bool IsTimeOfLast(double time) => time == _recorded;

    /// <summary>Records that the game moved a body for the next step.</summary>
    internal void RecordMove(KinematicBody body, double time)
    {
        if (IsTimeOfLast(time))
        {
            body.MovedAt = Steps;
            return;
        }

        // A look-ahead restores the bodies afterwards, so do not record its moves.
        _moves++;
        if (_lookAhead)
        {
            return;
        }

        _earliest = Math.Min(_earliest, time);
        _latest = Math.Max(_latest, time);
        _recorded = time;
        body.MovedAt = Steps;
    }

    /// <summary>Records that the game withdrew a body, which takes effect with the next step.</summary>
    internal void RecordWithdrawal(KinematicBody body)
    {
        _moves++;
        body.MovedAt = _lookAhead ? body.MovedAt : Steps;
    }

    /// <summary>True if the game has moved a body for the next step of a runner.</summary>
    internal bool WasMoved(int body) => _bodies[body].MovedAt >= _since;

    /// <summary>Moves a body for the next step, as if the game had done so.</summary>
    internal void Repeat(int body, in RigidMotion motion)
    {
        _bodies[body].Motion = motion;
        _bodies[body].MovedAt = Steps;
        _moves++;
    }

    private ArgumentOutOfRangeException NoBody(int index)
    {
        Check.Index(nameof(index), index, Count);
        return new ArgumentOutOfRangeException(nameof(index));
    }

    private void RefuseTime(double now)
    {
        for (int i = 0; i < Count; i++)
        {
            // Name the first body with a wrong time.
            if (_bodies[i].MovedAt == Steps && !_bodies[i].IsWithdrawn && !(Math.Abs(_bodies[i].Time - now) <= Foresight))
            {
                throw Check.Refusal(
                    Check.Item("bodies", i) + ".time",
                    _bodies[i].Time.ToString("R", CultureInfo.InvariantCulture),
                    FormattableString.Invariant($"the ball's time before the step, {now:R} s, ± {Foresight:R} s"));
            }
        }
    }

    /// <summary>Starts a look-ahead: its moves are not those of the next step.</summary>
    internal void BeginLook()
    {
        _lookAhead = true;
        _recorded = double.NaN;
    }

    /// <summary>Ends a look-ahead.</summary>
    internal void EndLook() => _lookAhead = false;

    internal void Validate(BallProperties ball)
    {
        for (int i = 0; i < Count; i++)
        {
            string field = Check.Item("bodies", i);
            HollowSamples.Validate(field, _bodies[i].Shape, ball.Radius);
            _bodies[i].Surface.Validate(field + ".surface", ball.MostDamping);
        }
    }
}
