namespace FootballPhysics;

/// <summary>Forces on a ball that a surface carries, without friction; per mass, or per moment of inertia.</summary>
internal struct SurfaceForces
{
    /// <summary>A load, or a friction to spare, of less than this, m/s², is none.</summary>
    public const double Least = 1e-9;

    /// <summary>n.</summary>
    public Vector3d Normal;

    /// <summary>q, the velocity relative to the shape, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>v − V_p, the velocity relative to the carrier's material, m/s: rolling friction acts against it.</summary>
    /// <remarks>It is q where nothing rotates.</remarks>
    public Vector3d Rolling;

    /// <summary>V_c, the velocity of the surface at the contact point, m/s.</summary>
    public Vector3d Surface;

    /// <summary>A, the rate of change of V_c along the path, m/s²; 0 where the carrier does not rotate.</summary>
    public Vector3d SurfaceRate;

    /// <summary>Acceleration of the carrier's material at the ball's centre along the surface, m/s²; 0 where the carrier does not rotate.</summary>
    public Vector3d MaterialRate;

    /// <summary>r ω_n n × ṅ, m/s²: what a spin about a normal that turns asks of friction.</summary>
    public Vector3d Gyration;

    /// <summary>ṅ = Hq, and Ω × n + Hq where the shape rotates, 1/s.</summary>
    public Vector3d Turning;

    /// <summary>qᵀHq − A_s·n, m/s²: the ball stays on the surface with n·v̇ = −this.</summary>
    public double Centripetal;

    /// <summary>Gravity, buoyancy and nets along the surface, m/s².</summary>
    public Vector3d Body;

    /// <summary>The air, and the game's own forces, along the surface, m/s².</summary>
    public Vector3d Air;

    /// <summary>The game's own forces, m/s²: they wake a ball at rest also where the air does not.</summary>
    public Vector3d Own;

    /// <summary>Torques of the air, of nets and of the game's own, rad/s².</summary>
    public Vector3d Torque;

    /// <summary>By how much the air slows the spin, rad/s²; of a ball without spin, by how much it holds one that begins to turn.</summary>
    public double Braking;

    /// <summary>True when the ball has a spin, as the air sees it.</summary>
    public bool Spins;

    /// <summary>N/m, not negative, m/s².</summary>
    public double Load;

    /// <summary>N/m as it would be if the surface could pull, m/s²: where it falls to zero the ball leaves.</summary>
    public double FreeLoad;
}

/// <summary>Ends of a piece of a slide or a roll: each a number that falls to zero there.</summary>
internal enum SurfaceLimit
{
    /// <summary>The load: the ball leaves the surface.</summary>
    Load,

    /// <summary>Reserve of static friction: at zero a rolling ball begins to slip.</summary>
    Grip,

    /// <summary>The energy above that of rest.</summary>
    Rest,

    /// <summary>The spin about the normal, which drilling friction ends and never reverses.</summary>
    Spin,
}
