using System.Globalization;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Serialization;
using System.Text.Json.Serialization;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>A rotation from body to world coordinates, as a unit quaternion (x, y, z, w) of doubles.</summary>
public readonly struct Quaterniond : IEquatable<Quaterniond>, IFormattable
{
    /// <summary>The x component of the vector part.</summary>
    [JsonInclude]
    public readonly double X;

    /// <summary>The y component of the vector part.</summary>
    [JsonInclude]
    public readonly double Y;

    /// <summary>The z component of the vector part.</summary>
    [JsonInclude]
    public readonly double Z;

    /// <summary>The scalar part.</summary>
    [JsonInclude]
    public readonly double W;

    /// <summary>Creates a quaternion from four components; it is not normalized.</summary>
    /// <param name="x">The x component of the vector part.</param>
    /// <param name="y">The y component of the vector part.</param>
    /// <param name="z">The z component of the vector part.</param>
    /// <param name="w">The scalar part.</param>
    [JsonConstructor]
    public Quaterniond(double x, double y, double z, double w)
    {
        X = x;
        Y = y;
        Z = z;
        W = w;
    }

    /// <summary>The identity rotation.</summary>
    public static Quaterniond Identity => new(0, 0, 0, 1);

    /// <summary>The squared norm; 1 for a rotation.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public double LengthSquared => (X * X) + (Y * Y) + (Z * Z) + (W * W);

    /// <summary>True if no component is infinite or NaN.</summary>
    [JsonIgnore]
    [IgnoreDataMember]
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z) && double.IsFinite(W);

    /// <summary>Returns the product a ⊗ b: rotation b first, then a.</summary>
    /// <param name="a">The left factor.</param>
    /// <param name="b">The right factor.</param>
    public static Quaterniond operator *(in Quaterniond a, in Quaterniond b) => new(
        (a.W * b.X) + (a.X * b.W) + ((a.Y * b.Z) - (a.Z * b.Y)),
        (a.W * b.Y) + (a.Y * b.W) + ((a.Z * b.X) - (a.X * b.Z)),
        (a.W * b.Z) + (a.Z * b.W) + ((a.X * b.Y) - (a.Y * b.X)),
        (a.W * b.W) - ((a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z)));

    /// <summary>Compares by value.</summary>
    /// <param name="a">One quaternion.</param>
    /// <param name="b">The other quaternion.</param>
    public static bool operator ==(in Quaterniond a, in Quaterniond b) => a.Equals(b);

    /// <summary>Compares by value.</summary>
    /// <param name="a">One quaternion.</param>
    /// <param name="b">The other quaternion.</param>
    public static bool operator !=(in Quaterniond a, in Quaterniond b) => !a.Equals(b);

    /// <summary>Converts a <see cref="Quaternion"/> to double precision; exact.</summary>
    /// <param name="q">The quaternion in single precision.</param>
    public static implicit operator Quaterniond(Quaternion q) => new(q.X, q.Y, q.Z, q.W);

    /// <summary>Returns the rotation by an angle about a unit axis.</summary>
    /// <param name="axis">The axis, a unit vector.</param>
    /// <param name="angle">The angle, in rad, counter-clockwise about the axis.</param>
    public static Quaterniond FromAxisAngle(in Vector3d axis, double angle)
    {
        Elementary.SinCos(0.5 * angle, out double sin, out double cos);
        return new(axis.X * sin, axis.Y * sin, axis.Z * sin, cos);
    }

    /// <summary>The angle above which a double resolves no fraction of a turn, in rad.</summary>
    private const double NoDigits = 1e15;

    /// <summary>Returns the rotation for a rotation vector, whose length is the angle and whose direction is the axis.</summary>
    /// <param name="rotation">The rotation vector, in rad.</param>
    public static Quaterniond FromRotationVector(in Vector3d rotation)
    {
        // An angle this large has no digits below one turn, so it does not define a rotation.
        double angle = rotation.Length;
        return angle > 0 && angle < NoDigits ? FromAxisAngle(rotation / angle, angle) : Identity;
    }

    /// <summary>Returns this rotation followed by that of a rotation vector, as at the end of a step.</summary>
    /// <remarks>No root, division or sine: both factors are unit quaternions up to rounding, and so is the product.</remarks>
    internal Quaterniond Turned(in Vector3d rotation)
    {
        double z = 0.25 * rotation.LengthSquared;

        // θ is the angle of the rotation.
        // z = (θ/2)². Above θ/2 = 2, the series would be too long: use sine and cosine.
        if (!(z <= 4.0))
        {
            return (FromRotationVector(in rotation) * this).Normalized();
        }

        // cos √z and sin √z / √z: Taylor series with remainders below 1e-18.
        double c;
        double s;
        if (z <= 0.25)
        {
            // Group the terms in pairs, which halves the dependency chain of Horner's scheme.
            double z2 = z * z;
            double z4 = z2 * z2;
            c = (1.0 + (z * C1)) + (z2 * (C2 + (z * C3))) + (z4 * ((C4 + (z * C5)) + (z2 * (C6 + (z * C7)))));
            s = (1.0 + (z * S1)) + (z2 * (S2 + (z * S3))) + (z4 * ((S4 + (z * S5)) + (z2 * (S6 + (z * S7)))));
        }
        else
        {
            // Horner's scheme in two parts, with more terms for θ/2 up to 2 rad.
            double highC = C6 + (z * (C7 + (z * (C8 + (z * (C9 + (z * (C10 + (z * (C11 + (z * C12)))))))))));
            double highS = S6 + (z * (S7 + (z * (S8 + (z * (S9 + (z * (S10 + (z * (S11 + (z * S12)))))))))));
            c = 1.0 + (z * (C1 + (z * (C2 + (z * (C3 + (z * (C4 + (z * (C5 + (z * highC)))))))))));
            s = 1.0 + (z * (S1 + (z * (S2 + (z * (S3 + (z * (S4 + (z * (S5 + (z * highS)))))))))));
        }

        return Turned(in rotation, 0.5 * s, c);
    }

    /// <summary>Returns this rotation followed by another one.</summary>
    /// <param name="axis">The axis of the other rotation, of any length.</param>
    /// <param name="s">The sine of half its angle, divided by the length of the axis.</param>
    /// <param name="c">The cosine of half its angle.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Quaterniond Turned(in Vector3d axis, double s, double c)
    {
        // Scale this quaternion by 1/√n², for n² = 1 + rounding: the norm of the other factor is 1. The scale does not wait for the sine.
        double scale = 1.5 - (0.5 * LengthSquared);
        double bx = scale * X;
        double by = scale * Y;
        double bz = scale * Z;
        double bw = scale * W;

        // The product, component by component: a quaternion in between would be stored and loaded. The vector part of the other factor is
        // s times the axis; the products with the axis do not wait for the sine.
        double rx = axis.X;
        double ry = axis.Y;
        double rz = axis.Z;
        return new(
            (c * bx) + (s * ((rx * bw) + ((ry * bz) - (rz * by)))),
            (c * by) + (s * ((ry * bw) + ((rz * bx) - (rx * bz)))),
            (c * bz) + (s * ((rz * bw) + ((rx * by) - (ry * bx)))),
            (c * bw) - (s * ((rx * bx) + (ry * by) + (rz * bz))));
    }

    /// <summary>Returns this quaternion, scaled to norm 1.</summary>
    public Quaterniond Normalized()
    {
        double scale = 1.0 / Math.Sqrt(LengthSquared);
        return new(X * scale, Y * scale, Z * scale, W * scale);
    }

    /// <summary>The distance of the squared norm from 1 up to which <see cref="Unit"/> keeps a quaternion.</summary>
    /// <remarks>It is above the rounding errors of <see cref="Normalized"/> and <see cref="Turned(in Vector3d)"/>, and far below the contact tolerances.</remarks>
    private const double NormRounding = 1e-14;

    /// <summary>Returns this quaternion if its norm is 1 up to rounding, and the normalized one otherwise.</summary>
    /// <remarks>A second call returns the same bits. <see cref="Normalized"/> may change the last bits of its own result.</remarks>
    internal Quaterniond Unit() => Math.Abs(LengthSquared - 1.0) <= NormRounding ? this : Normalized();

    /// <summary>Rotates a vector from body to world coordinates.</summary>
    /// <param name="v">The vector.</param>
    public Vector3d Rotate(in Vector3d v)
    {
        // q is the vector part, and w the scalar part.
        // v' = v + 2 w (q × v) + 2 q × (q × v)
        var q = new Vector3d(X, Y, Z);
        Vector3d t = 2.0 * Vector3d.Cross(q, v);
        return v + (W * t) + Vector3d.Cross(q, t);
    }

    /// <summary>Returns the constant spin that turns this orientation into another, in rad/s.</summary>
    /// <remarks>Use it to compute the spin of a bone from two frames of an animation. Of the two possible rotations, the method uses the shorter one, of at
    /// most π.</remarks>
    /// <param name="next">The later orientation.</param>
    /// <param name="duration">The time between the two orientations, in s; above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="duration"/> is not above 0.</exception>
    public Vector3d SpinTo(in Quaterniond next, double duration)
    {
        Check.Positive(nameof(duration), duration);

        // next q⁻¹ has the vector part sin(θ/2) n; the opposite sign represents the same rotation.
        Quaterniond turn = next * new Quaterniond(-X, -Y, -Z, W);
        var axis = new Vector3d(turn.X, turn.Y, turn.Z);
        double sine = axis.Length;
        double angle = 2.0 * Elementary.Atan2(sine, Math.Abs(turn.W));
        return sine > 0 ? (turn.W < 0 ? -angle : angle) / (sine * duration) * axis : Vector3d.Zero;
    }

    /// <summary>Converts to single precision, with rounding.</summary>
    public Quaternion ToQuaternion() => new((float)X, (float)Y, (float)Z, (float)W);

    /// <inheritdoc/>
    public bool Equals(Quaterniond other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z) && W.Equals(other.W);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Quaterniond other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => HashCode.Combine(X, Y, Z, W);

    /// <inheritdoc/>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Formats the components.</summary>
    /// <param name="format">The format of the numbers, such as "F2"; null for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"({X.ToString(format, culture)}, {Y.ToString(format, culture)}, {Z.ToString(format, culture)}, {W.ToString(format, culture)})";
    }

    // (−1)^k/(2k)! and (−1)^k/(2k + 1)!
    private const double C1 = -1.0 / 2.0;
    private const double C2 = 1.0 / 24.0;
    private const double C3 = -1.0 / 720.0;
    private const double C4 = 1.0 / 40320.0;
    private const double C5 = -1.0 / 3628800.0;
    private const double C6 = 1.0 / 479001600.0;
    private const double C7 = -1.0 / 87178291200.0;
    private const double C8 = 1.0 / 20922789888000.0;
    private const double C9 = -1.0 / 6402373705728000.0;
    private const double C10 = 1.0 / 2432902008176640000.0;
    private const double C11 = -1.0 / 1124000727777607680000.0;
    private const double C12 = 1.0 / 620448401733239439360000.0;
    private const double S1 = -1.0 / 6.0;
    private const double S2 = 1.0 / 120.0;
    private const double S3 = -1.0 / 5040.0;
    private const double S4 = 1.0 / 362880.0;
    private const double S5 = -1.0 / 39916800.0;
    private const double S6 = 1.0 / 6227020800.0;
    private const double S7 = -1.0 / 1307674368000.0;
    private const double S8 = 1.0 / 355687428096000.0;
    private const double S9 = -1.0 / 121645100408832000.0;
    private const double S10 = 1.0 / 51090942171709440000.0;
    private const double S11 = -1.0 / 25852016738884976640000.0;
    private const double S12 = 1.0 / 15511210043330985984000000.0;
}

