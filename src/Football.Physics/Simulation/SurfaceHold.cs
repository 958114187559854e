using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Holds a sliding or rolling ball on its carrier at the end of a piece, to remove the integrator's error.</summary>
internal sealed class SurfaceHold
{
    private readonly World _world;
    private readonly bool _brakesAlone;

    public SurfaceHold(Scene scene, Surroundings around)
    {
        _world = around.World;
        _brakesAlone = !around.Air.Varies && scene.Ground.Heights is null;
    }

    /// <summary>Projects the ball onto all surfaces that it touches, to remove the integrator's error.</summary>
    public void Hold(ref BallState s, in SurfaceSystem system, int met)
    {
        // Just beyond the edge of a flat face, the ball is still on the plane of that face.
        bool beyond = system.IsFace && system.Carrier.FaceMargin(s.Position, s.Time) <= 0;
        Vector3d n = beyond ? system.FaceNormal : _world.Hold(ref s, system.Carrier);
        if (met < 0 && !_world.IsPlaneAlone)
        {
            // The projection may have pushed the ball into a surface that it was leaving or touched without load.
            met = NearThings.Deepest(_world, in s, out _);
        }

        if (met >= 0)
        {
            // A flush surface, with a nearly equal normal, becomes the next carrier instead.
            ContactSet.PutOntoTwo(_world, ref s, system.Carrier, _world.ByIndex[met]);
            n = _world.Hold(ref s, system.Carrier);
        }

        Vector3d spin = s.SpinAxis;
        double about = Vector3d.Dot(in spin, in n);
        double carried = Vector3d.Dot(system.Carrier.Spin, in n);

        // Friction, damping and decay end the spin about the normal relative to the carrier, but never reverse it.
        bool brakesAlone = system.Material.Resistance.Drills || (_brakesAlone && system.Carrier == _world.Ground);
        double kept = system.AboutCarrier(in system.StartSpin, in n) * (about - carried) < 0 && brakesAlone ? carried : about;
        Vector3d surface = _world.SurfaceVelocity(system.Carrier, s.Position, in n, s.Time);
        s.SpinAxis = system.Rolls ? Slip.RollingSpin(s.Velocity - surface, kept, in n, _world.Ball.Radius)
            : kept == about ? spin : spin - ((about - kept) * n);
    }
}
