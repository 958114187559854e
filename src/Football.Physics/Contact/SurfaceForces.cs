namespace Football.Physics;

/// <summary>Forces on a ball that a surface carries, without friction; per mass, or per moment of inertia.</summary>
internal struct SurfaceForces
{
    /// <summary>A load, or a friction to spare, of less than this, m/s², is none.</summary>
    public const double Least = 1e-9;

    /// <summary>n.</summary>
    public Vector3d Normal;

    /// <summary>v − V, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>ṅ = H (v − V), 1/s.</summary>
    public Vector3d Turning;

    /// <summary>(v−V)ᵀH(v−V), m/s².</summary>
    public double Centripetal;

    /// <summary>Gravity, buoyancy and nets along the surface, m/s².</summary>
    public Vector3d Body;

    /// <summary>The air, and the game's own forces, along the surface, m/s².</summary>
    public Vector3d Air;

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