/// <summary>The rotation over a step with a changing spin.</summary>
internal static class RotationVector
{
    /// <summary>Solves q̇ = ½ ω ⊗ q over a step by the Magnus expansion of order 6 (Blanes et al.), where [a, b] = a × b.</summary>
    /// <param name="start">The spin at the start, in rad/s.</param>
    /// <param name="middle">The spin at half the step.</param>
    /// <param name="end">The spin at the end.</param>
    /// <param name="h">The length of the step, in s.</param>
    public static Vector3d Of(in Vector3d start, in Vector3d middle, in Vector3d end, double h)
    {
        // At the middle: α₁ = h ω, α₂ = h² ω̇, α₃ = h³ ω̈/2.
        Vector3d a1 = h * middle;
        Vector3d a2 = h * (end - start);
        Vector3d a3 = (2.0 * h) * ((start - middle) + (end - middle));

        // Ω is the rotation vector of the step, and [a, b] = a × b.
        // Ω = α₁ + α₃/12 + [−20 α₁ − α₃ + C₁, α₂ + C₂]/240,  C₁ = [α₁, α₂],  C₂ = −[α₁, 2 α₃ + C₁]/60
        Vector3d c1 = Vector3d.Cross(in a1, in a2);
        Vector3d c2 = (-1.0 / 60.0) * Vector3d.Cross(in a1, (2.0 * a3) + c1);
        return a1 + ((1.0 / 12.0) * a3) + ((1.0 / 240.0) * Vector3d.Cross((-20.0 * a1) - a3 + c1, a2 + c2));
    }

