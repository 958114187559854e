namespace Football.Physics;

/// <summary>
/// How the end of a step changes with its start, as the method takes it: the method itself, applied to the variational equation with the Jacobians at its own
/// stages. Its error is differentiated along with it, which matters where forces change much within a step.
/// </summary>
internal sealed class StepTangent<TAir>
    where TAir : struct, IAir
{
    /// <summary>The share of a step that is a moment.</summary>
    private const double Moment = 1e-3;

    private const int MostStages = 4;

    private readonly Tangent _tangent;
    private readonly Integrator _integrator;
    private readonly StageJacobian[] _stages = new StageJacobian[MostStages];

    public StepTangent(Tangent tangent, Integrator integrator)
    {
        _tangent = tangent;
        _integrator = integrator;
        for (int i = 0; i < MostStages; i++)
        {
            _stages[i] = new StageJacobian();
        }
    }

    /// <summary>Carries the tangent over a step of fixed length.</summary>
    /// <param name="now">What moves the ball.</param>
    /// <param name="time">Time at the start, s.</param>
    /// <param name="start">The motion at the start.</param>
    /// <param name="h">The length, s.</param>
    /// <returns>How the end changes with the length: all but its rates.</returns>
    public Motion Propagate(LocalMotion<TAir> now, double time, in Motion start, double h)
    {
        var stages = new StageJacobians<TAir>(now, _stages, Moment * h);
        Motion end = Advance(ref stages, time, in start, h);
        for (int c = 0; c < Tangent.Columns; c++)
        {
            var linear = new LinearStages(_stages);
            _tangent.Set(c, Advance(ref linear, time, _tangent.Of(c), h));
        }

        var longer = new LongerStages(_stages);
        Motion change = Advance(ref longer, time, new Motion(Vector3d.Zero, in start.Velocity, Vector3d.Zero), h);
        double perLength = 1.0 / h;
        return new Motion(perLength * change.Position, perLength * (change.Velocity - end.Velocity), perLength * change.Spin, perLength * change.AirDistance);
    }

    /// <summary>Where a step leads.</summary>
    public Motion End(LocalMotion<TAir> now, double time, in Motion from, double h)
    {
        var system = new LocalSystem<TAir>(now);
        return Advance(ref system, time, in from, h);
    }

    private Motion Advance<TSystem>(ref TSystem system, double time, in Motion from, double h)
        where TSystem : struct, IMotionRates
    {
        MotionStep step;
        switch (_integrator)
        {
            case Integrator.Euler:
                default(ExplicitEuler).Advance(ref system, time, in from, h, out step);
                break;
            case Integrator.SemiImplicitEuler:
                default(SemiImplicitEuler).Advance(ref system, time, in from, h, out step);
                break;
            case Integrator.Rk2:
                default(MidpointRungeKutta).Advance(ref system, time, in from, h, out step);
                break;
            default:
                default(ClassicalRungeKutta).Advance(ref system, time, in from, h, out step);
                break;
        }

        return step.End;
    }
}
