namespace FootballPhysics.Engines;

/// <summary>The colliders of a game engine.</summary>
/// <remarks>
/// The engine returns the colliders near a straight line. The library then finds the time of contact on the ball's real path.
/// <para>The simulator calls it once per segment of motion, on the thread that steps the ball. Threads that step balls at the same time need separate
/// scenes. Snapshots do not store engine colliders: if you replay steps, move the colliders back first.</para>
/// </remarks>
public interface IEngineColliders
{
    /// <summary>The time of the colliders' positions in the engine, on the clock of the ball, in s.</summary>
    /// <remarks>From this time on, each collider moves with its own velocity and spin.</remarks>
    double Time { get; }

    /// <summary>An upper bound on the speed of any point of any collider, including rotation, in m/s.</summary>
    /// <remarks>0 if all colliders are static. The radius of the sphere cast grows with this speed.</remarks>
    double MaximumSpeed { get; }

    /// <summary>Adds every collider that a moving sphere touches, including those that it touches at the start.</summary>
    /// <remarks>You may also add colliders that the sphere does not touch.</remarks>
    /// <param name="cast">The sphere and its line of motion.</param>
    /// <param name="hits">The list of hits to add to.</param>
    void Cast(in SphereCast cast, EngineHits hits);
}
