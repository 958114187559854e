using FootballPhysics.Numerics;

namespace FootballPhysics.Shapes;

/// <summary>Uneven ground: a uniform cubic B-spline over a grid of heights.</summary>
/// <remarks>
/// Beyond the grid, the values at the border are repeated. Let u, w be the fractional parts of ((x − x₀)/δ, (z − z₀)/δ), and i, j their floors. Then y = Σ
/// b_k(u) b_l(w) c[i−1+k][j−1+l], k, l = 0…3, b = ((1−u)³, 3u³−6u²+4, −3u³+3u²+3u+1, u³)/6.
/// <para>A ball can rest on it if its slope is at most 1 and its curvature at most 1/(2r).</para>
/// </remarks>
public sealed class HeightField : IShape
{
    /// <summary>The samples per cell and direction in the search for the steepest slope and the strongest curvature.</summary>
    private const int SamplesOfCell = 4;

    /// <summary>The step of Newton's method at which the search for the nearest point ends, in m.</summary>
    private const double Closeness = 1e-15;

    private const int MostIterations = 30;

    /// <summary>The distance up to which the nearest point is computed, relative to the radius of curvature.</summary>
    private const double NearBy = 0.8;

    private readonly double[] _values;
    private readonly int _rows;
    private readonly int _columns;
    private readonly double _highest;

    /// <summary>Creates uneven ground.</summary>
    /// <param name="originX">The x coordinate of the first value, in m; within ±1e6.</param>
    /// <param name="originZ">The z coordinate of the first value, in m; within ±1e6.</param>
    /// <param name="spacing">The distance δ between neighbours, in m; above 0, at most 1e6.</param>
    /// <param name="values">The heights c[i][j], in m, with i along x and j along z; at least one, each within ±1e6. They are copied.</param>
    /// <exception cref="ArgumentNullException"><paramref name="values"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public HeightField(double originX, double originZ, double spacing, double[,] values)
    {
        if (values is null)
        {
            throw new ArgumentNullException(nameof(values));
        }

        Check.Within("origin[0]", originX, -Limits.Length, Limits.Length);
        Check.Within("origin[1]", originZ, -Limits.Length, Limits.Length);
        Check.Within("spacing", spacing, 0, Limits.Length, exclusiveLow: true);
        _rows = values.GetLength(0);
        _columns = values.GetLength(1);
        if (_rows < 1 || _columns < 1)
        {
            throw Check.Refusal("values", $"{_rows} × {_columns}", "at least 1 × 1 heights");
        }

        OriginX = originX;
        OriginZ = originZ;
        Spacing = spacing;

        // Copy the values, so that later changes to the array do not move the ground under a ball.
        _values = new double[_rows * _columns];
        _highest = double.NegativeInfinity;
        for (int i = 0; i < _rows; i++)
        {
            for (int j = 0; j < _columns; j++)
            {
                double value = values[i, j];
                Check.Within($"values[{i}][{j}]", value, -Limits.Length, Limits.Length);
                _values[(i * _columns) + j] = value;
                _highest = Math.Max(_highest, value);
            }
        }

        (SteepestSlope, StrongestCurvature) = Extremes();
    }

    private HeightField(HeightField other, double by)
    {
        OriginX = other.OriginX;
        OriginZ = other.OriginZ;
        Spacing = other.Spacing;
        SteepestSlope = other.SteepestSlope;
        StrongestCurvature = other.StrongestCurvature;
        _rows = other._rows;
        _columns = other._columns;
        _highest = other._highest + by;
        _values = [.. other._values.Select(value => value + by)];
    }

    /// <summary>The x coordinate of the first value, in m.</summary>
    internal double OriginX { get; }

    /// <summary>The z coordinate of the first value, in m.</summary>
    internal double OriginZ { get; }

    /// <summary>The distance δ between neighbours, in m.</summary>
    public double Spacing { get; }

