using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Serialization;
using System.Text.Json.Serialization;

namespace FootballPhysics;

/// <summary>A vector of three doubles: bit-identical arithmetic on every runtime.</summary>
/// <remarks>The arithmetic uses only +, −, ×, ÷ and √. A <see cref="Vector3"/> converts implicitly to this type; <see cref="ToVector3"/> converts
/// back.</remarks>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public readonly struct Vector3d : IEquatable<Vector3d>, IFormattable
{
    /// <summary>The x component.</summary>
    [JsonInclude]
    public readonly double X;

    /// <summary>The y component, up.</summary>
    [JsonInclude]
    public readonly double Y;

    /// <summary>The z component.</summary>
    [JsonInclude]
    public readonly double Z;

    /// <summary>Creates a vector from three components.</summary>
    /// <param name="x">The x component.</param>
    /// <param name="y">The y component, up.</param>
    /// <param name="z">The z component.</param>
    [JsonConstructor]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3d(double x, double y, double z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    /// <summary>The zero vector.</summary>
    public static Vector3d Zero => default;

    /// <summary>The unit vector along y: up.</summary>
    public static Vector3d Up => new(0, 1, 0);

    /// <summary>The squared length.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public double LengthSquared { [MethodImpl(MethodImplOptions.AggressiveInlining)] get => (X * X) + (Y * Y) + (Z * Z); }

    /// <summary>The length.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public double Length => Math.Sqrt(LengthSquared);

    /// <summary>True if no component is infinite or NaN.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

    /// <summary>The vector with its vertical component set to zero.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public Vector3d Horizontal => new(X, 0, Z);

    /// <summary>Returns the unit vector in the same direction; zero for the zero vector.</summary>
    public Vector3d Normalized()
    {
        double length = Length;
        return length > 0 ? this / length : Zero;
    }

    /// <summary>Interpolates linearly between two points.</summary>
    /// <param name="a">The start.</param>
    /// <param name="b">The end.</param>
    /// <param name="fraction">0 is the start, 1 the end; other values extrapolate.</param>
    public static Vector3d Lerp(in Vector3d a, in Vector3d b, double fraction) => a + (fraction * (b - a));

    /// <summary>Returns the unit vector along an axis: x (0), y (1) or z (2).</summary>
    internal static Vector3d Axis(int axis) => new(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);

    /// <summary>Returns the component along an axis: x (0), y (1) or z (2).</summary>
    internal double Along(int axis) => axis == 0 ? X : axis == 1 ? Y : Z;

    /// <summary>Deconstructs the vector into its components.</summary>
    /// <param name="x">The x component.</param>
    /// <param name="y">The y component, up.</param>
    /// <param name="z">The z component.</param>
    public void Deconstruct(out double x, out double y, out double z)
    {
        x = X;
        y = Y;
        z = Z;
    }

    /// <summary>Returns the dot product.</summary>
    /// <param name="a">The left factor.</param>
    /// <param name="b">The right factor.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Dot(in Vector3d a, in Vector3d b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    /// <summary>Returns the cross product a × b, right-handed.</summary>
    /// <param name="a">The left factor.</param>
    /// <param name="b">The right factor.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d Cross(in Vector3d a, in Vector3d b) => new(
        (a.Y * b.Z) - (a.Z * b.Y),
        (a.Z * b.X) - (a.X * b.Z),
        (a.X * b.Y) - (a.Y * b.X));

    /// <summary>Returns the distance between two points.</summary>
    /// <param name="a">One point.</param>
    /// <param name="b">The other point.</param>
    public static double Distance(in Vector3d a, in Vector3d b) => (a - b).Length;

    /// <summary>Adds two vectors.</summary>
    /// <param name="a">The left term.</param>
    /// <param name="b">The right term.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator +(in Vector3d a, in Vector3d b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Subtracts the second vector from the first.</summary>
    /// <param name="a">The left term.</param>
    /// <param name="b">The right term.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator -(in Vector3d a, in Vector3d b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>Returns the opposite vector.</summary>
    /// <param name="a">The vector.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator -(in Vector3d a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>Scales a vector.</summary>
    /// <param name="a">The vector.</param>
    /// <param name="s">The factor.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator *(in Vector3d a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Scales a vector.</summary>
    /// <param name="s">The factor.</param>
    /// <param name="a">The vector.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator *(double s, in Vector3d a) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Divides a vector by a number.</summary>
    /// <param name="a">The vector.</param>
    /// <param name="s">The divisor.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator /(in Vector3d a, double s) => new(a.X / s, a.Y / s, a.Z / s);

    /// <summary>Compares by value.</summary>
    /// <param name="a">One vector.</param>
    /// <param name="b">The other vector.</param>
    public static bool operator ==(in Vector3d a, in Vector3d b) => a.Equals(b);

    /// <summary>Compares by value.</summary>
    /// <param name="a">One vector.</param>
    /// <param name="b">The other vector.</param>
    public static bool operator !=(in Vector3d a, in Vector3d b) => !a.Equals(b);

    /// <summary>Converts a <see cref="Vector3"/> to double precision; exact.</summary>
    /// <param name="v">The vector in single precision.</param>
    public static implicit operator Vector3d(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>Converts to single precision, with rounding.</summary>
    /// <param name="v">The vector.</param>
    public static explicit operator Vector3(in Vector3d v) => v.ToVector3();

    /// <summary>Converts to single precision, with rounding.</summary>
    public Vector3 ToVector3() => new((float)X, (float)Y, (float)Z);

    /// <inheritdoc/>
    public bool Equals(Vector3d other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Vector3d other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => HashCode.Combine(X, Y, Z);

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Formats the components.</summary>
    /// <param name="format">The format of the numbers, such as "F2"; null for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"({X.ToString(format, culture)}, {Y.ToString(format, culture)}, {Z.ToString(format, culture)})";
    }
}
