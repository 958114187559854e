namespace Football.Physics;

/// <summary>The frame in which a kick is sought: from the ball, horizontally forward to the target, to the left of that, and up.</summary>
internal readonly struct TargetFrame
{
    /// <summary>Where the ball is, m.</summary>
    public readonly Vector3d From;

    /// <summary>Where it is to go, m.</summary>
    public readonly Vector3d Target;

    /// <summary>Horizontal unit vector to the target; a fixed one where the target is straight above, below or at the ball.</summary>
    public readonly Vector3d Forward;

    /// <summary>ŷ × forward.</summary>
    public readonly Vector3d Left;

    /// <summary>Horizontal distance of the target, m.</summary>
    public readonly double Distance;

    public TargetFrame(in Vector3d from, in Vector3d target)
    {
        Vector3d flat = (target - from).Horizontal;
        From = from;
        Target = target;
        Distance = flat.Length;
        Forward = Distance > 0 ? flat / Distance : new Vector3d(0, 0, -1);
        Left = new Vector3d(Forward.Z, 0, -Forward.X);
    }

    /// <summary>Whether the target is at the ball, so that there is no direction to kick in.</summary>
    public bool IsDegenerate => Distance < 1e-6 && Math.Abs(Target.Y - From.Y) < 1e-6;

    /// <summary>Height at which a ball that falls is given up, m: far below both ends of any flight that is of use.</summary>
    public double Floor => Math.Min(From.Y, Target.Y) - (2.0 * Distance) - 10.0;

    /// <summary>A kick turned into a direction, as far as the bounds allow.</summary>
    public Kick Turned(in Kick kick, in Vector3d direction, in ElevationBounds bounds)
    {
        Kick turned = kick;
        turned.Elevation = bounds.Clamp(Elementary.Atan2(direction.Y, direction.Horizontal.Length));
        turned.Azimuth = Elementary.Atan2(Vector3d.Dot(in direction, in Left), Vector3d.Dot(in direction, in Forward));
        return turned;
    }
}
