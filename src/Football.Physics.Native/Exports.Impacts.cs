using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>The outputs of impacts.</content>
internal static unsafe partial class Exports
{
    /// <summary>Computes the outputs of an impact with a stationary surface: impulses, slip, duration, compression, peak force, energy.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="event">An impact of a ball in this scene.</param>
    /// <param name="out">Receives the outputs.</param>
    /// <returns>
    /// FP_OK, FP_HANDLE, or FP_ARGUMENT: the event is not an impact, or its object moves or has a mass. For the event of a match, use fp_match_impact.
    /// </returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_impact")]
    public static NativeStatus Impact([In] NativeScene* scene, [In] NativeEvent* @event, NativeImpactResult* @out)
    {
        try
        {
            CompiledScene compiled = Guard.SceneOf(scene);
            Guard.Given(@event, "event");
            Guard.Given(@out, "out");
            if (@event->Kind != (int)BallEventKind.Impact)
            {
                throw new ArgumentException($"event.kind is {@event->Kind}; allowed: {(int)BallEventKind.Impact}, an impact.");
            }

            var happened = new BallEvent(
                BallEventKind.Impact, @event->Thing, Guard.Vector(@event->Normal, "event.normal"), @event->Time, Guard.Vector(@event->Position, "event.position"),
                Guard.Vector(@event->VelocityBefore, "event.velocity_before"), Guard.Vector(@event->SpinBefore, "event.spin_before"),
                Guard.Vector(@event->Velocity, "event.velocity"), Guard.Vector(@event->Spin, "event.spin"));
            Impact impact = compiled.Simulator.ImpactOfStationary(in happened)
                ?? throw new ArgumentException($"event.thing is {@event->Thing}, which is not a stationary surface of the scene. Use fp_match_impact.");
            Put(in impact, @out);
            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    private static void Put(in Impact from, NativeImpactResult* to)
    {
        Put(from.Impulse, to->Impulse);
        to->NormalImpulse = from.NormalImpulse;
        to->TangentialImpulse = from.TangentialImpulse;
        to->SlipBefore = from.SlipBefore;
        to->SlipAfter = from.SlipAfter;
        to->ContactTime = from.ContactTime;
        to->Compression = from.Compression;
        to->PeakForce = from.PeakForce;
        to->EnergyLost = from.EnergyLost;
        to->Grips = from.Grips ? 1 : 0;
        to->Reserved = 0;
    }
}
