using FootballPhysics.Contacts;
using FootballPhysics.Events;

namespace FootballPhysics;

/// <content>The objects of events, and the outputs of impacts.</content>
public sealed partial class Simulator
{
    /// <summary>Computes the outputs of an impact: impulses, slip, duration, compression, peak force and energy.</summary>
    /// <remarks>Use them for sound, haptics and looks. The simulation does not depend on them, and computes none that is not read.</remarks>
    /// <param name="happened">An event of a ball of this scene.</param>
    /// <returns>The outputs; all are 0 if the event is not an impact.</returns>
    public Impact ImpactOf(in BallEvent happened) => happened.Kind == BallEventKind.Impact ? new Impact(Scene.Ball, in happened) : default;

    /// <summary>Computes the outputs of an impact with a stationary surface of this scene, from an event that has lost its object.</summary>
    /// <returns>The outputs; null if the object moves or has a mass, or is not in the scene.</returns>
    internal Impact? ImpactOfStationary(in BallEvent happened)
    {
        int index = happened.ColliderIndex - _world.FirstCollider;
        if ((uint)index >= (uint)_world.ByIndex.Length || _world.ByIndex[index] is not { Moves: false, GivesWay: false } hit)
        {
            return null;
        }

        // A contact that slips has the largest friction.
        var impact = new Impact(Scene.Ball, new BallEvent(in happened, new ImpactContact(Vector3d.Zero, grips: true)));
        double most = FrictionLaw.Limit(hit.MaterialAt(happened.Position).ImpactFriction, impact.NormalImpulse);
        bool slips = impact.TangentialImpulse > 0 && impact.TangentialImpulse >= most * (1.0 - ContactTolerances.SameLoad);
        return slips ? impact with { Grips = false } : impact;
    }

    /// <summary>The names of all surfaces and zones, indexed by <see cref="BallEvent.ColliderIndex"/>.</summary>
    /// <remarks>The order is: the ground, obstacles, posts and bars, bodies, nets, goals, zones.</remarks>
    public IReadOnlyList<string> Names => _world.Names;

    /// <summary>Returns the name of a surface or zone, such as "ground", "left post" or "goal"; null for a negative index.</summary>
    /// <param name="thing"><see cref="BallEvent.ColliderIndex"/> of an event; negative for none.</param>
    /// <exception cref="ArgumentOutOfRangeException">The scene has no such index.</exception>
    public string? NameOf(int thing) => thing < 0 ? null : _world.NameOf(thing);

    /// <summary>Returns the name of the object that an event reports, such as "ground" or "left post".</summary>
    /// <param name="happened">An event of a ball in this scene.</param>
    /// <returns>The name; null if the event has no object of the scene, as when the ball comes to rest or hits another ball.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The event is from another scene: this scene has no such object.</exception>
    public string? NameOf(in BallEvent happened) => NameOf(happened.ColliderIndex);
}
