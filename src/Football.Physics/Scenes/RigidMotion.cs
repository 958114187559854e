namespace FootballPhysics;

/// <summary>
/// Position and motion of an object: constant velocity and constant spin. The spin moves the surface; it also rotates the shape about the pivot
/// if <see cref="Swing"/> is above 0.
/// </summary>
internal struct RigidMotion
{
    /// <summary>Where the origin of its shape is at <see cref="Time"/>, m.</summary>
    public Vector3d Origin;

    /// <summary>Velocity V, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Spin of its surface Ω, rad/s.</summary>
    public Vector3d Spin;

    /// <summary>Centre of rotation of the surface, o at <see cref="Time"/>, m.</summary>
    public Vector3d Pivot;

    /// <summary>Orientation of its shape at <see cref="Time"/>.</summary>
    public Quaterniond Orientation;

    /// <summary>
    /// The greatest speed that the rotation about the pivot gives to any part of the shape, m/s. It is 0 for a shape that does not rotate, or that a rotation leaves
    /// as it is, and infinite for a shape without bounds.
    /// </summary>
    public double Swing;

    /// <summary>True when it is turned at all.</summary>
    public bool IsTurned;

    /// <summary>True when it is out of play: nothing meets it.</summary>
    public bool IsWithdrawn;

    /// <summary>When it is there, s.</summary>
    public double Time;

    /// <summary>True if the shape rotates within a step.</summary>
    public readonly bool Rotates => Swing > 0;

    /// <summary>The greatest speed of any part of it, m/s. For a shape without bounds, only its velocity counts.</summary>
    public readonly double GreatestSpeed => Velocity.Length + (double.IsInfinity(Swing) ? 0 : Swing);

    /// <summary>True if the numbers of another motion have the same bits, whenever it has them.</summary>
    public readonly bool IsSame(in RigidMotion other) =>
        Same(in Origin, in other.Origin) && Same(in Velocity, in other.Velocity) && Same(in Spin, in other.Spin) && Same(in Pivot, in other.Pivot)
        && Same(Orientation.X, other.Orientation.X) && Same(Orientation.Y, other.Orientation.Y) && Same(Orientation.Z, other.Orientation.Z) && Same(Orientation.W, other.Orientation.W)
        && IsWithdrawn == other.IsWithdrawn;

    /// <summary>How far it has gone since it was at its origin, m.</summary>
    public readonly Vector3d GoneBy(double time) => Origin + ((time - Time) * Velocity);

    /// <summary>It goes on from a time with another velocity.</summary>
    public void GoOn(in Vector3d velocity, double time)
    {
        // Up to the time with the old velocity, from there with the new one: nothing jumps.
        GoTo(time);
        Velocity = velocity;
    }

    /// <summary>Describes the same motion from another time on.</summary>
    public void GoTo(double time)
    {
        Vector3d gone = (time - Time) * Velocity;
        if (Rotates)
        {
            // o + R (origin − o), with R the rotation by Ω t.
            Vector3d turn = (time - Time) * Spin;
            Vector3d arm = Origin - Pivot;
            Origin = arm == Vector3d.Zero ? Origin : Pivot + Quaterniond.Identity.Turned(in turn).Rotate(in arm);
            Orientation = Orientation.Turned(in turn);
            IsTurned = true;
        }

        Origin += gone;
        Pivot += gone;
        Time = time;
    }

    /// <summary>A point of the world in the frame of its shape.</summary>
    public readonly Vector3d ToShape(in Vector3d position, double time) => ToOwn(position - GoneBy(time));

    /// <summary>Sets <see cref="Swing"/> for a shape that its spin rotates.</summary>
    public void Rotate(IShape shape) => Swing = Spin == Vector3d.Zero ? 0 : SwingOf.Shape(shape, ToOwn(in Spin), ToOwn(Pivot - Origin));

    /// <summary>A vector of the world in the axes of its shape.</summary>
    public readonly Vector3d ToOwn(in Vector3d vector) =>
        IsTurned ? new Quaterniond(-Orientation.X, -Orientation.Y, -Orientation.Z, Orientation.W).Rotate(in vector) : vector;

    /// <summary>A vector of its shape in the axes of the world.</summary>
    public readonly Vector3d ToWorld(in Vector3d vector) => IsTurned ? Orientation.Rotate(in vector) : vector;

    /// <summary>Distance, normal and curvature of a shape that moves so, seen from a point at a time.</summary>
    public readonly ShapePoint At(IShape shape, in Vector3d position, double time)
    {
        if (Rotates && time != Time)
        {
            RigidMotion then = this;
            then.GoTo(time);
            return then.At(shape, in position, time);
        }

        // The point as the shape sees it, in its own axes; the answer back in those of the world.
        Vector3d from = position - GoneBy(time);
        if (!IsTurned)
        {
            return shape.At(in from);
        }

        ShapePoint own = shape.At(ToOwn(in from));

        // The curvature is a bilinear form: its entries along the axes of the world.
        Vector3d x = ToOwn(new Vector3d(1, 0, 0));
        Vector3d y = ToOwn(new Vector3d(0, 1, 0));
        Vector3d z = ToOwn(new Vector3d(0, 0, 1));
        return new ShapePoint(own.Distance, ToWorld(own.Normal), own.Curvature.Transformed(in x, in y, in z));
    }

    /// <summary>The velocity of its surface at a point of contact, V + Ω × (c − o), m/s.</summary>
    public readonly Vector3d SurfaceVelocity(in Vector3d contact, double time) =>
        Velocity + Vector3d.Cross(in Spin, contact - Pivot - ((time - Time) * Velocity));

    /// <summary>A box in the world around a box of the shape, at its origin.</summary>
    public readonly Bounds3d Turned(in Bounds3d own)
    {
        // A turned box reaches Σ |R_ik| h_k along each axis; one that does not end reaches everywhere.
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

    private static bool Same(in Vector3d a, in Vector3d b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z);

    // Unlike ==, 0 and −0 differ: a ball that rests on the object takes over its velocity, with the sign.
    private static bool Same(double a, double b) => BitConverter.DoubleToInt64Bits(a) == BitConverter.DoubleToInt64Bits(b);
}
