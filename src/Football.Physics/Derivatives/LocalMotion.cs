namespace Football.Physics;

/// <summary>What moves the ball along a piece of its way: the same systems that a step integrates, locked to the same branch, nets, guides and carrier.</summary>
internal sealed class LocalMotion<TAir>
    where TAir : struct, IAir
{
    private readonly Surroundings<TAir> _around;
    private readonly bool _groundIsEven;
    private FlightSystem<TAir> _flight;
    private CarriedSystem<TAir> _carried;
    private SlidingSystem<TAir> _sliding;
    private RollingSystem<TAir> _rolling;

    public LocalMotion(Surroundings<TAir> around, bool groundIsEven)
    {
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
                Vector3d direction = Direction(s.Velocity);
                _rolling = new RollingSystem<TAir> { Around = _around, Branch = Branch, DirectionX = direction.X, DirectionZ = direction.Z };
                break;
        }
    }

    /// <summary>v̇ and ω̇.</summary>
    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        switch (Motion)
        {
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

    /// <summary>
    /// The end of a slide: by how much place and velocity still change, and the spin of the roll that it leads to, by the closed form of the slip with the push along
    /// the surface that acts now; and how long that takes.
    /// </summary>
    public Motion EndSlide(double time, in Motion at, out double t)
    {
        Vector3d n = NormalAt(in at.Position, time);
        Vector3d carrier = _around.World is null ? Vector3d.Zero : _carried.Carrier.Velocity;
        double sliding = _around.World is null ? _around.Ground.Sliding : _carried.SlidingFriction(_carried.ForcesOn(time, in at));
        double friction = _around.World is null ? sliding + (_around.Radius * _around.Ground.SlidingTorque)
            : (1.0 + (1.0 / _around.World.Ball.InertiaFactor)) * sliding;
        Rates(time, in at, out MotionRates rates);

        // ṡ = −k ŝ + c;  v = v₀ + a t − μ_s N/m ∫ŝ,  p = p₀ + v₀ t + a t²/2 − μ_s N/m ∫∫ŝ
        Vector3d slip = Slip.Of(at.Velocity - carrier, in at.Spin, in n, _around.Radius);
        Vector3d direction = Direction(in slip);
        Vector3d push = CarriedSystem<TAir>.Tangential(in rates.Acceleration, in n) + (_around.Radius * Vector3d.Cross(in n, in rates.SpinAcceleration)) + (friction * direction);
        var decay = new SlipDecay(in slip, in push, friction);
        t = decay.Time;
        Vector3d acceleration = rates.Acceleration + (sliding * direction);
        Vector3d velocity = (t * acceleration) - (sliding * decay.Direction);
        Vector3d position = (t * at.Velocity) + ((0.5 * t * t) * acceleration) - (sliding * decay.Twice);
        double about = Vector3d.Dot(in at.Spin, in n) + (t * Vector3d.Dot(in rates.SpinAcceleration, in n));
        return new Motion(in position, in velocity, Slip.RollingSpin(at.Velocity + velocity - carrier, about, in n, _around.Radius));
    }

    /// <summary>What friction can give beyond what a rolling ball needs, m/s²: where it falls to zero the grip ends.</summary>
    public double Grip(double time, in Motion at)
    {
        CarriedForces on = _carried.ForcesOn(time, in at);
        return _carried.SlidingFriction(in on) - _carried.Traction(in on).Length;
    }

    /// <summary>The slip of a ball on the ground or on what carries it, m/s.</summary>
    public double SlipAt(double time, in Motion at)
    {
        Vector3d n = NormalAt(in at.Position, time);
        Vector3d carrier = _around.World is null ? Vector3d.Zero : _carried.Carrier.Velocity;
        return Slip.Of(at.Velocity - carrier, in at.Spin, in n, _around.Radius).Length;
    }

    /// <summary>The normal of what carries the ball.</summary>
    public Vector3d NormalAt(in Vector3d position, double time) => _around.World is null ? Vector3d.Up : _carried.Carrier.At(in position, time).Normal;

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
        _carried.Direction = Direction(still ? drive : moving);
        DependsOnPlace |= _carried.Guides.Count > 0 || !(_groundIsEven && carrier == world.Ground);
    }
}
