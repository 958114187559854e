using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>No laws of the air: the flight step reduces to a parabola.</summary>
internal struct NoAir : IFlightAir
{
    public readonly bool Acts { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    public readonly bool HasField => false;

    public readonly bool HasSide => false;

    public readonly bool Tilts => false;

    public readonly Vector3d Sideways => Vector3d.Zero;

    public readonly bool Jumps { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => false; }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool Covers(double speedSquared, double spinRate, double h) => true;

    public readonly double WholeUpTo(in RateBound bound) => 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay, out double share)
    {
        share = 0;
        drag = 0;
        lift = 0;
        decay = 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        drag = 0;
        lift = 0;
        decay = 0;
        return spinSquared > AirLaws.NoSpin;
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
