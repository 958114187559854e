namespace FootballPhysics.Contacts;

/// <summary>A ball whose contacts are solved by impulses: a ball alone, or one of a pile.</summary>
internal struct PressedBall
{
    /// <summary>1/m, 1/kg.</summary>
    public double PerMass;

    /// <summary>1/I, 1/(kg m²).</summary>
    public double PerInertia;

    /// <summary>α.</summary>
    public double InertiaFactor;

    /// <summary>r, m.</summary>
    public double Radius;

    /// <summary>Velocity and spin in the solver, m/s and rad/s.</summary>
    public Vector3d V;
    public Vector3d W;

    /// <summary>Velocity and spin without contacts, m/s and rad/s.</summary>
    public Vector3d FreeV;
    public Vector3d FreeW;

    /// <summary>Its contacts with objects other than balls: index of the first, and their number.</summary>
    public int FirstContact;
    public int OwnContacts;

    /// <summary>The resistance to its rotation, rad/s.</summary>
    public TurningResistance Turning;

    public PressedBall(BallProperties ball)
    {
        this = default;
        PerMass = 1.0 / ball.Mass;
        PerInertia = 1.0 / ball.MomentOfInertia;
        InertiaFactor = ball.InertiaFactor;
        Radius = ball.Radius;
    }
}
