using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Serialization;
using System.Text.Json.Serialization;

namespace FootballPhysics;

/// <summary>A vector of three doubles: the library's own arithmetic type, the same bits on every runtime.</summary>
/// <remarks>Made from + − × ÷ √ only. <see cref="Vector3"/> is converted implicitly; the way back is <see cref="ToVector3"/>.</remarks>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public readonly struct Vector3d : IEquatable<Vector3d>, IFormattable
{
    /// <summary>The component along x.</summary>
    [JsonInclude]
    public readonly double X;

    /// <summary>The component along y, up.</summary>
    [JsonInclude]
    public readonly double Y;

    /// <summary>The component along z.</summary>
    [JsonInclude]
    public readonly double Z;

    /// <summary>Makes a vector from its three components.</summary>
    /// <param name="x">Component along x.</param>
    /// <param name="y">Component along y, up.</param>
    /// <param name="z">Component along z.</param>
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

    /// <summary>The square of the length.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public double LengthSquared
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (X * X) + (Y * Y) + (Z * Z);
    }

    /// <summary>The length.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public double Length => Math.Sqrt(LengthSquared);

    /// <summary>True when no component is infinite or NaN.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

    /// <summary>The vector without its vertical component.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public Vector3d Horizontal => new(X, 0, Z);

    /// <summary>The unit vector of the same direction; zero for the zero vector.</summary>
    public Vector3d Normalized()
    {
        double length = Length;
        return length > 0 ? this / length : Zero;
    }

    /// <summary>The point between two that a fraction of the way leads to.</summary>
    /// <param name="a">Where the way begins.</param>
    /// <param name="b">Where it ends.</param>
    /// <param name="fraction">0 is the beginning, 1 the end; other numbers continue the line.</param>
    public static Vector3d Lerp(in Vector3d a, in Vector3d b, double fraction) => a + (fraction * (b - a));

    /// <summary>Takes the vector apart.</summary>
    /// <param name="x">Component along x.</param>
    /// <param name="y">Component along y, up.</param>
    /// <param name="z">Component along z.</param>
    public void Deconstruct(out double x, out double y, out double z)
    {
        x = X;
        y = Y;
        z = Z;
    }

    /// <summary>The scalar product.</summary>
    /// <param name="a">Left factor.</param>
    /// <param name="b">Right factor.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Dot(in Vector3d a, in Vector3d b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    /// <summary>The vector product a × b, right-handed.</summary>
    /// <param name="a">Left factor.</param>
    /// <param name="b">Right factor.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d Cross(in Vector3d a, in Vector3d b) => new(
        (a.Y * b.Z) - (a.Z * b.Y),
        (a.Z * b.X) - (a.X * b.Z),
        (a.X * b.Y) - (a.Y * b.X));

    /// <summary>The distance between two points.</summary>
    /// <param name="a">One point.</param>
    /// <param name="b">The other point.</param>
    public static double Distance(in Vector3d a, in Vector3d b) => (a - b).Length;

    /// <summary>Adds two vectors.</summary>
    /// <param name="a">Left term.</param>
    /// <param name="b">Right term.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator +(in Vector3d a, in Vector3d b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Subtracts the second vector from the first.</summary>
    /// <param name="a">Left term.</param>
    /// <param name="b">Right term.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d operator -(in Vector3d a, in Vector3d b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite vector.</summary>
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

    /// <summary>Widens a <see cref="Vector3"/>; exact.</summary>
    /// <param name="v">The vector in single precision.</param>
    public static implicit operator Vector3d(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>Rounds to single precision.</summary>
    /// <param name="v">The vector.</param>
    public static explicit operator Vector3(in Vector3d v) => v.ToVector3();

    /// <summary>Rounds to single precision.</summary>
    public Vector3 ToVector3() => new((float)X, (float)Y, (float)Z);

    /// <inheritdoc/>
    public bool Equals(Vector3d other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Vector3d other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => HashCode.Combine(X, Y, Z);

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>The components with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"({X.ToString(format, culture)}, {Y.ToString(format, culture)}, {Z.ToString(format, culture)})";
    }
}
