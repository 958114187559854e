namespace Football.Physics.Yardsticks;

/// <summary>All forces by the fitted laws, with Math.Pow and Math.Exp; |u|, |ω|, Sp and C_D once an evaluation.</summary>
public readonly struct PlainFitted : IPlainLaw
{
    private const double A = 0.155;
    private const double B = 0.346;
    private const double CriticalSpeed = 12.19;
    private const double SpeedScale = 1.309;
    private static readonly double AtRest = A + (B / (1.0 + Math.Exp(-CriticalSpeed / SpeedScale)));

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
            double cd = DragCoefficient(speed, sp);
            acceleration -= (_dynamic * cd * speed) * u;
            if (rate > 0)
            {
                double cl = 1.15 * Math.Pow(sp, 0.83) * (AtRest - Math.Min(cd, AtRest)) / (AtRest - A);
                acceleration += (_dynamic * cl * speed / rate) * PlainVector.Cross(spin, u);
            }
        }

        if (rate > 0)
        {
            double torque = _plates * (Plate(speed + (0.5 * _radius * rate)) + Plate(Math.Abs(speed - (0.5 * _radius * rate))));
            spinAcceleration = (-torque / rate) * spin;
        }
    }

    private double DragCoefficient(double speed, double sp)
    {
        if (_regularised)
        {
            double w = Logistic((speed - CriticalSpeed) / 0.25) * Logistic((sp - 0.05) / 0.0025);
            return (w * WithSpin(sp)) + ((1.0 - w) * WithoutSpin(speed));
        }

        return speed > CriticalSpeed && sp > 0.05 ? WithSpin(sp) : WithoutSpin(speed);
    }

    // U² C with C = 0.0074 (U 2r/ν)^(−1/5)
    private double Plate(double u) => u > 0 ? u * u * 0.0074 * Math.Pow(u * _reynolds, -0.2) : 0;

    private static double WithSpin(double sp) => 0.4127 * Math.Pow(sp, 0.3056);

    private static double WithoutSpin(double speed) => A + (B / (1.0 + Math.Exp((speed - CriticalSpeed) / SpeedScale)));

    private static double Logistic(double x) => 1.0 / (1.0 + Math.Exp(-x));
}
