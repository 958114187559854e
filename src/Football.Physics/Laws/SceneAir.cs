using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>All effects of a scene's air at one instant: laws, local wind, knuckle force and custom forces.</summary>
/// <remarks>
/// All code except the hot flight step uses it. If the air varies, jumps in the drag law are not located: each evaluation uses the branch at its own flow.
/// </remarks>
internal unsafe struct SceneAir : IFlightAir
{
    private readonly AirLaws _laws;
    private readonly IWind? _wind;

    /// <summary>The wind field if it is a <see cref="WindByHeight"/>, to avoid the virtual call.</summary>
    private readonly WindByHeight? _byHeight;
    private readonly KnuckleForce? _knuckle;
    private readonly OwnForces? _own;
    private readonly Vector3d _sideways;
    private readonly double _radiusSquared;
    private readonly bool _hasField;
    private readonly bool _jumpsInField;

    private SceneAir(Scene scene, AirLaws laws, bool hasOwnForces)
    {
        _laws = laws;
        _wind = scene.Air.WindField;
        _byHeight = _wind as WindByHeight;
        _knuckle = KnuckleForce.Of(scene);
        _own = hasOwnForces ? new OwnForces(scene) : null;
        _radiusSquared = scene.Ball.Radius * scene.Ball.Radius;
        _sideways = Scenes.Weight.Sideways(scene);
        Tilts = scene.IsTilted;
        _hasField = HasFieldIn(scene);
        _jumpsInField = _hasField && laws.Jumps;
        Jumps = !_hasField && laws.Jumps;
        HasOwnForces = hasOwnForces;
        Varies = _hasField || hasOwnForces;
        Bound = laws.Bound + (_knuckle?.Bound ?? default);
        OrdinaryBound = laws.OrdinaryBound + (_knuckle?.Bound ?? default);
    }

    /// <summary>The laws alone.</summary>
    public readonly AirLaws Laws => _laws;

    /// <summary>The knuckle force; null if none acts.</summary>
    public readonly KnuckleForce? Knuckle => _knuckle;

    /// <summary>True if drag acts.</summary>
    public readonly bool Drags => _laws.Drags;

    /// <summary>True if the Magnus force acts.</summary>
    public readonly bool Lifts => _laws.Lifts;

    /// <summary>True if spin decays.</summary>
    public readonly bool SpinDecays => _laws.SpinDecays;

    public readonly bool Acts => _laws.Drags || _laws.Lifts || _laws.SpinDecays || _knuckle is not null || Tilts;

    public readonly bool HasField => _hasField;

    public readonly bool HasSide => _knuckle is not null;

    public readonly bool Tilts { get; }

    public readonly Vector3d Sideways => _sideways;

    public readonly bool Jumps { get; }

    /// <summary>True if the air depends on position or time, or has effects beyond drag, lift and spin decay.</summary>
    /// <remarks>Flight then calls only <see cref="Evaluate(in ForceContext, DragBranch, out AirFactors)"/>.</remarks>
    public readonly bool Varies { get; }

    /// <summary>True if the scene has custom forces. Their torques can turn the spin, so that the flight has no constant axis.</summary>
    public readonly bool HasOwnForces { get; }

    /// <summary>True if the wind at a fixed position can change with time.</summary>
    public readonly bool ChangesInTime => _wind is not null && _byHeight is not { Gusts: null };

    /// <summary>A bound on the speed of the variable wind, in m/s; 0 if the wind is steady.</summary>
    public readonly double FastestWind => _wind?.MaximumSpeed ?? 0;

    /// <summary>A bound on the rate at which the air changes the motion.</summary>
    public RateBound Bound { get; }

    /// <inheritdoc cref="AirLaws.OrdinaryBound"/>
    public RateBound OrdinaryBound { get; }

    /// <summary>Returns the air of a scene. If a <see cref="ScaledAir"/> is its only custom force, it scales the laws.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
    public static SceneAir Of(Scene scene) => ScaledAir.AloneIn(scene) is { } scaled
        ? new SceneAir(scene, AirLaws.Of(scene, scaled.Drag, scaled.Lift), false)
        : new SceneAir(scene, AirLaws.Of(scene), scene.HasOwnForces);

    /// <summary>Returns true if only laws act in a scene.</summary>
    public static bool HasLawsAlone(Scene scene) => !HasFieldIn(scene) && (!scene.HasOwnForces || ScaledAir.AloneIn(scene) is not null);

