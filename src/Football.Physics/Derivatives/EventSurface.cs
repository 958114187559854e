namespace Football.Physics;

/// <summary>The surfaces in the space of motions at which something happens.</summary>
internal sealed class EventSurface<TAir>
    where TAir : struct, IAir
{
    /// <summary>A ball this deep in a net when it meets it, m, came from beside it.</summary>
    private const double Deep = 1e-9;

    private readonly Surroundings<TAir> _around;

    public EventSurface(Surroundings<TAir> around) => _around = around;

    /// <summary>Contact with a thing: g is the distance.</summary>
    public EventGradient Contact(int thing, in BallState s)
    {
        if (_around.World is not { } world)
        {
            return new EventGradient(Vector3d.Up, Vector3d.Zero, Vector3d.Zero, s.Velocity.Y);
        }

        Collider hit = world.Colliders[thing - world.FirstCollider];
        Vector3d normal = hit.At(s.Position, s.Time).Normal;
        return new EventGradient(in normal, Vector3d.Zero, Vector3d.Zero, Vector3d.Dot(s.Velocity - hit.Velocity, in normal));
    }

    /// <summary>The jump of the drag law: g is |u|² − v_c², or 400 (r|ω|)² − |u|².</summary>
    public EventGradient DragJump(LocalMotion<TAir> local, DragBranch next, double time, in Motion at)
    {
        DragJump here = Physics.DragJump.At(in at, in _around.Wind, _around.Radius);
        local.Rates(time, in at, out MotionRates rates);
        DragJump rate = Physics.DragJump.Rate(in at, in rates, in _around.Wind, _around.Radius);
        bool bySpeed = next == DragBranch.AlongCriticalSpeed || (next != DragBranch.AlongCriticalSpin && here.NearerToSpeed);

        // Both are linear in |u|² and (r|ω|)², so their gradients are their rates for unit rates of these.
        Vector3d u = at.Velocity - _around.Wind;
        double bySpeedSquared = bySpeed ? Physics.DragJump.Rate(1, 0).Speed : Physics.DragJump.Rate(1, 0).Spin;
        double bySpinSquared = bySpeed ? 0 : Physics.DragJump.Rate(0, 1).Spin;
        return new EventGradient(Vector3d.Zero, (2.0 * bySpeedSquared) * u, (2.0 * bySpinSquared * _around.RadiusSquared) * at.Spin, bySpeed ? rate.Speed : rate.Spin);
    }

    /// <summary>A net that is met or left: across its plane, or beside it, where the push begins at once.</summary>
    public EventGradient Net(LocalMotion<TAir> before, LocalMotion<TAir> after, in Motion at)
    {
        World world = _around.World!;
        ulong met = after.Nets & ~before.Nets;
        ulong changed = met != 0 ? met : before.Nets & ~after.Nets;
        int i = 0;
        while ((changed >> i & 1) == 0)
        {
            i++;
        }

        NetSheet net = world.Nets[i];
        double side = World.SideOf(met != 0 ? after.NetSides : before.NetSides, i);
        if (met == 0 || net.Depth(in at.Position, side) < Deep)
        {
            Vector3d normal = side * net.Normal;
            return new EventGradient(in normal, Vector3d.Zero, Vector3d.Zero, Vector3d.Dot(in normal, in at.Velocity));
        }

        Vector3d place = net.PlaceInFrame(in at.Position);
        bool along = Math.Abs(Math.Abs(place.X) - net.HalfLength) < Math.Abs(Math.Abs(place.Y) - net.HalfWidth);
        Vector3d x = net.InFrame(new Vector3d(1, 0, 0));
        Vector3d y = net.InFrame(new Vector3d(0, 1, 0));
        Vector3d z = net.InFrame(new Vector3d(0, 0, 1));
        Vector3d direction = along ? new Vector3d(x.X, y.X, z.X) : new Vector3d(x.Y, y.Y, z.Y);
        return new EventGradient(in direction, Vector3d.Zero, Vector3d.Zero, Vector3d.Dot(in direction, in at.Velocity));
    }

    /// <summary>Where a net becomes slack or tight, and its push has a kink: g is its tension, 1 − b σ v·n.</summary>
    /// <param name="local">What moves the ball.</param>
    /// <param name="time">Time, s.</param>
    /// <param name="at">The motion.</param>
    /// <param name="slack">The gradient.</param>
    /// <returns>False where the ball is at none of its nets' kinks.</returns>
    public bool Slack(LocalMotion<TAir> local, double time, in Motion at, out EventGradient slack)
    {
        slack = default;
        World world = _around.World!;
        for (int i = 0; i < world.Nets.Length; i++)
        {
            double side = World.SideOf(local.NetSides, i);
            if ((local.Nets >> i & 1) != 0 && Math.Abs(world.Nets[i].Tension(in at.Velocity, side)) < Deep)
            {
                Vector3d normal = world.Nets[i].Normal;
                local.Rates(time, in at, out MotionRates rates);
                slack = new EventGradient(Vector3d.Zero, in normal, Vector3d.Zero, Vector3d.Dot(in normal, in rates.Acceleration));
                return true;
            }
        }

        return false;
    }

    /// <summary>The end of the grip: g is what friction can give beyond what a rolling ball needs.</summary>
    public EventGradient Grip(LocalMotion<TAir> local, double time, in Motion at)
    {
        Span<double> gradient = stackalloc double[MotionVector.AirDistance];
        for (int i = 0; i < MotionVector.AirDistance; i++)
        {
            double width = MotionVector.Width(in at, i);
            gradient[i] = (local.Grip(time, MotionVector.Changed(in at, i, width)) - local.Grip(time, MotionVector.Changed(in at, i, -width))) / (2.0 * width);
        }

        var place = new Vector3d(gradient[0], gradient[1], gradient[2]);
        var velocity = new Vector3d(gradient[3], gradient[4], gradient[5]);
        var spin = new Vector3d(gradient[6], gradient[7], gradient[8]);
        local.Rates(time, in at, out MotionRates rates);
        double rate = Vector3d.Dot(in place, in at.Velocity) + Vector3d.Dot(in velocity, in rates.Acceleration) + Vector3d.Dot(in spin, in rates.SpinAcceleration);
        return new EventGradient(in place, in velocity, in spin, rate);
    }
}
