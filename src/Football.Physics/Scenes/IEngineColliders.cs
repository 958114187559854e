namespace FootballPhysics.Engines;

/// <summary>The colliders of a game engine. The engine says what lies near a straight way; the library finds the instant of contact on the ball's own path.</summary>
/// <remarks>
/// It is asked about once for every piece of motion, on the thread that steps the ball. Where several ask at once, each needs a scene of its own.
/// Snapshots do not hold an engine's colliders: who steps again must have them where they were.
/// </remarks>
public interface IEngineColliders
{
    /// <summary>When the colliders are where the engine has them, on the clock of the ball, s. From there each goes on with its own velocity and spin.</summary>
    double Time { get; }

    /// <summary>Not slower than the fastest point of any collider, m/s, with its rotation; 0 where all stand still. So far beside the way they are looked for.</summary>
    double MaximumSpeed { get; }

    /// <summary>Adds every collider that a sphere touches on a straight way, also where it starts. What is too far does no harm.</summary>
    /// <param name="cast">The sphere and its way.</param>
    /// <param name="hits">What it touches, to be added to.</param>
    void Cast(in SphereCast cast, EngineHits hits);
}
