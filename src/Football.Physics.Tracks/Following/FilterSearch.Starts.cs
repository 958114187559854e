namespace FootballPhysics.Tracks;

/// <content>The motions at which fits start.</content>
internal sealed partial class FilterSearch
{
    /// <summary>Guesses the velocity after a kick: the median of the slopes to the points since then, corrected for gravity.</summary>
    private Vector3d Velocity(in BallState from, FilterHypothesis best, int at, out bool hasHeight)
    {
        hasHeight = true;
        int first = _points.After(best.History[at - 1].Time);
        int count = Math.Min(_slopes.Length, _points.Count - first);
        if (count == 0)
        {
            return from.Velocity;
        }

        hasHeight = false;
        for (int i = first; i < first + count; i++)
        {
            hasHeight |= _points[i].Kind != FilterPointKind.OnPlan;
            if (_points[i].Kind == FilterPointKind.Pixel)
            {
                return from.Velocity + _gain.Change;
            }
        }

        double fall = 0.5 * _model.Simulator.Scene.Gravity;
        Span<double> slope = stackalloc double[3];
        for (int axis = 0; axis < 3; axis++)
        {
            // Of two slopes, the last is the more accurate one.
            int used = Math.Min(count, count < 3 ? 1 : count);
            for (int i = 0; i < used; i++)
            {
                ref FilterPoint point = ref _points[first + count - 1 - i];
                double time = point.Time - from.Time;
                _slopes[i] = ((point.Value.Along(axis) - from.Position.Along(axis)) / time) + (axis == 1 ? fall * time : 0);
            }

            Array.Sort(_slopes, 0, used);
            slope[axis] = used % 2 == 1 ? _slopes[used / 2] : 0.5 * (_slopes[used / 2] + _slopes[(used / 2) - 1]);
        }

        return new Vector3d(slope[0], slope[1], slope[2]);
    }

    /// <summary>Adds a start at a point, without a path before it.</summary>
    private void StartAt(in FilterPoint point, in Vector3d guess, double prefix)
    {
        // Rolling, in the air, or sliding.
        bool mayLie = _model.Touches(guess.Y - (4 * point.Deviation)) || point.Kind != FilterPointKind.Position;
        for (FilterStart kind = FilterStart.Free; kind <= (mayLie ? FilterStart.Rolling : FilterStart.Free); kind++)
        {
            if (kind == FilterStart.Sliding)
            {
                continue;
            }

            bool isSplit = kind == FilterStart.Free && point.Kind == FilterPointKind.OnPlan;
            UpwardParts parts = isSplit ? UpwardParts.AtStart : UpwardParts.None;
            for (int part = 0; part < parts.Count; part++)
            {
                FilterHypothesis start = _slots[Count];
                _priors.SetStart(start, in point, in guess, kind);
                if (isSplit)
                {
                    _priors.SetHeight(start);
                    _priors.SetUpward(start, parts, part);
                }

                start.Start(point.Time, prefix + (kind == FilterStart.Free ? parts.LogShare : LogOnGround), double.NegativeInfinity, 0, kind);
                start.Part = part;
                start.IncludesStart = true;
                start.Fit(_points, Iterations);
                Keep();
            }
        }
    }
}
