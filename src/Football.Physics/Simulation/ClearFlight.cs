using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Checks that a flight, or a path along the ground, reaches no object except level ground.</summary>
/// <remarks>
/// The broad phase is queried for several steps ahead. The state stores the time up to which the path is clear; until then no query is
/// needed. The stored time is valid only in the scene with the same key.
/// </remarks>
internal sealed class ClearFlight
{
    /// <summary>Number of steps to look ahead if the air changes the motion little per step; also that of the spheres of balls in a group.</summary>
    public const double Ahead = 16;

    /// <summary>Number of steps to look ahead if the longer path is not clear: fewer steps need a narrower margin.</summary>
    private const double Nearer = 4;

    /// <summary>The margin of a search for bodies is that of a step this many times as long.</summary>
    private const double LongestStep = 2;

    /// <summary>The steps of a display vary in length: a tube is valid for steps up to this many times as long as the one for which it was found.</summary>
    private const double Varying = 1.1;

    /// <summary>If the air changes the motion by less than this per step, no integrator speeds the ball up by more than a tenth over all
    /// steps ahead.</summary>
    private const double SmallChange = 0.05;

    /// <summary>Maximum position error of a flight in single precision, m.</summary>
    private const double Rounding = 0.01;

    /// <summary>The share by which the validated path is narrower and shorter than the searched one, to allow for rounding.</summary>
    private const double Narrower = 1e-3;

    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly RateBound _ordinary;
    private readonly double _weight;
    private readonly double _shareInPath;
    private readonly double _friction;
    private readonly BodyTube? _tube;

    /// <summary>Prepares the queries of a scene.</summary>
    /// <param name="world">The world.</param>
    /// <param name="limit">Bounds how fast the air can change the motion.</param>
    /// <param name="ordinary">The same bound up to <see cref="AirLaws.OrdinarySpeed"/>.</param>
    /// <param name="wind">Wind, m/s.</param>
    /// <param name="weight">Magnitude of the acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="shareInPath">c in the integrator's path p + h (v + c h a).</param>
    public ClearFlight(World world, in StabilityLimit limit, in RateBound ordinary, in Vector3d wind, double weight, double shareInPath)
    {
        _world = world;
        _limit = limit;
        _ordinary = ordinary;
        _weight = weight;
        _shareInPath = Math.Max(0.5, shareInPath);
        _friction = world.Ground is { } ground ? ground.Materials.Max(material => material.Resistance.Largest) : 0;
        _tube = world.Bodies is { } bodies ? new BodyTube(bodies, world.Ball.Ignores) : null;

        // Hash all inputs of the result, so that a state moved to another scene does not keep its clear time.
        var key = new ClearKey();
        key.Add(limit.Bound.PerSpeed);
        key.Add(limit.Bound.PerSpin);
        key.Add(limit.Bound.Constant);
        key.Add(ordinary.PerSpeed);

        // Keep the negative sign, because keys stored by earlier versions include it.
        key.Add(-weight);
        key.Add(_shareInPath);
        key.Add(in wind);
        key.Add(_friction);
        world.BroadPhase.AddTo(ref key);
        Key = key.Value;
    }

    /// <summary>The key of the scene.</summary>
    public ulong Key { get; }

    /// <summary>The tube along the path of the ball; null without bodies.</summary>
    public BodyTube? Tube => _tube;

    /// <summary>True if every step has to check for bodies or engine colliders.</summary>
    public bool LooksForBodies => _tube is not null || _world.Engine is not null;

    /// <summary>True if the next step along the ground reaches no other object.</summary>
    /// <remarks>Friction also bends the path, and may convert spin to speed or speed to spin.</remarks>
    /// <param name="s">The ball, on the ground.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="airSpeed">|u|, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    public bool HoldsOnSurface(ref BallState s, double dt, double airSpeed, double spinRate)
    {
        if (_tube is null && _world.Engine is null && s.Time + dt <= s.ClearUntil && s.ClearIn == Key)
        {
            return true;
        }

        double radius = _world.Ball.Radius;
        double most = airSpeed + (radius * spinRate);
        return Holds(ref s, dt, most * most, spinRate + (airSpeed / radius), 1.0 + _friction);
    }

