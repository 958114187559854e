using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>A smooth tabulated law in steady air, with a knuckle force.</summary>
/// <typeparam name="TLaw">The type of the law, which has no regions.</typeparam>
internal struct SeamAir<TLaw> : IFlightAir
    where TLaw : struct, ITableLaw
{
    private readonly KnuckleForce _knuckle;
    private TableAir<TLaw> _table;

    public SeamAir(Scene scene, KnuckleForce knuckle)
    {
        _knuckle = knuckle;
        _table = new TableAir<TLaw>(scene, knuckle.Bound);
    }

    public readonly bool Acts => true;

    public readonly bool Jumps => false;

    public readonly bool HasField => false;

    public readonly bool HasSide => true;

    public readonly bool Tilts => false;

    public readonly Vector3d Sideways => Vector3d.Zero;

    public double WholeUpTo(in RateBound bound) => _table.WholeUpTo(in bound);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Covers(double speedSquared, double spinRate, double h) => _table.Covers(speedSquared, spinRate, h);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share) =>
        _table.Factors(speedSquared, spinRate, acrossSquared, region, out drag, out lift, out decay, out share);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay) =>
        _table.FactorsPerSpin(speedSquared, spinSquared, crossSquared, region, out drag, out lift, out decay);

    public readonly Vector3d WindAt(double time, double x, double y, double z) => Vector3d.Zero;

    public readonly void Begin(in BallState start, out SeamAxes seams) => _knuckle.Begin(in start, out seams);

    public readonly void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned) => KnuckleForce.Turn(in seams, in axis, turn, out turned);

    public readonly void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end) =>
        KnuckleForce.Turn(in seams, in start, half, out middle, out end);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d Side(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance) =>
        _knuckle.Acceleration(in seams, ux, uy, uz, perSquared, speed, share, crossSquared, distance);
}
