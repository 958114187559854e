namespace Football.Physics;

/// <summary>
/// The library's own solver for a point on the way and a target: four unknowns (elevation, azimuth, top and side spin), four
/// equations (the crossings of both points' planes). Start and Jacobian in closed form, Broyden's updates. A spin at its limit is
/// held there, and the point on the way is then missed, in its direction, by as little as that allows; the target is hit all the same.
/// </summary>
internal sealed class DirectTwoPointAim : IAimMethod
{
    private const double Degree = Math.PI / 180.0;
    private const int N = 4;
    private const int MostIterations = 20;

    /// <summary>Relative change of the spin by which its effect on the coefficients is found.</summary>
    private const double SpinChange = 0.05;

    /// <summary>Misses well below any tolerance worth having, m.</summary>
    private const double FineMiss = 1e-3;
    private const double FineThrough = 1e-2;

    /// <summary>Share of a tolerance within which a search ends.</summary>
    private const double Sharp = 0.8;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly double[] _j = new double[N * N];
    private readonly double[] _a = new double[N * (N + 1)];
    private readonly double[] _r = new double[N];
    private readonly double[] _next = new double[N];
    private readonly double[] _x = new double[N];
    private readonly double[] _dx = new double[N];
    private readonly double[] _trial = new double[N];
    private readonly double[] _limit = new double[N];
    private readonly bool[] _held = new bool[N];
    private AimRequest _request = new();
    private Vector3d _from;
    private Vector3d _forward;
    private Vector3d _left;
    private double _time;
    private double _throughMiss;
    private double _miss;
    private double _lowestHeight;

    public DirectTwoPointAim(AimContext context, DirectAim direct)
    {
        _context = context;
        _direct = direct;
    }

    public AimAnswer Find(AimRequest request)
    {
        Vector3d through = request.Through.GetValueOrDefault();
        _request = request;
        _from = _context.Start(request);
        _forward = AimContext.Forward(in _from, request.Target, out double distance);
        _left = new Vector3d(_forward.Z, 0, -_forward.X);
        double throughDistance = Vector3d.Dot(through - _from, in _forward);
        if (!(distance > 1e-6 && throughDistance > 1e-3 * distance && throughDistance < 0.999 * distance))
        {
            AimAnswer alone = _direct.Find(request);
            alone.ThroughMiss = double.NaN;
            return alone;
        }

        AimAnswer answer = Solve(through, distance, throughDistance);
        if (answer.Status == AimStatus.Hit)
        {
            return answer;
        }

        // The target first: with the spins that came nearest.
        AimAnswer single = _direct.FindSpun(request, answer.Kick.Top, answer.Kick.Side);
        single.Iterations += answer.Iterations;
        single.ThroughMiss = answer.ThroughMiss;
        if (single.Status != AimStatus.Hit)
        {
            // Perhaps in reach with more lift.
            AimAnswer lifted = _direct.FindSpun(request, -request.MaximumTopSpin, 0);
            if (lifted.Status == AimStatus.Hit || lifted.Miss < single.Miss)
            {
                lifted.Iterations += single.Iterations;
                lifted.ThroughMiss = single.ThroughMiss;
                return lifted;
            }
        }

        return single;
    }

    private AimAnswer Solve(Vector3d through, double distance, double throughDistance)
    {
        double floor = Math.Min(_from.Y, _request.Target.Y) - (2.0 * distance) - 10.0;
        _context.Flight.Aim(_request.Target, Vector3d.Zero, in _forward, floor);
        _context.Flight.AimThrough(in through, in _forward);
        Array.Clear(_held, 0, N);
        Start(in through, distance, throughDistance);
        var answer = new AimAnswer { Status = AimStatus.NotConverged, Forward = _forward, Speed = _request.Speed, Kick = KickOf(_x), ThroughMiss = double.NaN };
        if (!Fly(_x, _r))
        {
            answer.Iterations = 1;
            return answer;
        }

        Differentiate(in through);
        double tolerance = Sharp * Math.Min(_request.Tolerance, FineMiss);
        double throughTolerance = Sharp * Math.Min(_request.ThroughTolerance, FineThrough);
        double before = double.PositiveInfinity;
        for (int iteration = 1; ; iteration++)
        {
            double asked = ThroughAsked();
            answer.Iterations = iteration;
            answer.Kick = KickOf(_x);
            answer.Miss = _miss;
            answer.ThroughMiss = _throughMiss;
            answer.Time = _time;
            if (_miss <= tolerance && asked <= throughTolerance)
            {
                answer.Status = Clear() ? AimStatus.Hit : AimStatus.NotConverged;
                return answer;
            }

            double size = Math.Sqrt((_miss * _miss) + (asked * asked));
            double contraction = size / before;
            bool wasTopHeld = _held[2];
            bool wasSideHeld = _held[3];
            if (iteration >= Math.Min(_request.MaximumIterations, MostIterations) || !Step())
            {
                return answer;
            }

            // The last step shrank the misses by a factor; the next one will by no less. Where that is plenty, no flight is needed.
            bool sameHeld = wasTopHeld == _held[2] && wasSideHeld == _held[3];
            if (sameHeld && contraction > 0 && contraction < 0.1 && contraction * size < 0.1 * tolerance && Clear())
            {
                Trial();
                answer.Kick = KickOf(_trial);
                answer.Miss = contraction * _miss;
                answer.Status = AimStatus.Hit;
                return answer;
            }

            before = size;
            if (!FlyOn())
            {
                return answer;
            }

            bool stale = Size(_next) > 0.9 * Size(_r);
            Update();
            for (int i = 0; i < N; i++)
            {
                _x[i] += _dx[i];
                _r[i] = _next[i];
            }

            if (stale)
            {
                // Broyden's matrix no longer fits: read it off the flight again.
                Differentiate(in through);
            }
        }
    }

