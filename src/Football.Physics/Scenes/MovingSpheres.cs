using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Scenes;

/// <summary>The broad phase of moving objects: bounding spheres, tested four at a time with SIMD.</summary>
internal sealed class MovingSpheres
{
    // Each array contains four objects. Unused lanes are infinitely far away.
    private double[][] _fours = [];
    private int _count;

    /// <summary>Adds an object, and returns its lane.</summary>
    public MovingLane Add()
    {
        int lane = _count++ % MovingLane.Lanes;
        if (lane == 0)
        {
            Array.Resize(ref _fours, _fours.Length + 1);
            _fours[^1] = new double[MovingLane.Fields * MovingLane.Lanes];
            for (int i = 0; i < MovingLane.Lanes; i++)
            {
                new MovingLane(_fours[^1], i).Remove();
            }
        }

        return new MovingLane(_fours[^1], lane);
    }

    private MovingLane this[int index] => new(_fours[index / MovingLane.Lanes], index % MovingLane.Lanes);

    /// <summary>Finds the next candidate on a path.</summary>
    /// <param name="middle">The midpoint of the path, in m.</param>
    /// <param name="reach">The radius around the midpoint that contains the path and its margin, in m.</param>
    /// <param name="time">The time at the midpoint, in s.</param>
    /// <param name="half">Half the duration of the path, in s.</param>
    /// <param name="index">The first index to test; on return the index of the candidate.</param>
    /// <returns>False if no candidate is left.</returns>
    public bool Next(in Vector3d middle, double reach, double time, double half, ref int index)
    {
        // Skip groups whose four objects are all far away; test the objects of other groups one by one.
        double[][] fours = _fours;
        var atX = Quad.Of(middle.X);
        var atY = Quad.Of(middle.Y);
        var atZ = Quad.Of(middle.Z);
        var reaches = Quad.Of(reach);
        var times = Quad.Of(time);
        var halves = Quad.Of(half);
        for (int i = index; i < _count; i++)
        {
            if (i % MovingLane.Lanes == 0)
            {
                int group = i / MovingLane.Lanes;
                while (group < fours.Length && AreFar(ref fours[group][0], atX, atY, atZ, reaches, times, halves))
                {
                    group++;
                }

                i = group * MovingLane.Lanes;
            }

            if (i < _count && !this[i].IsFar(in middle, reach, time, half))
            {
                index = i;
                return true;
            }
        }

        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreFar(ref double four, Quad atX, Quad atY, Quad atZ, Quad reach, Quad time, Quad half)
    {
        Quad t = time - Quad.From(ref four, MovingLane.Time);
        var vx = Quad.From(ref four, MovingLane.VelocityX);
        var vy = Quad.From(ref four, MovingLane.VelocityY);
        var vz = Quad.From(ref four, MovingLane.VelocityZ);
        Quad x = Quad.From(ref four, MovingLane.X) + Quad.From(ref four, MovingLane.CenterX) + (t * vx) - atX;
        Quad y = Quad.From(ref four, MovingLane.Y) + Quad.From(ref four, MovingLane.CenterY) + (t * vy) - atY;
        Quad z = Quad.From(ref four, MovingLane.Z) + Quad.From(ref four, MovingLane.CenterZ) + (t * vz) - atZ;

        // The distance that ball and object can cover from the middle of the path in half its duration. |v_x| + |v_y| + |v_z| ≥ |v| needs no root.
        Quad near = reach + Quad.From(ref four, MovingLane.Radius) + (half * (vx.Abs + vy.Abs + vz.Abs));
        return ((x * x) + (y * y) + (z * z)).IsAbove(near * near);
    }
}
