namespace FootballPhysics.Yardsticks;

/// <summary>All forces by the fitted laws, with Math.Pow and Math.Exp; it computes |u|, |ω|, Sp and C_D once per evaluation.</summary>
public readonly struct PlainFitted : IPlainLaw
{
    private readonly double _radius;
    private readonly double _upward;
    private readonly double _dynamic;
    private readonly double _plates;
    private readonly double _reynolds;
    private readonly bool _regularised;

    public PlainFitted(Scene scene, bool regularised)
    {
        BallProperties ball = scene.Ball;
        _radius = ball.Radius;
        double area = Math.PI * ball.Radius * ball.Radius;
        _upward = -scene.Gravity + (4.0 / 3.0 * area * ball.Radius * scene.Air.Density * scene.Gravity / ball.Mass);
        _dynamic = 0.5 * scene.Air.Density * area / ball.Mass;
        _plates = 0.5 * ball.Radius * scene.Air.Density * area / ball.MomentOfInertia;
        _reynolds = 2.0 * ball.Radius / scene.Air.KinematicViscosity;
        _regularised = regularised;
    }

    public void Rates(in PlainVector u, in PlainVector spin, out PlainVector acceleration, out PlainVector spinAcceleration)
    {
        acceleration = new PlainVector(0, _upward, 0);
        spinAcceleration = default;
        double speed = u.Length;
        double rate = spin.Length;
        if (speed >= 1e-9)
        {
            double sp = _radius * rate / speed;
            double cd = _regularised ? FittedLaws.Regularised(speed, sp) : FittedLaws.Published(speed, sp);
            acceleration -= (_dynamic * cd * speed) * u;
            if (rate > 0)
            {
                acceleration += (_dynamic * FittedLaws.Lift(cd, sp) * speed / rate) * PlainVector.Cross(spin, u);
            }
        }

        if (rate > 0)
        {
            double torque = _plates * (FittedLaws.Plate(speed + (0.5 * _radius * rate), _reynolds) + FittedLaws.Plate(Math.Abs(speed - (0.5 * _radius * rate)), _reynolds));
            spinAcceleration = (-torque / rate) * spin;
        }
    }
}
