namespace FootballPhysics;

/// <summary>Velocity and spin of a kick from the numbers that a game has: speed, angles, top- and sidespin.</summary>
public static class KickVectors
{
    private const double Degree = Math.PI / 180.0;

    /// <summary>Velocity and spin of a kick by angles. Forward is −z, the azimuth turns to the left.</summary>
    /// <param name="speed">Speed, m/s; 0 … 1000.</param>
    /// <param name="elevationDegrees">Angle above the horizontal, degrees; −90 … 90.</param>
    /// <param name="azimuthDegrees">Angle from −z, counter-clockwise seen from above (to the left), degrees; −360 … 360.</param>
    /// <param name="topSpin">Spin about the horizontal axis across the kick, rad/s: positive dips, negative (backspin) lifts; ±10 000.</param>
    /// <param name="sideSpin">Spin about the vertical, rad/s: positive is counter-clockwise seen from above, and bends to the left; ±10 000.</param>
    /// <param name="velocity">Velocity, m/s.</param>
    /// <param name="spin">Spin, rad/s, world frame.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public static void FromAngles(
        double speed, double elevationDegrees, double azimuthDegrees, double topSpin, double sideSpin, out Vector3d velocity, out Vector3d spin)
    {
        Check.Within(nameof(speed), speed, 0, Limits.Speed);
        Check.Within(nameof(elevationDegrees), elevationDegrees, -90, 90);
        Check.Within(nameof(azimuthDegrees), azimuthDegrees, -360, 360);
        Check.Within(nameof(topSpin), topSpin, -Limits.Spin, Limits.Spin);
        Check.Within(nameof(sideSpin), sideSpin, -Limits.Spin, Limits.Spin);
        FromAngles(speed, elevationDegrees * Degree, Flat(azimuthDegrees * Degree, new Vector3d(0, 0, -1)), topSpin, sideSpin, out velocity, out spin);
    }

    /// <summary>The spin vector of a kick: ω = top · (ŷ × d) + side · ŷ, with d the horizontal direction of the kick.</summary>
    /// <param name="direction">Direction of the kick; its horizontal part must not be zero where there is top spin.</param>
    /// <param name="top">Topspin, rad/s; negative is backspin.</param>
    /// <param name="side">Sidespin, rad/s; positive is counter-clockwise seen from above.</param>
    /// <exception cref="ArgumentOutOfRangeException">A vertical kick with top spin has no axis for it, or a number is not finite.</exception>
    public static Vector3d Spin(Vector3d direction, double top, double side)
    {
        Check.Within("topSpin", top, -Limits.Spin, Limits.Spin);
        Check.Within("sideSpin", side, -Limits.Spin, Limits.Spin);
        Vector3d flat = direction.Horizontal;
        double length = flat.Length;
        if (!(length > 0))
        {
            return top == 0 ? new Vector3d(0, side, 0) : throw Check.Conflict("direction", "direction must not be vertical if topSpin is not 0. Tilt the direction or set topSpin to 0.");
        }

        return Spin(top, side, flat / length);
    }

    /// <summary>Unit vector of a direction.</summary>
    internal static Vector3d Unit(Vector3d direction)
    {
        double length = direction.Length;
        return length > 0 && double.IsFinite(length)
            ? direction / length
            : throw Check.Refusal("direction", direction.ToString(), "finite components, not all zero");
    }

    /// <summary>A horizontal unit vector, turned counter-clockwise seen from above.</summary>
    internal static Vector3d Flat(double azimuth, in Vector3d forward)
    {
        Elementary.SinCos(azimuth, out double sin, out double cos);

        // d = f cos φ + (ŷ × f) sin φ
        return new Vector3d((forward.X * cos) + (forward.Z * sin), 0, (forward.Z * cos) - (forward.X * sin));
    }

    /// <summary>Velocity and spin of a kick along a horizontal unit vector, which a launch does not refuse: at their limits they are not above them by rounding.</summary>
    internal static void FromAngles(double speed, double elevation, in Vector3d flat, double top, double side, out Vector3d velocity, out Vector3d spin)
    {
        Elementary.SinCos(elevation, out double sin, out double cos);

        // v (cos ε d + sin ε ŷ), ω = top (ŷ × d) + side ŷ
        velocity = Limited(new Vector3d(speed * cos * flat.X, speed * sin, speed * cos * flat.Z), Limits.Speed);
        spin = Limited(Spin(top, side, in flat), Limits.Spin);
    }

    /// <summary>A vector that is not longer than a limit, by rounding neither.</summary>
    internal static Vector3d Limited(in Vector3d vector, double limit)
    {
        double squared = vector.LengthSquared;

        // Not longer than the limit by its last bit either, or the launch would refuse what the kick has just checked.
        return squared < limit * limit * (1.0 - 1e-14) ? vector : (1.0 - 1e-14) * Math.Min(1.0, limit / Math.Sqrt(squared)) * vector;
    }

    // ŷ × d = (d_z, 0, −d_x)
    private static Vector3d Spin(double top, double side, in Vector3d flat) => new(top * flat.Z, side, -(top * flat.X));
}
