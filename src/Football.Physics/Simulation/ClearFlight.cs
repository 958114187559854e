namespace FootballPhysics;

/// <summary>
/// True when a flight, or a way along the ground, meets nothing but level ground. The broad phase is asked for several steps at once, and its answer is kept with the state as a time:
/// until then a step asks nothing. It holds for the scene in which it was given, which a key tells from others.
/// </summary>
internal sealed class ClearFlight
{
    /// <summary>How many steps ahead it looks, where the air changes little in one.</summary>
    private const double Ahead = 16;

    /// <summary>Where that is not free, how many steps ahead it looks next: less of a bend lies around those.</summary>
    private const double Nearer = 4;

    /// <summary>Steps that are looked ahead for bodies, which may stray.</summary>
    private const double AheadOfBodies = 24;

    /// <summary>Steps of what the game shows differ in length: what holds for bodies holds for steps so many times as long.</summary>
    private const double LongestStep = 2;

    /// <summary>Up to this change of the motion by the air in a step no method makes a ball faster by more than a tenth in all steps ahead.</summary>
    private const double SmallChange = 0.05;

    /// <summary>How far, m, a flight in single precision may be from where it is said to be.</summary>
    private const double Rounding = 0.01;

    /// <summary>By so much of itself a way is taken narrower, and shorter, that is checked: for rounding.</summary>
    private const double Narrower = 1e-3;

    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly RateBound _ordinary;
    private readonly double _weight;
    private readonly double _shareInPath;
    private readonly double _friction;
    private readonly BodyTube? _tube;

    /// <summary>Prepares the questions.</summary>
    /// <param name="world">The world.</param>
    /// <param name="limit">How fast the air can change the motion.</param>
    /// <param name="ordinary">The same up to <see cref="AirLaws.OrdinarySpeed"/>.</param>
    /// <param name="wind">Wind, m/s.</param>
    /// <param name="weight">Size of the acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="shareInPath">c of the method's path p + h (v + c h a).</param>
    public ClearFlight(World world, in StabilityLimit limit, in RateBound ordinary, in Vector3d wind, double weight, double shareInPath)
    {
        _world = world;
        _limit = limit;
        _ordinary = ordinary;
        _weight = weight;
        _shareInPath = Math.Max(0.5, shareInPath);
        _friction = world.Ground is { } ground ? ground.Materials.Max(material => Math.Max(material.SlidingFriction, material.RollingFriction)) : 0;
        _tube = world.Bodies is { } bodies ? new BodyTube(bodies, world.Ball.Radius) : null;

        // All that the answer depends on: a state that is taken to another scene must not bring it along.
        var key = new ClearKey();
        key.Add(limit.Bound.PerSpeed);
        key.Add(limit.Bound.PerSpin);
        key.Add(limit.Bound.Constant);
        key.Add(ordinary.PerSpeed);

        // Downwards: the sign that states of earlier versions have in their key.
        key.Add(-weight);
        key.Add(_shareInPath);
        key.Add(in wind);
        key.Add(_friction);
        world.AddTo(ref key);
        Key = key.Value;
    }

    /// <summary>The key of the scene.</summary>
    public ulong Key { get; }

    /// <summary>True when there are bodies to look for in every step.</summary>
    public bool LooksForBodies => _tube is not null || _world.Engine is not null;

    /// <summary>True when the next step of flight meets nothing.</summary>
    /// <param name="s">The ball, in the air.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="airSpeedSquared">|u|², m²/s².</param>
    public bool Holds(ref BallState s, double dt, double airSpeedSquared) => Holds(ref s, dt, new Push(airSpeedSquared, s.SpinRate, 1.0));

