using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The closest approach to a target as a function of the elevation, with the best azimuth for each.</summary>
internal sealed class ApproachByElevation(AimContext context)
{
    /// <summary>The maximum number of flights for the azimuth of one elevation.</summary>
    private const int MostTurns = 12;

    /// <summary>The lateral offset to accept, as a share of the miss; the miss is then accurate to a millionth.</summary>
    private const double SmallOffset = 2e-3;

    /// <summary>The first estimate of a ball's drift in wind, as a share of the distance that the air moves.</summary>
    private const double Drift = 0.3;

    /// <summary>The miss, as a multiple of the tolerance, below which a flight is repeated in shorter steps.</summary>
    private const double NearHit = 10;

    private readonly AimContext _context = context;
    private TargetFrame _frame;
    private Vector3d _targetVelocity;
    private Kick _kick;

    /// <summary>The elevations to search.</summary>
    public ElevationBounds Bounds { get; set; }

    /// <summary>The miss of an acceptable hit, in m.</summary>
    public double Tolerance { get; private set; }

    /// <summary>The closest approach so far.</summary>
    public Approach Best { get; private set; }

    /// <summary>The hit that was accepted as the result.</summary>
    public Approach Hit { get; private set; }

    /// <summary>True if a kick passes above the target.</summary>
    public bool AnyAbove { get; private set; }

    /// <summary>The lower bounds of the miss that follow from the flights so far.</summary>
    public ReachCover Cover { get; } = new();

    /// <summary>The speed of the kicks, in m/s.</summary>
    public double Speed { get; private set; }

    /// <summary>True if flights rotate with their azimuth, so that one flight yields the best azimuth for its elevation.</summary>
    public bool TurnWithAzimuth => _context.Turns(in _targetVelocity);

    /// <summary>True if the search budget is used up.</summary>
    public bool IsSpent => _context.IsSpent;

    /// <summary>Prepares a search for a target.</summary>
    public void Aim(PlaneProblem problem)
    {
        _frame = problem.Frame;
        _targetVelocity = problem.Request.TargetVelocity;
        _kick = problem.Spins;
        Speed = problem.Speed;
        Tolerance = problem.HitMiss;
        AnyAbove = false;
        Cover.Begin(Vector3d.Distance(_frame.From, in _frame.Target));
        Bounds = problem.Bounds;
        Best = new Approach { Kick = _kick, Miss = double.PositiveInfinity };
    }

    /// <summary>Accepts an approach as the result if it hits.</summary>
    public bool Accept(in Approach approach)
    {
        if (!(approach.Miss <= Tolerance))
        {
            return false;
        }

        Hit = approach;
        return true;
    }

    /// <summary>Simulates a kick at an elevation, starting with the last azimuth.</summary>
    public Approach At(double elevation) => At(elevation, _context.Steps.Search);

    /// <summary>Simulates a kick at an elevation, starting with the azimuth of another approach.</summary>
    public Approach At(double elevation, in Approach near)
    {
        _kick.Azimuth = near.Kick.Azimuth;
        return At(elevation);
    }

    /// <summary>Returns the closest approach at an elevation, in the shorter steps of a hit.</summary>
    public Approach HitAt(double elevation, in Approach near)
    {
        _kick.Azimuth = near.Kick.Azimuth;
        return At(elevation, _context.Steps.Hit);
    }

    /// <summary>Simulates a kick without changing its angles.</summary>
    public Approach Of(in Kick kick)
    {
        _kick.Elevation = kick.Elevation;
        _kick.Azimuth = kick.Azimuth;
        return Fly(_context.Steps.Search);
    }

    /// <summary>Simulates a roll along the ground, starting straight towards the target.</summary>
    public Approach Roll(double elevation)
    {
        _kick.Azimuth = 0;
        return At(elevation);
    }

