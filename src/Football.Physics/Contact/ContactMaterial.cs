namespace Football.Physics;

/// <summary>The numbers of a surface, as contact needs them: the pitch's and every other thing's alike.</summary>
internal readonly struct ContactMaterial
{
    /// <summary>Approach speed at which the restitution of a surface is given where it falls with speed, m/s: what the rigs measure at.</summary>
    private const double RigSpeed = 6.0;

    /// <summary>C: at a speed along the surface of so many times the approach, half of the rise is there (measured on the impacts of one match: 2.5 … 3.5).</summary>
    private const double HalfRise = 2.8;

    /// <summary>e₀ = e₆ √(1 + (6/V_e)²).</summary>
    public readonly double SlowRestitution;

    /// <summary>1/V_e, s/m.</summary>
    public readonly double PerRestitutionSpeed;

    /// <summary>η.</summary>
    public readonly double RestitutionRise;

    /// <summary>e_t along x, and along every direction but z.</summary>
    public readonly double TangentialX;

    /// <summary>e_t along z.</summary>
    public readonly double TangentialZ;

    /// <summary>e_ω.</summary>
    public readonly double Spin;

    /// <summary>μ of an impact.</summary>
    public readonly double ImpactFriction;

    /// <summary>μ_s.</summary>
    public readonly double SlidingFriction;

    /// <summary>μ_r or c₀.</summary>
    public readonly double RollingFriction;

    /// <summary>c₁, s/m.</summary>
    public readonly double RollingFrictionBySpeed;

    /// <summary>c_ω, N m s.</summary>
    public readonly double SpinDamping;

    /// <summary>b, m.</summary>
    public readonly double DrillingLength;

    public ContactMaterial(Ground ground)
    {
        PerRestitutionSpeed = 1.0 / ground.RestitutionSpeed;
        SlowRestitution = AtRest(ground.NormalRestitution, PerRestitutionSpeed);
        RestitutionRise = ground.RestitutionRise;
        TangentialX = ground.TangentialRestitutionX;
        TangentialZ = ground.TangentialRestitutionZ;
        Spin = ground.SpinRestitution;
        ImpactFriction = ground.ImpactFriction;
        SlidingFriction = ground.SlidingFriction;
        RollingFriction = ground.RollingFriction;
        RollingFrictionBySpeed = ground.RollingFrictionBySpeed;
        SpinDamping = ground.SpinDamping;
        DrillingLength = ground.DrillingLength;
    }

    public ContactMaterial(Surface surface)
    {
        PerRestitutionSpeed = 1.0 / surface.RestitutionSpeed;
        SlowRestitution = AtRest(surface.NormalRestitution, PerRestitutionSpeed);
        RestitutionRise = surface.RestitutionRise;
        TangentialX = surface.TangentialRestitution;
        TangentialZ = surface.TangentialRestitution;
        Spin = surface.SpinRestitution;
        ImpactFriction = surface.ImpactFriction;
        SlidingFriction = surface.SlidingFriction;
        RollingFriction = surface.RollingFriction;
        RollingFrictionBySpeed = surface.RollingFrictionBySpeed;
        SpinDamping = surface.SpinDamping;
        DrillingLength = surface.DrillingLength;
    }

    /// <summary>A surface by the three numbers of an impact alone, the same at every speed.</summary>
    public ContactMaterial(double restitution, double tangentialRestitution, double friction)
    {
        this = default;
        SlowRestitution = restitution;
        TangentialX = tangentialRestitution;
        TangentialZ = tangentialRestitution;
        Spin = 1;
        ImpactFriction = friction;
    }

    /// <summary>
    /// e = e_n + η (1 − e_n) v_t⁴/(v_t⁴ + (C v_n)⁴), e_n = e₀/√(1 + (v_n/V_e)²): a ball that grazes ploughs less. At most 1.
    /// </summary>
    /// <param name="approach">v_n, m/s.</param>
    /// <param name="along">v_t, the ball's velocity along the surface, m/s.</param>
    public double RestitutionAt(double approach, in Vector3d along)
    {
        double e = RestitutionHeadOn(approach);
        if (!(RestitutionRise > 0))
        {
            return e;
        }

        // Of the squares' ratio, so that nothing overflows.
        double steep = HalfRise * approach;
        double square = along.LengthSquared / (steep * steep);
        double grazing = square < 1e150 ? square * square / (1.0 + (square * square)) : 1;
        return e + (RestitutionRise * (1.0 - e) * grazing);
    }

    /// <summary>The most that e may be at any obliqueness.</summary>
    public double LargestRestitutionAt(double approach)
    {
        double e = RestitutionHeadOn(approach);
        return e + (RestitutionRise * (1.0 - e));
    }

    /// <summary>e_n = e₀/√(1 + (v_n/V_e)²), at most 1.</summary>
    private double RestitutionHeadOn(double approach)
    {
        double x = approach * PerRestitutionSpeed;
        return Math.Min(1.0, x > 0 ? SlowRestitution / Math.Sqrt(1.0 + (x * x)) : SlowRestitution);
    }

    private static double AtRest(double atRigSpeed, double perSpeed)
    {
        // e₀ = e₆ √(1 + (6/V_e)²)
        double x = RigSpeed * perSpeed;
        return x > 0 ? atRigSpeed * Math.Sqrt(1.0 + (x * x)) : atRigSpeed;
    }
}
