namespace Football.Physics;

/// <summary>A motion that a general step can advance: it gives the rates at any instant.</summary>
internal interface IMotionSystem
{
    /// <summary>v̇ and ω̇.</summary>
    void Rates(double time, in Motion at, out MotionRates rates);
}
