namespace Football.Physics;

/// <summary>
/// What the drag law's jump does to the bottom of a valley: a flight that just grazes it goes elsewhere at once, so that the miss distance over
/// the elevation has waves beside the bottom, and steps in the middle of a descent.
/// </summary>
internal sealed class WaveSearch
{
    /// <summary>How far apart, rad, and how many to each side, are looks for waves beside the bottom of a valley.</summary>
    private const double Wave = 0.025;
    private const int MostWaves = 4;

    /// <summary>What a step in the miss may hide, m, or as a share of the miss; and how often the way to it is halved.</summary>
    private const double StepCloseness = 5e-3;
    private const int MostHalvings = 12;

    private readonly ApproachByElevation _approaches;
    private readonly ValleySearch _valley;
    private readonly Approach[] _looks = new Approach[(2 * MostWaves) + 1];

    public WaveSearch(ApproachByElevation approaches, ValleySearch valley)
    {
        _approaches = approaches;
        _valley = valley;
    }

    /// <summary>Whether a wave beside the closest kick is deeper: looks to both sides of it.</summary>
    /// <param name="at">Where there are hits, three elevations beside them.</param>
    /// <returns>As <see cref="ValleySearch.Descend"/>.</returns>
    public bool Find(ref ApproachBracket at)
    {
        Approach best = _approaches.Best;
        double miss = best.Miss;
        Approach wave = default;
        int count = 0;
        for (int i = -MostWaves; i <= MostWaves; i++)
        {
            double elevation = best.Elevation + (i * Wave);
            if (!_approaches.Bounds.Contain(elevation))
            {
                continue;
            }

            Approach look = i == 0 ? best : _approaches.At(elevation);
            _looks[count++] = look;
            if (look.Miss < miss || look.Above)
            {
                wave = look;
                miss = look.Miss;
            }
        }

        if (wave.Miss > 0)
        {
            Approach low = _approaches.At(Math.Max(_approaches.Bounds.Lowest, wave.Elevation - (0.5 * Wave)));
            Approach high = _approaches.At(Math.Min(_approaches.Bounds.Highest, wave.Elevation + (0.5 * Wave)));
            at = new ApproachBracket(in low, in wave, in high);
            if (at.AnyAbove || _valley.Descend(ref at, enough: double.PositiveInfinity))
            {
                return true;
            }
        }

        for (int i = 3; i < count; i++)
        {
            // Upwards and downwards: three looks in a row, and the next.
            int k = count - 1 - i;
            if (FindStep(_looks[i - 3], _looks[i - 2], _looks[i - 1], _looks[i], ref at)
                || FindStep(_looks[k + 3], _looks[k + 2], _looks[k + 1], _looks[k], ref at))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// Where the miss steps up in the middle of a descent, it is least at the step: halving towards it, as long as the descent promises more than
    /// was found.
    /// </summary>
    /// <param name="one">First of three on the descent.</param>
    /// <param name="two">Second.</param>
    /// <param name="three">Third, the nearest to the step.</param>
    /// <param name="beyond">Perhaps beyond a step.</param>
    /// <param name="at">Where there are hits, three elevations beside them.</param>
    /// <returns>As <see cref="ValleySearch.Descend"/>.</returns>
    private bool FindStep(Approach one, Approach two, Approach three, Approach beyond, ref ApproachBracket at)
    {
        for (int i = 0; i < MostHalvings && !_approaches.IsSpent; i++)
        {
            double best = _approaches.Best.Miss;
            double promised = ApproachBracket.Extrapolate(in one, in two, in three, beyond.Elevation);
            if (!(Math.Max(0, promised) < best - (StepCloseness * Math.Max(1.0, best))))
            {
                return false;
            }

            double middle = 0.5 * (three.Elevation + beyond.Elevation);
            Approach look = _approaches.At(middle, in three);
            if (look.Above)
            {
                at = new ApproachBracket(in three, in look, in beyond);
                return true;
            }

            if (Math.Abs(look.Miss - ApproachBracket.Extrapolate(in one, in two, in three, middle)) < 0.25 * (beyond.Miss - promised))
            {
                (one, two, three) = (two, three, look);
            }
            else
            {
                beyond = look;
            }
        }

        return false;
    }
}