    /// <summary>Returns the closest approach at an elevation over all azimuths, starting with the last azimuth.</summary>
    private Approach At(double elevation, double step)
    {
        // In still air, one flight also yields the azimuth. In wind, turn the kick until the target lies in the direction of the path.
        _kick.Elevation = elevation;
        Approach approach = Fly(step);
        if (approach.Miss < NearHit * Tolerance && step > _context.Steps.Hit)
        {
            // Long steps are too inaccurate to decide whether the kick hits.
            step = _context.Steps.Hit;
            approach = Fly(step);
        }

        // In still air, the flight has already determined the azimuth.
        if (TurnWithAzimuth)
        {
            _kick.Azimuth = approach.Kick.Azimuth;
            return approach;
        }

        approach = Turned(approach, step);
        if (approach.Time == 0 && approach.Kick.Azimuth != 0)
        {
            // A kick in the wrong direction is closest at its start, which does not reveal which way to turn it: try azimuth 0.
            _kick.Azimuth = 0;
            Approach straight = Turned(Fly(step), step);
            approach = straight.Miss < approach.Miss ? straight : approach;
        }

        return approach;
    }

    /// <summary>Turns a kick in wind until it passes the target as closely as possible.</summary>
    private Approach Turned(Approach approach, double step)
    {
        // Turning a kick rotates its path about a point c that drifts with the wind: turn until the ball and the target have the same bearing from c.
        Vector3d toTarget = _frame.Target - _frame.From;
        Vector3d c = approach.Time * ((Drift * _context.Scene.Air.Wind) - _targetVelocity);
        for (int i = 0; i < MostTurns && !IsSpent; i++)
        {
            // Turn through the smaller angle; stop when the lateral offset is a small part of the miss.
            Vector3d at = approach.Gap + toTarget;
            double turn = Bearing(toTarget - c) - Bearing(at - c);
            turn = turn > Math.PI ? turn - (2 * Math.PI) : turn < -Math.PI ? turn + (2 * Math.PI) : turn;
            double offset = Math.Abs(turn) * (at - c).Horizontal.Length;
            if (!(offset > SmallOffset * approach.Miss && offset > 0.1 * Tolerance))
            {
                break;
            }

            _kick.Azimuth = approach.Kick.Azimuth + turn;
            Approach next = Fly(step);
            Centre(at, next.Gap + toTarget, next.Kick.Azimuth - approach.Kick.Azimuth, ref c);
            approach = next;
        }

        return approach;
    }

    /// <summary>Returns the centre c about which a turn of the kick rotated the closest point: p₂ − c = R (p₁ − c).</summary>
    private void Centre(in Vector3d one, in Vector3d other, double turn, ref Vector3d c)
    {
        if (!(Math.Abs(turn) > 1e-3))
        {
            return;
        }

        Elementary.SinCos(turn, out double sin, out double cos);

        // Use complex numbers: forward is the real axis, and left is the imaginary axis.
        double f1 = Vector3d.Dot(in one, in _frame.Forward);
        double l1 = Vector3d.Dot(in one, in _frame.Left);
        double f2 = Vector3d.Dot(in other, in _frame.Forward);
        double l2 = Vector3d.Dot(in other, in _frame.Left);

        // c = (p₂ − e^{iφ} p₁) / (1 − e^{iφ}), with 1/(1 − e^{iφ}) = ½ (1 + i cot(φ/2))
        double f = f2 - ((cos * f1) - (sin * l1));
        double l = l2 - ((sin * f1) + (cos * l1));
        double cot = sin / (1.0 - cos);
        c = (0.5 * (f - (cot * l)) * _frame.Forward) + (0.5 * (l + (cot * f)) * _frame.Left);
    }

    private double Bearing(in Vector3d way)
    {
        double f = Vector3d.Dot(in way, in _frame.Forward);
        double l = Vector3d.Dot(in way, in _frame.Left);
        return f == 0 && l == 0 ? 0 : Elementary.Atan2(l, f);
    }

    private Approach Fly(double step)
    {
        Approach approach = _context.Look(in _frame, in _targetVelocity, in _kick, Speed, step);
        if (approach.Miss < Best.Miss)
        {
            Best = approach;
        }

        AnyAbove |= approach.Above;
        if (Bounds.Contain(_kick.Elevation))
        {
            Cover.Add(_kick.Elevation, approach.Miss, (_frame.Target + approach.Gap - _frame.From).Length);
        }

        return approach;
    }
}

