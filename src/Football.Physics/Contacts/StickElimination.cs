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

    /// <summary>The load and the friction at the eliminated contact per unit of it.</summary>
    public double OwnLoad;
    public Vector3d OwnFriction;
}

/// <summary>A sticking contact in closed form: its response to any other force on the ball.</summary>
internal readonly struct StickElimination
{
    private readonly Vector3d _normal;
    private readonly Vector3d _pushV;
    private readonly Vector3d _pushW;
    private readonly double _radius;
    private readonly double _perLoad;
    private readonly double _share;
    private readonly double _perTurn;

    /// <summary>Prepares the elimination.</summary>
    /// <param name="normal">n, towards the ball.</param>
    /// <param name="load">Response to a unit of load, including rolling resistance.</param>
    /// <param name="radius">Radius of the ball, m.</param>
    /// <param name="alpha">α = I/(m r²).</param>
    public StickElimination(in Vector3d normal, in ForceRow load, double radius, double alpha)
    {
        _normal = normal;
        _pushV = load.PushV;
        _pushW = load.PushW;
        _radius = radius;
        _perLoad = 1.0 / Vector3d.Dot(in normal, in load.PushV);
        _share = alpha / (1.0 + alpha);
        _perTurn = 1.0 / (alpha * radius);
    }

    /// <summary>Adds the contact's response to accelerations: n·v̇ = target, and (v̇ + r n × ω̇)_t = the tangential part of a
    /// vector.</summary>
    public void Respond(double target, in Vector3d targetAlong, ref Vector3d acceleration, ref Vector3d spinAcceleration, out double load, out Vector3d friction)
    {
        load = (target - Vector3d.Dot(in _normal, in acceleration)) * _perLoad;
        acceleration += load * _pushV;
        spinAcceleration += load * _pushW;

        // The change of slip due to F: F − r n × (n × F)/(α r) = (1 + α)/α F.
        Vector3d slip = targetAlong - acceleration - (_radius * Vector3d.Cross(in _normal, in spinAcceleration));
        friction = _share * SurfaceSystem.Tangential(in slip, in _normal);
        acceleration += friction;
        spinAcceleration -= _perTurn * Vector3d.Cross(in _normal, in friction);
    }
}
