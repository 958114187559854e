using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>Semi-implicit (symplectic) Euler, order 1 (thesis 3.8, 3.9): velocity first, then position with the new velocity.</summary>
internal readonly struct SemiImplicitEuler : IIntegrator
{
    public int Stages => 1;

    public double LastStage => 0;

    public int Order => 1;

    public Tableau Tableau => new([0], [1], movesWithEnd: true);

    public double ShareInPath => 1;

    public bool GainsByHops => false;

    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        // v' = v + h a(v); the new velocity advances the position, p' = p + h v'.
        EulerStep.Take(ref air, in start, ref motion, in wind, branch, upward, h, out step);
        step.Path = h * step.AirVelocity;
        step.Turn = h * step.SpinRate;
        StepTurn.Take(ref air, in start, step.Turn, ref step);
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        step.StartRates = start;

        // Update the velocity first, then the position with the new velocity.
        Vector3d velocity = from.Velocity + (h * step.StartRates.Acceleration);
        step.End = from.After(h, in velocity, in step.StartRates);
        step.Rotation = RotationVector.OfMean(in step.End.Spin, in from.Spin, in step.End.Spin, h);
    }
}
