using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Shapes;

/// <summary>Uneven ground: a smooth surface through the heights at the nodes of a grid.</summary>
/// <remarks>
/// The surface is a uniform cubic B-spline. Let u, w be the fractional parts of ((x − x₀)/δ, (z − z₀)/δ), and i, j their floors. Then y = Σ b_k(u) b_l(w)
/// c[i−1+k][j−1+l], k, l = 0…3, b = ((1−u)³, 3u³−6u²+4, −3u³+3u²+3u+1, u³)/6. The constructor takes heights, and solves for the control values c.
/// <see cref="FromControlValues"/> takes the control values.
/// <para>A ball can rest on it if its slope is at most 1 and its curvature at most 1/(2r). Between nodes, the surface can be steeper, higher or lower
/// than at the nodes.</para>
/// </remarks>
public sealed class HeightField : IShape, IExactHollow
{
    /// <summary>The samples per cell and direction in the search for the steepest slope and the strongest curvature.</summary>
    private const int SamplesOfCell = 4;

    /// <summary>The step of Newton's method at which the search for the nearest point ends, in m.</summary>
    private const double Closeness = 1e-15;

    private const int MostIterations = 30;

    /// <summary>The distance up to which the nearest point is computed, relative to the radius of curvature.</summary>
    private const double NearBy = 0.8;

    /// <summary>The heights at the nodes; null if control values were given.</summary>
    private readonly double[,]? _nodes;

    private readonly double[] _values;
    private readonly int _rows;
    private readonly int _columns;
    private readonly double _highest;

    /// <summary>The x coordinate of the first control value, in m.</summary>
    private readonly double _firstX;

    /// <summary>The z coordinate of the first control value, in m.</summary>
    private readonly double _firstZ;

    /// <summary>Creates uneven ground that passes through the given heights.</summary>
    /// <remarks>
    /// A plane stays a plane within the grid: at the border, the second derivative is zero (a natural spline). Beyond the border, the surface becomes level
    /// within two spacings.
    /// <para>Between nodes, the surface can overshoot: by 14 % of the height of a single raised node, below its neighbours, and by 11 % of a step between
    /// two levels. In the worst case, it leaves the range of the heights by 70 % of that range. The overshoot is small if the heights change smoothly from
    /// node to node. In JSON, these are the <c>nodes</c> of <c>heights</c>.</para>
    /// </remarks>
    /// <param name="originX">The x coordinate of the first node, in m; within ±1e6.</param>
    /// <param name="originZ">The z coordinate of the first node, in m; within ±1e6.</param>
    /// <param name="spacing">The distance δ between neighbouring nodes, in m; above 0, at most 1e6.</param>
    /// <param name="heights">The heights at the nodes (x₀ + iδ, z₀ + jδ), in m, as heights[i, j]; at least one, each within ±1e6. They are copied.</param>
    /// <exception cref="ArgumentNullException"><paramref name="heights"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public HeightField(double originX, double originZ, double spacing, double[,] heights)
        : this(originX, originZ, spacing, heights, nameof(heights), areNodes: true)
    {
    }

    /// <param name="originX">The x coordinate of the first entry, in m.</param>
    /// <param name="originZ">The z coordinate of the first entry, in m.</param>
    /// <param name="spacing">The distance δ between neighbours, in m.</param>
    /// <param name="table">The heights at the nodes, or the control values.</param>
    /// <param name="field">The name of the table in messages.</param>
    /// <param name="areNodes">True if the surface passes through the entries; false if they are control values.</param>
    internal HeightField(double originX, double originZ, double spacing, double[,] table, string field, bool areNodes)
    {
        if (table is null)
        {
            throw new ArgumentNullException(field);
        }

        Check.Within("origin[0]", originX, -Limits.Length, Limits.Length);
        Check.Within("origin[1]", originZ, -Limits.Length, Limits.Length);
        Check.Within("spacing", spacing, 0, Limits.Length, exclusiveLow: true);
        int rows = table.GetLength(0);
        int columns = table.GetLength(1);
        if (rows < 1 || columns < 1)
        {
            throw Check.Refusal(field, $"{rows} × {columns}", "at least 1 × 1 heights");
        }

        for (int i = 0; i < rows; i++)
        {
            for (int j = 0; j < columns; j++)
            {
                Check.Within($"{field}[{i}][{j}]", table[i, j], -Limits.Length, Limits.Length);
            }
        }

        OriginX = originX;
        OriginZ = originZ;
        Spacing = spacing;

        // Copy the table, so that later changes to the array do not move the ground under a ball. The control values of nodes extend one spacing beyond them.
        _nodes = areNodes ? (double[,])table.Clone() : null;
        _values = areNodes ? SplineNodes.ControlValues(table) : new double[table.Length];
        if (!areNodes)
        {
            Buffer.BlockCopy(table, 0, _values, 0, table.Length * sizeof(double));
        }

        int beyond = areNodes ? 1 : 0;
        _rows = rows + (2 * beyond);
        _columns = columns + (2 * beyond);
        _firstX = originX - (beyond * spacing);
        _firstZ = originZ - (beyond * spacing);
        _highest = _values.Max();
        (Steepest, Strongest) = Extremes();
    }

    private HeightField(HeightField other, double by)
    {
        OriginX = other.OriginX;
        OriginZ = other.OriginZ;
        Spacing = other.Spacing;
        Steepest = other.Steepest;
        Strongest = other.Strongest;
        _rows = other._rows;
        _columns = other._columns;
        _firstX = other._firstX;
        _firstZ = other._firstZ;
        _highest = other._highest + by;
        _values = [.. other._values.Select(value => value + by)];
    }

