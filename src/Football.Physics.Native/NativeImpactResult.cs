namespace FootballPhysics.Native;

/// <summary>The outputs of an impact, for sound, haptics and looks. The simulation does not depend on them.</summary>
internal unsafe struct NativeImpactResult
{
    /// <summary>The impulse on the ball, N s. The object received the opposite impulse.</summary>
    public fixed double Impulse[3];

    /// <summary>The impulse along the normal, N s; at least 0.</summary>
    public double NormalImpulse;

    /// <summary>The impulse of friction, N s; at least 0.</summary>
    public double TangentialImpulse;

    /// <summary>The speed of the ball's contact point along the surface just before, m/s.</summary>
    public double SlipBefore;

    /// <summary>The same just after, m/s.</summary>
    public double SlipAfter;

    /// <summary>The duration of a real impact, s.</summary>
    public double ContactTime;

    /// <summary>The largest compression of the ball, m.</summary>
    public double Compression;

    /// <summary>The largest normal force, N.</summary>
    public double PeakForce;

    /// <summary>The kinetic energy lost, J, relative to the surface; negative if a bumper adds energy.</summary>
    public double EnergyLost;

    /// <summary>1 if friction held the contact; 0 if the ball slipped.</summary>
    public int Grips;

    /// <summary>0.</summary>
    public int Reserved;
}
