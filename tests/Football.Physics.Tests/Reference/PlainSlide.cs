namespace Football.Physics.Tests.Reference;

/// <summary>A slide on the level pitch by the measured laws, written out from their equations, in steps that shrink with the slip.</summary>
internal sealed class PlainSlide(Scene scene)
{
    private readonly double _mass = scene.Ball.Mass;
    private readonly double _radius = scene.Ball.Radius;
    private readonly double _density = scene.Air.Density;

    /// <summary>Where, when and how fast the ball is once its slip is gone.</summary>
    public (double Time, Vector3d Position, Vector3d Velocity) ToItsEnd(Vector3d position, Vector3d velocity, Vector3d spin)
    {
        double time = 0;
        while (true)
        {
            double slip = SlipOf(velocity, spin).Length;
            if (slip < 1e-9)
            {
                return (time, position, velocity);
            }

            double h = Math.Min(1e-3, 0.02 * slip / (2.5 * scene.Ground.SlidingFriction * scene.Gravity));
            (Vector3d a1, Vector3d b1) = Rates(velocity, spin);
            (Vector3d a2, Vector3d b2) = Rates(velocity + ((h / 2) * a1), spin + ((h / 2) * b1));
            (Vector3d a3, Vector3d b3) = Rates(velocity + ((h / 2) * a2), spin + ((h / 2) * b2));
            (Vector3d a4, Vector3d b4) = Rates(velocity + (h * a3), spin + (h * b3));
            position += (h * velocity) + ((h * h / 6) * (a1 + a2 + a3));
            velocity += (h / 6) * (a1 + (2 * a2) + (2 * a3) + a4);
            spin += (h / 6) * (b1 + (2 * b2) + (2 * b3) + b4);
            time += h;
        }
    }

    /// <summary>s = v + r ŷ × ω.</summary>
    private Vector3d SlipOf(Vector3d v, Vector3d w) => v + (_radius * Vector3d.Cross(Vector3d.Up, in w));

    /// <summary>v̇ = (F_air,h − μ_s N ŝ)/m, ω̇ = T_D/I + r μ_s N ŷ × ŝ/I − sign(ω_y) b μ_s N/I ŷ.</summary>
    private (Vector3d Acceleration, Vector3d SpinAcceleration) Rates(Vector3d v, Vector3d w)
    {
        double inertia = scene.Ball.MomentOfInertia;
        double area = Math.PI * _radius * _radius;
        DragCurve curve = scene.Ball.DragCurve;
        Vector3d u = v - scene.Air.Wind;
        double speed = u.Length;
        double re = 2 * _radius * speed / scene.Air.KinematicViscosity;
        double q = Sigma((re - curve.CriticalReynolds) / curve.Width);
        Vector3d across = Vector3d.Cross(in w, in u);
        double spinParameter = _radius * across.Length / (speed * speed);
        double drag = ((curve.Subcritical - curve.Supercritical) * q) + curve.Supercritical
            + ((re - curve.RiseFrom) * Sigma(-(re - curve.RiseFrom) / curve.Width) * (curve.Risen - curve.Supercritical) / (curve.RiseTo - curve.RiseFrom))
            + (0.30 * spinParameter / Math.Sqrt((spinParameter * spinParameter) + (0.577 * 0.577)) * (1 - (0.5 * q)));
        double lift = 0.32 * (1 - (0.6 * q)) * _radius / Math.Sqrt((spinParameter * spinParameter) + (0.14 * 0.14));
        Vector3d air = (0.5 * _density * area) * ((lift * across) - ((drag * speed) * u));
        double decay = (0.0096 * Math.PI * _density * Math.Pow(_radius, 4) / inertia * speed) + (0.004 * _density / 1.2);

        double load = (_mass * scene.Gravity) - (4.0 / 3.0 * Math.PI * Math.Pow(_radius, 3) * _density * scene.Gravity) - air.Y;
        double friction = scene.Ground.SlidingFriction * load;
        Vector3d s = SlipOf(v, w);
        s /= s.Length;
        Vector3d turning = (_radius * friction) * Vector3d.Cross(Vector3d.Up, in s);
        double drilling = Math.Sign(w.Y) * scene.Ground.DrillingLength * friction;
        return (((1 / _mass) * (air - (friction * s))).Horizontal, ((1 / inertia) * (turning - new Vector3d(0, drilling, 0))) - (decay * w));
    }

    private static double Sigma(double x) => 1 / (1 + Math.Exp(x));
}