/// <summary>Finds the hit between a kick above the target and one below: the root of the signed miss over the elevation.</summary>
internal sealed class HitSearch(ApproachByElevation approaches)
{
    /// <summary>The minimum number of flights that a search may use.</summary>
    private const int LeastShots = 8;

    /// <summary>The slope of the signed miss, in path lengths per rad, above which it jumps because another point of the path is now closest.</summary>
    private const double Jump = 100;

    private readonly ApproachByElevation _approaches = approaches;
    private int _mostShots;

    /// <summary>Prepares for a request.</summary>
    public void Begin(AimRequest request) => _mostShots = Math.Max(LeastShots, request.MaximumIterations);

    /// <summary>Finds the hit between two elevations.</summary>
    /// <returns>False if there is no hit, or none was found.</returns>
    public bool Between(in Approach one, in Approach other)
    {
        if (_approaches.Accept(in one) || _approaches.Accept(in other))
        {
            return true;
        }

        // If the sign does not change, there is no root in between.
        if (one.SignedMiss < 0 == other.SignedMiss < 0)
        {
            return false;
        }

        var miss = new MissOverElevation(_approaches, in one, in other);
        Roots.Illinois(ref miss, one.Elevation, one.SignedMiss, other.Elevation, other.SignedMiss, 1e-12, _mostShots);
        return miss.Hits;
    }

    /// <summary>Finds a hit on one arc or, failing that, on the other, near three elevations of which at least one passes above the target.</summary>
    public bool Beside(in ApproachBracket at, AimArc arc) =>
        arc == AimArc.Low ? BelowLowArc(in at) || AboveHighArc(in at) : AboveHighArc(in at) || BelowLowArc(in at);

    /// <summary>Finds the hit at the lower end of the elevations that pass above.</summary>
    private bool BelowLowArc(in ApproachBracket at)
    {
        // Use the lowest kick that passes above the target, and the next lower one. If there is none, search down to the bound.
        Approach above = at.Low.Above ? at.Low : at.Middle.Above ? at.Middle : at.High;
        Approach below = at.Low.Above || at.Middle.Above ? at.Low : at.Middle;
        return FromBound(in below, in above, _approaches.Bounds.Lowest);
    }

    /// <summary>Finds the hit at the upper end of the elevations that pass above.</summary>
    private bool AboveHighArc(in ApproachBracket at)
    {
        Approach above = at.High.Above ? at.High : at.Middle.Above ? at.Middle : at.Low;
        Approach below = at.High.Above || at.Middle.Above ? at.High : at.Middle;
        return FromBound(in below, in above, _approaches.Bounds.Highest);
    }

    private bool FromBound(in Approach outer, in Approach above, double bound)
    {
        // Even the outer kick passes above: simulate a kick at the bound itself, because nothing beyond the bound is allowed.
        Approach below = outer.Above && outer.Elevation != bound ? _approaches.At(bound) : outer;
        return !below.Above && Between(in below, in above);
    }

    /// <summary>The signed miss as a function of the elevation; the search ends at a hit.</summary>
    private struct MissOverElevation(ApproachByElevation approaches, in Approach one, in Approach other) : IFunction
    {
        private readonly ApproachByElevation _approaches = approaches;
        private Approach _one = one;
        private Approach _other = other;

        public bool Hits { get; private set; } = false;

        public bool Evaluate(double x, out double value)
        {
            // Start with the azimuth of the closer of the two enclosing kicks.
            Approach next = _approaches.HitAt(x, _one.Miss < _other.Miss ? _one : _other);

            // Keep the two kicks that enclose the root: they yield the azimuth, and reveal a jump.
            value = next.SignedMiss;
            Hits = _approaches.Accept(in next);
            if (value < 0 == _one.SignedMiss < 0)
            {
                _one = next;
            }
            else
            {
                _other = next;
            }

            return Hits || _approaches.IsSpent || Jumps;
        }

        /// <summary>True if the miss jumps across zero between the two kicks, so that there is no root.</summary>
        private readonly bool Jumps =>
            _one.Miss + _other.Miss > Jump * Math.Abs(_one.Elevation - _other.Elevation) * _approaches.Speed * Math.Max(_one.Time, _other.Time);
    }
}
