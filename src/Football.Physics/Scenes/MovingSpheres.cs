using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>Spheres around things that move, four side by side, for a quick look: most are too far to be met, and that is seen of four at once.</summary>
internal sealed class MovingSpheres
{
    private const int Lanes = 4;
    private const int Fields = 8;

    // Of each four their centers, velocities, radii and speeds, each four numbers one after the other; a lane without a thing is infinitely far.
    private double[] _fours = [];
    private int _count;

    /// <summary>Makes room for one more, and puts it there.</summary>
    /// <param name="box">A box around it, at time 0.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    public void Add(in Bounds3d box, in Vector3d velocity)
    {
        if (_count % Lanes == 0)
        {
            // Room for four at a time; lanes of none are infinitely far, so that they never count.
            int start = _fours.Length;
            Array.Resize(ref _fours, start + (Fields * Lanes));
            for (int lane = 0; lane < Lanes; lane++)
            {
                _fours[start + lane] = double.PositiveInfinity;
            }
        }

        Set(_count++, in box, in velocity);
    }

    /// <summary>Puts one elsewhere.</summary>
    /// <param name="index">Which.</param>
    /// <param name="box">A box around it, at time 0.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    public void Set(int index, in Bounds3d box, in Vector3d velocity)
    {
        Vector3d center = 0.5 * (box.Min + box.Max);
        int i = FirstOf(index);
        _fours[i] = center.X;
        _fours[i + Lanes] = center.Y;
        _fours[i + (2 * Lanes)] = center.Z;
        _fours[i + (3 * Lanes)] = velocity.X;
        _fours[i + (4 * Lanes)] = velocity.Y;
        _fours[i + (5 * Lanes)] = velocity.Z;
        _fours[i + (6 * Lanes)] = 0.5 * (box.Max - box.Min).Length;

        // |v_x| + |v_y| + |v_z| ≥ |v|: a bound without a root.
        _fours[i + (7 * Lanes)] = Math.Abs(velocity.X) + Math.Abs(velocity.Y) + Math.Abs(velocity.Z);
    }

    /// <summary>Takes one out: it is infinitely far from every way.</summary>
    /// <param name="index">Which.</param>
    public void Remove(int index)
    {
        int i = FirstOf(index);
        for (int field = 0; field < Fields; field++)
        {
            _fours[i + (field * Lanes)] = field < 3 ? double.PositiveInfinity : 0;
        }
    }

    /// <summary>Goes on to the next that may be met on a way.</summary>
    /// <param name="middle">The middle of the way, m.</param>
    /// <param name="reach">How far the way goes from there, and what lies around it, m.</param>
    /// <param name="time">When the ball is in the middle, s.</param>
    /// <param name="half">How long it goes from there, s.</param>
    /// <param name="index">Where to look first; then which it is.</param>
    /// <returns>False where there is none.</returns>
    public bool Next(in Vector3d middle, double reach, double time, double half, ref int index)
    {
        // Four that are far are passed over at once; of four of which one may be near each is looked at.
        for (; index < _count; index++)
        {
            if (index % Lanes == 0 && AreFar(index, in middle, reach, time, half))
            {
                index += Lanes - 1;
            }
            else if (!IsFar(index, in middle, reach, time, half))
            {
                return true;
            }
        }

        return false;
    }

