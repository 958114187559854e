namespace FootballPhysics;

/// <summary>The part of the ball that decides whether the ball is in a <see cref="Zone"/>.</summary>
public enum ZonePart
{
    /// <summary>Its surface: the ball enters when it first touches the shape, and leaves when no part of it is in the shape.</summary>
    Ball = 0,

    /// <summary>Its centre.</summary>
    Center = 1,
}
