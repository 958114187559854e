namespace FootballPhysics.Native;

/// <summary>The forces on a ball with which its next step begins, for arrows and overlays. A force that does not act is zero. World frame.</summary>
internal unsafe struct NativeForcesResult
{
    /// <summary>The weight, N.</summary>
    public fixed double Weight[3];

    /// <summary>The buoyancy in the air, N.</summary>
    public fixed double Buoyancy[3];

    /// <summary>The drag, against the motion through the air, N.</summary>
    public fixed double Drag[3];

    /// <summary>The Magnus force, across spin and motion through the air, N.</summary>
    public fixed double Magnus[3];

    /// <summary>The knuckle force of the seams, N; it acts only in flight.</summary>
    public fixed double Knuckle[3];

    /// <summary>The sum of the custom forces, N. A scene in JSON has none, so it is zero.</summary>
    public fixed double Custom[3];

    /// <summary>The sum of the forces of all nets that the ball is in, N.</summary>
    public fixed double Nets[3];

    /// <summary>The sum of the loads of all contacts, along their normals, N.</summary>
    public fixed double Load[3];

    /// <summary>The sum of the friction of all contacts, N; it includes rolling resistance, and the force that holds a ball at rest.</summary>
    public fixed double Friction[3];

    /// <summary>The sum of all forces, N.</summary>
    public fixed double Sum[3];

    /// <summary>The acceleration with which the next step begins, m/s^2; sum divided by the mass, to within rounding.</summary>
    public fixed double Acceleration[3];

    /// <summary>
    /// 1 if there are forces. 0, and all vectors zero, if the step begins with an impact or solves the contacts by impulses, or if the contacts of a ball at rest do
    /// not determine their forces.
    /// </summary>
    public int Determined;

    /// <summary>0.</summary>
    public int Reserved;
}
