namespace FootballPhysics;

/// <summary>A force or torque that is left out.</summary>
internal struct NoAirLaw : IAirLaw
{
    public readonly RateBound Bound => default;

    public readonly void Prepare(Scene scene)
    {
    }

    public readonly double Factor(in AirFlow flow) => 0;
}
