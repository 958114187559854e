namespace FootballPhysics.Yardsticks;

/// <summary>A ball as a general rigid-body engine treats it: symplectic Euler, damping for air, restitution at the frame's end.</summary>
public sealed class RigidBodyEngine
{
    /// <summary>The default frame rate of such engines, Hz.</summary>
    public const double FrameRate = 60;

    private readonly double _radius = BallProperties.Tunnel.Radius;
    private readonly double _inertiaFactor = BallProperties.Tunnel.InertiaFactor;

    /// <summary>Gravity, m/s².</summary>
    public double Gravity { get; init; } = 9.81;

    /// <summary>Linear damping, 1/s: the only substitute for drag.</summary>
    public double LinearDamping { get; init; } = 0.1;

    /// <summary>Angular damping, 1/s.</summary>
    public double AngularDamping { get; init; } = 0.05;

    /// <summary>Restitution.</summary>
    public double Restitution { get; init; } = SurfaceMaterial.PublishedTurf.NormalRestitution;

    /// <summary>Coulomb friction.</summary>
    public double Friction { get; init; } = SurfaceMaterial.PublishedTurf.SlidingFriction;

    /// <summary>Below this speed of approach, m/s, a contact does not bounce.</summary>
    public double RestitutionThreshold { get; init; } = 0.5;

    /// <summary>Advances a ball by a frame.</summary>
    public void Step(ref PlainState s, double h)
    {
        PlainVector v = 1.0 / (1.0 + (h * LinearDamping)) * (s.Velocity + (h * new PlainVector(0, -Gravity, 0)));
        PlainVector w = 1.0 / (1.0 + (h * AngularDamping)) * s.Spin;
        PlainVector p = s.Position + (h * v);
        if (p.Y < _radius)
        {
            // The contact is found and resolved at the frame's end: push out, bounce, and a friction impulse bounded by Coulomb's law.
            p = new PlainVector(p.X, _radius, p.Z);
            if (v.Y < 0)
            {
                double normal = v.Y < -RestitutionThreshold ? -(1.0 + Restitution) * v.Y : -v.Y;
                v = new PlainVector(v.X, v.Y + normal, v.Z);
                double slipX = v.X + (_radius * w.Z);
                double slipZ = v.Z - (_radius * w.X);
                double slip = Math.Sqrt((slipX * slipX) + (slipZ * slipZ));
                if (slip > 0)
                {
                    double stick = slip / (1.0 + (1.0 / _inertiaFactor));
                    double impulse = Math.Min(Friction * normal, stick);
                    double dx = -impulse * slipX / slip;
                    double dz = -impulse * slipZ / slip;
                    v = new PlainVector(v.X + dx, v.Y, v.Z + dz);
                    double turn = 1.0 / (_inertiaFactor * _radius);
                    w = new PlainVector(w.X - (turn * dz), w.Y, w.Z + (turn * dx));
                }
            }
        }

        s.Position = p;
        s.Velocity = v;
        s.Spin = w;
    }
}
