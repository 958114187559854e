using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Batch;

/// <summary>The surfaces in the space of motions at which events happen.</summary>
internal sealed class EventSurface(Surroundings around)
{
    private readonly Surroundings _around = around;

    /// <summary>Returns the surface of a contact with an object: g is the distance.</summary>
    public EventGradient Contact(int thing, in BallState s)
    {
        Collider hit = _around.World.ByIndex[_around.World.Struck(thing, in s)];
        Vector3d normal = hit.At(s.Position, s.Time).Normal;
        return new EventGradient(in normal, Vector3d.Zero, Vector3d.Zero, Vector3d.Dot(s.Velocity - hit.Velocity, in normal));
    }

    /// <summary>Returns the surface of the jump in the drag law: g is |u|² − v_c², or 400 (r|ω|)² − |u|².</summary>
    public EventGradient DragJump(LocalFlight local, DragBranch next, double time, in Motion at)
    {
        DragJump here = Laws.DragJump.At(in at, in _around.Wind, _around.Radius);
        local.Rates(time, in at, out MotionRates rates);
        DragJump rate = Laws.DragJump.Rate(in at, in rates, in _around.Wind, _around.Radius);
        bool bySpeed = next == DragBranch.AlongCriticalSpeed || (next != DragBranch.AlongCriticalSpin && here.NearerToSpeed);

        // Both are linear in |u|² and (r|ω|)², so rates for unit rates of these give the gradients.
        Vector3d u = at.Velocity - _around.Wind;
        double bySpeedSquared = bySpeed ? Laws.DragJump.Rate(1, 0).Speed : Laws.DragJump.Rate(1, 0).Spin;
        double bySpinSquared = bySpeed ? 0 : Laws.DragJump.Rate(0, 1).Spin;
        return new EventGradient(Vector3d.Zero, (2.0 * bySpeedSquared) * u, (2.0 * bySpinSquared * _around.RadiusSquared) * at.Spin, bySpeed ? rate.Speed : rate.Spin);
    }
}

/// <summary>A function g of the motion that is zero at an event: its gradient, and its rate along the motion just before.</summary>
internal readonly struct EventGradient(in Vector3d place, in Vector3d velocity, in Vector3d spin, double rate)
{
    /// <summary>∂g/∂p.</summary>
    public readonly Vector3d Place = place;

    /// <summary>∂g/∂v.</summary>
    public readonly Vector3d Velocity = velocity;

    /// <summary>∂g/∂ω.</summary>
    public readonly Vector3d Spin = spin;

    /// <summary>ġ.</summary>
    public readonly double Rate = rate;
}
