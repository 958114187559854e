namespace FootballPhysics.Yardsticks;

/// <summary>Gravity only.</summary>
public readonly struct PlainVacuum(double gravity) : IPlainLaw
{
    public void Rates(in PlainVector u, in PlainVector spin, out PlainVector acceleration, out PlainVector spinAcceleration)
    {
        acceleration = new PlainVector(0, -gravity, 0);
        spinAcceleration = default;
    }
}
