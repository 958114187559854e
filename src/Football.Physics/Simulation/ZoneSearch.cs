namespace FootballPhysics;

/// <summary>The crossings of the border of one zone along one path, in order.</summary>
/// <remarks>
/// g is the distance left until the ball is in the zone. The distance from a shape bends down no more than its hollows do, so along the path g'' ≥ −M: from a point outside,
/// g stays positive until g + g' s − ½ M s² = 0, and between two points inside it rises above its chord by ⅛ M w² at most. No crossing is missed except a dip of less than
/// <see cref="Dip"/>.
/// </remarks>
internal readonly struct ZoneSearch
{
    /// <summary>A ball that enters or leaves by less than this, m, and comes back within the piece does not report it.</summary>
    private const double Dip = 1e-9;

    /// <summary>Steps of one walk at most.</summary>
    private const int MostSteps = 4_096;

    /// <summary>How often a part of a path inside is halved at most.</summary>
    private const int MostHalvings = 24;

    /// <summary>A crossing is located to this share of the piece, and to this distance, m.</summary>
    private const double Closeness = 1e-13;

    private readonly StepLog _log;
    private readonly Border _border;
    private readonly int _zone;
    private readonly double _bend;
    private readonly double _near;
    private readonly double _speed;

    /// <param name="log">Where crossings are added.</param>
    /// <param name="path">The path.</param>
    /// <param name="zone">Index of the zone.</param>
    /// <param name="shape">Its shape.</param>
    /// <param name="level">The distance of the centre at which the ball is in it, m.</param>
    public ZoneSearch(StepLog log, in ZonePath path, int zone, IShape shape, double level)
    {
        _log = log;
        _zone = zone;
        _border = new Border(in path, shape, level);

        // A hollow of curvature κ bends the distance by κ/(1 − κ d), here with κ d ≤ ¾; farther out the speed alone bounds it.
        double hollow = shape.MaximumConcaveCurvature;
        _speed = path.FastestSpeed;
        _bend = path.GreatestAcceleration + (4.0 * hollow * _speed * _speed);
        _near = hollow > 0 ? 0.5 * ((1.0 / hollow) - level) : double.PositiveInfinity;
    }

    /// <summary>Finds all crossings.</summary>
    public void Run()
    {
        double start = _border.At(0, out _);
        double end = _border.At(1, out _);
        if (start <= 0)
        {
            FromInside(0, start, 1, end, 0);
            return;
        }

        double enters = First(0, 1, end <= 0);
        if (enters <= 1)
        {
            Add(enters, true);
            FromInside(enters, 0, 1, end, 0);
        }
    }

    /// <summary>Crossings from a point inside on.</summary>
    private void FromInside(double from, double atFrom, double to, double atTo, int halvings)
    {
        if (atTo > 0)
        {
            // It ends outside: from there back to the last crossing.
            double leaves = Last(from, to);
            Inside(from, atFrom, leaves, 0, halvings);
            Add(leaves, false);
        }
        else
        {
            Inside(from, atFrom, to, atTo, halvings);
        }
    }

    /// <summary>Crossings between two points inside.</summary>
    private void Inside(double from, double atFrom, double to, double atTo, int halvings)
    {
        double w = to - from;
        if (!(Math.Max(atFrom, atTo) + (0.125 * _bend * w * w) > Dip) || halvings >= MostHalvings)
        {
            return;
        }

        double middle = from + (0.5 * w);
        double value = _border.At(middle, out _);
        FromInside(from, atFrom, middle, value, halvings + 1);
        if (value <= 0)
        {
            Inside(middle, value, to, atTo, halvings + 1);
            return;
        }

        double enters = First(middle, to, true);
        Add(enters, true);
        Inside(enters, 0, to, atTo, halvings + 1);
    }

    /// <summary>The first crossing after a point outside; infinite if there is none.</summary>
    private double First(double from, double to, bool endsInside)
    {
        double s = from;
        for (int i = 0; i < MostSteps; i++)
        {
            double value = _border.At(s, out double rate);
            if (value <= 0)
            {
                return s;
            }

            double next = s + Safe(value, rate);
            if (!(next < to))
            {
                break;
            }

            if (_border.At(next, out _) <= 0)
            {
                return Locate(s, next, 1);
            }

            s = next;
        }

        return endsInside ? Locate(s, to, 1) : double.PositiveInfinity;
    }

    /// <summary>The last crossing before a point outside, after a point inside.</summary>
    private double Last(double from, double to)
    {
        double s = to;
        for (int i = 0; i < MostSteps; i++)
        {
            double value = _border.At(s, out double rate);
            if (value <= 0)
            {
                return s;
            }

            double next = s - Safe(value, -rate);
            if (!(next > from))
            {
                break;
            }

            if (_border.At(next, out _) <= 0)
            {
                return Locate(next, s, -1);
            }

            s = next;
        }

        return Locate(from, s, -1);
    }

    /// <summary>How far, in s, the ball stays out from a point outside.</summary>
    private double Safe(double value, double rate)
    {
        if (value > _near)
        {
            return value / _speed;
        }

        double root = Math.Sqrt((rate * rate) + (2.0 * _bend * (value + Dip)));
        return rate < 0 ? 2.0 * (value + Dip) / (root - rate) : _bend > 0 ? (root + rate) / _bend : double.PositiveInfinity;
    }

    /// <summary>The crossing between two points.</summary>
    private double Locate(double from, double to, double sign)
    {
        var crossing = new Crossing(in _border, sign);
        return Roots.Newton(ref crossing, from, to, 0.5 * (from + to), Closeness);
    }

    private void Add(double s, bool enters) => _log.AddCrossing(new ZoneCrossing(Math.Min(s, 1), _zone, enters));

    /// <summary>The distance left until the ball is in the zone, along the path.</summary>
    private readonly struct Border(in ZonePath path, IShape shape, double level)
    {
        private readonly ZonePath _path = path;
        private readonly IShape _shape = shape;
        private readonly double _level = level - Zone.Touching;

        /// <summary>Its value and its rate, m.</summary>
        public double At(double s, out double rate)
        {
            ShapePoint at = _shape.At(_path.At(s));
            rate = Vector3d.Dot(at.Normal, _path.RateAt(s));
            return at.Distance - _level;
        }
    }

    /// <summary>The same, positive before the crossing.</summary>
    private readonly struct Crossing(in Border border, double sign) : IDifferentiableFunction
    {
        private readonly Border _border = border;
        private readonly double _sign = sign;

        public bool Evaluate(double x, out double value, out double slope)
        {
            value = _sign * _border.At(x, out double rate);
            slope = _sign * rate;
            return Math.Abs(value) < Closeness;
        }
    }
}

/// <summary>A crossing of the border of a zone within a piece.</summary>
/// <param name="At">When: the share of the piece that is over.</param>
/// <param name="Zone">Index of the zone.</param>
/// <param name="Enters">True if the ball enters.</param>
internal readonly record struct ZoneCrossing(double At, int Zone, bool Enters)
{
    /// <summary>True if it comes before another: by time, then by zone.</summary>
    public bool IsBefore(in ZoneCrossing other) => At < other.At || (At == other.At && Zone < other.Zone);
}
