namespace FootballPhysics.Aiming;

/// <summary>The closest approach to a target as a function of the elevation: each kick with the azimuth that brings it closest.</summary>
internal sealed class ApproachByElevation
{
    /// <summary>Flights that may be spent on the azimuth of one elevation.</summary>
    private const int MostTurns = 12;

    /// <summary>Share of its miss by which a kick may be off to the side: the miss is known to a millionth then.</summary>
    private const double SmallOffset = 2e-3;

    /// <summary>Where no wind is known yet, the drift of a ball is about this share of the wind's own way.</summary>
    private const double Drift = 0.3;

    /// <summary>Up to so many tolerances off, a flight is taken again in shorter steps.</summary>
    private const double NearHit = 10;

    private readonly AimContext _context;
    private TargetFrame _frame;
    private Vector3d _targetVelocity;
    private Kick _kick;

    public ApproachByElevation(AimContext context) => _context = context;

    /// <summary>The elevations that are searched.</summary>
    public ElevationBounds Bounds { get; set; }

    /// <summary>Miss distance of a hit that is sharp enough, m.</summary>
    public double Tolerance { get; private set; }

    /// <summary>The closest approach so far.</summary>
    public Approach Best { get; private set; }

    /// <summary>The hit that was accepted.</summary>
    public Approach Hit { get; private set; }

    /// <summary>Speed of the kicks, m/s.</summary>
    public double Speed { get; private set; }

    /// <summary>True when flights turn with their azimuth, so that the azimuth of an elevation is known after one.</summary>
    public bool TurnWithAzimuth => _context.Turns(in _targetVelocity);

    /// <summary>True when nothing more can be searched.</summary>
    public bool IsSpent => _context.IsSpent;

    /// <summary>Prepares for a target.</summary>
    public void Aim(PlaneProblem problem)
    {
        _frame = problem.Frame;
        _targetVelocity = problem.Request.TargetVelocity;
        _kick = problem.Spins;
        Speed = problem.Speed;
        Tolerance = problem.Tolerance;
        Bounds = problem.Bounds;
        Best = new Approach { Kick = _kick, Miss = double.PositiveInfinity };
    }

    /// <summary>Takes an approach for the answer, if it hits.</summary>
    public bool Accept(in Approach approach)
    {
        if (!(approach.Miss <= Tolerance))
        {
            return false;
        }

        Hit = approach;
        return true;
    }

    /// <summary>Flies an elevation, beginning with the azimuth of the last one.</summary>
    public Approach At(double elevation) => At(elevation, _context.Steps.Search);

    /// <summary>Flies an elevation, beginning with the azimuth of another.</summary>
    public Approach At(double elevation, in Approach near)
    {
        _kick.Azimuth = near.Kick.Azimuth;
        return At(elevation);
    }

    /// <summary>Closest approach of an elevation, in the shorter steps of a hit.</summary>
    public Approach HitAt(double elevation, in Approach near)
    {
        _kick.Azimuth = near.Kick.Azimuth;
        return At(elevation, _context.Steps.Hit);
    }

    /// <summary>Flies a kick as it is.</summary>
    public Approach Of(in Kick kick)
    {
        _kick.Elevation = kick.Elevation;
        _kick.Azimuth = kick.Azimuth;
        return Fly(_context.Steps.Search);
    }

    /// <summary>Rolls along the ground, straight at the target at first.</summary>
    public Approach Roll(double elevation)
    {
        _kick.Azimuth = 0;
        return At(elevation);
    }

    private Approach At(double elevation, double step)
    {
        // In still air one flight tells the azimuth too; in a wind it is turned until the target lies in the way's own direction.
        _kick.Elevation = elevation;
        Approach approach = Fly(step);
        if (approach.Miss < NearHit * Tolerance && step > _context.Steps.Hit)
        {
            // A hit is not said from long steps.
            step = _context.Steps.Hit;
            approach = Fly(step);
        }

        // In still air that was all: the flight has told its own azimuth.
        if (TurnWithAzimuth)
        {
            _kick.Azimuth = approach.Kick.Azimuth;
            return approach;
        }

        approach = Turned(approach, step);
        if (approach.Time == 0 && approach.Kick.Azimuth != 0)
        {
            // Kicked the wrong way, it was never closer than at the start, which says nothing of where to turn.
            _kick.Azimuth = 0;
            Approach straight = Turned(Fly(step), step);
            approach = straight.Miss < approach.Miss ? straight : approach;
        }

        return approach;
    }

