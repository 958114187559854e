namespace FootballPhysics.Tracks;

/// <summary>A common parameter that differs from flight to flight, and its standard deviation.</summary>
internal readonly struct ParameterDoubt(int parameter, double deviation)
{
    public int Parameter => parameter;

    public double Deviation => deviation;
}