    /// <summary>True when the next step along the ground meets nothing else. Friction adds to what bends the path, and may make speed of spin, or spin of speed.</summary>
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
        return Holds(ref s, dt, new Push(most * most, spinRate + (airSpeed / radius), 1.0 + _friction));
    }

    private bool Holds(ref BallState s, double dt, in Push push)
    {
        // An engine may move its colliders between two steps: it is asked in each.
        if (_world.Engine is { } engine)
        {
            double bend = Bend(in push, dt, dt);
            if (s.Nets != 0 || !engine.IsFree(new StraightWay(s.Position, s.Velocity, s.Time, dt, _world.Ball.Radius + bend)))
            {
                return false;
            }
        }

        // The answer that the state brings along; bodies, which stray, have theirs in the tube.
        bool isKnown = s.Time + dt <= s.ClearUntil && s.ClearIn == Key;
        if (isKnown && (_tube is null || _tube.Holds(in s, dt, push.AirSpeedSquared, push.SpinRate)))
        {
            return true;
        }

        // In a net and in the mouth of a goal a ball meets what has no box.
        if (s.Nets != 0 || s.GoalsEntered != 0)
        {
            return false;
        }

        // The way ahead is a straight line, and as much around it as forces can bend it.
        double steps = dt * RateAtMost(push.AirSpeed, push.SpinRate) <= SmallChange ? Ahead : 1.0;
        return (isKnown || IsFree(ref s, dt, steps, in push) || (steps > 1.0 && (IsFree(ref s, dt, Nearer, in push) || IsFree(ref s, dt, 1.0, in push))))
            && (_tube is null || IsFreeOfBodies(in s, dt, steps, in push));
    }

    /// <summary>
    /// True when the way ahead of a state may be as free as it says: the straight way of the ball alone is. Where that bends by no more than was looked along, it lies within
    /// what was found to be free.
    /// </summary>
    public bool MayBeFree(in BallState s)
    {
        double ahead = s.ClearUntil - s.Time;
        double radius = (1.0 - Narrower) * _world.Ball.Radius;
        var way = new StraightWay(s.Position, s.Velocity, s.Time, ahead, radius);
        Vector3d end = s.Position + (ahead * s.Velocity);
        for (int i = 0; i < _world.Unbounded.Length; i++)
        {
            Collider collider = _world.Colliders[_world.Unbounded[i]];
            if (!(collider == _world.Ground && _world.IsLevel) && !(collider.At(in end).Distance >= radius))
            {
                return false;
            }
        }

        return _world.Tree.FirstMet(in way, ahead) >= (1.0 - Narrower) * ahead;
    }

    /// <inheritdoc cref="Stepper.FliesClear"/>
    public bool HasFlown(in Vector3d from, in Vector3d to, double duration, double airSpeed, double spinRate)
    {
        // A path that bends by a at most is within ⅛ a t² of the straight way between its ends.
        double most = airSpeed + (duration * _weight);
        double bend = 0.125 * (_weight + (RateAtMost(most, spinRate) * most)) * duration * duration;
        var way = new StraightWay(in from, (to - from) / duration, 0, duration, _world.Ball.Radius + bend + Rounding);
        return _world.FreeFor(in way) >= duration;
    }

    private bool IsFree(ref BallState s, double dt, double steps, in Push push)
    {
        double ahead = steps * dt;

        // The ball, and as far around its straight way as it may bend in that time.
        double around = _world.Ball.Radius + Bend(in push, ahead, ahead);
        double free = _world.FreeFor(new StraightWay(s.Position, s.Velocity, s.Time, ahead, around));
        s.ClearUntil = s.Time + free;
        s.ClearIn = Key;
        return dt <= free;
    }

    /// <summary>
    /// True when no body is near in the next step: for that step alone, so that the answer is the same whatever was found before. Where it is so, a tube is looked for in which
    /// it stays so for some time.
    /// </summary>
    private bool IsFreeOfBodies(in BallState s, double dt, double steps, in Push push)
    {
        if (!Renew(in s, dt, 1.0, 0, in push))
        {
            return false;
        }

        if (steps > 1.0)
        {
            Renew(in s, dt, Math.Min(steps, AheadOfBodies), BodyTube.Width(Bend(in push, dt, dt)), in push);
        }

        return true;
    }

    private bool Renew(in BallState s, double dt, double steps, double spare, in Push push)
    {
        double ahead = Math.Min(steps * dt, Math.Max(dt, KinematicBodies.Foresight));
        double longest = LongestStep * dt;
        return _tube!.Renew(
            in s, push.SpinRate, dt, longest, ahead, spare, SpeedLater(in push, ahead), Bend(in push, ahead + longest, longest), Bend(in push, ahead, ahead));
    }

    /// <summary>A bound of how far the ball goes off a straight line, m: c a t², which is ½ a t² for most methods, with all that the air can do to the speed that the ball may have then.</summary>
    /// <param name="push">What acts on it now.</param>
    /// <param name="ahead">The speed may be that of so much later, s.</param>
    /// <param name="during">t, s.</param>
    private double Bend(in Push push, double ahead, double during)
    {
        // c a t² with a = (1 + μ)(g + λ |u|), λ how fast the air can change the motion.
        double most = SpeedLater(in push, ahead);
        double acceleration = push.Friction * (_weight + (RateAtMost(most, push.SpinRate) * most));
        return _shareInPath * acceleration * during * during;
    }

    private double RateAtMost(double speed, double spinRate) =>
        speed <= AirLaws.OrdinarySpeed ? _ordinary.At(speed, spinRate) : _limit.RateAtMost(speed, spinRate);

    /// <summary>A bound of the air speed so much later, m/s.</summary>
    private double SpeedLater(in Push push, double ahead) => 1.1 * (push.AirSpeed + (ahead * push.Friction * _weight));

    /// <summary>Bounds of what bends a path.</summary>
    private readonly struct Push(double airSpeedSquared, double spinRate, double friction)
    {
        /// <summary>|u|², m²/s².</summary>
        public readonly double AirSpeedSquared = airSpeedSquared;

        /// <summary>|ω|, rad/s.</summary>
        public readonly double SpinRate = spinRate;

        /// <summary>By how much friction adds to the air and the weight: 1 in the air, 1 + μ on a surface.</summary>
        public readonly double Friction = friction;

        /// <summary>|u|, m/s.</summary>
        public double AirSpeed => Math.Sqrt(AirSpeedSquared);
    }
}
