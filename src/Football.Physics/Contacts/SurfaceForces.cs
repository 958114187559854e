namespace FootballPhysics.Contacts;

/// <summary>Forces on a ball on a surface, without friction; per mass, or per moment of inertia.</summary>
internal struct SurfaceForces
{
    /// <summary>n.</summary>
    public Vector3d Normal;

    /// <summary>q, the velocity relative to the shape, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>v − V_p, the velocity relative to the carrier's material, m/s. Rolling friction acts against it.</summary>
    /// <remarks>It equals q if the carrier does not rotate.</remarks>
    public Vector3d Rolling;

    /// <summary>V_c, the velocity of the surface at the contact point, m/s.</summary>
    public Vector3d Surface;

    /// <summary>s, the slip relative to the carrier, m/s; zero in a roll.</summary>
    public Vector3d Slip;

    /// <summary>A, the rate of change of V_c along the path, m/s²; 0 if the carrier does not rotate.</summary>
    public Vector3d SurfaceRate;

    /// <summary>Tangential acceleration of the carrier's material at the ball's centre, m/s²; 0 if the carrier does not rotate.</summary>
    public Vector3d MaterialRate;

    /// <summary>r ω_n n × ṅ, m/s²: the friction that a spin about a turning normal requires.</summary>
    public Vector3d Gyration;

    /// <summary>ṅ = Hq, or Ω × n + Hq if the shape rotates, 1/s.</summary>
    public Vector3d Turning;

    /// <summary>qᵀHq − A_s·n, m/s²: the ball stays on the surface if n·v̇ is the negative of this.</summary>
    public double Centripetal;

    /// <summary>Gravity, buoyancy and nets along the surface, m/s².</summary>
    public Vector3d Body;

    /// <summary>Air and custom forces along the surface, m/s².</summary>
    public Vector3d Air;

    /// <summary>Custom forces, m/s². They wake a ball at rest even if the air does not.</summary>
    public Vector3d Own;

    /// <summary>Their torques, rad/s².</summary>
    public Vector3d OwnTorque;

    /// <summary>Torques of the air, nets and custom forces, rad/s².</summary>
    public Vector3d Torque;

    /// <summary>Deceleration of the spin by the air, rad/s².</summary>
    /// <remarks>For a ball without spin, this is the limit that acts against a starting spin.</remarks>
    public double Braking;

    /// <summary>True if the laws of the air treat the ball as spinning.</summary>
    public bool Spins;

    /// <summary>N/m, not negative, m/s².</summary>
    public double Load;

    /// <summary>N/m if the surface could pull, m/s²: the ball leaves when it falls to zero.</summary>
    public double FreeLoad;

    /// <summary>Computes the motion of a plane without spin below the ball. It is part of <see cref="Describe"/>, and faster alone.</summary>
    public void DescribeFlat(Collider carrier, in Vector3d normal, in Motion at)
    {
        Normal = normal;
        Velocity = at.Velocity - carrier.Velocity;
        Turning = Vector3d.Zero;
        Centripetal = 0;
        Rolling = Velocity;
        Surface = carrier.Velocity;
        SurfaceRate = Vector3d.Zero;
        MaterialRate = Vector3d.Zero;
        Gyration = Vector3d.Zero;
    }

    /// <summary>Computes the motion of a surface below the ball: all quantities that do not depend on forces.</summary>
    /// <param name="carrier">The surface.</param>
    /// <param name="radius">r, m.</param>
    /// <param name="point">Distance, normal and curvature below the ball.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="at">The ball.</param>
    /// <param name="on">Receives the result.</param>
    public static void Describe(Collider carrier, double radius, in ShapePoint point, double time, in Motion at, ref SurfaceForces on)
    {
        on.DescribeFlat(carrier, point.Normal, in at);
        on.Turning = point.Curvature * on.Velocity;
        on.Centripetal = Vector3d.Dot(in on.Velocity, in on.Turning);
        if (carrier.Spin != Vector3d.Zero)
        {
            AddRotation(carrier, radius, in point, time, in at, ref on);
        }

        on.Gyration = on.Turning == Vector3d.Zero ? Vector3d.Zero : radius * Vector3d.Dot(in at.Spin, in on.Normal) * Vector3d.Cross(in on.Normal, in on.Turning);
    }

    /// <summary>Adds the terms of a rotating carrier (contact.md, Surfaces that move).</summary>
    private static void AddRotation(Collider carrier, double radius, in ShapePoint point, double time, in Motion at, ref SurfaceForces on)
    {
        Vector3d n = on.Normal;
        Vector3d spin = carrier.Spin;
        Vector3d contact = at.Position - (radius * n);
        on.Surface = carrier.SurfaceVelocity(in contact, in n, time);
        double off = carrier.OffShape(carrier.SpinVelocity(in contact, time), in n);
        Vector3d material = carrier.SpinVelocity(in at.Position, time) - (off * n);
        on.Rolling = SurfaceSystem.Tangential(at.Velocity - material, in n);

        // If only the surface rotates, its velocity is V + w − (w·n) n, with w = Ω × (p − o) by its spin Ω about the pivot o. The
        // rate of it has the further part −(w·n) ṅ along the surface.
        Vector3d along = material - carrier.Velocity;
        on.MaterialRate = SurfaceSystem.Tangential(Vector3d.Cross(in spin, in along), in n) - (off * (point.Curvature * along));
        if (carrier.Rotates)
        {
            // The velocity q = v − V_p relative to the material, the rate of the normal ṅ = Ω × n + Hq with the curvature H, and the acceleration of the
            // surface, A_s = Ω × (Ω × (p − o)) + 2 Ω × q.
            Vector3d q = at.Velocity - material;
            Vector3d bent = point.Curvature * q;
            on.Velocity = q;
            on.Turning = Vector3d.Cross(in spin, in n) + bent;
            on.Centripetal = Vector3d.Dot(in q, in bent)
                - Vector3d.Dot(Vector3d.Cross(in spin, (material - carrier.Velocity) + (2.0 * q)), in n);
        }

        // The rate of the surface's velocity at the contact point c: A = Ω × (ċ − V), ċ = v − r ṅ.
        on.SurfaceRate = SurfaceSystem.Tangential(Vector3d.Cross(in spin, at.Velocity - (radius * on.Turning) - carrier.Velocity), in n) - (off * on.Turning);
    }
}
