using System.Globalization;
using System.Text.Json.Serialization;

namespace FootballPhysics.Prediction;

/// <summary>A plane through a point, such as a goal line's vertical plane.</summary>
/// <remarks>Its default value has no normal, and is no plane: whatever is given one refuses it.</remarks>
public readonly struct Plane3d : IFormattable
{
    /// <summary>Makes a plane.</summary>
    /// <param name="point">A point of it, m; components within ±1e6.</param>
    /// <param name="normal">Its normal; any length but zero.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    [JsonConstructor]
    public Plane3d(Vector3d point, Vector3d normal)
    {
        Check.Place(nameof(point), point);
        Point = point;
        Normal = KickVectors.Unit(normal);
    }

    /// <summary>A point of the plane, m.</summary>
    public Vector3d Point { get; }

    /// <summary>Its unit normal.</summary>
    public Vector3d Normal { get; }

    /// <summary>Refuses a plane that was never made.</summary>
    internal void Validate(string field)
    {
        if (Normal == Vector3d.Zero)
        {
            throw Check.Refusal(field + ".normal", Normal.ToString(), "a plane made from a point and a normal, not default(Plane3d)");
        }
    }

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Its point and its normal, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most, "R" for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Point.ToString(format, culture)}, normal {Normal.ToString(format, culture)}";
    }
}
