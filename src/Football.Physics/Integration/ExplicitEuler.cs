using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Integration;

/// <summary>Explicit Euler, y' = y + h f(y) (thesis 3.7). Order 1.</summary>
internal readonly struct ExplicitEuler : IIntegrator
{
    public int Stages => 1;

    public double LastStage => 0;

    public int Order => 1;

    public Tableau Tableau => new([0], [1]);

    public double ShareInPath => 0;

    public bool GainsByHops => true;

    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, in BallState start, ref FlightMotion motion, in Vector3d wind, DragBranch branch, double upward, double h, out FlightStep step)
        where TAir : struct, IFlightLaws
    {
        // y is the state, f its rate, and h the step.
        // y' = y + h f(y); the velocity at the start advances the position.
        Vector3d velocity = motion.Velocity - wind;
        double spinRate = motion.SpinRate;
        EulerStep.Take(ref air, in start, ref motion, in wind, branch, upward, h, out step);
        step.Path = h * velocity;
        step.Turn = h * spinRate;
        StepTurn.Take(ref air, in start, step.Turn, ref step);
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, in MotionRates start, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        step.StartRates = start;
        step.End = from.After(h, in from.Velocity, in step.StartRates);
        step.Rotation = RotationVector.OfMean(in from.Spin, in from.Spin, in step.End.Spin, h);
    }
}
