namespace Football.Physics;

/// <summary>A function g of the motion whose zero is an event: its gradient, and its rate along the motion just before.</summary>
internal readonly struct EventGradient
{
    /// <summary>∂g/∂p.</summary>
    public readonly Vector3d Place;

    /// <summary>∂g/∂v.</summary>
    public readonly Vector3d Velocity;

    /// <summary>∂g/∂ω.</summary>
    public readonly Vector3d Spin;

    /// <summary>ġ.</summary>
    public readonly double Rate;

    public EventGradient(in Vector3d place, in Vector3d velocity, in Vector3d spin, double rate)
    {
        Place = place;
        Velocity = velocity;
        Spin = spin;
        Rate = rate;
    }
}
