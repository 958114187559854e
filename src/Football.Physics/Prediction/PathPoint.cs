using System.Globalization;
using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A point on a predicted path.</summary>
public readonly struct PathPoint : IFormattable
{
    internal PathPoint(double time, in Vector3d position, in Vector3d velocity, double distance)
    {
        Time = time;
        Position = position;
        Velocity = velocity;
        Distance = distance;
    }

    /// <summary>The time, in s since the launch.</summary>
    public double Time { get; }

    /// <summary>The position of the centre, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The distance from the queried plane or object, in m: 0 for a plane, otherwise the distance at the closest approach.</summary>
    public double Distance { get; }

    /// <summary>Returns time and position as text, such as "1.25 s: (0, 1.5, −20)".</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Returns time and position as text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for at most three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Time.ToString(format, culture)} s: {Position.ToString(format, culture)}";
    }
}
