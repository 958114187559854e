namespace Football.Physics;

/// <summary>What moves the ball along one piece, as a system that a step can advance.</summary>
internal readonly struct LocalSystem<TAir> : IMotionSystem
    where TAir : struct, IAir
{
    private readonly LocalMotion<TAir> _local;

    public LocalSystem(LocalMotion<TAir> local) => _local = local;

    public void Rates(double time, in Motion at, out MotionRates rates) => _local.Rates(time, in at, out rates);

    public void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        s.Position = step.End.Position;
        s.Velocity = step.End.Velocity;
    }
}
