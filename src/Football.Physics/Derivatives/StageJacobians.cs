namespace Football.Physics;

/// <summary>What moves the ball along a piece, with the Jacobian taken wherever a method asks for the rates.</summary>
internal struct StageJacobians<TAir> : IMotionRates
    where TAir : struct, IAir
{
    private readonly LocalMotion<TAir> _local;
    private readonly StageJacobian[] _stages;
    private readonly double _moment;
    private int _stage;

    /// <param name="local">What moves the ball.</param>
    /// <param name="stages">Where the Jacobians go.</param>
    /// <param name="moment">A moment, s: a piece may start on a kink of the forces, and what counts is on which side it goes on.</param>
    public StageJacobians(LocalMotion<TAir> local, StageJacobian[] stages, double moment)
    {
        _moment = moment;
        _local = local;
        _stages = stages;
        _stage = 0;
    }

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        _local.Rates(time, in at, out rates);
        StageJacobian stage = _stages[_stage];
        stage.Velocity = at.Velocity;
        stage.Rates = rates;
        Motion soon = _stage == 0 ? at.After(_moment, in at.Velocity, in rates) : at;
        MotionJacobian.At(_local, time, in at, in soon, stage.Jacobian);
        _stage++;
    }
}
