namespace FootballPhysics.Contacts;

/// <summary>A contact of a ball with another object, or with another ball: its geometry, its material, and its impulse in the last part.</summary>
internal struct Contact
{
    /// <summary>The ball, as a member of its pile; 0 for a ball alone.</summary>
    public int First;

    /// <summary>The other ball; −1 if the contact is with another object.</summary>
    public int Second;

    /// <summary>Index of the collider; −1 for a ball.</summary>
    public int Collider;

    /// <summary>True if the collider moves. The ball may then overlap the collider if it cannot get out of the way.</summary>
    public readonly bool Moves;

    /// <summary>True if no ball of a pile can rest on it: it moves in this step, or overlaps a ball.</summary>
    public bool MovesNow;

    /// <summary>True if it bounces when it touches, so that it has no load before.</summary>
    public bool Bounces;

    /// <summary>True if friction holds the contact.</summary>
    public bool Sticks;

    /// <summary>True if the surface is flat there.</summary>
    public readonly bool IsFlat;

    /// <summary>The curvature of the surface as the ball meets it.</summary>
    public readonly Bend Bend;

    /// <summary>n, towards the first ball.</summary>
    public Vector3d Normal;

    /// <summary>V_c, the velocity of the surface at the contact point, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Distance from the ball, m; negative for an overlap.</summary>
    public double Gap;

    /// <summary>True if it touches the ball. A contact of a ball that rattles may have a small gap.</summary>
    public readonly bool Touches => Gap <= ContactTolerances.Touching;

    /// <summary>Material of the surface.</summary>
    public ContactMaterial Material;

    /// <summary>1/(1/m₁ + 1/m₂), and the same including r²/I of both, kg.</summary>
    public double NormalMass;
    public double SlipMass;

    /// <summary>1/(1/I₁ + 1/I₂) of two balls, kg m².</summary>
    public double TwistMass;

    /// <summary>J_n, N s.</summary>
    public double Load;

    /// <summary>J_t, N s.</summary>
    public Vector3d Rub;

    /// <summary>For two balls: the angular impulse about n, N m s.</summary>
    public double Twist;

    /// <summary>The closing speed that the gap allows in the part, m/s.</summary>
    public double MostClosing;

    /// <summary>Changes of J_n and J_t in an iteration, N s, and the search direction.</summary>
    public double LoadChange;
    public Vector3d RubChange;
    public double LoadStep;
    public Vector3d RubStep;

    public Contact(int index, Collider collider, in ShapePoint at, double gap, BallProperties ball, in BallState s)
    {
        this = default;
        Second = -1;
        Collider = index;
        Moves = collider.Moves;
        IsFlat = at.IsFlat;
        Bend = collider.BendAt(in at, s.Position, s.Velocity, s.Time);
        Normal = at.Normal;
        Velocity = collider.SurfaceVelocity(s.Position - (ball.Radius * at.Normal), at.Normal, s.Time);
        Gap = gap;
        Material = collider.MaterialAt(s.Position);
        NormalMass = ball.Mass;
        SlipMass = ball.InertiaFactor / (1.0 + ball.InertiaFactor) * ball.Mass;
    }
}
