namespace Football.Physics;

/// <summary>
/// Which kick comes closest to a target, over all elevations within the bounds. The signed miss is a smooth function of the elevation:
/// zero at a hit, negative where a kick is too low or too short. Where it is negative all over, its largest value is the verdict.
/// </summary>
internal sealed class ReachSearch
{
    /// <summary>Elevations that a close look tries.</summary>
    private const int Looks = 25;

    /// <summary>Flights that may be spent on the bottom of one valley.</summary>
    private const int MostInValley = 30;

    /// <summary>A kick is the closest where no other is closer by more than this, m, or this share of its miss.</summary>
    private const double Closeness = 5e-4;

    /// <summary>How near to a bound, rad, a kick must be that is further off than the one at the bound: the drag law's jump makes small waves.</summary>
    private const double NearBound = 0.06;

    /// <summary>Share of the target's distance by which three elevations and a parabola must miss it to need no closer look.</summary>
    private const double ClearMiss = 0.002;

    /// <summary>How far apart, rad, and how many to each side, are looks for waves beside the bottom of a valley.</summary>
    private const double Wave = 0.025;
    private const int MostWaves = 4;

    /// <summary>So far below the target, m, the direction of a roll need not be known to the centimetre.</summary>
    private const double WellBelow = 0.25;

    /// <summary>What a step in the miss may hide, m, or as a share of the miss; and how often the way to it is halved.</summary>
    private const double EdgeCloseness = 5e-3;
    private const int MostHalvings = 12;

    /// <summary>Turns by which a kick in a wind is tried to come closer, first and last, rad.</summary>
    private const double FirstStep = 0.04;
    private const double LastStep = 1e-3;

    private readonly AimContext _context;
    private readonly ReachFlights _flights;
    private readonly Pass[] _looks = new Pass[Looks];
    private double _along;
    private double _roll;
    private double _lowest;
    private double _highest;
    private double _tolerance;
    private int _mostRootFlights;

    public ReachSearch(AimContext context)
    {
        _context = context;
        _flights = new ReachFlights(context);
    }

    /// <summary>The kick that was found: a hit, or the closest.</summary>
    public Pass Found { get; private set; }

    /// <summary>Flights of the last search.</summary>
    public int Flights => _flights.Flights;

    /// <summary>Searches all elevations within the bounds.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="from">Where the ball is.</param>
    /// <param name="kick">Its spins.</param>
    /// <param name="speed">Its speed.</param>
    /// <param name="arc">Which of two hits is wanted.</param>
    /// <param name="tolerance">Miss of a hit that is sharp enough.</param>
    /// <returns>Whether a kick was found that hits within the tolerance.</returns>
    public bool Find(AimRequest request, in Vector3d from, in Kick kick, double speed, AimArc arc, double tolerance)
    {
        const double Degree = Math.PI / 180.0;
        _flights.Aim(request, in from, in kick, speed, tolerance);
        _tolerance = tolerance;
        _mostRootFlights = Math.Max(8, request.MaximumIterations);
        _lowest = request.MinimumElevation * Degree;
        _highest = request.MaximumElevation * Degree;
        _along = Math.Min(Math.Max(0, _lowest), _highest);
        _roll = double.PositiveInfinity;
        Elementary.SinCos(_along, out double sine, out _);
        if (_context.StaysDown(in from, speed * sine))
        {
            // On the ground there are two ways to go: to roll along it, whatever the elevation, or to leave it at a steeper one.
            _roll = request.TargetVelocity.Y == 0 ? Math.Abs(request.Target.Y - _context.Game.ContactHeight) : 0;
            double climb = _context.Scene.Ground.MinimumBounceSpeed / speed;
            _lowest = climb < 1 ? Math.Max(_lowest, Elementary.Atan2(climb, Math.Sqrt(1.0 - (climb * climb))) * (1.0 + 1e-9)) : double.PositiveInfinity;
        }

        Vector3d way = request.Target - from;
        if (_lowest <= _highest && Flying(arc, Elementary.Atan2(way.Y, Math.Max(way.Horizontal.Length, 1e-9)), ClearMiss * way.Horizontal.Length))
        {
            return true;
        }

        if (_roll < _flights.Best.Miss && Hits(Roll()))
        {
            return true;
        }

        if (!_flights.Turns)
        {
            Settle();
        }

        Found = _flights.Best;
        return Found.Miss <= tolerance;
    }

