namespace Football.Physics;

/// <summary>
/// In a wind, where elevation and azimuth do not separate: whether a kick beside the closest one, up, down, left or right, is closer. Steps are
/// halved where none is.
/// </summary>
internal sealed class CompassSearch
{
    private const int MostShots = 30;

    /// <summary>Steps, first and last, rad.</summary>
    private const double FirstStep = 0.04;
    private const double LastStep = 1e-3;

    private readonly ApproachByElevation _approaches;

    public CompassSearch(ApproachByElevation approaches) => _approaches = approaches;

    /// <summary>Searches around the closest kick so far.</summary>
    /// <param name="rolls">Whether that rolls, so that its elevation does not matter.</param>
    public void Find(bool rolls)
    {
        int shots = 0;
        for (double step = FirstStep; step > LastStep && shots < MostShots && !_approaches.IsSpent; step *= 0.5)
        {
            bool closer = true;
            while (closer && shots < MostShots && !_approaches.IsSpent)
            {
                closer = false;
                for (int i = rolls ? 2 : 0; i < 4 && !closer; i++)
                {
                    Approach best = _approaches.Best;
                    Kick kick = best.Kick;
                    double move = i % 2 == 0 ? step : -step;
                    kick.Elevation = i < 2 ? _approaches.Bounds.Clamp(kick.Elevation + move) : kick.Elevation;
                    kick.Azimuth += i < 2 ? 0 : move;
                    shots++;
                    closer = _approaches.Of(in kick).Miss < best.Miss;
                }
            }
        }
    }
}
