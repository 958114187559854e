namespace FootballPhysics;

/// <summary>
/// What the game has done to a ball by moving its bodies between two steps: one that was put over the ball pushes it out, one that was taken away from
/// under it lets it go. Its velocity stays: what a body gives to the ball it gives by hitting it.
/// </summary>
internal sealed class BodyPush
{
    /// <summary>How often the ball is pushed, from one body onto the next, at most: between two that close in on it there is no place.</summary>
    private const int MostPushes = 16;

    /// <summary>Steps of Newton's method at most.</summary>
    private const int MostSteps = 20;

    private readonly World _world;
    private readonly WorldContact _contact;
    private readonly Displacement _displacement;

    public BodyPush(World world, Displacement displacement, WorldContact contact)
    {
        _world = world;
        _contact = contact;
        _displacement = displacement;
    }

    /// <summary>Before the pieces of a step.</summary>
    public void Apply(ref BallState s, ref StepRun run)
    {
        _world.Engine?.Forget();
        if (s.Motion == MotionState.Pinned)
        {
            return;
        }

        // First what carried it: the game may have taken it away from under the ball.
        LetGo(ref s, ref run);
        CrossSeam(ref s, ref run);
        int deepest = NearThings.Deepest(_world, in s, out bool overlapsBody);

        // What overlaps a thing that stands still alone is not the game's doing: that is an impact.
        Vector3d from = s.Position;
        int pressing = Math.Max(deepest, 0);
        for (int i = 0; overlapsBody && i < MostPushes && deepest >= 0; i++)
        {
            PushOut(ref s, _world.Colliders[deepest]);
            deepest = NearThings.Deepest(_world, in s, out _);
        }

        if (overlapsBody && (deepest >= 0 || IsBarred(in s, in from)))
        {
            // There is no place for it, or no way there.
            s.Position = from;
            _contact.BeginSqueeze(ref s, pressing, ref run);
        }

        // It meets nets, and comes through goals, on the way out too.
        _displacement.Follow(ref s, in from, ref run);
    }

    /// <summary>A step may begin just beyond the edge of a flush body that is higher by next to nothing: that body carries the ball, and pushes it nowhere.</summary>
    private void CrossSeam(ref BallState s, ref StepRun run)
    {
        if (s.Motion is not (MotionState.Rolling or MotionState.Sliding))
        {
            return;
        }

        int next = Flush.CarrierOf(_world, in s);
        if (_world.Ball.Radius - _world.Colliders[next].At(s.Position, s.Time).Distance <= Flush.LowerBy)
        {
            _contact.HandOver(ref s, next, ref run);
        }
    }

    /// <summary>Out of one thing: Newton on the gap, along the way that is open to the ball.</summary>
    private void PushOut(ref BallState s, Collider collider)
    {
        for (int i = 0; i < MostSteps; i++)
        {
            ShapePoint at = collider.At(s.Position, s.Time);
            double gap = at.Distance - _world.Ball.Radius;
            if (Math.Abs(gap) <= 0.5 * ContactSearch.Touching)
            {
                return;
            }

            s.Position -= gap * Way(in s, at.Normal);
            StayOnCarrier(ref s);
        }
    }

    /// <summary>True when something stands in the way of a push, as a thin board does.</summary>
    private bool IsBarred(in BallState s, in Vector3d from)
    {
        BallState pushed = s;
        pushed.Position = from;

        // The push as a straight path in next to no time: nothing that stands still may be met on it.
        var path = PathCubic.Line(in from, (s.Position - from) / Displacement.AtOnce, Displacement.AtOnce);
        int carrier = s.Motion == MotionState.Airborne ? -1 : (int)s.Carrier - _world.FirstCollider;
        return new ContactSearch(_world, in path, s.Time).FirstContact(in pushed, carrier, default, out Separation met) <= Displacement.AtOnce
            && met.What == SeparationKind.Contact && !_world.Colliders[met.Index].Moves;
    }

    /// <summary>A body that carried the ball and is no longer where it was expected carries it no more.</summary>
    private void LetGo(ref BallState s, ref StepRun run)
    {
        if (s.Motion == MotionState.Airborne || !_world.CarrierOf(in s).IsBody)
        {
            return;
        }

        Collider carrier = _world.CarrierOf(in s);

        // An engine may not have the collider any more.
        if (_world.Engine is { } engine && engine.Has((int)s.Carrier - _world.FirstCollider))
        {
            engine.LookAt(s.Position, s.Time, ContactSearch.Touching);
            if (!engine.Finds((int)s.Carrier - _world.FirstCollider))
            {
                _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
                return;
            }
        }

        // Let go where a gap has opened, or where the carrier no longer moves along with the ball.
        ShapePoint at = carrier.At(s.Position, s.Time);
        double off = Vector3d.Dot(s.Velocity - carrier.ShapeVelocity(s.Position, s.Time), at.Normal);
        if (carrier.IsWithdrawn || Math.Abs(at.Distance - _world.Ball.Radius) > ContactSearch.Touching || Math.Abs(off) > ContactSearch.Approaching)
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
        }
    }

    /// <summary>The way out along a normal; for a ball that something carries, along that surface.</summary>
    private Vector3d Way(in BallState s, in Vector3d normal)
    {
        if (s.Motion == MotionState.Airborne)
        {
            return normal;
        }

        Vector3d up = _world.CarrierOf(in s).At(s.Position, s.Time).Normal;

        // n_t/|n_t|²: so far along the carrier that the gap closes.
        Vector3d along = normal - (Vector3d.Dot(in normal, in up) * up);
        double share = along.LengthSquared;

        // Trodden on from straight above, it slips out somewhere: forward.
        return share > 1e-12 ? along / Math.Max(share, 0.01) : Vector3d.Cross(in up, Math.Abs(up.X) < 0.9 ? new Vector3d(1, 0, 0) : Vector3d.Up);
    }

    /// <summary>Back onto what carries it, which may be curved.</summary>
    private void StayOnCarrier(ref BallState s)
    {
        if (s.Motion != MotionState.Airborne)
        {
            ShapePoint at = _world.CarrierOf(in s).At(s.Position, s.Time);
            s.Position += (_world.Ball.Radius - at.Distance) * at.Normal;
        }
    }
}
