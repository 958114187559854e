using System.Runtime.CompilerServices;

namespace FootballPhysics.Scenes;

/// <summary>The position and motion of an object: constant velocity and constant spin.</summary>
/// <remarks>The spin moves the surface. If <see cref="Swing"/> is above 0, it also rotates the shape about the pivot.</remarks>
internal struct RigidMotion
{
    /// <summary>The origin of the shape at <see cref="Time"/>, in m.</summary>
    public Vector3d Origin;

    /// <summary>The velocity V, in m/s.</summary>
    public Vector3d Velocity;

    /// <summary>The spin Ω of the surface, in rad/s.</summary>
    public Vector3d Spin;

    /// <summary>The centre of rotation o of the surface at <see cref="Time"/>, in m.</summary>
    public Vector3d Pivot;

    /// <summary>The orientation of the shape at <see cref="Time"/>.</summary>
    public Quaterniond Orientation;

    /// <summary>The greatest speed that the rotation about the pivot gives to any part of the shape, in m/s.</summary>
    /// <remarks>It is 0 if the shape does not rotate, or the rotation does not change it. It is infinite for an unbounded shape.</remarks>
    public double Swing;

    /// <summary>True if the orientation is not the identity.</summary>
    public bool IsTurned;

    /// <summary>True if the object is out of play: nothing collides with it.</summary>
    public bool IsWithdrawn;

    /// <summary>The time of the position, in s.</summary>
    public double Time;

    /// <summary>True if the shape rotates within a step.</summary>
    public readonly bool Rotates => Swing > 0;

    /// <summary>The greatest speed of any part, in m/s. For an unbounded shape, this is the speed without the rotation.</summary>
    public readonly double GreatestSpeed => Velocity.Length + (double.IsInfinity(Swing) ? 0 : Swing);

    /// <summary>True if another motion is bit-identical, apart from its time.</summary>
    public readonly bool IsSame(in RigidMotion other) =>
        Same(in Origin, in other.Origin) && Same(in Velocity, in other.Velocity) && Same(in Spin, in other.Spin) && Same(in Pivot, in other.Pivot)
        && Same(in Orientation, in other.Orientation) && IsWithdrawn == other.IsWithdrawn;

    /// <summary>Returns the position of the shape's origin at a time, without rotation about the pivot, in m.</summary>
    public readonly Vector3d GoneBy(double time) => Origin + ((time - Time) * Velocity);

    /// <summary>Changes the velocity at a time.</summary>
    public void GoOn(in Vector3d velocity, double time)
    {
        // Advance with the old velocity first, so that the position is continuous.
        GoTo(time);
        Velocity = velocity;
    }

    /// <summary>Advances the position and orientation to another time, with the same motion.</summary>
    public void GoTo(double time)
    {
        Vector3d gone = (time - Time) * Velocity;
        if (Rotates)
        {
            // o + R (origin − o), where R is the rotation by the angle vector Ω t.
            Vector3d turn = (time - Time) * Spin;
            Vector3d arm = Origin - Pivot;
            Origin = arm == Vector3d.Zero ? Origin : Pivot + Quaterniond.Identity.Turned(in turn).Rotate(in arm);
            Orientation = Orientation.Turned(in turn);
            IsTurned = Orientation != Quaterniond.Identity;
        }

        Origin += gone;
        Pivot += gone;
        Time = time;
    }

    /// <summary>Transforms a point from the world to the frame of the shape.</summary>
    public readonly Vector3d ToShape(in Vector3d position, double time) => ToOwn(position - GoneBy(time));

    /// <summary>Computes <see cref="Swing"/> for a shape that rotates with the spin.</summary>
    public void Rotate(IShape shape) => Swing = Spin == Vector3d.Zero ? 0 : SwingOf.Shape(shape, ToOwn(in Spin), ToOwn(Pivot - Origin));

    /// <summary>Rotates a vector from the world to the axes of the shape.</summary>
    public readonly Vector3d ToOwn(in Vector3d vector) =>
        IsTurned ? ToOwnAxes.Rotate(in vector) : vector;