    /// <summary>The steepest slope, from samples in every cell.</summary>
    internal double SteepestSlope { get; }

    /// <summary>The strongest curvature, from samples in every cell, in 1/m.</summary>
    internal double StrongestCurvature { get; }

    /// <summary>The heights passed to the constructor, row by row.</summary>
    internal IEnumerable<IEnumerable<double>> Rows => Enumerable.Range(0, _rows).Select(i => _values.Skip(i * _columns).Take(_columns));

    /// <inheritdoc/>
    double IShape.MaximumConcaveCurvature => StrongestCurvature;

    /// <inheritdoc/>
    public Bounds3d Bounds => new(
        new Vector3d(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity),
        new Vector3d(double.PositiveInfinity, _highest, double.PositiveInfinity));

    /// <summary>Returns the height at a point, in m.</summary>
    /// <param name="x">The x coordinate, in m.</param>
    /// <param name="z">The z coordinate, in m.</param>
    public double HeightAt(double x, double z) => Sample(x, z).Height;

    /// <summary>Returns a copy at another height.</summary>
    /// <param name="by">The change of the height, in m.</param>
    internal HeightField Raised(double by) => by == 0 ? this : new HeightField(this, by);

    /// <inheritdoc/>
    /// <remarks>
    /// Near the ground, up to four fifths of its radius of curvature, the distance is exact. Farther away it is a lower bound, which is enough for the
    /// contact search.
    /// </remarks>
    public ShapePoint At(in Vector3d point)
    {
        double x = point.X;
        double z = point.Z;

        // Start from the point vertically below.
        Patch patch = Sample(x, z);
        double above = point.Y - patch.Height;
        if (Math.Abs(above) * StrongestCurvature > NearBy)
        {
            // The lower bound is the vertical distance divided by √(1 + slope²).
            Vector3d up = patch.Normal;
            return new ShapePoint(above / Math.Sqrt(1.0 + (SteepestSlope * SteepestSlope)), in up, SymmetricMatrix3d.Zero);
        }

        // Apply Newton's method to find the nearest point: (S − p)·S_x = 0, (S − p)·S_z = 0.
        for (int i = 0; i < MostIterations; i++)
        {
            // f and g are the two residuals; their Jacobian is symmetric.
            double up = patch.Height - point.Y;
            double f = (x - point.X) + (up * patch.SlopeX);
            double g = (z - point.Z) + (up * patch.SlopeZ);
            double fx = 1.0 + (patch.SlopeX * patch.SlopeX) + (up * patch.XX);
            double fz = (patch.SlopeX * patch.SlopeZ) + (up * patch.XZ);
            double gz = 1.0 + (patch.SlopeZ * patch.SlopeZ) + (up * patch.ZZ);
            double determinant = (fx * gz) - (fz * fz);
            double dx = ((gz * f) - (fz * g)) / determinant;
            double dz = ((fx * g) - (fz * f)) / determinant;
            x -= dx;
            z -= dz;
            patch = Sample(x, z);
            if (Math.Abs(dx) + Math.Abs(dz) <= Closeness * (1.0 + Math.Abs(x) + Math.Abs(z)))
            {
                break;
            }
        }

        Vector3d normal = patch.Normal;

        // The sign is right because the normal points out of the ground.
        double distance = Vector3d.Dot(point - new Vector3d(x, patch.Height, z), in normal);
        return new ShapePoint(distance, in normal, patch.CurvatureAt(distance));
    }

    private (double Slope, double Curvature) Extremes()
    {
        double slope = 0;
        double curvature = 0;

        // Include the cells beyond the border, because the surface still curves there.
        for (int i = -SamplesOfCell; i <= (_rows + 1) * SamplesOfCell; i++)
        {
            for (int j = -SamplesOfCell; j <= (_columns + 1) * SamplesOfCell; j++)
            {
                Patch patch = Sample(OriginX + (i * Spacing / SamplesOfCell), OriginZ + (j * Spacing / SamplesOfCell));
                slope = Math.Max(slope, Math.Sqrt((patch.SlopeX * patch.SlopeX) + (patch.SlopeZ * patch.SlopeZ)));
                curvature = Math.Max(curvature, patch.StrongestCurvature);
            }
        }

        return (slope, curvature);
    }