    /// <summary>In a wind: whether a kick beside the best one, in elevation or azimuth, is closer.</summary>
    private void Settle()
    {
        bool flies = _flights.Best.Kick.Elevation != _along;
        int flights = 0;
        for (double step = FirstStep; step > LastStep && flights < MostInValley; step *= 0.5)
        {
            bool closer = true;
            while (closer && flights < MostInValley)
            {
                closer = false;
                for (int i = flies ? 0 : 2; i < 4 && !closer; i++)
                {
                    Pass best = _flights.Best;
                    Kick kick = best.Kick;
                    double move = i % 2 == 0 ? step : -step;
                    kick.Elevation = i < 2 ? Math.Min(Math.Max(kick.Elevation + move, _lowest), _highest) : kick.Elevation;
                    kick.Azimuth += i < 2 ? 0 : move;
                    flights++;
                    closer = _flights.Of(in kick).Miss < best.Miss;
                }
            }
        }
    }

    /// <summary>Along the ground: no closer than the target is above it, and only once.</summary>
    private Pass Roll()
    {
        double above = _roll;
        _roll = double.PositiveInfinity;
        if (_flights.Turns && above > WellBelow && !_context.Fine)
        {
            // Well below a target only the direction counts, and even that little; where the ball stops short, the rest does too.
            Pass rough = _flights.Along(_along, rough: true);
            if (rough.Miss <= above + (0.1 * Closeness))
            {
                return rough;
            }
        }

        return _flights.Along(_along, rough: false);
    }

    /// <summary>Searches the elevations at which the ball flies.</summary>
    private bool Flying(AimArc arc, double sight, double clear)
    {
        if (_highest - _lowest < 1e-9)
        {
            return Hits(_flights.At(_lowest));
        }

        return (_flights.Turns && AtAGlance(arc, sight, clear, out bool hit)) ? hit : Closely(arc);
    }

    private bool Hits(in Pass pass)
    {
        if (!(pass.Miss <= _tolerance))
        {
            return false;
        }

        Found = pass;
        return true;
    }

    /// <summary>Three elevations and parabolas through them: enough where they hit, or miss by far.</summary>
    /// <returns>False where it takes a closer look.</returns>
    private bool AtAGlance(AimArc arc, double sight, double clear, out bool hit)
    {
        hit = false;
        double span = _highest - _lowest;
        double middle = Math.Min(Math.Max(0.55 + (0.5 * sight), _lowest + (0.25 * span)), _highest - (0.25 * span));
        Pass a = _flights.At(Math.Max(_lowest, middle - 0.3));
        Pass b = _flights.At(middle);
        Pass c = _flights.At(Math.Min(_highest, middle + 0.25));

        // Downhill until the closest is in the middle, or at a bound.
        while (!b.Above && (a.Miss < b.Miss || c.Miss < b.Miss))
        {
            if (c.Miss < b.Miss)
            {
                if (c.Above || c.Kick.Elevation >= _highest)
                {
                    break;
                }

                a = b;
                b = c;
                c = _flights.At(Math.Min(_highest, b.Kick.Elevation + (1.6 * (b.Kick.Elevation - a.Kick.Elevation))));
            }
            else
            {
                if (a.Above || a.Kick.Elevation <= _lowest)
                {
                    break;
                }

                c = b;
                b = a;
                a = _flights.At(Math.Max(_lowest, b.Kick.Elevation - (1.6 * (c.Kick.Elevation - b.Kick.Elevation))));
            }
        }

        bool above = a.Above || b.Above || c.Above;
        if (!above)
        {
            // Where a ball that rolls below the target is closer than any that flies, the closest of those need not be known any better.
            above = Valley(ref a, ref b, ref c, enough: _roll);
            double bottom = Bottom(in a, in b, in c);
            if (!above && _roll < b.Miss && !(Roll().Miss < bottom))
            {
                above = Valley(ref a, ref b, ref c, enough: double.PositiveInfinity);
            }
        }

        if (!above && _flights.Best.Kick.Elevation != _along)
        {
            above = Waves(ref a, ref b, ref c);
        }

        double least = Math.Min(Math.Min(a.Miss, b.Miss), c.Miss);
        return above ? HitsBeside(arc, ref a, ref b, ref c, out hit) : least > clear && least > 10 * _tolerance;
    }

