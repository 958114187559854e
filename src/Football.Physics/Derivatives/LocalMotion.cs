namespace Football.Physics;

/// <summary>What moves the ball along a piece of its way: the same systems that a step integrates, locked to the same branch, nets, guides and carrier.</summary>
internal sealed class LocalMotion<TAir>
    where TAir : struct, IAir
{
    /// <summary>A moment at the end of a slide, s.</summary>
    private const double LastOfSlide = 1.25e-5;

    private readonly Surroundings<TAir> _around;
    private readonly bool _groundIsEven;

    /// <summary>What friction turns, per what it brakes: r m/I, 1/m.</summary>
    private readonly double _torque;
    private FlightSystem<TAir> _flight;
    private CarriedSystem<TAir> _carried;
    private SlidingSystem<TAir> _sliding;
    private RollingSystem<TAir> _rolling;

    public LocalMotion(Surroundings<TAir> around, bool groundIsEven, BallProperties ball)
    {
        _torque = 1.0 / (ball.InertiaFactor * ball.Radius);
        _around = around;
        _groundIsEven = groundIsEven;
    }

    /// <summary>What the ball does.</summary>
    public MotionState Motion { get; private set; }

    /// <summary>The branch of the drag law.</summary>
    public DragBranch Branch { get; private set; }

    /// <summary>The nets that the ball is in.</summary>
    public ulong Nets { get; private set; }

    /// <summary>On which side of them it came.</summary>
    public ulong NetSides { get; private set; }

    /// <summary>Which way a carried ball spins about the normal: drilling friction keeps to it.</summary>
    public double SpinSign { get; private set; }

    /// <summary>Whether the rates depend on the place.</summary>
    public bool DependsOnPlace { get; private set; }

    /// <summary>Whether it is plain flight: along a constant axis of the spin, in air that does not vary, with nothing else that pushes.</summary>
    public bool IsPlainFlight { get; private set; }

    /// <summary>Whether the ball stands on its spot and only spins about the normal.</summary>
    public bool IsPinned { get; private set; }

    /// <summary>Whether something guides it, which bends its rates in ways that are not taken apart.</summary>
    public bool IsGuided => Motion == MotionState.Airborne ? _flight.Guides.Count > 0 : _around.World is not null && _carried.Guides.Count > 0;

    /// <summary>Makes it that of a ball.</summary>
    public void Take(in BallState s)
    {
        Motion = s.Motion;
        World? world = _around.World;
        Nets = world is null ? 0 : s.Nets;
        NetSides = s.NetSides;
        SpinSign = 0;
        Motion at = MotionVector.Of(in s);
        Branch = s.Branch != DragBranch.Unknown || !_around.Air.Jumps ? s.Branch : DragJump.At(in at, in _around.Wind, _around.Radius).Branch;
        IsPlainFlight = false;
        IsPinned = false;
        DependsOnPlace = _around.Air.Varies || Nets != 0;
        switch (s.Motion)
        {
            case MotionState.Airborne:
                _flight = new FlightSystem<TAir>
                {
                    Around = _around,
                    Branch = Branch,
                    Nets = Nets,
                    NetSides = NetSides,
                    Guides = world is null ? default : Guides.Of(world, s.Position, s.Velocity, s.Time, -1),
                };
                DependsOnPlace |= _flight.Guides.Count > 0;
                IsPlainFlight = !DependsOnPlace && Branch < DragBranch.AlongCriticalSpeed;
                break;
            case MotionState.Sliding or MotionState.Rolling when world is not null:
                TakeCarried(in s, in at, world);
                break;
            case MotionState.Sliding:
                Vector3d slip = Slip.Of(s.Velocity, s.Spin, _around.Radius);
                Vector3d way = Direction(in slip);
                _sliding = new SlidingSystem<TAir> { Around = _around, Branch = Branch, SlipX = way.X, SlipZ = way.Z, StartSpin = s.Spin };
                break;
            case MotionState.Rolling:
                TakeRolling(in s, in at);
                break;
        }
    }

    /// <summary>v̇ and ω̇.</summary>
    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        switch (Motion)
        {
            case MotionState.Airborne when Branch >= DragBranch.AlongCriticalSpeed && !IsGuided:
                // Beyond where it leaves the surface it goes on as before: a difference is that of one motion.
                double share = _flight.SpinningShare(time, in at, out MotionRates spinning, out MotionRates noSpin);
                rates = new MotionRates(
                    noSpin.Acceleration + (share * (spinning.Acceleration - noSpin.Acceleration)),
                    noSpin.SpinAcceleration + (share * (spinning.SpinAcceleration - noSpin.SpinAcceleration)));
                break;
            case MotionState.Airborne:
                _flight.Rates(time, in at, out rates);
                break;
            case MotionState.Sliding or MotionState.Rolling when _around.World is not null:
                _carried.Rates(time, in at, out rates);
                break;
            case MotionState.Sliding:
                _sliding.Rates(time, Planar(in at), out PlanarRates slides);
                rates = new MotionRates(slides.Acceleration, slides.SpinAcceleration);
                break;
            case MotionState.Rolling:
                _rolling.Rates(time, Planar(in at), out PlanarRates rolls);
                rates = new MotionRates(rolls.Acceleration, rolls.SpinAcceleration);
                break;
            default:
                rates = default;
                break;
        }
    }

    /// <summary>The nets that it is in.</summary>
    public NetJacobian NetPush => new(_around.World!, Nets, NetSides);

    /// <summary>Whether drilling friction ends its spin about the normal.</summary>
    public bool Drills => _around.World is not null && _carried.Material.DrillingLength > 0;

    /// <summary>What carries it, at a place.</summary>
    public ShapePoint SurfaceAt(in Vector3d position, double time) => _carried.Carrier.At(in position, time);

    /// <summary>The rates without what changes fast with the motion: with the friction of a slide along one direction, and without the push of nets in flight.</summary>
    /// <param name="time">Time, s.</param>
    /// <param name="at">The motion.</param>
    /// <param name="direction">Direction of the slip.</param>
    /// <param name="rates">v̇ and ω̇.</param>
    public void SmoothRates(double time, in Motion at, in Vector3d direction, out MotionRates rates)
    {
        if (Motion == MotionState.Airborne)
        {
            FlightSystem<TAir> free = _flight;
            free.Nets = 0;
            free.Rates(time, in at, out rates);
            return;
        }

        Rates(time, in at, out rates);
        if (Motion == MotionState.Sliding)
        {
            double size = FrictionAt(time, in at);
            MotionRates turned = Friction(time, in at, size, in direction);
            MotionRates own = Friction(time, in at, size, SlipDirection(time, in at));
            rates = new MotionRates(rates.Acceleration + (turned.Acceleration - own.Acceleration), rates.SpinAcceleration + (turned.SpinAcceleration - own.SpinAcceleration));
        }
    }

    /// <summary>What friction does to a ball that slides: v̇ = −μ_s N/m ŝ, ω̇ = (μ_s N r/I) n × ŝ.</summary>
    /// <param name="time">Time, s.</param>
    /// <param name="at">The motion.</param>
    /// <param name="size">μ_s N/m, m/s².</param>
    /// <param name="direction">ŝ.</param>
    public MotionRates Friction(double time, in Motion at, double size, in Vector3d direction) =>
        new(-size * direction, size * _torque * Vector3d.Cross(NormalAt(in at.Position, time), in direction));

    /// <summary>μ_s N/m, m/s².</summary>
    public double FrictionAt(double time, in Motion at) =>
        _around.World is null ? _around.Ground.Sliding : _carried.SlidingFriction(_carried.ForcesOn(time, in at));

    /// <summary>Direction of the slip; that of the piece's start where it has passed zero.</summary>
    public Vector3d SlipDirection(double time, in Motion at)
    {
        Vector3d slip = SlipOf(time, in at);
        Vector3d start = _around.World is null ? new Vector3d(_sliding.SlipX, 0, _sliding.SlipZ) : _carried.Direction;
        return Vector3d.Dot(in slip, in start) > 0 ? Direction(in slip) : start;
    }

    /// <summary>Speed of the flow, m/s.</summary>
    public double FlowAt(in Motion at) => (at.Velocity - _around.Wind).Length;

    /// <summary>Speed of the flow across the axis of the spin, m/s.</summary>
    public double AcrossAt(in Motion at) => Vector3d.Cross(at.Spin / at.Spin.Length, at.Velocity - _around.Wind).Length;

    /// <summary>
    /// The end of a slide: by how much place and velocity still change, and the spin of the roll that it leads to, by the closed form of the slip with what
    /// pushes at the mean motion up to then, which is the mean push of one that is linear in the motion; and how long that takes.
    /// </summary>
    public Motion EndSlide(double time, in Motion at, out double t)
    {
        Vector3d n = NormalAt(in at.Position, time);
        Vector3d carrier = _around.World is null ? Vector3d.Zero : _carried.Carrier.Velocity;
        double sliding = FrictionAt(time, in at);
        double friction = sliding * (1.0 + (_around.Radius * _torque));
        Vector3d slip = SlipOf(time, in at);
        Vector3d direction = Direction(in slip);
        MotionRates now = Frictionless(time, in at, in direction);
        var decay = new SlipDecay(in slip, SlipRate(in now, in n), friction);
        t = decay.Time;

        // ṡ = −k ŝ + c;  v = v₀ + ∫a − μ_s N/m ∫ŝ, its mean v₀ + ½ a t − μ_s N/m ∫∫ŝ/t
        Vector3d turned = sliding / t * decay.Twice;
        var mean = new Motion(
            at.Position + ((0.5 * t) * at.Velocity),
            at.Velocity + ((0.5 * t) * now.Acceleration) - turned,
            at.Spin + ((0.5 * t) * now.SpinAcceleration) + (_torque * Vector3d.Cross(in n, in turned)));
        now = Frictionless(time + (0.5 * t), in mean, in direction);
        decay = new SlipDecay(in slip, SlipRate(in now, in n), friction);
        t = decay.Time;
        Vector3d velocity = (t * now.Acceleration) - (sliding * decay.Direction);
        Vector3d position = (t * at.Velocity) + ((0.5 * t * t) * now.Acceleration) - (sliding * decay.Twice);
        double about = Vector3d.Dot(in at.Spin, in n) + (t * Vector3d.Dot(in now.SpinAcceleration, in n));
        return new Motion(in position, in velocity, Slip.RollingSpin(at.Velocity + velocity - carrier, about, in n, _around.Radius));
    }

    /// <summary>What friction can give beyond what a rolling ball needs, m/s²: where it falls to zero the grip ends.</summary>
    public double Grip(double time, in Motion at)
    {
        CarriedForces on = _carried.ForcesOn(time, in at);
        return _carried.SlidingFriction(in on) - _carried.Traction(in on).Length;
    }

    /// <summary>The slip of a ball on the ground or on what carries it, m/s.</summary>
    public Vector3d SlipOf(double time, in Motion at)
    {
        Vector3d n = NormalAt(in at.Position, time);
        Vector3d carrier = _around.World is null ? Vector3d.Zero : _carried.Carrier.Velocity;
        return Slip.Of(at.Velocity - carrier, in at.Spin, in n, _around.Radius);
    }

    /// <summary>Whether friction ends the slip within a moment in which all else that pushes is constant: it does not where that pushes more.</summary>
    public bool IsAlmostRolling(double time, in Motion at)
    {
        Vector3d slip = SlipOf(time, in at);
        double friction = FrictionAt(time, in at) * (1.0 + (_around.Radius * _torque));
        MotionRates free = Frictionless(time, in at, Direction(in slip));
        Vector3d push = SlipRate(in free, NormalAt(in at.Position, time));
        return push.LengthSquared < friction * friction && new SlipDecay(in slip, in push, friction).Time < LastOfSlide;
    }

    /// <summary>The velocity on the surface that friction turns with, m/s: of the slip, or of the roll.</summary>
    public double SpeedOnSurface(double time, in Motion at) => Motion == MotionState.Sliding ? SlipOf(time, in at).Length
        : (_around.World is null ? at.Velocity : at.Velocity - _carried.Carrier.Velocity).Length;

    /// <summary>The normal of what carries the ball.</summary>
    public Vector3d NormalAt(in Vector3d position, double time) => _around.World is null ? Vector3d.Up : _carried.Carrier.At(in position, time).Normal;

    /// <summary>The rates of a ball that slides, without friction.</summary>
    private MotionRates Frictionless(double time, in Motion at, in Vector3d direction)
    {
        SmoothRates(time, in at, in direction, out MotionRates rates);
        MotionRates friction = Friction(time, in at, FrictionAt(time, in at), in direction);
        return new MotionRates(rates.Acceleration - friction.Acceleration, rates.SpinAcceleration - friction.SpinAcceleration);
    }

    /// <summary>ṡ = v̇_t + r n × ω̇.</summary>
    private Vector3d SlipRate(in MotionRates rates, in Vector3d n) =>
        CarriedSystem<TAir>.Tangential(in rates.Acceleration, in n) + (_around.Radius * Vector3d.Cross(in n, in rates.SpinAcceleration));

    private static Vector3d Direction(in Vector3d v)
    {
        double length = v.Length;
        return length > 0 ? v / length : Vector3d.Zero;
    }

    private static PlanarMotion Planar(in Motion at)
    {
        PlanarMotion planar;
        planar.X = at.Position.X;
        planar.Z = at.Position.Z;
        planar.VX = at.Velocity.X;
        planar.VZ = at.Velocity.Z;
        planar.WX = at.Spin.X;
        planar.WY = at.Spin.Y;
        planar.WZ = at.Spin.Z;
        return planar;
    }

    private void TakeRolling(in BallState s, in Motion at)
    {
        PlanarMotion from = Planar(in at);
        double speed = s.Velocity.Length;
        Vector3d direction = Direction(s.Velocity);
        if (speed < Slip.Rolling)
        {
            GroundPush.On(_around, Branch, MotionState.Rolling, s.Time, in from, out GroundPush push);
            var drive = new Vector3d(push.X, 0, push.Z);
            IsPinned = drive.Length <= _around.Ground.Rolling;
            direction = Direction(in drive);
        }

        _rolling = new RollingSystem<TAir> { Around = _around, Branch = Branch, DirectionX = direction.X, DirectionZ = direction.Z, Pinned = IsPinned };
    }

    private void TakeCarried(in BallState s, in Motion at, World world)
    {
        Collider carrier = world.CarrierOf(in s);
        ShapePoint point = carrier.At(s.Position, s.Time);
        double about = Vector3d.Dot(s.Spin, point.Normal);
        SpinSign = about > Slip.Rolling ? 1.0 : about < -Slip.Rolling ? -1.0 : 0.0;
        bool rolls = s.Motion == MotionState.Rolling;
        _carried = new CarriedSystem<TAir>
        {
            Around = _around,
            World = world,
            Carrier = carrier,
            Material = carrier.MaterialAt(s.Position),
            Branch = Branch,
            Nets = Nets,
            NetSides = NetSides,
            Guides = Guides.Of(world, s.Position, s.Velocity, s.Time, (int)s.Carrier - world.FirstCollider),
            Rolls = rolls,
            SpinSign = SpinSign,
        };
        CarriedForces on = _carried.ForcesOn(s.Time, in at);
        Vector3d moving = rolls ? on.Velocity : _carried.SlipOf(in at, in on.Normal);
        bool still = moving.Length < Slip.Rolling;
        Vector3d drive = rolls ? _carried.Drive(in on) : _carried.Traction(in on);
        _carried.Pinned = rolls && still && drive.Length <= _carried.RollingFriction(in on, 0);
        IsPinned = _carried.Pinned;
        _carried.Direction = Direction(still ? drive : moving);
        DependsOnPlace |= _carried.Guides.Count > 0 || !(_groundIsEven && carrier == world.Ground);
    }
}
