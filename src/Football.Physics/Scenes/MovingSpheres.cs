using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Scenes;

/// <summary>The broad phase of moving objects: bounding spheres, tested four at a time with SIMD.</summary>
internal sealed class MovingSpheres
{
    private const int Lanes = 4;
    private const int Fields = 8;

    // Each group contains four objects: centres, velocities, radii and speeds, each as four consecutive numbers. Unused lanes are infinitely far away.
    private double[] _fours = [];
    private int _count;

    /// <summary>Adds an object.</summary>
    /// <param name="box">A bounding box at time 0.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    public void Add(in Bounds3d box, in Vector3d velocity)
    {
        if (_count % Lanes == 0)
        {
            // Allocate four lanes at once; empty lanes are infinitely far away and never match.
            int start = _fours.Length;
            Array.Resize(ref _fours, start + (Fields * Lanes));
            for (int lane = 0; lane < Lanes; lane++)
            {
                _fours[start + lane] = double.PositiveInfinity;
            }
        }

        Set(_count++, in box, in velocity);
    }

    /// <summary>Changes the bounds and velocity of an object.</summary>
    /// <param name="index">The index of the object.</param>
    /// <param name="box">A bounding box at time 0.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
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

        // |v_x| + |v_y| + |v_z| ≥ |v| is a bound without a square root.
        _fours[i + (7 * Lanes)] = Math.Abs(velocity.X) + Math.Abs(velocity.Y) + Math.Abs(velocity.Z);
    }

    /// <summary>Removes an object by moving it infinitely far away.</summary>
    /// <param name="index">The index of the object.</param>
    public void Remove(int index)
    {
        int i = FirstOf(index);
        for (int field = 0; field < Fields; field++)
        {
            _fours[i + (field * Lanes)] = field < 3 ? double.PositiveInfinity : 0;
        }
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

        // The distance that ball and object can cover from the middle of the path in half its duration.
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
