namespace FootballPhysics.Tracks;

/// <content>Second fits of doubtful hypotheses.</content>
/// <remarks>
/// The friction of a slide and of an impact depends on the direction of the slip, so the density of the spin can have two maxima. A fit that reaches the lower
/// one stays there, and then a kick explains its misfit. A fit that starts with topspin, between sliding and rolling, reaches the higher one in most cases.
/// </remarks>
internal sealed partial class FilterSearch
{
    /// <summary>The topspin at which a second fit starts, in standard deviations of the spin of a kick.</summary>
    private const double TwinSpin = 1.5;

    /// <summary>The number of iterations of a second fit, which several updates may share.</summary>
    private const int TwinIterations = 5;

    /// <summary>The ratio of the numbers of points after which another second fit may find another maximum.</summary>
    private const double TwinGrowth = 1.25;

    /// <summary>The number of points after a kick in which an older hypothesis may still explain the points better.</summary>
    private const int Young = FilterHistory.Room;

    /// <summary>The least number of points that decide between two spins.</summary>
    private const int TwinPoints = 5;

    /// <summary>The number of iterations that are left of the second fit in the last slot; 0 without one.</summary>
    private int _twinLeft;

    /// <summary>Starts a second fit of a hypothesis, unless there is one or it was tried.</summary>
    private void BeginTwin(FilterHypothesis? of)
    {
        if (_twinLeft > 0 || of is null || of.Kind == FilterStart.Rolling || of.Points < TwinPoints || of.Points < TwinGrowth * of.TwinPoints)
        {
            return;
        }

        var along = new Vector3d(of.Values[3], 0, of.Values[5]);
        double speed = along.Length;
        if (speed > 0)
        {
            of.TwinPoints = of.Points;
            _slots[Slots].StartLike(of, TwinSpin * _model.Settings.KickSpin / speed * Vector3d.Cross(Vector3d.Up, along));
            _twinLeft = TwinIterations;
        }
    }

    /// <summary>Continues the second fit until the work of the update is used up, and adds its hypothesis at the end.</summary>
    private void FitTwin()
    {
        FilterHypothesis twin = _slots[Slots];
        while (_twinLeft > 0 && _model.MayFit)
        {
            bool ends = twin.Fit(_points, 1);
            if (twin.IsPaused)
            {
                return;
            }

            _twinLeft = ends ? 0 : _twinLeft - 1;
            if (_twinLeft == 0)
            {
                twin.MayPause = false;
                (_slots[Count], _slots[Slots]) = (twin, _slots[Count]);
                Keep();
                Drop();
            }
        }
    }

    /// <summary>The hypothesis with the earliest start, if a recent kick is more probable; null if there is none.</summary>
    private FilterHypothesis? Oldest
    {
        get
        {
            FilterHypothesis best = Best;
            FilterHypothesis oldest = best;
            for (int i = 0; i < Count; i++)
            {
                oldest = _slots[i].StartTime < oldest.StartTime ? _slots[i] : oldest;
            }

            return oldest != best && best.Count == FilterHypothesis.Most && best.Points <= Young ? oldest : null;
        }
    }
}
