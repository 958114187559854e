namespace FootballPhysics;

/// <summary>The part of the ball that determines whether the ball is in a <see cref="Zone"/>.</summary>
public enum ZonePart
{
    /// <summary>Any part of the ball: it enters at the first contact with the shape, and leaves when no part is inside.</summary>
    Ball = 0,

    /// <summary>The centre of the ball.</summary>
    Center = 1,
}
