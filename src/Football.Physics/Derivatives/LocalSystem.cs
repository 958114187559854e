namespace Football.Physics;

/// <summary>What moves the ball along one piece, as a system that a step can advance.</summary>
internal readonly struct LocalSystem<TAir> : IMotionRates
    where TAir : struct, IAir
{
    private readonly LocalMotion<TAir> _local;

    public LocalSystem(LocalMotion<TAir> local) => _local = local;

    public void Rates(double time, in Motion at, out MotionRates rates) => _local.Rates(time, in at, out rates);
}
