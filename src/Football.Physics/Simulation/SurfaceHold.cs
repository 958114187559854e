using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Holds a sliding or rolling ball on its carrier at the end of a piece, to remove the integrator's error.</summary>
internal sealed class SurfaceHold
{
    /// <summary>Maximum number of iterations that move a ball onto a second surface.</summary>
    private const int MostPuts = 16;

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
            n = PutOnto(ref s, system.Carrier, met);
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

    /// <summary>Moves the ball along its carrier onto a second surface that it touches, and iterates if the surfaces are curved.</summary>
    /// <remarks>
    /// A flush surface, with a nearly equal normal, is skipped: it becomes the next carrier instead.
    /// </remarks>
    /// <returns>The carrier's normal at the new position.</returns>
    private Vector3d PutOnto(ref BallState s, Collider carrier, int collider)
    {
        Vector3d n = carrier.At(s.Position, s.Time).Normal;

        // Use Newton's method along the carrier, by −gap n_t/|n_t|², then project back onto the carrier.
        for (int i = 0; i < MostPuts; i++)
        {
            ShapePoint at = _world.ByIndex[collider].At(s.Position, s.Time);
            Vector3d along = SurfaceSystem.Tangential(at.Normal, in n);
            double gap = at.Distance - _world.Ball.Radius;
            double share = along.LengthSquared;
            if (!(Math.Abs(gap) > ContactTolerances.ClosedGap) || !(share > 2.0 * ContactTolerances.SameNormal))
            {
                break;
            }

            s.Position -= gap / share * along;
            n = _world.Hold(ref s, carrier);
        }

        return n;
    }
}
