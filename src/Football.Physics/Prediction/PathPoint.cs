using System.Globalization;

namespace FootballPhysics.Prediction;

/// <summary>A point of a predicted path.</summary>
public readonly struct PathPoint : IFormattable
{
    internal PathPoint(double time, in Vector3d position, in Vector3d velocity, double distance)
    {
        Time = time;
        Position = position;
        Velocity = velocity;
        Distance = distance;
    }

    /// <summary>When, s since the launch.</summary>
    public double Time { get; }

    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Velocity, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Distance from what was asked for, m: 0 on a plane, the closest approach for a point.</summary>
    public double Distance { get; }

    /// <summary>When and where, such as "1.25 s: (0, 1.5, −20)".</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>When and where, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most, "R" for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Time.ToString(format, culture)} s: {Position.ToString(format, culture)}";
    }
}
