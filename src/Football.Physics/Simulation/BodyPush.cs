using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Handles bodies that the game has moved between two steps: a body moved into the ball ejects it, and a carrier that was taken
/// away releases it.</summary>
/// <remarks>The velocity does not change: a body accelerates the ball only in an impact.</remarks>
internal sealed class BodyPush
{
    /// <summary>Maximum number of pushes from one body to the next.</summary>
    /// <remarks>Between two bodies that close on the ball there is no free position.</remarks>
    private const int MostPushes = 16;

    /// <summary>Maximum number of Newton iterations.</summary>
    private const int MostSteps = 20;

    private readonly World _world;
    private readonly WorldContact _contact;
    private readonly WorldGuard _guard;

    public BodyPush(World world, WorldGuard guard, WorldContact contact)
    {
        _world = world;
        _contact = contact;
        _guard = guard;
    }

    /// <summary>Resolves the overlaps before the pieces of a step.</summary>
    public void Apply(ref BallState s, ref StepRun run)
    {
        _world.Engine?.Forget();
        if (s.Motion == MotionState.Pinned)
        {
            return;
        }

        // Check the carrier first, because the game may have moved it away from the ball.
        LetGo(ref s, ref run);
        CrossSeam(ref s, ref run);
        int deepest = NearThings.Deepest(_world, in s, out bool overlapsBody);

        // The game does not cause overlaps with stationary objects: handle such an overlap as an impact.
        Vector3d from = s.Position;
        int pressing = Math.Max(deepest, 0);
        for (int i = 0; overlapsBody && i < MostPushes && deepest >= 0; i++)
        {
            PushOut(ref s, _world.ByIndex[deepest]);
            deepest = NearThings.Deepest(_world, in s, out _);
        }

        if (overlapsBody && (deepest >= 0 || IsBarred(in s, in from)))
        {
            // No free position was found, or an object blocks the path to it: the ball is squeezed.
            s.Position = from;
            _contact.BeginSqueeze(ref s, pressing, ref run);
        }

        // While the ball is pushed out, it may pass through nets and goals.
        _guard.Follow(ref s, in from, ref run);
    }

    /// <summary>Hands the ball over to a flush body if a step starts just beyond a seam.</summary>
    /// <remarks>A tiny height difference therefore causes no push.</remarks>
    private void CrossSeam(ref BallState s, ref StepRun run)
    {
        if (s.Motion is not (MotionState.Rolling or MotionState.Sliding))
        {
            return;
        }

        int next = Flush.CarrierOf(_world, in s);
        if (_world.Ball.Radius - _world.ByIndex[next].At(s.Position, s.Time).Distance <= Flush.LowerBy)
        {
            _contact.HandOver(ref s, next, ref run);
        }
    }

    /// <summary>Pushes the ball out of one object: Newton iteration on the gap, along the direction that is open to the ball.</summary>
    private void PushOut(ref BallState s, Collider collider)
    {
        for (int i = 0; i < MostSteps; i++)
        {
            ShapePoint at = collider.At(s.Position, s.Time);
            double gap = at.Distance - _world.Ball.Radius;
            if (Math.Abs(gap) <= 0.5 * ContactTolerances.Touching)
            {
                return;
            }

            s.Position -= gap * Way(in s, at.Normal);
            StayOnCarrier(ref s);
        }
    }

    /// <summary>True if a stationary object, such as a thin board, blocks the path of a push.</summary>
    private bool IsBarred(in BallState s, in Vector3d from)
    {
        // Treat the push as a straight path of nearly zero duration, and search it for a stationary object.
        var path = PathCubic.Line(in from, (s.Position - from) / ContactTolerances.Displacement, ContactTolerances.Displacement);
        int carrier = s.Motion == MotionState.Airborne ? -1 : (int)s.Carrier - _world.FirstCollider;
        return new ContactSearch(_world, in path, s.Time).FirstContact(in s, carrier, default, out Separation met, out _) <= ContactTolerances.Displacement
            && met.What == SeparationKind.Contact && !_world.ByIndex[met.Index].Moves;
    }

    /// <summary>Releases the ball if its carrier is a body that is no longer at its expected position.</summary>
    private void LetGo(ref BallState s, ref StepRun run)
    {
        if (s.Motion == MotionState.Airborne || !_world.CarrierOf(in s).IsBody)
        {
            return;
        }

        Collider carrier = _world.CarrierOf(in s);

        // The engine may have removed the collider.
        if (_world.Engine is { } engine && engine.Has((int)s.Carrier - _world.FirstCollider))
        {
            engine.LookAt(s.Position, s.Time, ContactTolerances.Touching);
            if (!engine.Finds((int)s.Carrier - _world.FirstCollider))
            {
                _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
                return;
            }
        }

        // Release the ball if a gap has opened, or if the carrier no longer moves along with it.
        ShapePoint at = carrier.At(s.Position, s.Time);
        double off = Vector3d.Dot(s.Velocity - carrier.ShapeVelocity(s.Position, s.Time), at.Normal);
        if (carrier.IsWithdrawn || Math.Abs(at.Distance - _world.Ball.Radius) > ContactTolerances.Touching || Math.Abs(off) > ContactTolerances.Approaching)
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
        }
    }

    /// <summary>Returns the push direction: the normal, or its projection on the carrier for a supported ball.</summary>
    private Vector3d Way(in BallState s, in Vector3d normal)
    {
        if (s.Motion == MotionState.Airborne)
        {
            return normal;
        }

        Vector3d up = _world.CarrierOf(in s).At(s.Position, s.Time).Normal;

        // n_t/|n_t|², with the part n_t of the normal along the carrier: the displacement along the carrier that closes a gap of length 1.
        Vector3d along = normal - (Vector3d.Dot(in normal, in up) * up);
        double share = along.LengthSquared;

        // If a body is exactly above the ball, no direction is preferred: push the ball forward.
        return share > ContactTolerances.AlongNormal ? along / Math.Max(share, 0.01) : Vector3d.Cross(in up, Math.Abs(up.X) < 0.9 ? new Vector3d(1, 0, 0) : Vector3d.Up);
    }

    /// <summary>Moves the ball back onto its carrier, which may be curved.</summary>
    private void StayOnCarrier(ref BallState s)
    {
        if (s.Motion != MotionState.Airborne)
        {
            ShapePoint at = _world.CarrierOf(in s).At(s.Position, s.Time);
            s.Position += (_world.Ball.Radius - at.Distance) * at.Normal;
        }
    }
}
