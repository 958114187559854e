namespace Football.Physics;

/// <summary>Flight along a constant axis of the spin in air that depends on place or time: it gives the rates at any instant.</summary>
internal interface IFieldSystem
{
    /// <summary>Rates of change at a time, s.</summary>
    void Rates(double time, in FieldMotion at, out FieldRates rates);
}