    /// <summary>The rotation from the world to the axes of the shape.</summary>
    public readonly Quaterniond ToOwnAxes => new(-Orientation.X, -Orientation.Y, -Orientation.Z, Orientation.W);

    /// <summary>Rotates a vector from the axes of the shape to the world.</summary>
    public readonly Vector3d ToWorld(in Vector3d vector) => IsTurned ? Orientation.Rotate(in vector) : vector;

    /// <summary>Returns the distance, normal and curvature of the moving shape at a point and time.</summary>
    public readonly ShapePoint At(IShape shape, in Vector3d position, double time)
    {
        if (Rotates && time != Time)
        {
            RigidMotion then = this;
            then.GoTo(time);
            return then.At(shape, in position, time);
        }

        // Query the shape in its own frame, then rotate the result back to the world.
        Vector3d from = position - GoneBy(time);
        if (!IsTurned)
        {
            return shape.At(in from);
        }

        ShapePoint own = shape.At(ToOwn(in from));

        // The curvature is a bilinear form: compute its entries along the world axes.
        Vector3d x = ToOwn(new Vector3d(1, 0, 0));
        Vector3d y = ToOwn(new Vector3d(0, 1, 0));
        Vector3d z = ToOwn(new Vector3d(0, 0, 1));
        return new ShapePoint(own.Distance, ToWorld(own.Normal), own.Curvature.Transformed(in x, in y, in z));
    }

    /// <summary>Returns the velocity of the surface at a contact point, V + Ω × (c − o), in m/s.</summary>
    public readonly Vector3d SurfaceVelocity(in Vector3d contact, double time) =>
        Velocity + Vector3d.Cross(in Spin, contact - Pivot - ((time - Time) * Velocity));

    /// <summary>Returns the velocity of the shape at a point, in m/s: V, and Ω × (c − o) only if the shape rotates.</summary>
    public readonly Vector3d ShapeVelocity(in Vector3d point, double time) => Swing > 0 ? SurfaceVelocity(in point, time) : Velocity;

    /// <summary>Returns a bounding box, along the world axes, of a rotated box of the shape.</summary>
    public readonly Bounds3d Turned(in Bounds3d own)
    {
        // A rotated box extends Σ |R_ik| h_k along each axis; a rotated unbounded box is unbounded in all directions.
        Vector3d half = 0.5 * (own.Max - own.Min);
        if (!IsTurned || !half.IsFinite)
        {
            return IsTurned ? Bounds3d.Everywhere : own;
        }

        Vector3d x = half.X * ToWorld(new Vector3d(1, 0, 0));
        Vector3d y = half.Y * ToWorld(new Vector3d(0, 1, 0));
        Vector3d z = half.Z * ToWorld(new Vector3d(0, 0, 1));
        return Bounds3d.Around(
            ToWorld(own.Min + half),
            Math.Abs(x.X) + Math.Abs(y.X) + Math.Abs(z.X),
            Math.Abs(x.Y) + Math.Abs(y.Y) + Math.Abs(z.Y),
            Math.Abs(x.Z) + Math.Abs(y.Z) + Math.Abs(z.Z));
    }

    /// <summary>True if each component is 0, and none is −0.</summary>
    public static bool IsPlusZero(in Vector3d a) =>
        (BitConverter.DoubleToInt64Bits(a.X) | BitConverter.DoubleToInt64Bits(a.Y) | BitConverter.DoubleToInt64Bits(a.Z)) == 0;

    /// <summary>True if two rotations are bit-identical.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Same(in Quaterniond a, in Quaterniond b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z) && Same(a.W, b.W);

    private static bool Same(in Vector3d a, in Vector3d b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z);

    // Unlike ==, this comparison distinguishes 0 from −0, because a ball at rest on the object takes on the sign of its velocity.
    private static bool Same(double a, double b) => BitConverter.DoubleToInt64Bits(a) == BitConverter.DoubleToInt64Bits(b);
}