    /// <summary>Flies the kick after the step, or after half of it where that does not reach both planes.</summary>
    private bool FlyOn()
    {
        for (int half = 0; half < 4; half++)
        {
            Trial();
            if (Fly(_trial, _next))
            {
                return true;
            }

            for (int i = 0; i < N; i++)
            {
                _dx[i] *= 0.5;
            }
        }

        return false;
    }

    /// <summary>The kick after the step.</summary>
    private void Trial()
    {
        for (int i = 0; i < N; i++)
        {
            _trial[i] = _x[i] + _dx[i];
        }
    }

    /// <summary>The miss at the point on the way, m, but for the directions of spins that are held at their limit.</summary>
    private double ThroughAsked()
    {
        double left = _held[3] ? 0 : _r[0];
        double up = _held[2] ? 0 : _r[1];
        return Math.Sqrt((left * left) + (up * up));
    }

    private bool Clear()
    {
        Elementary.SinCos(_x[0], out double sine, out _);
        return !_context.StaysDown(in _from, _request.Speed * sine)
            && (_lowestHeight >= _context.Game.ContactHeight - 1e-9 || _lowestHeight >= _from.Y - 1e-9);
    }

    private static double Size(double[] r) => Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]) + (r[2] * r[2]) + (r[3] * r[3]));

    private static Kick KickOf(double[] x) => new() { Elevation = x[0], Azimuth = x[1], Top = x[2], Side = x[3] };

    /// <summary>Flies to both planes. r: left and up at the point on the way, left and up at the target.</summary>
    private bool Fly(double[] x, double[] r)
    {
        KickOf(x).Vectors(_request.Speed, in _forward, out Vector3d velocity, out Vector3d spin);
        _context.Fly(in _from, in velocity, in spin, _context.StepFor(Sharp * Math.Min(_request.Tolerance, FineMiss)));
        KickFlight flight = _context.Flight;
        if (!flight.Crossed || !flight.CrossedThrough)
        {
            return false;
        }

        r[0] = Vector3d.Dot(flight.ThroughOffset, in _left);
        r[1] = flight.ThroughOffset.Y;
        r[2] = Vector3d.Dot(flight.Offset, in _left);
        r[3] = flight.Offset.Y;
        _miss = Math.Sqrt((r[2] * r[2]) + (r[3] * r[3]));
        _throughMiss = Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]));
        _time = flight.Time;
        _lowestHeight = flight.Lowest;
        return true;
    }

    /// <summary>
    /// In closed form: the way bends sideways like a parabola of the time, so the two bearings give azimuth and side curvature; up and
    /// down likewise with gravity's fall taken out; curvatures are then turned into spins.
    /// </summary>
    private void Start(in Vector3d through, double distance, double throughDistance)
    {
        double spinRate = Math.Max(10.0, Math.Sqrt((_request.TopSpin * _request.TopSpin) + (_request.SideSpin * _request.SideSpin)));
        double wantedTop = 0;
        double wantedSide = 0;
        Vector3d wind = _context.Scene.Air.Wind;
        double azimuth = 0;
        double elevation = 0.2;
        for (int i = 0; i < 3; i++)
        {
            FlatFire model = _context.Model(_request.Speed, spinRate, distance);
            Elementary.SinCos(elevation, out double sine, out double cosine);
            TimeFor(in model, throughDistance / Math.Max(cosine, 0.3), out double t1);
            TimeFor(in model, distance / Math.Max(cosine, 0.3), out double t2);
            model.Ways(_request.Speed, t1, out double s1, out _, out double fall1, out double bend1);
            model.Ways(_request.Speed, t2, out double s2, out _, out double fall2, out double bend2);

            // Offsets after gravity and wind: s · slope + bend · c at both points
            double left1 = Vector3d.Dot(through - _from - (t1 * wind), in _left);
            double left2 = Vector3d.Dot(_request.Target - _from - (t2 * wind), in _left);
            double up1 = through.Y - _from.Y - (t1 * wind.Y) - (model.Upward * fall1);
            double up2 = _request.Target.Y - _from.Y - (t2 * wind.Y) - (model.Upward * fall2);
            double determinant = (s1 * bend2) - (s2 * bend1);
            double slopeLeft = ((left1 * bend2) - (left2 * bend1)) / determinant;
            double bendLeft = ((s1 * left2) - (s2 * left1)) / determinant;
            double slopeUp = ((up1 * bend2) - (up2 * bend1)) / determinant;
            double bendUp = ((s1 * up2) - (s2 * up1)) / determinant;

            // Lift L(|ω|) along ω: solved for |ω| by its law, L ~ |ω|^0.83
            double lift = Math.Sqrt((bendLeft * bendLeft) + (bendUp * bendUp));
            double share = model.Lift > 0 ? lift / model.Lift : 0;
            double grown = spinRate * Math.Min(Math.Max(share * (0.83 + (0.17 * share)), 0.1), 4.0);
            spinRate = Math.Min(Math.Max(grown, 0.5), 1.5 * Math.Sqrt((_request.MaximumTopSpin * _request.MaximumTopSpin) + (_request.MaximumSideSpin * _request.MaximumSideSpin)));
            if (!double.IsFinite(lift + slopeUp + slopeLeft))
            {
                // No way of the model passes there: straight at the target, and the single-target solver after it.
                wantedSide = 0;
                wantedTop = 0;
                break;
            }

            wantedSide = lift > 0 ? spinRate * bendLeft / lift : 0;
            wantedTop = lift > 0 ? -spinRate * bendUp / lift : 0;
            elevation = Math.Min(Math.Max(Elementary.Atan2(slopeUp, Math.Sqrt(Math.Max(0.05, 1.0 - (slopeUp * slopeUp)))), -1.2), 1.2);
            azimuth = Elementary.Atan2(slopeLeft, Math.Sqrt(Math.Max(0.05, 1.0 - (slopeLeft * slopeLeft))));
        }

        _x[0] = Math.Min(Math.Max(elevation, _request.MinimumElevation * Degree), _request.MaximumElevation * Degree);
        _x[1] = azimuth;
        _x[2] = Math.Min(Math.Max(wantedTop, -_request.MaximumTopSpin), _request.MaximumTopSpin);
        _x[3] = Math.Min(Math.Max(wantedSide, -_request.MaximumSideSpin), _request.MaximumSideSpin);
    }

    /// <summary>Time to go a way along the path.</summary>
    private void TimeFor(in FlatFire model, double way, out double time)
    {
        double k = model.Drag;
        time = k * way > 1e-6 ? (Elementary.Exp(Math.Min(k * way, 5.0)) - 1.0) / (k * _request.Speed) : way / _request.Speed;
    }

    /// <summary>The Jacobian, read off the last flight: angles turn the way, spins bend it.</summary>
    private void Differentiate(in Vector3d through)
    {
        Kick kick = KickOf(_x);
        Vector3d d = kick.Direction(in _forward);
        var raise = new Vector3d(-d.Z, 0, d.X); // d × ŷ
        double spinRate = Math.Max(1.0, Math.Sqrt((kick.Top * kick.Top) + (kick.Side * kick.Side)));
        Vector3d axisTop = new(d.Z, 0, -d.X);
        kick.Vectors(1.0, in _forward, out Vector3d launch, out _);
        KickFlight flight = _context.Flight;
        double distance = Vector3d.Dot(_request.Target - _from, in _forward);
        double way = distance / Math.Max(0.3, launch.Horizontal.Length);
        FlatFire model = _context.Model(_request.Speed, spinRate, way);
        double change = SpinChange;
        FlatFire more = _context.Model(_request.Speed, spinRate * (1.0 + change), way);
        if (Math.Abs(more.Drag - model.Drag) > 0.5 * SpinChange * model.Drag)
        {
            // Across the drag law's jump: the other way then.
            change = -change;
            more = _context.Model(_request.Speed, spinRate * (1.0 + change), way);
        }

        double perRate = 1.0 / (change * spinRate);
        Vector3d omega = (kick.Top * axisTop) + (kick.Side * Vector3d.Up);
        Vector3d unit = omega / spinRate;
        for (int plane = 0; plane < 2; plane++)
        {
            double t = plane == 0 ? flight.ThroughTime : flight.Time;
            Vector3d p = plane == 0 ? flight.ThroughOffset + through - _from : flight.Offset + _request.Target - _from;
            Vector3d v = plane == 0 ? flight.ThroughVelocity : flight.Velocity;
            model.Ways(_request.Speed, t, out double along, out _, out double fall, out double bend);
            more.Ways(_request.Speed, t, out double moreAlong, out _, out double moreFall, out double moreBend);
            Vector3d turning = p - new Vector3d(0, _context.Upward * fall, 0);
            double forward = Math.Max(1e-3, Vector3d.Dot(in v, in _forward));
            Vector3d slope = v / forward;

            // The mean direction is half-way between launch and end.
            Vector3d middle = launch + (v / v.Length);
            middle /= middle.Length;

            // More spin of the same axis: more lift, and more drag. Another axis: the bend turns with it.
            Vector3d byRate = perRate * (((moreAlong - along) * launch)
                + new Vector3d(0, _context.Upward * (moreFall - fall), 0)
                + (((more.Lift * moreBend) - (model.Lift * bend)) * Vector3d.Cross(in unit, in middle)));
            double byAxis = model.Lift / spinRate * bend;

            // A raised kick turns the way, and the axis of its top spin, but not that of its side spin.
            Vector3d upright = kick.Side * byAxis * Vector3d.Cross(in d, in launch);
            Column(plane, 0, Vector3d.Cross(in raise, in turning) + upright, in slope);
            Column(plane, 1, Vector3d.Cross(Vector3d.Up, in turning), in slope);
            double top = Vector3d.Dot(in unit, in axisTop);
            Column(plane, 2, (top * byRate) + (byAxis * Vector3d.Cross(axisTop - (top * unit), in middle)), in slope);
            Column(plane, 3, (unit.Y * byRate) + (byAxis * Vector3d.Cross(Vector3d.Up - (unit.Y * unit), in middle)), in slope);
        }
    }

    private void Column(int plane, int column, Vector3d moved, in Vector3d slope)
    {
        moved -= Vector3d.Dot(in moved, in _forward) * slope;
        _j[(((2 * plane) + 0) * N) + column] = Vector3d.Dot(in moved, in _left);
        _j[(((2 * plane) + 1) * N) + column] = moved.Y;
    }

    /// <summary>One Newton step. A spin that would pass its limit is held there, and its equation at the point on the way dropped.</summary>
    private bool Step()
    {
        _held[2] = false;
        _held[3] = false;
        for (int attempt = 0; attempt < 3; attempt++)
        {
            for (int i = 0; i < N; i++)
            {
                // Equation 0 (left at the point on the way) is the side spin's, equation 1 (up) the top spin's.
                int spin = i == 0 ? 3 : 2;
                bool dropped = i < 2 && _held[spin];
                for (int k = 0; k < N; k++)
                {
                    _a[(i * (N + 1)) + k] = !dropped ? _j[(i * N) + k] : k == spin ? 1 : 0;
                }

                _a[(i * (N + 1)) + N] = dropped ? _limit[spin] - _x[spin] : -_r[i];
            }

            if (!Linear.Solve(_a, _dx, N))
            {
                return false;
            }

            bool again = false;
            for (int i = 2; i < N; i++)
            {
                double wanted = _x[i] + _dx[i];
                if (!_held[i] && Limited(i, wanted) != wanted)
                {
                    _held[i] = true;
                    _limit[i] = Limited(i, wanted);
                    again = true;
                }
            }

            if (!again)
            {
                break;
            }
        }

        double low = _request.MinimumElevation * Degree;
        double high = _request.MaximumElevation * Degree;
        _dx[0] = Math.Min(Math.Max(_dx[0], low - _x[0]), high - _x[0]);
        return Math.Max(Math.Abs(_dx[0]), Math.Abs(_dx[1])) < 1.0;
    }

    private double Limited(int unknown, double spin)
    {
        double limit = unknown == 2 ? _request.MaximumTopSpin : _request.MaximumSideSpin;
        return Math.Min(Math.Max(spin, -limit), limit);
    }

    /// <summary>Broyden's update: J += (Δr − J Δx) Δxᵀ / |Δx|², in units in which a radian and 100 rad/s of spin count alike.</summary>
    private void Update()
    {
        const double SpinUnit = 1e-4;
        double squared = (_dx[0] * _dx[0]) + (_dx[1] * _dx[1]) + (SpinUnit * ((_dx[2] * _dx[2]) + (_dx[3] * _dx[3])));
        if (!(squared > 0))
        {
            return;
        }

        for (int i = 0; i < N; i++)
        {
            double error = _next[i] - _r[i];
            for (int k = 0; k < N; k++)
            {
                error -= _j[(i * N) + k] * _dx[k];
            }

            for (int k = 0; k < N; k++)
            {
                _j[(i * N) + k] += error * (k < 2 ? 1 : SpinUnit) * _dx[k] / squared;
            }
        }
    }
}
