using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>Computes the velocity and spin of a kick from speed, angles, topspin and sidespin.</summary>
public static class KickVectors
{
    private const double Degree = Math.PI / 180.0;

    /// <summary>Computes the velocity and spin of a kick from angles. Forward is −z.</summary>
    /// <param name="speed">The speed, in m/s; 0 … 1000.</param>
    /// <param name="elevationDegrees">The angle above the horizontal, in degrees; −90 … 90.</param>
    /// <param name="azimuthDegrees">The angle from −z, counter-clockwise seen from above (to the left), in degrees; −360 … 360.</param>
    /// <param name="topSpin">The spin about the horizontal axis across the kick, in rad/s; ±10 000. Topspin (positive) makes the ball dip, backspin makes it lift.</param>
    /// <param name="sideSpin">The spin about the vertical, in rad/s; ±10 000. Positive is counter-clockwise seen from above, and bends the path to the left.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    /// <param name="spin">The spin in the world frame, in rad/s.</param>
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

    /// <summary>Returns the spin vector of a kick from its topspin and sidespin.</summary>
    /// <remarks>ω = top · (ŷ × d) + side · ŷ, where d is the horizontal direction of the kick.</remarks>
    /// <param name="direction">The direction of the kick. With topspin, its horizontal part must not be zero.</param>
    /// <param name="top">The topspin, in rad/s; negative is backspin.</param>
    /// <param name="side">The sidespin, in rad/s; positive is counter-clockwise seen from above.</param>
    /// <exception cref="ArgumentOutOfRangeException">A vertical kick has topspin, or a number is out of range.</exception>
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

    /// <summary>Returns the unit vector of a direction.</summary>
    internal static Vector3d Unit(Vector3d direction)
    {
        double length = direction.Length;
        return length > 0 && double.IsFinite(length)
            ? direction / length
            : throw Check.Refusal("direction", direction.ToString(), "finite components, not all zero");
    }

    /// <summary>Rotates a horizontal unit vector counter-clockwise, seen from above.</summary>
    internal static Vector3d Flat(double azimuth, in Vector3d forward)
    {
        Elementary.SinCos(azimuth, out double sin, out double cos);

        // f is the forward direction, and φ the azimuth.
        // d = f cos φ + (ŷ × f) sin φ
        return new Vector3d((forward.X * cos) + (forward.Z * sin), 0, (forward.Z * cos) - (forward.X * sin));
    }

    /// <summary>Computes the velocity and spin of a kick along a horizontal unit vector.</summary>
    /// <remarks>Rounding never lifts speed or spin above the limits, so a launch accepts both.</remarks>
    internal static void FromAngles(double speed, double elevation, in Vector3d flat, double top, double side, out Vector3d velocity, out Vector3d spin)
    {
        Elementary.SinCos(elevation, out double sin, out double cos);

        // v is the speed, ε the elevation, and d the flat direction.
        // v (cos ε d + sin ε ŷ), ω = top (ŷ × d) + side ŷ
        velocity = Limited(new Vector3d(speed * cos * flat.X, speed * sin, speed * cos * flat.Z), Limits.Speed);
        spin = Limited(Spin(top, side, in flat), Limits.Spin);
    }

    /// <summary>Returns a vector scaled so that rounding cannot make it longer than a limit.</summary>
    internal static Vector3d Limited(in Vector3d vector, double limit)
    {
        double squared = vector.LengthSquared;

        // Even the last bit matters: otherwise, the launch would reject a kick that has just been checked.
        return squared < limit * limit * (1.0 - 1e-14) ? vector : (1.0 - 1e-14) * Math.Min(1.0, limit / Math.Sqrt(squared)) * vector;
    }

    // ŷ × d = (d_z, 0, −d_x)
    private static Vector3d Spin(double top, double side, in Vector3d flat) => new(top * flat.Z, side, -(top * flat.X));
}
