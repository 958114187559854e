using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>A net prepared for queries: the depth of the ball in it, and its force on the ball.</summary>
internal sealed class NetSheet
{
    /// <summary>The end of every net: no bounce and no friction.</summary>
    private static readonly ContactMaterial s_end = new(0, 0, 0);

    private readonly Vector3d _center;
    private readonly Vector3d _along;
    private readonly Vector3d _across;
    private readonly double _radius;
    private readonly double _stiffness;
    private readonly double _damping;
    private readonly double _tangential;
    private readonly double _spin;

    public NetSheet(Net net, BallProperties ball)
    {
        Name = net.Name;
        _center = net.Center;
        Normal = Check.Direction("normal", net.Normal);
        _along = Check.Direction("along", net.Along);
        _across = Vector3d.Cross(Normal, in _along);
        HalfLength = net.HalfLength;
        HalfWidth = net.HalfWidth;
        Give = net.Give;
        _radius = ball.Radius;
        _stiffness = net.Stiffness / ball.Mass;
        _damping = net.Damping;
        _tangential = net.TangentialDamping / ball.Mass;
        _spin = net.SpinDamping / ball.MomentOfInertia;
    }

    /// <summary>Its name.</summary>
    public string Name { get; }

    /// <summary>Normal of its plane.</summary>
    public Vector3d Normal { get; }

    /// <summary>Half size in its first direction, m.</summary>
    public double HalfLength { get; }

    /// <summary>Half size in its second direction, m.</summary>
    public double HalfWidth { get; }

    /// <summary>The greatest depth of a ball, m.</summary>
    public double Give { get; }

    /// <summary>The speed at which it returns on its own, 1/b, m/s.</summary>
    public double ReturnSpeed => 1.0 / _damping;

    /// <summary>Its bounding box.</summary>
    public Bounds3d Bounds => Bounds3d.Around(
        _center,
        (HalfLength * Math.Abs(_along.X)) + (HalfWidth * Math.Abs(_across.X)),
        (HalfLength * Math.Abs(_along.Y)) + (HalfWidth * Math.Abs(_across.Y)),
        (HalfLength * Math.Abs(_along.Z)) + (HalfWidth * Math.Abs(_across.Z)));

    /// <summary>True if another sheet has the same position and size, regardless of its material.</summary>
    public bool IsAt(NetSheet other) =>
        _center == other._center && Normal == other.Normal && _along == other._along && HalfLength == other.HalfLength && HalfWidth == other.HalfWidth;

    /// <summary>Returns σ of a net.</summary>
    public static double SideOf(ulong sides, int net) => (sides >> net & 1) != 0 ? 1.0 : -1.0;

    /// <summary>Returns the end of the net for a ball on a side: the plane δ = give, as a stationary surface with normal σ n.</summary>
    public Collider EndOn(double side) =>
        new(Name, new PlaneShape(side * Normal, (side * Vector3d.Dot(in _center, Normal)) - Give), in s_end) { IsNetEnd = true };

    /// <summary>Converts a vector to the sheet's axes: along, across, off its plane.</summary>
    public Vector3d InFrame(in Vector3d vector) =>
        new(Vector3d.Dot(in vector, in _along), Vector3d.Dot(in vector, in _across), Vector3d.Dot(in vector, Normal));

    /// <summary>Converts a position to the sheet's axes, relative to its centre.</summary>
    public Vector3d PlaceInFrame(in Vector3d position) => InFrame(position - _center);

    /// <summary>Returns the distance of a position beyond an edge of the sheet, or off its plane, m.</summary>
    /// <param name="axis">0 or 1 for an edge along the sheet, 2 for the plane.</param>
    /// <param name="sign">The side of that axis.</param>
    /// <param name="position">The position, m.</param>
    /// <param name="velocity">The velocity, m/s.</param>
    /// <param name="rate">The rate of the distance, m/s.</param>
    public double Beyond(int axis, double sign, in Vector3d position, in Vector3d velocity, out double rate)
    {
        Vector3d direction = axis == 0 ? _along : axis == 1 ? _across : Normal;
        rate = sign * Vector3d.Dot(in velocity, in direction);
        return (sign * Vector3d.Dot(position - _center, in direction)) - (axis == 0 ? HalfLength : axis == 1 ? HalfWidth : 0);
    }

