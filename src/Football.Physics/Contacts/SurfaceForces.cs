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
}

/// <summary>Events that end a piece of a slide or a roll, each with a margin that falls to zero.</summary>
internal enum SurfaceLimit
{
    /// <summary>The load: the ball leaves the surface.</summary>
    Load,

    /// <summary>The margin of static friction: at zero a rolling ball starts to slip.</summary>
    Grip,

    /// <summary>The energy above the rest energy.</summary>
    Rest,

    /// <summary>The spin about the normal, which drilling friction stops and never reverses.</summary>
    Spin,
}