    /// <summary>In a wind: turns a kick until it passes the target as closely as that allows.</summary>
    private Approach Turned(Approach approach, double step)
    {
        // Turning a kick turns its way about a point c that the wind carries along: the target is to be seen from c where the ball is.
        Vector3d toTarget = _frame.Target - _frame.From;
        Vector3d c = approach.Time * ((Drift * _context.Scene.Air.Wind) - _targetVelocity);
        for (int i = 0; i < MostTurns && !IsSpent; i++)
        {
            // The short way round; enough where what is left to the side is little of the miss.
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

    /// <summary>The point about which a turn moved the closest point: p₂ − c = R (p₁ − c).</summary>
    private void Centre(in Vector3d one, in Vector3d other, double turn, ref Vector3d c)
    {
        if (!(Math.Abs(turn) > 1e-3))
        {
            return;
        }

        Elementary.SinCos(turn, out double sin, out double cos);

        // As complex numbers, forward the real and left the imaginary axis.
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

        return approach;
    }
}

/// <summary>The hit between a kick that passes above the target and one that does not: the root of the signed miss distance over the elevation.</summary>
internal sealed class HitSearch
{
    /// <summary>Flights that a search may always take.</summary>
    private const int LeastShots = 8;

    /// <summary>So many lengths of the way a radian: a signed miss that rises faster through zero jumps, for its closest point is another one then.</summary>
    private const double Jump = 100;

    private readonly ApproachByElevation _approaches;
    private int _mostShots;

    public HitSearch(ApproachByElevation approaches) => _approaches = approaches;

    /// <summary>Prepares for a request.</summary>
    public void Begin(AimRequest request) => _mostShots = Math.Max(LeastShots, request.MaximumIterations);

    /// <summary>The hit between two elevations.</summary>
    /// <returns>False where there is none, or it was not found.</returns>
    public bool Between(in Approach one, in Approach other)
    {
        if (_approaches.Accept(in one) || _approaches.Accept(in other))
        {
            return true;
        }

        // Without a change of sign there is no root between.
        if (one.SignedMiss < 0 == other.SignedMiss < 0)
        {
            return false;
        }

        var miss = new MissOverElevation(_approaches, in one, in other);
        Roots.Illinois(ref miss, one.Elevation, one.SignedMiss, other.Elevation, other.SignedMiss, 1e-12, _mostShots);
        return miss.Hits;
    }

    /// <summary>A hit on one arc, or else on the other, beside three elevations of which one at least passes above the target.</summary>
    public bool Beside(in ApproachBracket at, AimArc arc) =>
        arc == AimArc.Low ? BelowLowArc(in at) || AboveHighArc(in at) : AboveHighArc(in at) || BelowLowArc(in at);

    /// <summary>The hit at the lower end of the elevations that pass above.</summary>
    private bool BelowLowArc(in ApproachBracket at)
    {
        // The lowest of the three that passes above, and the one below it; where there is none, it is looked for at the bound.
        Approach above = at.Low.Above ? at.Low : at.Middle.Above ? at.Middle : at.High;
        Approach below = at.Low.Above || at.Middle.Above ? at.Low : at.Middle;
        return FromBound(in below, in above, _approaches.Bounds.Lowest);
    }

    /// <summary>The hit at their upper end.</summary>
    private bool AboveHighArc(in ApproachBracket at)
    {
        Approach above = at.High.Above ? at.High : at.Middle.Above ? at.Middle : at.Low;
        Approach below = at.High.Above || at.Middle.Above ? at.High : at.Middle;
        return FromBound(in below, in above, _approaches.Bounds.Highest);
    }

    private bool FromBound(in Approach outer, in Approach above, double bound)
    {
        // Where even the outer one passes above, the bound itself is flown: beyond it nothing is allowed.
        Approach below = outer.Above && outer.Elevation != bound ? _approaches.At(bound) : outer;
        return !below.Above && Between(in below, in above);
    }

    /// <summary>The signed miss distance over the elevation; done where it hits.</summary>
    private struct MissOverElevation : IFunction
    {
        private readonly ApproachByElevation _approaches;
        private Approach _one;
        private Approach _other;

        public MissOverElevation(ApproachByElevation approaches, in Approach one, in Approach other)
        {
            _approaches = approaches;
            _one = one;
            _other = other;
            Hits = false;
        }

        public bool Hits { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            // It begins with the azimuth of the nearer of the two that it lies between.
            Approach next = _approaches.HitAt(x, _one.Miss < _other.Miss ? _one : _other);

            // The two kicks between which the root lies are kept, for the azimuth and to see a jump.
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

        /// <summary>True when the miss has no root between the two kicks, but jumps over it.</summary>
        private readonly bool Jumps =>
            _one.Miss + _other.Miss > Jump * Math.Abs(_one.Elevation - _other.Elevation) * _approaches.Speed * Math.Max(_one.Time, _other.Time);
    }
}