    /// <summary>Depth of the ball, δ = r − σ (p − c)·n, m.</summary>
    public double Depth(in Vector3d position, double side) => _radius - (side * Vector3d.Dot(position - _center, Normal));

    /// <summary>δ̇, m/s.</summary>
    public double DepthRate(in Vector3d velocity, double side) => -side * Vector3d.Dot(in velocity, Normal);

    /// <summary>1 + b δ̇, the factor of the force.</summary>
    /// <remarks>If it is negative, the ball leaves faster than the net follows.</remarks>
    public double Tension(in Vector3d velocity, double side) => 1.0 + (_damping * DepthRate(in velocity, side));

    /// <summary>b δ̈, 1/s.</summary>
    public double TensionRate(in Vector3d acceleration, double side) => _damping * DepthRate(in acceleration, side);

    /// <summary>Upper bound of the distance from the net's centre to a ball that entered at a given speed, m.</summary>
    /// <remarks>At this distance the net holds all of the ball's energy, in any direction. Infinite without stiffness.</remarks>
    public double FarthestIn(double speed) => HalfLength + HalfWidth + (2.0 * _radius) + (speed / Math.Sqrt(_stiffness));

    /// <summary>Returns how fast the net changes the motion at a depth, 1/s.</summary>
    public double RateAt(double depth) => (depth * RatePerDepth) + Math.Sqrt(_stiffness);

    /// <summary>Increase of this rate per metre of depth, 1/(m s).</summary>
    public double RatePerDepth => (_stiffness * _damping) + _tangential + _spin;

    /// <summary>Bounds the distance of a piece's path from the quintic through the positions, velocities and accelerations at its ends,
    /// m.</summary>
    /// <remarks>
    /// It is |x⁽⁶⁾| h⁶/46080 with |x⁽⁶⁾| ≤ λ⁴ |a| for a force that settles at the rate λ. The net's pull and its drag have different rates.
    /// </remarks>
    public double Bends(in Vector3d position, in Vector3d velocity, double side, double h)
    {
        // The maximum depth that the ball can reach within h.
        double depth = Math.Max(0, Depth(in position, side)) + (h * velocity.Length);
        double off = Vector3d.Dot(in velocity, Normal);
        double pull = _stiffness * depth * Math.Max(0, Tension(in velocity, side));
        double drag = _tangential * depth * (velocity - (off * Normal)).Length;

        // λ h to the fourth power for the rates λ of the pull, k b δ + √k, and of the drag, k_t δ: stiffness k, damping b, depth δ, drag k_t along the net.
        double pulls = h * ((_stiffness * _damping * depth) + Math.Sqrt(_stiffness));
        double drags = h * _tangential * depth;
        pulls *= pulls;
        drags *= drags;
        return h * h * Math.Max(pull * pulls * pulls, drag * drags * drags) / 46080.0;
    }

    /// <summary>Returns the force on a ball in the net: F/m = σ k δ max(0, 1 + b δ̇) n − k_t δ v_t, T/I = −k_ω δ ω.</summary>
    public MotionRates Push(in Motion at, double side) => Push(in at, side, Tension(in at.Velocity, side) < 0);

    /// <summary>Returns the same force, on one side of its kink: without its first term if the net counts as slack, otherwise with 1 + b δ̇ of any
    /// sign.</summary>
    public MotionRates Push(in Motion at, double side, bool isSlack)
    {
        double depth = Math.Max(0, Depth(in at.Position, side));
        double off = Vector3d.Dot(in at.Velocity, Normal);
        Vector3d tangential = at.Velocity - (off * Normal);
        double normal = isSlack ? 0 : side * _stiffness * depth * Tension(in at.Velocity, side);
        return new MotionRates((normal * Normal) - ((_tangential * depth) * tangential), (-_spin * depth) * at.Spin);
    }
}
