using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>A contact of a pile: of two of its balls, or of a ball with another object.</summary>
internal struct PileContact
{
    /// <summary>The ball, as a member of the pile.</summary>
    public int First;

    /// <summary>The other ball; −1 if the contact is with another object.</summary>
    public int Second;

    /// <summary>Index of the collider; −1 for a ball.</summary>
    public int Collider;

    /// <summary>True if that collider moves.</summary>
    public bool Moves;

    /// <summary>True if no ball can rest on it: it moves in this step, or overlaps a ball.</summary>
    public bool MovesNow;

    /// <summary>True if it bounces when it touches, so that it has no load before.</summary>
    public bool Bounces;

    /// <summary>True if friction holds the contact.</summary>
    public bool Sticks;

    /// <summary>n, towards the first ball.</summary>
    public Vector3d Normal;

    /// <summary>V of the collider, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Distance, m; 0 for an overlap.</summary>
    public double Gap;

    /// <summary>1/(1/m₁ + 1/m₂), and the same including r²/I of both, kg.</summary>
    public double NormalMass;
    public double SlipMass;

    /// <summary>1/(1/I₁ + 1/I₂) of two balls, kg m².</summary>
    public double TwistMass;

    /// <summary>The resistance of the collider, or of the other ball.</summary>
    public Resistance Resistance;

    /// <summary>J_n, N s.</summary>
    public double Load;

    /// <summary>J_t, N s.</summary>
    public Vector3d Rub;

    /// <summary>For two balls: the angular impulse about n, N m s.</summary>
    public double Twist;

    /// <summary>Changes of both in an iteration, N s, and the search direction.</summary>
    public double LoadChange;
    public Vector3d RubChange;
    public double LoadStep;
    public Vector3d RubStep;
}
