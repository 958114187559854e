namespace Football.Physics;

/// <summary>A motion that a general step can integrate: it gives the rates at any instant.</summary>
internal interface IMotionRates
{
    /// <summary>v̇ and ω̇.</summary>
    void Rates(double time, in Motion at, out MotionRates rates);
}
