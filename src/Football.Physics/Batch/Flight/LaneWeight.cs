namespace Football.Physics;

/// <summary>The acceleration by gravity and buoyancy, in float.</summary>
internal readonly struct LaneWeight
{
    /// <summary>Along the lanes' x, m/s².</summary>
    public readonly float AlongX;

    /// <summary>Along the lanes' y, m/s².</summary>
    public readonly float AlongY;

    /// <param name="scene">The scene.</param>
    /// <param name="upAlongX">Whether up is along the lanes' x, else y.</param>
    public LaneWeight(Scene scene, bool upAlongX)
    {
        double up = Weight.UpwardAcceleration(scene);
        AlongX = upAlongX ? (float)up : 0f;
        AlongY = upAlongX ? 0f : (float)up;
    }
}
