namespace Football.Physics;

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

        /// <summary>Whether the miss has no root between the two kicks, but jumps over it.</summary>
        private readonly bool Jumps =>
            _one.Miss + _other.Miss > Jump * Math.Abs(_one.Elevation - _other.Elevation) * _approaches.Speed * Math.Max(_one.Time, _other.Time);
    }
}
