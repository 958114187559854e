namespace Football.Physics;

/// <summary>The variational equation δẏ = A δy with the Jacobians at the stages of a method, which asks for them in the same order.</summary>
internal struct LinearStages : IMotionRates
{
    private readonly StageJacobian[] _stages;
    private int _stage;

    public LinearStages(StageJacobian[] stages)
    {
        _stages = stages;
        _stage = 0;
    }

    public void Rates(double time, in Motion at, out MotionRates rates) => rates = _stages[_stage++].Times(in at);
}
