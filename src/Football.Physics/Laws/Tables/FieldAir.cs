using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>A smooth tabulated law in air that varies, with gravity that is not straight down, or with a reverse lift.</summary>
/// <remarks>Each stage checks the range of the tables, because the wind may change by any amount along a step.</remarks>
/// <typeparam name="TLaw">The type of the law, which has no regions.</typeparam>
internal struct FieldAir<TLaw> : IFlightAir
    where TLaw : struct, ITableLaw
{
    private readonly SceneAir _scene;
    private readonly ReverseLift _reverse;
    private TableAir<TLaw> _table;

    public FieldAir(Scene scene, in SceneAir air)
    {
        _scene = air;
        _table = new TableAir<TLaw>(scene);
        _reverse.Prepare(scene);
    }

    public readonly bool Acts => true;

    public readonly bool Jumps => false;

    public readonly bool HasField => true;

    public readonly bool HasSide => _scene.HasSide;

    public readonly bool Tilts => _scene.Tilts;

    public readonly Vector3d Sideways => _scene.Sideways;

    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share)
    {
        share = _scene.ShareAt(speedSquared);
        _table.FactorsAnywhere(speedSquared, spinRate, acrossSquared, region, out drag, out lift, out decay);
        lift += _reverse.Acts ? _reverse.Part(speedSquared, spinRate, acrossSquared) : 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        bool spins = _table.FactorsPerSpin(speedSquared, spinSquared, crossSquared, region, out drag, out lift, out decay);
        lift += spins && _reverse.Acts ? _reverse.Part(speedSquared, 1.0, crossSquared) : 0;
        return spins;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d WindAt(double time, double x, double y, double z) => _scene.WindAt(time, x, y, z);

    public readonly void Begin(in BallState start, out SeamAxes seams) => _scene.Begin(in start, out seams);

    public readonly void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned) => KnuckleForce.Turn(in seams, in axis, turn, out turned);

    public readonly void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end) =>
        KnuckleForce.Turn(in seams, in start, half, out middle, out end);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector3d Side(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance) =>
        _scene.Side(in seams, ux, uy, uz, perSquared, speed, share, crossSquared, distance);
}