    /// <summary>True if the next step reaches no object.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="airSpeedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s.</param>
    /// <param name="friction">Factor by which friction increases the acceleration: 1 in the air, 1 + μ on a surface.</param>
    public bool Holds(ref BallState s, double dt, double airSpeedSquared, double spinRate, double friction = 1.0)
    {
        // Use the clear time stored in the state. It excludes bodies, which may change their motion; the tube covers them.
        bool isKnown = s.Time + dt <= s.ClearUntil && s.ClearIn == Key;
        return (isKnown && _world.Engine is null && (_tube is null || _tube.Holds(in s, dt, airSpeedSquared, spinRate, friction)))
            || IsFree(ref s, dt, isKnown, airSpeedSquared, spinRate, friction);
    }

    /// <summary>True if the next step reaches no object, by new queries.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool IsFree(ref BallState s, double dt, bool isKnown, double airSpeedSquared, double spinRate, double friction)
    {
        var push = new FlightPush(airSpeedSquared, spinRate, friction);

        // An engine may move its colliders between steps: query it in every step.
        if (_world.Engine is { } engine)
        {
            double bend = Bend(in push, dt, dt);
            if (s.Nets != 0 || !engine.IsFree(new StraightWay(s.Position, s.Velocity, s.Time, dt, _world.Ball.Radius + bend)))
            {
                return false;
            }
        }

        if (isKnown && _tube is null)
        {
            return true;
        }

        // Nets and goal mouths have no bounding box, so a ball inside one is never clear.
        if (!isKnown && (s.Nets != 0 || s.GoalsEntered != 0))
        {
            return false;
        }

        // The path ahead is a straight line with a margin: the distance by which forces can bend it.
        double steps = dt * RateAtMost(push.AirSpeed, push.SpinRate) <= SmallChange ? Ahead : 1.0;
        return (isKnown || IsFree(ref s, dt, steps, in push) || (steps > 1.0 && (IsFree(ref s, dt, Nearer, in push) || IsFree(ref s, dt, 1.0, in push))))
            && (_tube is null || IsFreeOfBodies(in s, dt, steps, in push));
    }

    /// <summary>True if the clear time stored in a state is plausible: the straight path of the ball must be clear.</summary>
    /// <remarks>The real path bends less than the margin that was searched.</remarks>
    public bool MayBeFree(in BallState s)
    {
        double ahead = s.ClearUntil - s.Time;
        double radius = (1.0 - Narrower) * _world.Ball.Radius;
        var way = new StraightWay(s.Position, s.Velocity, s.Time, ahead, radius);
        Vector3d end = s.Position + (ahead * s.Velocity);
        for (int i = 0; i < _world.BroadPhase.Unbounded.Length; i++)
        {
            Collider collider = _world.ByIndex[_world.BroadPhase.Unbounded[i]];
            if (!collider.IsLevelGround && !(collider.At(in end).Distance >= radius))
            {
                return false;
            }
        }

        return _world.BroadPhase.Tree.FirstMet(in way, ahead) >= (1.0 - Narrower) * ahead;
    }

    /// <inheritdoc cref="Stepper.FliesClear"/>
    public bool HasFlown(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate)
    {
        // In a time t, a path with an acceleration of at most a stays within ⅛ a t² of the chord between its ends.
        double most = airSpeed + (duration * _weight);
        double bend = 0.125 * (_weight + (RateAtMost(most, spinRate) * most)) * duration * duration;
        var way = new StraightWay(in from, (to - from) / duration, 0, duration, _world.Ball.Radius + bend + Rounding);
        return _world.BroadPhase.FreeFor(in way) >= duration;
    }

    private bool IsFree(ref BallState s, double dt, double steps, in FlightPush push)
    {
        double ahead = steps * dt;

        // The query radius is the ball's radius plus the deviation of the path from a straight line.
        double around = _world.Ball.Radius + Bend(in push, ahead, ahead);
        double free = _world.BroadPhase.FreeFor(new StraightWay(s.Position, s.Velocity, s.Time, ahead, around));
        s.ClearUntil = s.Time + free;
        s.ClearIn = Key;
        return dt <= free;
    }