    /// <summary>Creates uneven ground from the control values of the spline.</summary>
    /// <remarks>
    /// The surface is smoother than the control values and does not pass through them: a single value of 1 m gives 0.444 m at its position. It never leaves
    /// their range. Beyond the grid, the values at the border are repeated. In JSON, these are the <c>values</c> of <c>heights</c>.
    /// </remarks>
    /// <param name="originX">The x coordinate of the first value, in m; within ±1e6.</param>
    /// <param name="originZ">The z coordinate of the first value, in m; within ±1e6.</param>
    /// <param name="spacing">The distance δ between neighbours, in m; above 0, at most 1e6.</param>
    /// <param name="values">The control values c[i, j], in m, with i along x and j along z; at least one, each within ±1e6. They are copied.</param>
    /// <returns>The ground.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="values"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public static HeightField FromControlValues(double originX, double originZ, double spacing, double[,] values) =>
        new(originX, originZ, spacing, values, nameof(values), areNodes: false);

    /// <summary>The x coordinate of the first node or control value, in m.</summary>
    internal double OriginX { get; }

    /// <summary>The z coordinate of the first node or control value, in m.</summary>
    internal double OriginZ { get; }

    /// <summary>The distance δ between neighbours, in m.</summary>
    public double Spacing { get; }

    /// <summary>The steepest slope, from samples in every cell.</summary>
    internal Extreme Steepest { get; }

    /// <summary>The strongest curvature, from samples in every cell, in 1/m.</summary>
    internal Extreme Strongest { get; }

    /// <summary>True if the surface passes through the given heights; false if control values were given.</summary>
    internal bool HasNodes => _nodes is not null;

    /// <summary>The heights at the nodes or the control values, as given, row by row.</summary>
    internal IEnumerable<IEnumerable<double>> Rows => _nodes is { } nodes
        ? Enumerable.Range(0, nodes.GetLength(0)).Select(i => Enumerable.Range(0, nodes.GetLength(1)).Select(j => nodes[i, j]))
        : Enumerable.Range(0, _rows).Select(i => _values.Skip(i * _columns).Take(_columns));

    /// <inheritdoc/>
    double IShape.MaximumConcaveCurvature => Strongest.Value;

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
        if (Math.Abs(above) * Strongest.Value > NearBy)
        {
            // The lower bound is the vertical distance divided by √(1 + slope²).
            Vector3d up = patch.Normal;
            return new ShapePoint(above / Math.Sqrt(1.0 + (Steepest.Value * Steepest.Value)), in up, SymmetricMatrix3d.Zero);
        }

        // S is the point of the surface, S_x and S_z are its derivatives, and p is the given point.
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

    private (Extreme Slope, Extreme Curvature) Extremes()
    {
        Extreme slope = default;
        Extreme curvature = default;

        // Include the cells beyond the border, because the surface still curves there.
        for (int i = -SamplesOfCell; i <= (_rows + 1) * SamplesOfCell; i++)
        {
            for (int j = -SamplesOfCell; j <= (_columns + 1) * SamplesOfCell; j++)
            {
                double x = _firstX + (i * Spacing / SamplesOfCell);
                double z = _firstZ + (j * Spacing / SamplesOfCell);
                Patch patch = Sample(x, z);
                bool isBetween = HasNodes && (i % SamplesOfCell != 0 || j % SamplesOfCell != 0);
                slope = slope.Or(Math.Sqrt((patch.SlopeX * patch.SlopeX) + (patch.SlopeZ * patch.SlopeZ)), x, z, isBetween);
                curvature = curvature.Or(patch.StrongestCurvature, x, z, isBetween);
            }
        }

        return (slope, curvature);
    }

    /// <summary>Returns the height and its derivatives at a point.</summary>
    private Patch Sample(double x, double z)
    {
        double u = (x - _firstX) / Spacing;
        double w = (z - _firstZ) / Spacing;

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

            // I and II are the fundamental forms, and d is the distance from the surface.
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

            // h_x and h_z are the slopes.
            // J = ((1, h_x, 0), (0, h_z, 1))
            double yx = (cxx * SlopeX) + (cxz * SlopeZ);
            double yz = (cxz * SlopeX) + (czz * SlopeZ);
            double yy = (yx * SlopeX) + (yz * SlopeZ);
            return new SymmetricMatrix3d(cxx, yx, cxz, yy, yz, czz);
        }
    }

    /// <summary>The largest value of a quantity over the surface, and its position.</summary>
    /// <param name="Value">The value.</param>
    /// <param name="X">The x coordinate, in m.</param>
    /// <param name="Z">The z coordinate, in m.</param>
    /// <param name="IsBetween">True if the position is not a point of the grid.</param>
    internal readonly record struct Extreme(double Value, double X, double Z, bool IsBetween)
    {
        /// <summary>Of two values that differ less than this share, the first has the position.</summary>
        private const double Equal = 1e-12;

        /// <summary>Returns the larger of this value and another one.</summary>
        public Extreme Or(double value, double x, double z, bool isBetween) =>
            value > Value * (1.0 + Equal) ? new Extreme(value, x, z, isBetween)
            : value > Value ? this with { Value = value }
            : this;

        /// <summary>Returns the field for messages: the quantity, and its position if it is between nodes.</summary>
        /// <param name="quantity">The name of the quantity.</param>
        public string Field(string quantity) => FormattableString.Invariant($"ground.heights ({quantity}, {(IsBetween ? "between nodes, " : "")}at x {X:G6}, z {Z:G6})");
    }
}
