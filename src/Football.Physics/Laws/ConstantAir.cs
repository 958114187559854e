using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>Constant coefficients (<see cref="ConstantDrag"/>, <see cref="ConstantMagnus"/>, <see cref="ConstantSpinDecay"/>) for the flight step.</summary>
internal struct ConstantAir : IFlightAir
{
    private readonly double _drag;
    private readonly double _lift;
    private readonly double _decay;

    public ConstantAir(Scene scene)
    {
        // Each constant equals the law's factor at a speed of 1 m/s and a spin of 1 rad/s.
        AirFlow unit = default;
        unit.Speed = 1;
        unit.SpinRate = 1;
        _drag = SceneLaws.Drag(scene).Factor(in unit);
        _lift = SceneLaws.Magnus(scene).Factor(in unit);
        _decay = SceneLaws.SpinDecay(scene).Factor(in unit);
    }

    public readonly bool Acts { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => true; }

    public readonly bool HasField => false;

    public readonly bool HasSide => false;

    public readonly bool Tilts => false;

    public readonly Vector3d Sideways => Vector3d.Zero;

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    // u is the velocity through the air; k_D, k_L and k are the constants of drag, lift and decay.
    // D = k_D |u|,  L = k_L |ω|,  |ω|˙ = −k |ω|
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share)
    {
        share = 0;
        drag = _drag * Math.Sqrt(speedSquared);
        lift = _lift * (spinRate > 0 ? spinRate : 0);
        decay = _decay * Math.Abs(spinRate);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        // Per unit of spin, the lift is k_L and the decay is k.
        bool spins = spinSquared > AirLaws.NoSpin;
        drag = _drag * Math.Sqrt(speedSquared);
        lift = _lift;
        decay = spins ? _decay : 0;
        return spins;
    }

    public readonly Vector3d WindAt(double time, double x, double y, double z) => Vector3d.Zero;

    public readonly void Begin(in BallState start, out SeamAxes seams) => seams = default;

    public readonly void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned) => turned = default;

    public readonly void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end)
    {
        middle = default;
        end = default;
    }

    public readonly Vector3d Side(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance) => Vector3d.Zero;
}
