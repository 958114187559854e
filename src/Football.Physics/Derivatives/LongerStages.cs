namespace Football.Physics;

/// <summary>
/// How the stages of a step of length h change with ln h: δẏ = A δy + ẏ. The place changes at the rate δv + v, so that sum takes the place of the velocity.
/// </summary>
internal struct LongerStages : IMotionRates
{
    private readonly StageJacobian[] _stages;
    private int _stage;

    public LongerStages(StageJacobian[] stages)
    {
        _stages = stages;
        _stage = 0;
    }

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        StageJacobian stage = _stages[_stage++];
        MotionRates change = stage.Times(new Motion(at.Position, at.Velocity - stage.Velocity, at.Spin, at.AirDistance));
        rates = new MotionRates(
            change.Acceleration + (2.0 * stage.Rates.Acceleration), change.SpinAcceleration + stage.Rates.SpinAcceleration, change.AirSpeed + stage.Rates.AirSpeed);
    }
}
