using System.Globalization;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>The position and orientation in which to draw the ball.</summary>
public readonly struct BallPose : IFormattable
{
    internal BallPose(in Vector3d position, in Quaterniond orientation)
    {
        Position = position;
        Orientation = orientation;
    }

    /// <summary>The position of the centre, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The orientation, from body to world coordinates; norm 1.</summary>
    public Quaterniond Orientation { get; }

    /// <summary>Returns the position and the orientation as text.</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Returns the position and the orientation as text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for at most three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Position.ToString(format, culture)}, {Orientation.ToString(format, culture)}";
    }
}
