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
        for (; index < _count; index++)
        {
            double[] four = _fours[index / MovingLane.Lanes];
            int lane = index % MovingLane.Lanes;
            if (lane == 0 && AreFar(four, in middle, reach, time, half))
            {
                index += MovingLane.Lanes - 1;
            }
            else if (!new MovingLane(four, lane).IsFar(in middle, reach, time, half))
            {
                return true;
            }
        }

        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreFar(double[] four, in Vector3d middle, double reach, double time, double half)
    {
        Quad t = Quad.Of(time) - Quad.From(four, MovingLane.Time);
        var vx = Quad.From(four, MovingLane.VelocityX);
        var vy = Quad.From(four, MovingLane.VelocityY);
        var vz = Quad.From(four, MovingLane.VelocityZ);
        Quad x = Quad.From(four, MovingLane.X) + Quad.From(four, MovingLane.CenterX) + (t * vx) - Quad.Of(middle.X);
        Quad y = Quad.From(four, MovingLane.Y) + Quad.From(four, MovingLane.CenterY) + (t * vy) - Quad.Of(middle.Y);
        Quad z = Quad.From(four, MovingLane.Z) + Quad.From(four, MovingLane.CenterZ) + (t * vz) - Quad.Of(middle.Z);

        // The distance that ball and object can cover from the middle of the path in half its duration. |v_x| + |v_y| + |v_z| ≥ |v| needs no root.
        Quad near = Quad.Of(reach) + Quad.From(four, MovingLane.Radius) + (Quad.Of(half) * (vx.Abs + vy.Abs + vz.Abs));
        return ((x * x) + (y * y) + (z * z)).IsAbove(near * near);
    }
}
