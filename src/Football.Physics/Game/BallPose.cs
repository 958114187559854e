using System.Globalization;

namespace FootballPhysics;

/// <summary>Where to draw the ball.</summary>
public readonly struct BallPose : IFormattable
{
    internal BallPose(in Vector3d position, in Quaterniond orientation)
    {
        Position = position;
        Orientation = orientation;
    }

    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Orientation, body to world; norm 1.</summary>
    public Quaterniond Orientation { get; }

    /// <summary>Place and orientation.</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Place and orientation, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most, "R" for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Position.ToString(format, culture)}, {Orientation.ToString(format, culture)}";
    }
}
