using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The side force of the seams and panels, as a field that is fixed to the ball: it depends on the direction of motion through the air.</summary>
/// <remarks>
/// G(b) = Σ_k t_k (p_k + h_k t_k²) (n_k − t_k b), t_k = n_k · b, b the direction seen from the ball. G is a gradient on the sphere, and G(−b) = −G(b): the mean over
/// a turn about an axis across the motion is zero. The mean square of each component over all directions is 1 for every seed.
/// </remarks>
internal sealed class SeamField
{
    /// <summary>w, the share of degree 4 in the variance (guess, 0 … 1). The correlation of the force is 0.69 at 20°, 0.39 at 30° and 0 at 45°.</summary>
    public const double FineShare = 0.5;

    private const int Axes = 6;

    /// <summary>Two quads hold six axes; the last two lanes are zero.</summary>
    private const int Lanes = 8;

    private const int FirstCounter = 32;

    private readonly SeamAxes _axes;
    private readonly Quad _lowLinear; // p of the first four axes
    private readonly Quad _highLinear;
    private readonly Quad _lowCubic; // h
    private readonly Quad _highCubic;

    /// <param name="seed">The seed of the ball.</param>
    public SeamField(long seed)
    {
        Span<Vector3d> n = stackalloc Vector3d[Lanes];
        Span<double> a = stackalloc double[Lanes];
        n.Clear();
        a.Clear();
        for (int k = 0; k < Axes; k++)
        {
            int counter = FirstCounter + (3 * k);
            double z = (2.0 * SplitMix64.At(seed, counter)) - 1.0;
            double across = Math.Sqrt(1.0 - (z * z));
            Elementary.SinCos(2.0 * Math.PI * SplitMix64.At(seed, counter + 1), out double sin, out double cos);
            n[k] = new Vector3d(across * cos, across * sin, z);
            a[k] = (2.0 * SplitMix64.At(seed, counter + 2)) - 1.0;
        }

        // n_j are the axes, a_j their amplitudes, and P₂ and P₄ the Legendre polynomials.
        // V₂ = 6/5 Σ a_j a_k P₂(n_j·n_k),  V₄ = 20/9 Σ a_j a_k P₄(n_j·n_k): the mean squares of both degrees
        double second = 0;
        double fourth = 0;
        for (int j = 0; j < Axes; j++)
        {
            for (int k = 0; k < Axes; k++)
            {
                double t = Vector3d.Dot(in n[j], in n[k]);
                double squared = t * t;
                double product = a[j] * a[k];
                second += product * (((3.0 * squared) - 1.0) / 2.0);
                fourth += product * (((((35.0 * squared) - 30.0) * squared) + 3.0) / 8.0);
            }
        }

        double s2 = Math.Sqrt(2.0 * (1.0 - FineShare) / (6.0 / 5.0 * second));
        double s4 = Math.Sqrt(2.0 * FineShare / (20.0 / 9.0 * fourth));
        Span<double> p = stackalloc double[Lanes];
        Span<double> h = stackalloc double[Lanes];
        for (int k = 0; k < Lanes; k++)
        {
            p[k] = a[k] * ((3.0 * s2) - (7.5 * s4));
            h[k] = 17.5 * a[k] * s4;
            Largest += LargestOf(p[k], h[k]);
        }

        const int High = Lanes / 2;
        _axes = new SeamAxes(n);
        _lowLinear = new Quad(p[0], p[1], p[2], p[3]);
        _highLinear = new Quad(p[High], p[High + 1], p[High + 2], p[High + 3]);
        _lowCubic = new Quad(h[0], h[1], h[2], h[3]);
        _highCubic = new Quad(h[High], h[High + 1], h[High + 2], h[High + 3]);
    }

    /// <summary>An upper bound on |G|.</summary>
    public double Largest { get; }

    /// <summary>Turns the axes with the ball.</summary>
    /// <param name="orientation">The orientation.</param>
    /// <param name="axes">The axes in the frame of the world.</param>
    public void Turn(in Quaterniond orientation, out SeamAxes axes) => _axes.Turn(in orientation, out axes);

    /// <summary>Returns U Σ_k t_k (p_k + h_k t_k²) n_k, of which U G is the part across u.</summary>
    /// <param name="axes">The axes n_k, in any frame.</param>
    /// <param name="ux">The x component of the velocity relative to the air, in that frame.</param>
    /// <param name="uy">Its y component.</param>
    /// <param name="uz">Its z component.</param>
    /// <param name="perSquared">1/U².</param>
    /// <param name="along">The product of the result with u.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3d At(in SeamAxes axes, double ux, double uy, double uz, double perSquared, out double along)
    {
        var x = Quad.Of(ux);
        var y = Quad.Of(uy);
        var z = Quad.Of(uz);
        var scale = Quad.Of(perSquared);

        // t is the cosine between the flow and an axis, p and h are the coefficients of low and high degree.
        // U t, its square, and p + h t²
        Quad low = (axes.LowX * x) + (axes.LowY * y) + (axes.LowZ * z);
        Quad high = (axes.HighX * x) + (axes.HighY * y) + (axes.HighZ * z);
        Quad lowSquared = low * low;
        Quad highSquared = high * high;
        Quad lowWeight = _lowLinear + (_lowCubic * (lowSquared * scale));
        Quad highWeight = _highLinear + (_highCubic * (highSquared * scale));
        along = ((lowWeight * lowSquared) + (highWeight * highSquared)).SumOfHalves;
        low *= lowWeight;
        high *= highWeight;
        return new Vector3d(
            ((low * axes.LowX) + (high * axes.HighX)).SumOfHalves, ((low * axes.LowY) + (high * axes.HighY)).SumOfHalves, ((low * axes.LowZ) + (high * axes.HighZ)).SumOfHalves);
    }

