namespace Football.Physics;

/// <summary>One compiled body: the laws of a scene and an integrator.</summary>
internal sealed partial class Stepper<TAir, TIntegrator> : Stepper
    where TAir : struct, IAerodynamics
    where TIntegrator : struct, IIntegrator
{
    public Stepper(Scene scene, SolverSettings settings)
    {
    }

    public override void Step(ref BallState state, double dt, StepLog log)
    {
        state.Time += dt;
    }
}