    /// <summary>Solves the same equation to the second term of the series, from the mean spin: h ω̄ + h²/12 ω(h) × ω(0).</summary>
    /// <param name="mean">The mean spin, in rad/s.</param>
    /// <param name="start">The spin at the start.</param>
    /// <param name="end">The spin at the end.</param>
    /// <param name="h">The length of the step, in s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3d OfMean(in Vector3d mean, in Vector3d start, in Vector3d end, double h) => (h * mean) + (h * h * (1.0 / 12.0) * Vector3d.Cross(in end, in start));

    /// <summary>Returns the rate of a rotation vector: φ̇ = ω − φ × ω/2 + φ × (φ × ω)/12, with an error of order φ⁴.</summary>
    /// <param name="turn">φ, the rotation vector, in rad.</param>
    /// <param name="spin">ω, in rad/s.</param>
    public static Vector3d Rate(in Vector3d turn, in Vector3d spin)
    {
        Vector3d c = Vector3d.Cross(in turn, in spin);
        return spin - (0.5 * c) + ((1.0 / 12.0) * Vector3d.Cross(in turn, in c));
    }

    /// <summary>Composes two small rotations: the Baker–Campbell–Hausdorff series to the third order.</summary>
    /// <param name="first">The first rotation, in rad.</param>
    /// <param name="second">The second rotation, in rad.</param>
    public static Vector3d Then(in Vector3d first, in Vector3d second)
    {
        // a + b + [b, a]/2 + [b − a, [b, a]]/12
        Vector3d c = Vector3d.Cross(in second, in first);
        return first + second + (0.5 * c) + ((1.0 / 12.0) * Vector3d.Cross(second - first, c));
    }
}
