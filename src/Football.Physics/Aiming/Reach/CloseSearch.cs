namespace Football.Physics;

/// <summary>Many elevations: every change of sign of the miss distance is a hit, and every valley is searched to its bottom.</summary>
internal sealed class CloseSearch
{
    private const int Looks = 25;

    private readonly ApproachByElevation _approaches;
    private readonly ValleySearch _valley;
    private readonly HitSearch _hits;
    private readonly Approach[] _looks = new Approach[Looks];

    public CloseSearch(ApproachByElevation approaches, ValleySearch valley, HitSearch hits)
    {
        _approaches = approaches;
        _valley = valley;
        _hits = hits;
    }

    /// <summary>Searches.</summary>
    /// <param name="arc">Which of two hits is wanted.</param>
    /// <returns>Whether a hit was found.</returns>
    public bool Find(AimArc arc)
    {
        double lowest = _approaches.Bounds.Lowest;
        double highest = _approaches.Bounds.Highest;
        for (int i = 0; i < Looks; i++)
        {
            if (_approaches.IsSpent)
            {
                return _approaches.Accept(_approaches.Best);
            }

            _looks[i] = _approaches.At(i == Looks - 1 ? highest : lowest + ((highest - lowest) * i / (Looks - 1)));
        }

        for (int i = 1; i < Looks; i++)
        {
            int at = arc == AimArc.Low ? i : Looks - i;
            if (_looks[at - 1].Above != _looks[at].Above && _hits.Between(in _looks[at - 1], in _looks[at]))
            {
                return true;
            }
        }

        for (int i = 0; i < Looks; i++)
        {
            double miss = _looks[i].Miss;
            if (miss <= _looks[Math.Max(0, i - 1)].Miss && miss <= _looks[Math.Min(Looks - 1, i + 1)].Miss && FindInValley(i, arc))
            {
                return true;
            }
        }

        return _approaches.Accept(_approaches.Best);
    }

    private bool FindInValley(int look, AimArc arc)
    {
        int middle = Math.Min(Math.Max(look, 1), Looks - 2);
        var at = new ApproachBracket(in _looks[middle - 1], in _looks[middle], in _looks[middle + 1]);
        if (!_valley.Descend(ref at, enough: double.PositiveInfinity))
        {
            return false;
        }

        return arc == AimArc.Low
            ? _hits.Between(in at.Low, in at.Middle) || _hits.Between(in at.High, in at.Middle)
            : _hits.Between(in at.High, in at.Middle) || _hits.Between(in at.Low, in at.Middle);
    }
}
