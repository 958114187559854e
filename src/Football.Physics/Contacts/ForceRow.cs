namespace FootballPhysics.Contacts;

/// <summary>An unknown force: the response of the ball to a unit of it, and the condition that determines it.</summary>
internal struct ForceRow
{
    /// <summary>The condition AlongV·v̇ + AlongW·ω̇ = Target.</summary>
    public Vector3d AlongV;
    public Vector3d AlongW;
    public double Target;

    /// <summary>Response of v̇ and ω̇ to a unit of it.</summary>
    public Vector3d PushV;
    public Vector3d PushW;

    /// <summary>The parts of the response that rolling resistance and drilling friction take, if they hold the ball.</summary>
    public double Held;
    public double HeldSpin;
}
