namespace FootballPhysics.Labs.Scenes;

/// <summary>
/// A ball on a plane or a cylinder that moves and turns, in an inertial frame without air: the equations of slip and roll at the contact point, in steps of
/// 0.05 ms by the classical Runge-Kutta method. It shares no code with the library.
/// </summary>
/// <param name="Radius">Radius of the ball, m.</param>
/// <param name="Inertia">Its inertia factor.</param>
/// <param name="Gravity">Gravity, m/s².</param>
/// <param name="Sliding">The coefficient of sliding friction.</param>
/// <param name="Rolling">The coefficient of rolling friction.</param>
/// <param name="RollingBySpeed">Its growth with speed, s/m.</param>
/// <param name="Damping">The rate at which the spin about the normal is damped, c/I, 1/s.</param>
/// <param name="ShapeTurns">True if the shape itself turns, false if only its surface does.</param>
/// <param name="Curve">The radius of a cylinder, m; 0 for a plane.</param>
/// <param name="Axis">The axis of a cylinder, of length 1, through the pivot.</param>
/// <param name="Normal">The normal of a plane, of length 1, through the pivot's start.</param>
internal sealed record CarrierModel(
    double Radius, double Inertia, Vector3d Gravity, double Sliding, double Rolling, double RollingBySpeed, double Damping, bool ShapeTurns, double Curve, Vector3d Axis, Vector3d Normal)
{
    private const double Longest = 5e-5;

    /// <summary>A slip below this, m/s, has ended.</summary>
    private const double NoSlip = 1e-11;

    private Vector3d _ahead;
    private bool _slides;

    /// <summary>The carrier's pivot, velocity and spin.</summary>
    public Vector3d Pivot { get; set; }

    public Vector3d Velocity { get; set; }

    public Vector3d Spin { get; set; }

    public Vector3d Place { get; set; }

    public Vector3d Moves { get; set; }

    public Vector3d Turns { get; set; }

    /// <summary>The smallest load so far, as a share of the ball's weight, and the smallest speed over the carrier while the ball rolled, m/s.</summary>
    public double LeastLoad { get; private set; } = double.PositiveInfinity;

    /// <summary>True if friction no longer held a ball that rolled.</summary>
    public bool LostGrip { get; private set; }

    public double SlowestRoll { get; private set; } = double.PositiveInfinity;

    /// <summary>Advances with the current motion of the carrier; a change of this motion becomes slip.</summary>
    public void Advance(double duration)
    {
        _slides |= Slip(Place, Moves, Turns).Length > NoSlip;
        double left = duration;
        while (left > 1e-15)
        {
            double h = Math.Min(Longest, left);
            if (!_slides && !Grips())
            {
                // The direction of a new slip is stiff: these explicit steps cannot follow it to the limit of the comparison.
                _slides = true;
                LostGrip = true;
                _ahead = -Hold(Place, Moves, Turns).Normalized();
            }

            if (_slides)
            {
                // The direction of the slip turns ever faster towards its end, so the steps shrink with it.
                double ends = Slip(Place, Moves, Turns).Length / ((1 + (1 / Inertia)) * Sliding * Math.Max(Load(Place, Moves), 1e-9));
                h = ends > 1e-15 ? Math.Min(h, 0.2 * ends) : h;
            }

            Step(h);
            Pivot += h * Velocity;
            left -= h;
            if (_slides && Slip(Place, Moves, Turns).Length < NoSlip && Grips())
            {
                _slides = false;
            }

            if (!_slides)
            {
                RollWithoutSlip();
                SlowestRoll = Math.Min(SlowestRoll, Over(Place, Moves).Length);
            }

            LeastLoad = Math.Min(LeastLoad, Load(Place, Moves) / Gravity.Length);
        }
    }

    private Vector3d NormalAt(in Vector3d p) => Curve > 0 ? LabMath.Along(p - Pivot, Axis).Normalized() : Normal;

    /// <summary>Returns H v, the rate at which the normal turns along a motion.</summary>
    private Vector3d Bend(in Vector3d p, in Vector3d v)
    {
        if (Curve == 0)
        {
            return default;
        }

        Vector3d n = NormalAt(p);
        return LabMath.Along(LabMath.Along(v, n), Axis) / (Curve + Radius);
    }

    /// <summary>Returns q, the velocity relative to the shape.</summary>
    private Vector3d Relative(in Vector3d p, in Vector3d v) => v - Velocity - (ShapeTurns ? Vector3d.Cross(Spin, p - Pivot) : default);

    private Vector3d NormalRate(in Vector3d p, in Vector3d v) => Bend(p, Relative(p, v)) + (ShapeTurns ? Vector3d.Cross(Spin, NormalAt(p)) : default);

    /// <summary>Returns A_s, the acceleration that the shape gives a ball that follows it.</summary>
    private Vector3d Frame(in Vector3d p, in Vector3d v) => ShapeTurns
        ? Vector3d.Cross(Spin, Vector3d.Cross(Spin, p - Pivot)) + (2 * Vector3d.Cross(Spin, Relative(p, v)))
        : default;

    /// <summary>Returns N/m, m/s².</summary>
    private double Load(in Vector3d p, in Vector3d v)
    {
        Vector3d q = Relative(p, v);
        return -Vector3d.Dot(Gravity - Frame(p, v), NormalAt(p)) - Vector3d.Dot(q, Bend(p, q));
    }

    private Vector3d SurfaceVelocity(in Vector3d p) => Velocity + Vector3d.Cross(Spin, p - (Radius * NormalAt(p)) - Pivot);

    private Vector3d Slip(in Vector3d p, in Vector3d v, in Vector3d w)
    {
        Vector3d n = NormalAt(p);
        return LabMath.Along(v - SurfaceVelocity(p), n) + (Radius * Vector3d.Cross(n, w));
    }

    /// <summary>Returns the velocity over the carrier's material, which rolling friction opposes.</summary>
    private Vector3d Over(in Vector3d p, in Vector3d v) => LabMath.Along(v - Velocity - Vector3d.Cross(Spin, p - Pivot), NormalAt(p));

    /// <summary>Returns A_t + r ω_n n × ṅ: the rate of the surface's velocity along the path, plus the share of the ball's own spin about the normal.</summary>
    private Vector3d Drag(in Vector3d p, in Vector3d v, in Vector3d w)
    {
        Vector3d n = NormalAt(p);
        Vector3d rate = NormalRate(p, v);
        Vector3d surface = Vector3d.Cross(Spin, v - (Radius * rate) - Velocity);
        return LabMath.Along(surface, n) + (Radius * Vector3d.Dot(w, n) * Vector3d.Cross(n, rate));
    }

    /// <summary>Returns F/m, the friction that keeps the ball from slipping.</summary>
    private Vector3d Hold(in Vector3d p, in Vector3d v, in Vector3d w) => Inertia / (1 + Inertia) * (Drag(p, v, w) - LabMath.Along(Gravity, NormalAt(p)));

    private bool Grips() => Hold(Place, Moves, Turns).Length <= Sliding * Load(Place, Moves);

    private void RollWithoutSlip()
    {
        Vector3d n = NormalAt(Place);
        Turns = (Vector3d.Dot(Turns, n) * n) + (Vector3d.Cross(n, Moves - SurfaceVelocity(Place)) / Radius);
    }

    private void Rates(in Vector3d p, in Vector3d v, in Vector3d w, out Vector3d acceleration, out Vector3d spin)
    {
        Vector3d n = NormalAt(p);
        Vector3d q = Relative(p, v);
        Vector3d rate = NormalRate(p, v);
        double load = Load(p, v);
        double follows = Vector3d.Dot(Frame(p, v), n) - Vector3d.Dot(q, Bend(p, q));
        Vector3d damping = -Damping * Vector3d.Dot(w - Spin, n) * n;
        if (_slides)
        {
            Vector3d slip = Slip(p, v, w);
            Vector3d direction = slip.Length > 0.1 * NoSlip ? slip.Normalized() : _ahead;
            acceleration = LabMath.Along(Gravity, n) - (Sliding * load * direction) + (follows * n);
            spin = (Sliding * load / (Inertia * Radius) * Vector3d.Cross(n, direction)) + damping;
            return;
        }

        Vector3d over = Over(p, v);
        double speed = over.Length;
        Vector3d brakes = speed > 0 ? (Rolling + (RollingBySpeed * speed)) * load / speed * over : default;
        acceleration = ((LabMath.Along(Gravity, n) + (Inertia * Drag(p, v, w))) / (1 + Inertia)) - brakes + (follows * n);

        // ω = ω_n n + n × (v − V_c)/r: the tangential part follows from the path, so only ω_n is integrated, as X.
        Vector3d about = Vector3d.Dot(w, n) * n;
        spin = new Vector3d(Vector3d.Dot(damping, n) + Vector3d.Dot(w - about, rate), 0, 0);
    }

    private void Step(double h)
    {
        Vector3d p = Place, v = Moves, w = Turns, o = Pivot;
        double about = Vector3d.Dot(w, NormalAt(p));
        Rates(p, v, w, out Vector3d a1, out Vector3d s1);
        Pivot = o + (0.5 * h * Velocity);
        (Vector3d p2, Vector3d v2) = (p + (0.5 * h * v), v + (0.5 * h * a1));
        Rates(p2, v2, Spun(w, about, s1, 0.5 * h, p2, v2), out Vector3d a2, out Vector3d s2);
        (Vector3d p3, Vector3d v3) = (p + (0.5 * h * v2), v + (0.5 * h * a2));
        Rates(p3, v3, Spun(w, about, s2, 0.5 * h, p3, v3), out Vector3d a3, out Vector3d s3);
        Pivot = o + (h * Velocity);
        (Vector3d p4, Vector3d v4) = (p + (h * v3), v + (h * a3));
        Rates(p4, v4, Spun(w, about, s3, h, p4, v4), out Vector3d a4, out Vector3d s4);
        Place = p + (h / 6 * (v + (2 * v2) + (2 * v3) + v4));
        Moves = v + (h / 6 * (a1 + (2 * a2) + (2 * a3) + a4));
        Turns = Spun(w, about, s1 + (2 * s2) + (2 * s3) + s4, h / 6, Place, Moves);
        Pivot = o;
    }

    /// <summary>Returns the spin after a part of a step, at the position and velocity reached there.</summary>
    private Vector3d Spun(in Vector3d w, double about, in Vector3d rate, double h, in Vector3d place, in Vector3d moves)
    {
        if (_slides)
        {
            return w + (h * rate);
        }

        Vector3d n = NormalAt(place);
        return ((about + (h * rate.X)) * n) + (Vector3d.Cross(n, moves - SurfaceVelocity(place)) / Radius);
    }
}