    /// <summary>Returns true if the wind of a scene depends on position or time, or a knuckle force acts.</summary>
    public static bool HasFieldIn(Scene scene) => scene.Air.WindField is not null || scene.Forces.KnuckleSeed is not null;

    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        // In a wind field, jumps are not located: use the branch of the present flow.
        DragBranch here = DragJump.Choose(_jumpsInField, locates: false, region, speedSquared, _radiusSquared * spinRate * spinRate);
        _laws.Factors(speedSquared, spinRate, acrossSquared, here, out drag, out lift, out decay);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share)
    {
        share = ShareAt(speedSquared);
        Factors(speedSquared, spinRate, acrossSquared, region, out drag, out lift, out decay);
    }

    /// <summary>Returns the share of subcritical flow for the knuckle force; 0 if none acts.</summary>
    public readonly double ShareAt(double speedSquared) => _knuckle is null ? 0 : _knuckle.ShareAt(speedSquared);

    public readonly bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay) =>
        _laws.FactorsPerSpin(speedSquared, spinSquared, crossSquared, region, out drag, out lift, out decay);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d WindAt(double time, double x, double y, double z) =>
        _byHeight is not null ? _byHeight.At(time, x, y, z) : _wind is null ? Vector3d.Zero : _wind.At(time, new Vector3d(x, y, z));

    public readonly void Begin(in BallState start, out SeamAxes seams) => _knuckle!.Begin(in start, out seams);

    public readonly void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned) => KnuckleForce.Turn(in seams, in axis, turn, out turned);

    public readonly void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end) =>
        KnuckleForce.Turn(in seams, in start, half, out middle, out end);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d Side(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance) =>
        _knuckle!.Acceleration(in seams, ux, uy, uz, perSquared, speed, share, crossSquared, distance);

    /// <summary>Returns the acceleration by the knuckle force, in m/s².</summary>
    /// <param name="u">The velocity relative to the air, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="distance">The distance flown through the air, in m.</param>
    /// <param name="orientation">The orientation.</param>
    public readonly Vector3d Side(in Vector3d u, in Vector3d spin, double distance, in Quaterniond orientation) =>
        _knuckle!.Acceleration(in u, in spin, distance, in orientation);

    /// <summary>Throws if custom forces or a wind field led to a state that is not finite.</summary>
    /// <exception cref="InvalidOperationException">The state of the ball is not finite.</exception>
    public readonly void CheckOutcome(in BallState state)
    {
        if (!(state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite && state.BaseOrientation.LengthSquared > 0))
        {
            string cause = !HasOwnForces ? "air.windField" : _wind is null ? "forces.customForces" : "air.windField or forces.customForces";
            throw new InvalidOperationException($"{cause} made the state of the ball overflow. Use a smaller time step, a slower wind or a weaker force.");
        }
    }

    /// <inheritdoc cref="Evaluate(in ForceContext, DragBranch, out AirFactors, ForceTrace*)"/>
    public readonly double Evaluate(in ForceContext ball, DragBranch branch, out AirFactors factors) => Evaluate(in ball, branch, out factors, null);

    /// <summary>Computes the effect of the air and of custom forces at one instant, for any motion.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="factors">The effect of the air.</param>
    /// <param name="trace">Receives the custom forces; null if nobody needs them.</param>
    /// <returns>|ω|, in rad/s; 0 if its reciprocal would overflow.</returns>
    public readonly double Evaluate(in ForceContext ball, DragBranch branch, out AirFactors factors, ForceTrace* trace)
    {
        // v is the ball's velocity, and W the wind at its position p and time t.
        // u = v − W(p, t)
        Vector3d u = _wind is null ? ball.AirVelocity : ball.AirVelocity - _wind.At(ball.Time, ball.Position);
        Vector3d w = ball.Spin;
        DragBranch here = DragJump.Choose(_jumpsInField, locates: false, branch, u.LengthSquared, _radiusSquared * w.LengthSquared);
        double rate = OfLaws(in u, in w, here, out factors);

        // The knuckle force acts only in flight, and depends on the distance flown and the orientation.
        if (_knuckle is not null && ball.Motion == MotionState.Airborne)
        {
            factors.AirSpeed = u.Length;
            factors.Acceleration = Side(in u, in w, ball.AirDistance, ball.Orientation);
        }

        _own?.AddTo(in ball, ref factors, trace);
        return rate;
    }

    /// <summary>Computes the effect of the laws alone. It is that of all air unless <see cref="Varies"/> is true.</summary>
    /// <param name="u">The velocity relative to the air, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="factors">The effect of the air.</param>
    /// <returns>|ω|, in rad/s; 0 if its reciprocal would overflow.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double OfLaws(in Vector3d u, in Vector3d spin, DragBranch branch, out AirFactors factors)
    {
        factors.AirVelocity = u;
        factors.AirSpeed = 0;
        factors.Acceleration = Vector3d.Zero;
        factors.SpinAcceleration = Vector3d.Zero;
        double spinSquared = spin.LengthSquared;
        bool spins = _laws.FactorsPerSpin(
            u.LengthSquared, spinSquared, Vector3d.Cross(in spin, in u).LengthSquared, branch, out factors.Drag, out factors.Lift, out factors.Decay);
        return spins ? Math.Sqrt(spinSquared) : 0;
    }
}

/// <summary>An upper bound on the rate at which a law changes the motion: PerSpeed · |u| + PerSpin · |ω| + Constant, in 1/s.</summary>
internal readonly struct RateBound
{
    public readonly double PerSpeed;
    public readonly double PerSpin;
    public readonly double Constant;

    public RateBound(double perSpeed, double perSpin, double constant)
    {
        PerSpeed = perSpeed;
        PerSpin = perSpin;
        Constant = constant;
    }

    /// <summary>Returns the bound, in 1/s, for an air speed in m/s and a spin in rad/s.</summary>
    public double At(double speed, double spinRate) => (PerSpeed * speed) + (PerSpin * spinRate) + Constant;

    public static RateBound operator +(in RateBound a, in RateBound b) =>
        new(a.PerSpeed + b.PerSpeed, a.PerSpin + b.PerSpin, a.Constant + b.Constant);
}