    /// <summary>Returns the height and its derivatives at a point.</summary>
    private Patch Sample(double x, double z)
    {
        double u = (x - OriginX) / Spacing;
        double w = (z - OriginZ) / Spacing;

        // The cell index, and the position within the cell.
        double floorU = Math.Floor(u);
        double floorW = Math.Floor(w);
        var alongX = new Basis(u - floorU);
        var alongZ = new Basis(w - floorW);

        // Clamp before the conversion, because an int cannot hold 1e300.
        int i = (int)Math.Min(Math.Max(floorU, -4), _rows + 4);
        int j = (int)Math.Min(Math.Max(floorW, -4), _columns + 4);

        // Use sixteen values; clamp indices beyond the border to the border.
        int column0 = Math.Min(Math.Max(j - 1, 0), _columns - 1);
        int column1 = Math.Min(Math.Max(j, 0), _columns - 1);
        int column2 = Math.Min(Math.Max(j + 1, 0), _columns - 1);
        int column3 = Math.Min(Math.Max(j + 2, 0), _columns - 1);
        Patch sum = default;
        for (int k = 0; k < 4; k++)
        {
            int row = Math.Min(Math.Max(i - 1 + k, 0), _rows - 1) * _columns;
            double c0 = _values[row + column0];
            double c1 = _values[row + column1];
            double c2 = _values[row + column2];
            double c3 = _values[row + column3];

            // Interpolate along z first: value, slope and second derivative. The weights along x follow.
            double value = (alongZ.Value0 * c0) + (alongZ.Value1 * c1) + (alongZ.Value2 * c2) + (alongZ.Value3 * c3);
            double slope = (alongZ.Slope0 * c0) + (alongZ.Slope1 * c1) + (alongZ.Slope2 * c2) + (alongZ.Slope3 * c3);
            double bend = (alongZ.Bend0 * c0) + (alongZ.Bend1 * c1) + (alongZ.Bend2 * c2) + (alongZ.Bend3 * c3);
            sum.Height += alongX.Value(k) * value;
            sum.SlopeX += alongX.Slope(k) * value;
            sum.SlopeZ += alongX.Value(k) * slope;
            sum.XX += alongX.Bend(k) * value;
            sum.XZ += alongX.Slope(k) * slope;
            sum.ZZ += alongX.Value(k) * bend;
        }

        // Convert derivatives from units of cells to metres.
        double per = 1.0 / Spacing;
        sum.SlopeX *= per;
        sum.SlopeZ *= per;
        sum.XX *= per * per;
        sum.XZ *= per * per;
        sum.ZZ *= per * per;
        return sum;
    }

    /// <summary>The four cubic B-splines at a position in the cell, with their first and second derivatives.</summary>
    private readonly struct Basis
    {
        public readonly double Value0;
        public readonly double Value1;
        public readonly double Value2;
        public readonly double Value3;
        public readonly double Slope0;
        public readonly double Slope1;
        public readonly double Slope2;
        public readonly double Slope3;
        public readonly double Bend0;
        public readonly double Bend1;
        public readonly double Bend2;
        public readonly double Bend3;

        public Basis(double u)
        {
            // Use both u and 1 − u, so that the four weights are exactly symmetric.
            double v = 1.0 - u;
            Value0 = v * v * v / 6.0;
            Value1 = ((((3.0 * u) - 6.0) * u * u) + 4.0) / 6.0;
            Value2 = ((((3.0 * v) - 6.0) * v * v) + 4.0) / 6.0;
            Value3 = u * u * u / 6.0;
            Slope0 = -0.5 * v * v;
            Slope1 = ((1.5 * u) - 2.0) * u;
            Slope2 = -((1.5 * v) - 2.0) * v;
            Slope3 = 0.5 * u * u;
            Bend0 = v;
            Bend1 = (3.0 * u) - 2.0;
            Bend2 = (3.0 * v) - 2.0;
            Bend3 = u;
        }

        public double Value(int k) => k == 0 ? Value0 : k == 1 ? Value1 : k == 2 ? Value2 : Value3;

        public double Slope(int k) => k == 0 ? Slope0 : k == 1 ? Slope1 : k == 2 ? Slope2 : Slope3;

        public double Bend(int k) => k == 0 ? Bend0 : k == 1 ? Bend1 : k == 2 ? Bend2 : Bend3;
    }

