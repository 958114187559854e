namespace FootballPhysics.Laws;

/// <summary>A disabled force or torque.</summary>
internal struct NoAirLaw : IAirLaw
{
    public readonly RateBound Bound => default;

    public readonly void Prepare(Scene scene)
    {
    }

    public readonly double Factor(in AirFlow flow) => 0;
}