    private static int FirstOf(int index) => (index / Lanes * (Fields * Lanes)) + (index % Lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool AreFar(int first, in Vector3d middle, double reach, double time, double half)
    {
        int i = FirstOf(first);
        var t = Quad.Of(time);
        Quad x = Quad.From(_fours, i) + (t * Quad.From(_fours, i + (3 * Lanes))) - Quad.Of(middle.X);
        Quad y = Quad.From(_fours, i + Lanes) + (t * Quad.From(_fours, i + (4 * Lanes))) - Quad.Of(middle.Y);
        Quad z = Quad.From(_fours, i + (2 * Lanes)) + (t * Quad.From(_fours, i + (5 * Lanes))) - Quad.Of(middle.Z);

        // As far as both may go in half of the way's time, from where they are at its middle.
        Quad near = Quad.Of(reach) + Quad.From(_fours, i + (6 * Lanes)) + (Quad.Of(half) * Quad.From(_fours, i + (7 * Lanes)));
        return ((x * x) + (y * y) + (z * z)).IsAbove(near * near);
    }

    private bool IsFar(int index, in Vector3d middle, double reach, double time, double half)
    {
        int i = FirstOf(index);
        double x = _fours[i] + (time * _fours[i + (3 * Lanes)]) - middle.X;
        double y = _fours[i + Lanes] + (time * _fours[i + (4 * Lanes)]) - middle.Y;
        double z = _fours[i + (2 * Lanes)] + (time * _fours[i + (5 * Lanes)]) - middle.Z;
        double near = reach + _fours[i + (6 * Lanes)] + (half * _fours[i + (7 * Lanes)]);
        return (x * x) + (y * y) + (z * z) > near * near;
    }
}

/// <summary>A straight way of a ball, with all that lies near it: what the broad phase looks along.</summary>
internal readonly struct StraightWay
{
    /// <summary>A velocity along an axis smaller than this, m/s, is taken for this: so that nothing is divided by zero.</summary>
    private const double Slowest = 1e-30;

    /// <summary>A way.</summary>
    /// <param name="from">Where it starts, m.</param>
    /// <param name="velocity">Velocity on it, m/s.</param>
    /// <param name="time">When it starts, s.</param>
    /// <param name="duration">How long it lasts, s.</param>
    /// <param name="around">All that is so near, m, counts as met.</param>
    public StraightWay(in Vector3d from, in Vector3d velocity, double time, double duration, double around)
    {
        From = from;
        Velocity = velocity;
        Time = time;
        Duration = duration;
        Around = around;
    }

    /// <summary>Where it starts, m.</summary>
    public Vector3d From { get; }

    /// <summary>Velocity on it, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>When it starts, s.</summary>
    public double Time { get; }

    /// <summary>How long it lasts, s.</summary>
    public double Duration { get; }

    /// <summary>All that is so near, m, counts as met.</summary>
    public double Around { get; }

    /// <summary>Its middle, m.</summary>
    public Vector3d Middle => From + ((0.5 * Duration) * Velocity);

    /// <summary>A box around it and all that lies near it.</summary>
    public Bounds3d Box
    {
        get
        {
            Vector3d to = From + (Duration * Velocity);
            return new Bounds3d(
                new Vector3d((From.X < to.X ? From.X : to.X) - Around, (From.Y < to.Y ? From.Y : to.Y) - Around, (From.Z < to.Z ? From.Z : to.Z) - Around),
                new Vector3d((From.X < to.X ? to.X : From.X) + Around, (From.Y < to.Y ? to.Y : From.Y) + Around, (From.Z < to.Z ? to.Z : From.Z) + Around));
        }
    }

    /// <summary>The way as something sees it that moves steadily.</summary>
    /// <param name="velocity">Its velocity, m/s.</param>
    public StraightWay SeenFrom(in Vector3d velocity) => new(From, Velocity - velocity, Time, Duration, Around);

    /// <summary>When it comes near a box, s from its start: the slab test. Infinite where it never does.</summary>
    public double Meets(in Bounds3d box)
    {
        double enter = 0;
        double leave = double.PositiveInfinity;

        // The ball is a point, and the box larger by what lies near; it is inside where it is between all three pairs of planes.
        Slab(box.Min.X - Around - From.X, box.Max.X + Around - From.X, Inverse(Velocity.X), ref enter, ref leave);
        Slab(box.Min.Y - Around - From.Y, box.Max.Y + Around - From.Y, Inverse(Velocity.Y), ref enter, ref leave);
        Slab(box.Min.Z - Around - From.Z, box.Max.Z + Around - From.Z, Inverse(Velocity.Z), ref enter, ref leave);
        return enter <= leave ? enter : double.PositiveInfinity;
    }

    private static void Slab(double low, double high, double inverse, ref double enter, ref double leave)
    {
        // Which plane comes first depends on the direction.
        double first = inverse < 0 ? high * inverse : low * inverse;
        double last = inverse < 0 ? low * inverse : high * inverse;
        enter = first > enter ? first : enter;
        leave = last < leave ? last : leave;
    }

    private static double Inverse(double speed) => 1.0 / (Math.Abs(speed) < Slowest ? Slowest : speed);
}
