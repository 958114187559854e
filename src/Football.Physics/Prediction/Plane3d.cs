using System.Globalization;
using System.Text.Json.Serialization;
using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A plane through a point, such as a goal line's vertical plane.</summary>
/// <remarks>The default value has no normal and is not a plane; methods reject it.</remarks>
public readonly struct Plane3d : IFormattable
{
    /// <summary>Creates a plane.</summary>
    /// <param name="point">A point on the plane, in m; components within ±1e6.</param>
    /// <param name="normal">The normal; any length except zero.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    [JsonConstructor]
    public Plane3d(Vector3d point, Vector3d normal)
    {
        Check.Place(nameof(point), point);
        Point = point;
        Normal = KickVectors.Unit(normal);
    }

    /// <summary>A point on the plane, in m.</summary>
    public Vector3d Point { get; }

    /// <summary>The unit normal.</summary>
    public Vector3d Normal { get; }

    /// <summary>Throws if the plane is the default value.</summary>
    internal void Validate(string field)
    {
        if (Normal == Vector3d.Zero)
        {
            throw Check.Refusal(field + ".normal", Normal.ToString(), "a plane made from a point and a normal, not default(Plane3d)");
        }
    }

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Returns the point and the normal as text, in a given number format.</summary>
    /// <param name="format">A number format; null or empty for at most three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Point.ToString(format, culture)}, normal {Normal.ToString(format, culture)}";
    }
}