    /// <summary>True if no body is near in the next step.</summary>
    /// <remarks>
    /// Only that step counts, so the result does not depend on earlier queries: a tube that stays clear for some time is wider, and never decides
    /// otherwise. It is not worth its search while the game moves bodies before every step.
    /// </remarks>
    private bool IsFreeOfBodies(in BallState s, double dt, double steps, in FlightPush push)
    {
        if (steps > 1.0 && _tube!.IsWorthwhile)
        {
            // The tube is valid for somewhat longer steps and for the speed that the ball may gain. The margin of such a step is larger.
            double ahead = Math.Min(steps * dt, Math.Max(dt, KinematicBodies.Foresight));
            double longest = Varying * dt;
            FlightPush later = push.At(SpeedLater(in push, ahead));
            if (_tube.Renew(in s, in later, dt, longest, ahead, BodyTube.Width(Bend(in push, ahead, ahead)), AroundStep(in later, longest)))
            {
                return true;
            }
        }

        return _tube!.IsFree(in s, dt, AroundStep(in push, dt));
    }

    /// <inheritdoc cref="Stepper.SearchMargin"/>
    public double MarginAt(double speed, double spinRate, double dt)
    {
        // On a surface, spin may become speed, and speed spin.
        double radius = _world.Ball.Radius;
        double most = speed + (radius * spinRate);
        return AroundStep(new FlightPush(most * most, spinRate + (speed / radius), 1.0 + _friction), dt);
    }

    /// <summary>Returns the margin of a search for bodies in one step, m. It grows with each argument.</summary>
    private double AroundStep(in FlightPush push, double dt)
    {
        double longest = LongestStep * dt;
        return _world.Ball.Radius + BodyTube.Width(Bend(in push, dt, dt)) + Bend(in push, dt + longest, longest);
    }

    /// <summary>Bounds the distance of the ball from a straight line, m: c a t², which is ½ a t² for most integrators.</summary>
    /// <remarks>It includes the speed that the ball may gain.</remarks>
    /// <param name="push">Bounds of the forces now.</param>
    /// <param name="ahead">Time until which the speed may grow, s.</param>
    /// <param name="during">t, s.</param>
    private double Bend(in FlightPush push, double ahead, double during)
    {
        // c a t² with a = (1 + μ)(g + λ |u|): friction μ, weight g, airspeed |u|. The rate λ bounds how fast the air can change the motion.
        double most = SpeedLater(in push, ahead);
        double acceleration = push.FrictionFactor * (_weight + (RateAtMost(most, push.SpinRate) * most));
        return _shareInPath * acceleration * during * during;
    }

    private double RateAtMost(double speed, double spinRate)
    {
        double ordinary = _ordinary.At(speed, spinRate);
        return speed <= AirLaws.OrdinarySpeed ? ordinary : Math.Max(ordinary, _limit.RateAtMost(speed, spinRate));
    }

    /// <summary>Upper bound of the airspeed after a time, m/s.</summary>
    private double SpeedLater(in FlightPush push, double ahead) => 1.1 * (push.AirSpeed + (ahead * push.FrictionFactor * _weight));
}

/// <summary>Bounds of the forces that bend a path.</summary>
internal readonly struct FlightPush(double airSpeedSquared, double spinRate, double friction)
{
    /// <summary>|u|², m²/s².</summary>
    public readonly double AirSpeedSquared = airSpeedSquared;

    /// <summary>|ω|, rad/s.</summary>
    public readonly double SpinRate = spinRate;

    /// <summary>Factor by which friction increases the acceleration.</summary>
    public readonly double FrictionFactor = friction;

    /// <summary>|u|, m/s.</summary>
    public readonly double AirSpeed = Math.Sqrt(airSpeedSquared);

    /// <summary>Returns the bounds at another air speed, m/s.</summary>
    public FlightPush At(double airSpeed) => new(airSpeed * airSpeed, SpinRate, FrictionFactor);
}
