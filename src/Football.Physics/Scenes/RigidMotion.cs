namespace Football.Physics;

/// <summary>Where a thing is and how it goes on: at a constant velocity. Its surface may turn; the shape stays as it is turned now.</summary>
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

    /// <summary>How its shape is turned.</summary>
    public Quaterniond Orientation;

    /// <summary>True when it is turned at all.</summary>
    public bool IsTurned;

    /// <summary>True when it is out of play: nothing meets it.</summary>
    public bool IsWithdrawn;

    /// <summary>When it is there, s.</summary>
    public double Time;

    /// <summary>How far it has gone since it was at its origin, m.</summary>
    public readonly Vector3d GoneBy(double time) => Origin + ((time - Time) * Velocity);

    /// <summary>It goes on from a time with another velocity.</summary>
    public void GoOn(in Vector3d velocity, double time)
    {
        // Up to the time with the old velocity, from there with the new one: nothing jumps.
        Vector3d gone = (time - Time) * Velocity;
        Origin += gone;
        Pivot += gone;
        Velocity = velocity;
        Time = time;
    }

    /// <summary>A vector of the world in the axes of its shape.</summary>
    public readonly Vector3d ToOwn(in Vector3d vector) =>
        IsTurned ? new Quaterniond(-Orientation.X, -Orientation.Y, -Orientation.Z, Orientation.W).Rotate(in vector) : vector;

    /// <summary>A vector of its shape in the axes of the world.</summary>
    public readonly Vector3d ToWorld(in Vector3d vector) => IsTurned ? Orientation.Rotate(in vector) : vector;

    /// <summary>Distance, normal and curvature of a shape that moves so, seen from a point at a time.</summary>
    public readonly ShapePoint At(IShape shape, in Vector3d position, double time)
    {
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
        return new ShapePoint(own.Distance, ToWorld(own.Normal), own.Curvature.Along(in x, in y, in z));
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
}
