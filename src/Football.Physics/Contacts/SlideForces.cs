namespace FootballPhysics.Contacts;

/// <summary>Loads and friction of a ball that slips on two stationary surfaces with constant normals: <see cref="ContactForces"/> in closed
/// form.</summary>
/// <remarks>The ball has the velocity x a, with a across both normals, and any spin.</remarks>
internal struct SlideForces
{
    /// <summary>a.</summary>
    public Vector3d Along;

    /// <summary>Directions of the slips at the start. Friction keeps these directions if a stage passes zero.</summary>
    public Vector3d FirstDirection;
    public Vector3d SecondDirection;

    /// <summary>True if drilling friction acts at the second surface (the bearer).</summary>
    public bool IsSecondBearer;

    /// <summary>Sign of the ball's spin about the bearer's normal.</summary>
    public double SpinSign;

    private Vector3d _first;
    private Vector3d _second;
    private Vector3d _bearer;
    private bool _holdsSpin;
    private double _cosine;
    private double _radius;
    private double _perTurn;
    private double _firstSliding;
    private double _secondSliding;
    private double _damping;
    private double _drilling;

    /// <summary>Prepares two surfaces.</summary>
    /// <returns>False if their normals define no line.</returns>
    public bool Prepare(in Touched first, in Touched second, BallProperties ball)
    {
        Vector3d along = Vector3d.Cross(in first.Normal, in second.Normal);
        double size = along.Length;
        Along = along / size;
        _first = first.Normal;
        _second = second.Normal;
        _cosine = Vector3d.Dot(in _first, in _second);
        _radius = ball.Radius;
        _perTurn = 1.0 / (ball.InertiaFactor * ball.Radius);
        _firstSliding = first.Sliding;
        _secondSliding = second.Sliding;
        return size > ContactTolerances.Independent;
    }

    /// <summary>Sets the bearer. Drilling friction may hold the spin about its normal at zero.</summary>
    public void Bear(bool isSecond, in Touched bearer, ref Vector3d spin)
    {
        IsSecondBearer = isSecond;
        _bearer = bearer.Normal;
        _damping = bearer.Damping;
        _drilling = bearer.Drilling;
        double about = About(in spin);
        SpinSign = about > ContactTolerances.Rolling ? 1.0 : about < -ContactTolerances.Rolling ? -1.0 : 0.0;
        _holdsSpin = SpinSign == 0 && _drilling > 0;
        spin -= _holdsSpin ? about * _bearer : Vector3d.Zero;
    }

    /// <summary>The slip at the first surface, m/s.</summary>
    public readonly Vector3d FirstSlip(double speed, in Vector3d spin) => (speed * Along) + (_radius * Vector3d.Cross(in _first, in spin));

    /// <summary>The slip at the second surface, m/s.</summary>
    public readonly Vector3d SecondSlip(double speed, in Vector3d spin) => (speed * Along) + (_radius * Vector3d.Cross(in _second, in spin));

    /// <summary>The spin about the bearer's normal, rad/s.</summary>
    public readonly double About(in Vector3d spin) => Vector3d.Dot(in spin, in _bearer);

    /// <summary>True if drilling friction brakes that spin.</summary>
    public readonly bool Drills => _drilling > 0 && SpinSign != 0;

    /// <summary>Computes rates and loads at a state: n₁·v̇ = n₂·v̇ = 0 with F = −μ N ŝ at both.</summary>
    /// <param name="push">Acceleration without contacts, m/s².</param>
    /// <param name="torque">Angular acceleration without contacts, rad/s².</param>
    /// <param name="speed">x, m/s.</param>
    /// <param name="spin">ω, rad/s.</param>
    /// <param name="rates">The rates and loads; NaN if the loads are not determined.</param>
    public readonly void Evaluate(in Vector3d push, in Vector3d torque, double speed, in Vector3d spin, out SlideRates rates)
    {
        Vector3d first = Unit(FirstSlip(speed, in spin), in FirstDirection);
        Vector3d second = Unit(SecondSlip(speed, in spin), in SecondDirection);

        Load(in push, in first, in second, out rates.First, out rates.Second);

        // v̇ = A − Σ μ N ŝ along the line; ω̇ = T + Σ μ N n × ŝ/(α r), minus the bearer's resistance about its own normal.
        double firstRub = _firstSliding * rates.First;
        double secondRub = _secondSliding * rates.Second;
        double most = _drilling * (IsSecondBearer ? rates.Second : rates.First);
        rates.Along = Vector3d.Dot(in push, in Along) - (firstRub * Vector3d.Dot(in first, in Along)) - (secondRub * Vector3d.Dot(in second, in Along));
        rates.Spin = torque + (_perTurn * ((firstRub * Vector3d.Cross(in _first, in first)) + (secondRub * Vector3d.Cross(in _second, in second))));
        double held = About(in rates.Spin);
        rates.Spin -= (_holdsSpin ? held : (_damping * About(in spin)) + (SpinSign * most)) * _bearer;
        rates.HoldSpin = _holdsSpin ? most - Math.Abs(held) : 1.0;
    }

    /// <summary>Computes the loads: N₁ + p N₂ = −A·n₁ and q N₁ + N₂ = −A·n₂.</summary>
    /// <remarks>p and q are the cosine of the angle between the normals, minus the share of the other surface's friction in the load.</remarks>
    /// <param name="push">Acceleration without contacts, m/s².</param>
    /// <param name="firstSlip">ŝ₁.</param>
    /// <param name="secondSlip">ŝ₂.</param>
    /// <param name="first">N₁/m, m/s²; NaN if the loads are not determined.</param>
    /// <param name="second">N₂/m, m/s².</param>
    public readonly void Load(in Vector3d push, in Vector3d firstSlip, in Vector3d secondSlip, out double first, out double second)
    {
        double p = _cosine - (_secondSliding * Vector3d.Dot(in secondSlip, in _first));
        double q = _cosine - (_firstSliding * Vector3d.Dot(in firstSlip, in _second));
        double determinant = 1.0 - (p * q);
        double per = determinant > ContactTolerances.LeastDeterminant ? 1.0 / determinant : double.NaN;
        double onFirst = -Vector3d.Dot(in push, in _first);
        double onSecond = -Vector3d.Dot(in push, in _second);
        first = per * (onFirst - (p * onSecond));
        second = per * (onSecond - (q * onFirst));
    }

    private static Vector3d Unit(in Vector3d slip, in Vector3d direction)
    {
        double size = slip.Length;
        return Vector3d.Dot(in slip, in direction) > 0 ? slip / size : direction;
    }
}

/// <summary>Rates of a ball that slips on two surfaces, and its loads.</summary>
internal struct SlideRates
{
    /// <summary>ẍ, m/s², and ω̇, rad/s².</summary>
    public double Along;
    public Vector3d Spin;

    /// <summary>N/m, m/s².</summary>
    public double First;
    public double Second;

    /// <summary>The reserve of drilling friction that holds the spin about the bearer's normal, rad/s²; positive if it does not hold the spin.</summary>
    public double HoldSpin;
}
