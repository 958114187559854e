namespace FootballPhysics.Contacts;

/// <summary>The contact constants of a surface: the pitch or any other object.</summary>
internal readonly struct ContactMaterial
{
    /// <summary>Approach speed at which a speed-dependent restitution is specified, m/s: the speed in the test rigs.</summary>
    private const double RigSpeed = 6.0;

    /// <summary>C: the ratio of tangential to approach speed at which half of the rise is reached (measured in one match: 2.5 …
    /// 3.5).</summary>
    private const double HalfRise = 2.8;

    /// <summary>e₀ = e₆ √(1 + (6/V_e)²).</summary>
    public double SlowRestitution { get; init; }

    /// <summary>1/V_e, s/m.</summary>
    public readonly double PerRestitutionSpeed;

    /// <summary>η.</summary>
    public double RestitutionRise { get; init; }

    /// <summary>Upper bound of e at any speed: 1, or more for a bumper.</summary>
    private readonly double _most;

    /// <summary>Minimum separation speed after an impact, m/s.</summary>
    public double MinimumExitSpeed { get; init; }

    /// <summary>e_t along x, and along every direction except z.</summary>
    public readonly double TangentialX;

    /// <summary>e_t along z.</summary>
    public readonly double TangentialZ;

    /// <summary>e_ω.</summary>
    public readonly double Spin;

    /// <summary>μ of an impact.</summary>
    public readonly double ImpactFriction;

    /// <summary>The resistance to a slide, a roll and a spin about the normal.</summary>
    public Resistance Resistance { get; init; }

    public ContactMaterial(Ground ground, double bounce = 1)
        : this(ground.Material, bounce) => TangentialZ = ground.TangentialRestitutionZ ?? TangentialX;

    /// <param name="surface">The surface.</param>
    /// <param name="bounce">The factor by which the ball scales its restitution.</param>
    public ContactMaterial(SurfaceMaterial surface, double bounce = 1)
    {
        PerRestitutionSpeed = 1.0 / surface.RestitutionSpeedScale;
        SlowRestitution = bounce * AtRest(surface.NormalRestitution, PerRestitutionSpeed);
        _most = surface.NormalRestitution > 1 ? Math.Max(1.0, bounce * surface.NormalRestitution) : 1.0;
        MinimumExitSpeed = surface.MinimumExitSpeed;
        RestitutionRise = surface.GrazingRestitutionGain;
        TangentialX = surface.TangentialRestitution;
        TangentialZ = surface.TangentialRestitution;
        Spin = surface.SpinRestitution;
        ImpactFriction = surface.ImpactFriction;
        Resistance = new Resistance(
            surface.SlidingFriction, surface.RollingResistance, surface.RollingResistancePerSpeed, surface.SpinDamping, surface.TorsionalPatchRadius);
    }

    /// <summary>Creates a surface with the three constants of an impact only, the same at every speed.</summary>
    public ContactMaterial(double restitution, double tangentialRestitution, double friction)
    {
        this = default;
        SlowRestitution = restitution;
        _most = 1;
        TangentialX = tangentialRestitution;
        TangentialZ = tangentialRestitution;
        Spin = 1;
        ImpactFriction = friction;
    }

    /// <summary>Returns the same surface without restitution.</summary>
    public ContactMaterial WithoutRestitution() => this with { SlowRestitution = 0, RestitutionRise = 0, MinimumExitSpeed = 0 };

    /// <summary>True if an impact may add energy.</summary>
    public bool IsBumper => _most > 1 || MinimumExitSpeed > 0;

    /// <summary>e = e_n + η (1 − e_n) v_t⁴/(v_t⁴ + (C v_n)⁴), e_n = e₀/√(1 + (v_n/V_e)²).</summary>
    /// <remarks>
    /// An oblique impact has a higher e.
    /// e is at most 1, except for a bumper, whose e does not rise.
    /// </remarks>
    /// <param name="approach">v_n, m/s.</param>
    /// <param name="along">v_t, the ball's velocity along the surface, m/s.</param>
    public double RestitutionAt(double approach, in Vector3d along)
    {
        double e = RestitutionHeadOn(approach);
        if (!(RestitutionRise > 0))
        {
            return e;
        }

        // Use the ratio of squares, up to the limit beyond which its square would overflow.
        double steep = HalfRise * approach;
        double square = along.LengthSquared / (steep * steep);
        double grazing = square < 1e150 ? square * square / (1.0 + (square * square)) : 1;
        return e + (RestitutionRise * Math.Max(0, 1.0 - e) * grazing);
    }

    /// <summary>Returns the upper bound of e at any obliqueness.</summary>
    public double LargestRestitutionAt(double approach)
    {
        double e = RestitutionHeadOn(approach);
        return e + (RestitutionRise * Math.Max(0, 1.0 - e));
    }

    /// <summary>Returns the largest speed that a surface of this speed gives a squeezed ball, m/s: (1 + e) |V|, without a bumper's energy.</summary>
    public double FastestBy(double speed) => (1.0 + Math.Min(1.0, LargestRestitutionAt(speed))) * speed;

    /// <summary>Returns the largest restitution anywhere on a ground: in the slowest and most oblique impacts.</summary>
    public static double LargestOn(Ground ground, BallProperties ball)
    {
        double largest = new ContactMaterial(ground.Material, ball.Bounce).LargestRestitutionAt(0);
        for (int i = 0; i < (ground.Pattern?.Surfaces.Count ?? 0); i++)
        {
            largest = Math.Max(largest, new ContactMaterial(ground.Pattern!.Surfaces[i], ball.Bounce).LargestRestitutionAt(0));
        }

        return largest;
    }

    /// <summary>Returns the separation speed after an impact with a bumper, m/s: e v_n or more.</summary>
    /// <remarks>It exceeds 1000 m/s only if the approach speed did.</remarks>
    /// <param name="approach">v_n, m/s.</param>
    /// <param name="restitution">e.</param>
    public double Bumped(double approach, double restitution) =>
        Math.Min(Math.Max(restitution * approach, MinimumExitSpeed), Math.Max(approach, Limits.Speed));

    /// <summary>e_n = e₀/√(1 + (v_n/V_e)²), limited to 1, or to the higher bound of a bumper.</summary>
    private double RestitutionHeadOn(double approach)
    {
        double x = approach * PerRestitutionSpeed;
        return Math.Min(_most, x > 0 ? SlowRestitution / Math.Sqrt(1.0 + (x * x)) : SlowRestitution);
    }

    private static double AtRest(double atRigSpeed, double perSpeed)
    {
        // The restitution at zero speed, e₀ = e₆ √(1 + (6/V_e)²), from that of the test at 6 m/s. V_e is the speed at which it falls.
        double x = RigSpeed * perSpeed;
        return x > 0 ? atRigSpeed * Math.Sqrt(1.0 + (x * x)) : atRigSpeed;
    }
}