    /// <summary>Returns the largest |t (p + h t²)| √(1 − t²) for |t| ≤ 1.</summary>
    private static double LargestOf(double p, double h)
    {
        // With x = t², the square x (p + h x)² (1 − x) is stationary where p + (3h − 2p) x − 4h x² = 0.
        double b = (3.0 * h) - (2.0 * p);
        double root = Math.Sqrt((b * b) + (16.0 * h * p) > 0 ? (b * b) + (16.0 * h * p) : 0);
        double largest = 0;
        for (int sign = -1; sign <= 1 && h != 0; sign += 2)
        {
            double x = Math.Min(Math.Max((b + (sign * root)) / (8.0 * h), 0), 1);
            largest = Math.Max(largest, Math.Abs(p + (h * x)) * Math.Sqrt(x * (1.0 - x)));
        }

        return largest;
    }
}

/// <summary>Eight unit vectors, of which the last two are zero.</summary>
internal struct SeamAxes
{
    public Quad LowX;
    public Quad LowY;
    public Quad LowZ;
    public Quad HighX;
    public Quad HighY;
    public Quad HighZ;

    public SeamAxes(Span<Vector3d> n)
    {
        LowX = new Quad(n[0].X, n[1].X, n[2].X, n[3].X);
        LowY = new Quad(n[0].Y, n[1].Y, n[2].Y, n[3].Y);
        LowZ = new Quad(n[0].Z, n[1].Z, n[2].Z, n[3].Z);
        HighX = new Quad(n[4].X, n[5].X, n[6].X, n[7].X);
        HighY = new Quad(n[4].Y, n[5].Y, n[6].Y, n[7].Y);
        HighZ = new Quad(n[4].Z, n[5].Z, n[6].Z, n[7].Z);
    }

    /// <summary>Rotates all vectors from body to world coordinates.</summary>
    public readonly void Turn(in Quaterniond q, out SeamAxes axes)
    {
        double x2 = q.X + q.X;
        double y2 = q.Y + q.Y;
        double z2 = q.Z + q.Z;
        double xx = q.X * x2;
        double yy = q.Y * y2;
        double zz = q.Z * z2;
        double xy = q.X * y2;
        double xz = q.X * z2;
        double yz = q.Y * z2;
        double wx = q.W * x2;
        double wy = q.W * y2;
        double wz = q.W * z2;
        Row(1.0 - (yy + zz), xy - wz, xz + wy, out axes.LowX, out axes.HighX);
        Row(xy + wz, 1.0 - (xx + zz), yz - wx, out axes.LowY, out axes.HighY);
        Row(xz - wy, yz + wx, 1.0 - (xx + yy), out axes.LowZ, out axes.HighZ);
    }

    /// <summary>Rotates all vectors by an angle θ about an axis n: v cos θ + n (n·v)(1 − cos θ) + sin θ n × v.</summary>
    /// <param name="n">The axis.</param>
    /// <param name="sin">sin θ.</param>
    /// <param name="versine">1 − cos θ.</param>
    /// <param name="axes">The rotated vectors.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Turn(in Vector3d n, double sin, double versine, out SeamAxes axes)
    {
        double cos = 1.0 - versine;
        double vx = versine * n.X;
        double vy = versine * n.Y;
        double vz = versine * n.Z;
        double xy = vx * n.Y;
        double xz = vx * n.Z;
        double yz = vy * n.Z;
        double sx = sin * n.X;
        double sy = sin * n.Y;
        double sz = sin * n.Z;
        Row(cos + (vx * n.X), xy - sz, xz + sy, out axes.LowX, out axes.HighX);
        Row(xy + sz, cos + (vy * n.Y), yz - sx, out axes.LowY, out axes.HighY);
        Row(xz - sy, yz + sx, cos + (vz * n.Z), out axes.LowZ, out axes.HighZ);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Row(double a, double b, double c, out Quad low, out Quad high)
    {
        low = (Quad.Of(a) * LowX) + (Quad.Of(b) * LowY) + (Quad.Of(c) * LowZ);
        high = (Quad.Of(a) * HighX) + (Quad.Of(b) * HighY) + (Quad.Of(c) * HighZ);
    }
}
