using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Finds the crossings of the border of one zone along one path, in order.</summary>
/// <remarks>
/// g is the signed distance of the ball from the zone. The concave curvature of the shape bounds g'', so g'' ≥ −M along the path.
/// From a point outside, g stays positive until g + g' s − ½ M s² = 0. Between two points inside, g rises at most ⅛ M w² above its chord.
/// No crossing is missed except a dip below <see cref="Dip"/>.
/// </remarks>
internal readonly struct ZoneSearch
{
    /// <summary>A ball that enters or leaves by less than this, and returns within the piece, is not reported, m.</summary>
    private const double Dip = 1e-9;

    /// <summary>Maximum number of halvings of a part of the path inside the zone.</summary>
    private const int MostHalvings = 24;

    /// <summary>Tolerance of a crossing, as a share of the piece and as a distance, m.</summary>
    private const double Closeness = 1e-13;

    private readonly StepLog _log;
    private readonly Border _border;
    private readonly int _zone;
    private readonly double _bend;
    private readonly double _near;
    private readonly double _speed;

    /// <param name="log">Receives the crossings.</param>
    /// <param name="path">The path.</param>
    /// <param name="zone">Index of the zone.</param>
    /// <param name="shape">Its shape.</param>
    /// <param name="hollow">Its strongest concave curvature, 1/m.</param>
    /// <param name="level">Distance of the centre at which the ball is in the zone, m.</param>
    public ZoneSearch(StepLog log, in PathPolynomial path, int zone, IShape shape, double hollow, double level)
    {
        _log = log;
        _zone = zone;
        _border = new Border(in path, shape, level);

        // A concave curvature κ bends the distance by κ/(1 − κ d); this is valid for κ d ≤ ¾. Farther out, use only the speed to bound the distance.
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

        double enters = Nearest(0, 1, end <= 0);
        if (enters <= 1)
        {
            Add(enters, true);
            FromInside(enters, 0, 1, end, 0);
        }
    }

    /// <summary>Finds the crossings from a point inside.</summary>
    private void FromInside(double from, double atFrom, double to, double atTo, int halvings)
    {
        if (atTo > 0)
        {
            // The path ends outside the zone: search backwards for the last crossing.
            double leaves = Nearest(to, from, true);
            Inside(from, atFrom, leaves, 0, halvings);
            Add(leaves, false);
        }
        else
        {
            Inside(from, atFrom, to, atTo, halvings);
        }
    }

    /// <summary>Finds the crossings between two points inside.</summary>
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

        double enters = Nearest(middle, to, true);
        Add(enters, true);
        Inside(enters, 0, to, atTo, halvings + 1);
    }

    /// <summary>Returns the crossing nearest to a point outside, in either direction; infinite if there is none.</summary>
    /// <param name="from">The point.</param>
    /// <param name="to">The end of the search.</param>
    /// <param name="endsInside">True if the end is inside.</param>
    private double Nearest(double from, double to, bool endsInside)
    {
        var gap = new BorderGap(in this, from, to < from ? -1 : 1);
        long evaluations = 0;
        double way = TimeOfImpact.First(ref gap, new SearchSpan(Math.Abs(to - from), double.PositiveInfinity), ref evaluations);
        _log.SearchEvaluations += evaluations;
        return way < double.PositiveInfinity ? Locate(gap.Outside, gap.At(way))
            : endsInside ? Locate(gap.Outside, to)
            : way;
    }

    /// <summary>Locates the crossing between a point outside and a point inside.</summary>
    private double Locate(double outside, double inside)
    {
        var crossing = new Crossing(in _border, inside < outside ? -1 : 1);
        double low = Math.Min(outside, inside);
        double high = Math.Max(outside, inside);
        return Roots.Newton(ref crossing, low, high, 0.5 * (low + high), Closeness);
    }

    private void Add(double s, bool enters) => _log.AddCrossing(new ZoneCrossing(Math.Min(s, 1), _zone, enters));

    /// <summary>The signed distance of the ball from the zone along the path.</summary>
    private readonly struct Border(in PathPolynomial path, IShape shape, double level)
    {
        private readonly PathPolynomial _path = path;
        private readonly IShape _shape = shape;
        private readonly double _level = level - Zone.Touching;

        /// <summary>Returns the distance and its rate, m.</summary>
        public double At(double s, out double rate)
        {
            ShapePoint at = _shape.At(_path.At(s));
            rate = Vector3d.Dot(at.Normal, _path.RateAt(s));
            return at.Distance - _level;
        }
    }

    /// <summary>The distance along the path in one direction, until it is not positive.</summary>
    private struct BorderGap(in ZoneSearch search, double from, double sign) : IGap
    {
        private readonly ZoneSearch _search = search;
        private double _way;

        /// <summary>The last point outside that was evaluated.</summary>
        public readonly double Outside => At(_way);

        public readonly double At(double way) => from + (sign * way);

        public bool IsClosed(double t, out double step)
        {
            double value = _search._border.At(At(t), out double rate);
            step = value > _search._near ? value / _search._speed : TimeOfImpact.Safe(value + Dip, sign * rate, _search._bend);
            if (value <= 0)
            {
                return true;
            }

            _way = t;
            return false;
        }
    }

    /// <summary>The same distance, with the sign that makes it positive before the crossing.</summary>
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
/// <param name="At">Elapsed share of the piece.</param>
/// <param name="Zone">Index of the zone.</param>
/// <param name="Enters">True if the ball enters.</param>
internal readonly record struct ZoneCrossing(double At, int Zone, bool Enters)
{
    /// <summary>True if it comes before another crossing: by time, then by zone.</summary>
    public bool IsBefore(in ZoneCrossing other) => At < other.At || (At == other.At && Zone < other.Zone);
}