    /// <summary>The surface y = h(x, z) at a point, with its derivatives.</summary>
    private struct Patch
    {
        public double Height;
        public double SlopeX;
        public double SlopeZ;
        public double XX;
        public double XZ;
        public double ZZ;

        public readonly Vector3d Normal
        {
            get
            {
                double per = 1.0 / Math.Sqrt(1.0 + (SlopeX * SlopeX) + (SlopeZ * SlopeZ));
                return new Vector3d(-SlopeX * per, per, -SlopeZ * per);
            }
        }

        /// <summary>The larger principal curvature, |M| + √(M² − K), from the mean curvature M and the Gaussian curvature K.</summary>
        public readonly double StrongestCurvature
        {
            get
            {
                // (e, f, g) is the first fundamental form; (h_xx, h_xz, h_zz)/√(e g − f²) is the second.
                double e = 1.0 + (SlopeX * SlopeX);
                double f = SlopeX * SlopeZ;
                double g = 1.0 + (SlopeZ * SlopeZ);
                double area = (e * g) - (f * f);
                double per = 1.0 / Math.Sqrt(area);
                double mean = 0.5 * per * ((e * ZZ) - (2.0 * f * XZ) + (g * XX)) / area;
                double gaussian = per * per * ((XX * ZZ) - (XZ * XZ)) / area;
                return Math.Abs(mean) + Math.Sqrt(Math.Max(0, (mean * mean) - gaussian));
            }
        }

        /// <summary>Returns the Hessian of the distance at a distance d: −J I⁻¹ II (I − d II)⁻¹ Jᵀ, where J = (S_x, S_z).</summary>
        /// <remarks>I and II are the fundamental forms.</remarks>
        public readonly SymmetricMatrix3d CurvatureAt(double distance)
        {
            double e = 1.0 + (SlopeX * SlopeX);
            double f = SlopeX * SlopeZ;
            double g = 1.0 + (SlopeZ * SlopeZ);
            double area = (e * g) - (f * f);
            double per = 1.0 / Math.Sqrt(area);
            double l = per * XX;
            double m = per * XZ;
            double n = per * ZZ;

            // A = I⁻¹ II, B = (I − d II)⁻¹
            double axx = ((g * l) - (f * m)) / area;
            double axz = ((g * m) - (f * n)) / area;
            double azx = ((e * m) - (f * l)) / area;
            double azz = ((e * n) - (f * m)) / area;
            double bxx = e - (distance * l);
            double bxz = f - (distance * m);
            double bzz = g - (distance * n);
            double determinant = (bxx * bzz) - (bxz * bxz);
            double cxx = -((axx * bzz) - (axz * bxz)) / determinant;
            double cxz = -((axz * bxx) - (axx * bxz)) / determinant;
            double czz = -((azz * bxx) - (azx * bxz)) / determinant;

            // J = ((1, h_x, 0), (0, h_z, 1))
            double yx = (cxx * SlopeX) + (cxz * SlopeZ);
            double yz = (cxz * SlopeX) + (czz * SlopeZ);
            double yy = (yx * SlopeX) + (yz * SlopeZ);
            return new SymmetricMatrix3d(cxx, yx, cxz, yy, yz, czz);
        }
    }
}
