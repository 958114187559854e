namespace FootballPhysics.Yardsticks;

/// <summary>The right-hand side of a flight: accelerations from the air-relative velocity and the spin.</summary>
public interface IPlainLaw
{
    void Rates(in PlainVector u, in PlainVector spin, out PlainVector acceleration, out PlainVector spinAcceleration);
}
