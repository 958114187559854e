namespace FootballPhysics.Yardsticks;

/// <summary>Position, velocity and spin of a ball in flight.</summary>
public struct PlainState
{
    public PlainVector Position { get; set; }

    public PlainVector Velocity { get; set; }

    public PlainVector Spin { get; set; }

    public static PlainState Of(Shot shot) => new() { Position = shot.Position, Velocity = shot.Velocity, Spin = shot.Spin };
}