    /// <summary>Whether a wave of the drag law's jump, beside the bottom of a valley, is deeper: looks to both sides of the best.</summary>
    /// <returns>As <see cref="Valley"/>.</returns>
    private bool Waves(ref Pass a, ref Pass b, ref Pass c)
    {
        Pass best = _flights.Best;
        double miss = best.Miss;
        Pass wave = default;
        int count = 0;
        for (int i = -MostWaves; i <= MostWaves; i++)
        {
            double elevation = best.Kick.Elevation + (i * Wave);
            if (elevation < _lowest || elevation > _highest)
            {
                continue;
            }

            Pass d = i == 0 ? best : _flights.At(elevation);
            _looks[count++] = d;
            if (d.Miss < miss || d.Above)
            {
                wave = d;
                miss = d.Miss;
            }
        }

        if (wave.Miss > 0)
        {
            b = wave;
            a = _flights.At(Math.Max(_lowest, wave.Kick.Elevation - (0.5 * Wave)));
            c = _flights.At(Math.Min(_highest, wave.Kick.Elevation + (0.5 * Wave)));
            if (a.Above || b.Above || c.Above || Valley(ref a, ref b, ref c, enough: double.PositiveInfinity))
            {
                return true;
            }
        }

        for (int i = 3; i < count; i++)
        {
            // Upwards and downwards: three looks in a row, and the next.
            int k = count - 1 - i;
            if (Edge(_looks[i - 3], _looks[i - 2], _looks[i - 1], _looks[i], ref a, ref b, ref c)
                || Edge(_looks[k + 3], _looks[k + 2], _looks[k + 1], _looks[k], ref a, ref b, ref c))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// Where the way of the ball changes at once with the elevation, as where it just grazes the drag law's jump, the miss steps up in the
    /// middle of a descent, and is least at the step: halving towards it, as long as the descent promises more than was found.
    /// </summary>
    /// <param name="one">First of three on the descent.</param>
    /// <param name="two">Second.</param>
    /// <param name="three">Third, the nearest to the step.</param>
    /// <param name="beyond">Perhaps beyond a step.</param>
    /// <param name="a">Of three elevations, one of which hits beside it, the first.</param>
    /// <param name="b">The second.</param>
    /// <param name="c">The third.</param>
    /// <returns>As <see cref="Valley"/>.</returns>
    private bool Edge(Pass one, Pass two, Pass three, Pass beyond, ref Pass a, ref Pass b, ref Pass c)
    {
        for (int i = 0; i < MostHalvings; i++)
        {
            double promised = Continued(in one, in two, in three, beyond.Kick.Elevation);
            if (!(Math.Max(0, promised) < _flights.Best.Miss - (EdgeCloseness * Math.Max(1.0, _flights.Best.Miss))))
            {
                return false;
            }

            double middle = 0.5 * (three.Kick.Elevation + beyond.Kick.Elevation);
            Pass d = _flights.At(middle, in three);
            if (d.Above)
            {
                (a, b, c) = (three, d, beyond);
                return true;
            }

            if (Math.Abs(d.Miss - Continued(in one, in two, in three, middle)) < 0.25 * (beyond.Miss - promised))
            {
                (one, two, three) = (two, three, d);
            }
            else
            {
                beyond = d;
            }
        }

        return false;
    }

    /// <summary>The miss at another elevation, of the parabola through three.</summary>
    private static double Continued(in Pass one, in Pass two, in Pass three, double elevation)
    {
        double x = elevation - three.Kick.Elevation;
        double x1 = one.Kick.Elevation - three.Kick.Elevation;
        double x2 = two.Kick.Elevation - three.Kick.Elevation;
        double s1 = (one.Miss - three.Miss) / x1;
        double s2 = (two.Miss - three.Miss) / x2;
        double q = (s1 - s2) / (x1 - x2);
        return three.Miss + (x * (s2 + (q * (x - x2))));
    }

    /// <summary>What no elevation between three is below: the least of their parabola, less what that may be wrong by.</summary>
    private static double Bottom(in Pass a, in Pass b, in Pass c)
    {
        double left = b.Kick.Elevation - a.Kick.Elevation;
        double right = c.Kick.Elevation - b.Kick.Elevation;
        double least = Math.Min(Math.Min(a.Miss, b.Miss), c.Miss);
        if (!(left > 0 && right > 0))
        {
            return 0;
        }

        // m(b + x) = m_b + s x + ½ q x²
        double q = 2.0 * ((left * (c.Miss - b.Miss)) + (right * (a.Miss - b.Miss))) / (left * right * (left + right));
        double s = ((c.Miss - b.Miss) / right) - (0.5 * q * right);
        double x = q > 0 ? -s / q : 0;
        double vertex = q > 0 && x > -left && x < right ? b.Miss - (0.5 * s * s / q) : least;
        double doubt = left * right;
        return vertex - (0.5 * Math.Abs(q) * doubt * doubt);
    }

    /// <summary>Hits on one arc or the other, beside three elevations of which one at least is above the target.</summary>
    private bool HitsBeside(AimArc arc, ref Pass a, ref Pass b, ref Pass c, out bool hit)
    {
        hit = false;
        for (int i = 0; i < 2 && !hit; i++)
        {
            bool low = (arc == AimArc.Low) == (i == 0);
            Pass above = low ? (a.Above ? a : b.Above ? b : c) : (c.Above ? c : b.Above ? b : a);
            Pass below = low ? (a.Above ? a : b.Above ? a : b) : (c.Above ? c : b.Above ? c : b);
            double bound = low ? _lowest : _highest;
            if (below.Above && below.Kick.Elevation != bound)
            {
                below = _flights.At(bound);
            }

            hit = !below.Above && Root(below, above);
        }

        return hit;
    }

    /// <summary>Many elevations: every change of sign is a hit, and every valley is searched to its bottom.</summary>
    private bool Closely(AimArc arc)
    {
        for (int i = 0; i < Looks; i++)
        {
            _looks[i] = _flights.At(i == Looks - 1 ? _highest : _lowest + ((_highest - _lowest) * i / (Looks - 1)));
        }

        for (int i = 1; i < Looks; i++)
        {
            int at = arc == AimArc.Low ? i : Looks - i;
            if (_looks[at - 1].Above != _looks[at].Above && Root(_looks[at - 1], _looks[at]))
            {
                return true;
            }
        }

        for (int i = 0; i < Looks; i++)
        {
            double miss = _looks[i].Miss;
            if (!(miss <= _looks[Math.Max(0, i - 1)].Miss && miss <= _looks[Math.Min(Looks - 1, i + 1)].Miss))
            {
                continue;
            }

            int middle = Math.Min(Math.Max(i, 1), Looks - 2);
            Pass a = _looks[middle - 1];
            Pass b = _looks[middle];
            Pass c = _looks[middle + 1];

            if (Valley(ref a, ref b, ref c, enough: double.PositiveInfinity))
            {
                bool first = arc == AimArc.Low;
                if (Root(first ? a : c, b) || Root(first ? c : a, b))
                {
                    return true;
                }
            }
        }

        return Hits(_flights.Best);
    }

    /// <summary>The bottom of a valley: parabolas through the best elevation and its neighbours, at a bound through the two nearest.</summary>
    /// <param name="a">The lowest of three elevations.</param>
    /// <param name="b">The middle one.</param>
    /// <param name="c">The highest.</param>
    /// <param name="enough">A miss that is known to be had elsewhere: a valley that is shallower need not be searched on.</param>
    /// <returns>True where the target lies on the other side of the way of b than of its neighbours': there are hits between.</returns>
    private bool Valley(ref Pass a, ref Pass b, ref Pass c, double enough)
    {
        bool above = b.Above;
        for (int i = 0; i < MostInValley; i++)
        {
            double left = b.Kick.Elevation - a.Kick.Elevation;
            double right = c.Kick.Elevation - b.Kick.Elevation;
            if (!(left > 0 && right > 0) || Math.Max(left, right) < 1e-6)
            {
                return false;
            }

            if (Bottom(in a, in b, in c) > enough)
            {
                return false;
            }

            // m(b + x) = m_b + s x + ½ q x²
            double q = 2.0 * ((left * (c.Miss - b.Miss)) + (right * (a.Miss - b.Miss))) / (left * right * (left + right));
            double s = ((c.Miss - b.Miss) / right) - (0.5 * q * right);
            double move;
            if (a.Miss < b.Miss || c.Miss < b.Miss)
            {
                // At a bound: downhill to the very end? The slope there is known up to a third derivative like the second.
                bool atRight = c.Miss < a.Miss;
                double near = atRight ? right : left;
                double slope = atRight ? s + (q * right) : (q * left) - s;
                if ((slope < -Math.Abs(q) * near * (left + right) && near < NearBound) || near < 1e-4)
                {
                    return false;
                }

                move = (atRight ? 0.7 : -0.7) * near;
            }
            else
            {
                double close = Closeness * Math.Max(1.0, b.Miss);
                move = q > 0 ? -s / q : 0;

                // The vertex is off by about half the product of the neighbours' distances, with such a third derivative.
                double doubt = 0.5 * left * right;
                if (0.5 * q * ((doubt * doubt) + (move * move)) < close)
                {
                    return false;
                }

                double least = 0.05 * Math.Max(left, right);
                if (Math.Abs(move) < least)
                {
                    // No news from there: towards the further neighbour instead.
                    least = Math.Max(least, 0.06);
                    move = left > right ? -Math.Min(0.5 * left, least) : Math.Min(0.5 * right, least);
                }

                move = Math.Min(Math.Max(move, -0.9 * left), 0.9 * right);
            }

            Pass d = _flights.At(b.Kick.Elevation + move, in b);
            bool crossed = d.Above != above;
            Between(ref a, ref b, ref c, in d, crossed, leftSide: move < 0);
            if (crossed)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Takes an elevation between b and a neighbour into the three, and leaves one out.</summary>
    private static void Between(ref Pass a, ref Pass b, ref Pass c, in Pass d, bool becomesMiddle, bool leftSide)
    {
        double outer = leftSide ? a.Miss : c.Miss;
        if (becomesMiddle || d.Miss < b.Miss || outer < b.Miss)
        {
            (a, c) = leftSide ? (a, b) : (b, c);
            b = d;
        }
        else
        {
            (a, c) = leftSide ? (d, c) : (a, d);
        }
    }

    /// <summary>The hit between two elevations: Illinois on the signed miss.</summary>
    private bool Root(Pass one, Pass other)
    {
        if (Hits(in one) || Hits(in other))
        {
            return true;
        }

        if (one.Signed < 0 == other.Signed < 0)
        {
            return false;
        }

        var miss = new SignedMiss(this, in one, in other);
        Roots.Illinois(ref miss, one.Kick.Elevation, one.Signed, other.Kick.Elevation, other.Signed, 1e-12, _mostRootFlights);
        return miss.Hit;
    }

    /// <summary>The signed miss over the elevation.</summary>
    private struct SignedMiss : IFunction
    {
        private readonly ReachSearch _owner;
        private Pass _one;
        private Pass _other;

        public SignedMiss(ReachSearch owner, in Pass one, in Pass other)
        {
            _owner = owner;
            _one = one;
            _other = other;
            Hit = false;
        }

        public bool Hit { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            Pass flown = _owner._flights.Near(x, _one.Miss < _other.Miss ? _one : _other);
            value = flown.Signed;
            Hit = _owner.Hits(in flown);
            if (value < 0 == _one.Signed < 0)
            {
                _one = flown;
            }
            else
            {
                _other = flown;
            }

            return Hit;
        }
    }
}
