using System.Runtime.CompilerServices;

namespace FootballPhysics.Scenes;

/// <summary>The position, velocity and bounding sphere of one object of <see cref="MovingSpheres"/>.</summary>
/// <param name="four">The numbers of four objects: each field as four consecutive numbers.</param>
/// <param name="lane">The index among the four.</param>
internal readonly struct MovingLane(double[] four, int lane)
{
    /// <summary>The number of objects per array.</summary>
    public const int Lanes = 4;

    /// <summary>A margin for the rounding errors of positions, in m: sufficient up to 1000 km from the origin.</summary>
    public const double Rounding = 1e-6;

    /// <summary>The number of fields per object.</summary>
    public const int Fields = 11;

    // The first index of each field: the origin at a time, its velocity, this time; then the centre relative to the origin, and the radius.
    public const int X = 0;
    public const int Y = Lanes;
    public const int Z = 2 * Lanes;
    public const int VelocityX = 3 * Lanes;
    public const int VelocityY = 4 * Lanes;
    public const int VelocityZ = 5 * Lanes;
    public const int Time = 6 * Lanes;
    public const int CenterX = 7 * Lanes;
    public const int CenterY = 8 * Lanes;
    public const int CenterZ = 9 * Lanes;
    public const int Radius = 10 * Lanes;

    /// <summary>True for an object that is in no broad phase.</summary>
    public bool IsNone => four is null;

    /// <summary>The origin at <see cref="At"/>, in m.</summary>
    public Vector3d Origin
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Own, Unsafe.Add(ref Own, Y), Unsafe.Add(ref Own, Z));
    }

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Unsafe.Add(ref Own, VelocityX), Unsafe.Add(ref Own, VelocityY), Unsafe.Add(ref Own, VelocityZ));
    }

    /// <summary>The time of the origin, in s.</summary>
    public double At
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Own, Time);
    }

    // All fields of a lane are in the array, so one check of the index is enough.
    private ref double Own
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref four[lane];
    }

    /// <summary>Sets the origin, the velocity and the time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Move(in Vector3d origin, in Vector3d velocity, double time)
    {
        ref double own = ref Own;
        own = origin.X;
        Unsafe.Add(ref own, Y) = origin.Y;
        Unsafe.Add(ref own, Z) = origin.Z;
        Unsafe.Add(ref own, VelocityX) = velocity.X;
        Unsafe.Add(ref own, VelocityY) = velocity.Y;
        Unsafe.Add(ref own, VelocityZ) = velocity.Z;
        Unsafe.Add(ref own, Time) = time;
    }

    /// <summary>Sets the bounding sphere: that of a box.</summary>
    /// <param name="box">A bounding box relative to the origin.</param>
    public void Bound(in Bounds3d box)
    {
        Vector3d center = 0.5 * (box.Min + box.Max);
        four[lane + CenterX] = center.X;
        four[lane + CenterY] = center.Y;
        four[lane + CenterZ] = center.Z;
        four[lane + Radius] = 0.5 * (box.Max - box.Min).Length;
    }

    /// <summary>Sets a sphere that contains the sphere of the box at any rotation about the origin, in spite of rounding errors in <see cref="IsFar"/>.</summary>
    /// <param name="box">A bounding box relative to the origin.</param>
    public void BoundAlways(in Bounds3d box)
    {
        // The box around a rotated box is at most √3 times as large.
        Vector3d half = 0.5 * (box.Max - box.Min);
        double reach = (0.5 * (box.Min + box.Max)).Length + (1.75 * half.Length) + Rounding;
        Bound(Bounds3d.Around(Vector3d.Zero, reach, 0, 0));
    }

    /// <summary>Removes the object from all searches, until <see cref="Bound"/> brings it back.</summary>
    public void Remove()
    {
        four[lane + CenterX] = double.PositiveInfinity;
        four[lane + Radius] = 0;
    }

    /// <summary>True if no part of the object reaches a path; <see cref="MovingSpheres.Next"/> describes the parameters.</summary>
    public bool IsFar(in Vector3d middle, double reach, double time, double half)
    {
        Vector3d velocity = Velocity;
        double t = time - At;
        double x = four[lane + X] + four[lane + CenterX] + (t * velocity.X) - middle.X;
        double y = four[lane + Y] + four[lane + CenterY] + (t * velocity.Y) - middle.Y;
        double z = four[lane + Z] + four[lane + CenterZ] + (t * velocity.Z) - middle.Z;
        double near = reach + four[lane + Radius] + (half * (Math.Abs(velocity.X) + Math.Abs(velocity.Y) + Math.Abs(velocity.Z)));
        return (x * x) + (y * y) + (z * z) > near * near;
    }
}
