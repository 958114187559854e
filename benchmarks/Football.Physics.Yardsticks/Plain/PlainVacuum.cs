namespace Football.Physics.Yardsticks;

/// <summary>Gravity alone.</summary>
public readonly struct PlainVacuum(double gravity) : IPlainLaw
{
    public void Rates(PlainVector u, PlainVector spin, out PlainVector acceleration, out PlainVector spinAcceleration)
    {
        acceleration = new PlainVector(0, -gravity, 0);
        spinAcceleration = default;
    }
}
