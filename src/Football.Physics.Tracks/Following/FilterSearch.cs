using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The hypotheses of a filter: adds, weighs and drops them.</summary>
internal sealed partial class FilterSearch
{
    /// <summary>The number of hypotheses that are kept, also if the last point has no height, and the number of slots: one more receives a candidate.</summary>
    private const int Kept = 7;
    private const int KeptWithoutHeight = 11;
    public const int Slots = KeptWithoutHeight + 1;

    /// <summary>A hypothesis whose evidence, a logarithm, is this much below that of the best is dropped; also if the last point has no height.</summary>
    private const double ImprobableWithHeight = 10;
    private const double ImprobableWithoutHeight = 20;

    /// <summary>The estimated gain of a kick, a logarithm, from which it is fitted; below 0, because the estimate is rough.</summary>
    private const double LeastGain = -3;

    /// <summary>The number of rejected points in a row after which the filter also tries a new start, and the log probability of one.</summary>
    private const int RejectedForStart = 4;
    private const int StartAgo = 3;
    private const double LogStart = -12;

    /// <summary>The index of the moment at which older points are condensed.</summary>
    private const int Condensed = FilterHistory.Room / 2;

    /// <summary>The number of iterations of a first fit.</summary>
    private const int Iterations = 4;

    /// <summary>The number of iterations before a kick is sought.</summary>
    private const int Again = 2;

    /// <summary>The number of points after a start in which a kick is not sought: the motion of the start is still unknown.</summary>
    private const int Fresh = 4;

    private readonly FilterModel _model;
    private readonly FilterPoints _points;

    /// <summary>The hypotheses, a candidate, free ones, and at the end that of a second fit.</summary>
    private readonly FilterHypothesis[] _slots = new FilterHypothesis[Slots + 1];
    private readonly FilterPriors _priors;
    private readonly FilterGain _gain = new();
    private readonly double[] _slopes = new double[FilterHistory.Room];

    public FilterSearch(FilterModel model, FilterPoints points)
    {
        _model = model;
        _points = points;
        _priors = new FilterPriors(model.Settings);
        for (int i = 0; i <= Slots; i++)
        {
            _slots[i] = new FilterHypothesis(model, i);
        }
    }

    public int Count { get; private set; }

    /// <summary>True if the last point shows a height.</summary>
    public bool HasHeight => _points[_points.Count - 1].Kind != FilterPointKind.OnPlan;

    private double Improbable => HasHeight ? ImprobableWithHeight : ImprobableWithoutHeight;

    public FilterHypothesis this[int index] => _slots[index];

    /// <summary>The hypothesis with the greatest evidence.</summary>
    public FilterHypothesis Best
    {
        get
        {
            int best = 0;
            for (int i = 1; i < Count; i++)
            {
                best = _slots[i].Evidence > _slots[best].Evidence ? i : best;
            }

            return _slots[best];
        }
    }

    /// <summary>Starts with the first point.</summary>
    public void Begin(in Vector3d guess)
    {
        Count = 0;
        _twinLeft = 0;
        StartAt(in _points[_points.Count - 1], in guess, 0);
    }

    /// <summary>The share of starts and of kicks from the ground in which the ball stays on the ground, as a logarithm.</summary>
    private static readonly double LogOnGround = Elementary.Log(0.4);

    /// <summary>Includes the last point.</summary>
    public void Add()
    {
        // A second fit waits for work that is left. Other fits may repeat at each point, so they leave it a share.
        _model.KeepFor(_twinLeft > 0 ? _slots[Slots].WorkOfFit : 0);
        int added = 0;
        for (int i = Next(added); i >= 0; i = Next(added))
        {
            _slots[i].IsKept = added == 0;
            _slots[i].Add(_points);
            added |= 1 << i;
        }

        _model.KeepFor(0);
        Drop();
        FitTwin();
        Branch(Best);
        Drop();
    }

    /// <summary>Includes a late point.</summary>
    public void Insert(double time)
    {
        if (_slots[Slots].StartTime < time)
        {
            _slots[Slots].Restart();
        }

        int included = 0;
        for (int i = Next(included); i >= 0; i = Next(included))
        {
            FilterHypothesis into = _slots[i];
            into.IsKept = included == 0;
            included |= 1 << i;
            if (into.StartTime < time)
            {
                into.IsStale = true;
                if (into.MayFit)
                {
                    into.Fit(_points, 1);
                }
            }
        }

        Drop();
    }

    /// <summary>Returns the hypothesis with the greatest evidence of those whose bit is not set; −1 if there is none. The work may not suffice for all.</summary>
    private int Next(int done)
    {
        int next = -1;
        for (int i = 0; i < Count; i++)
        {
            if ((done & (1 << i)) == 0 && (next < 0 || _slots[i].Evidence > _slots[next].Evidence))
            {
                next = i;
            }
        }

        return next;
    }

    /// <summary>Condenses the points before the history of hypotheses that are older than a time, as far as the work of the update suffices.</summary>
    public void Condense(double time)
    {
        // The points of a second fit are forgotten, too.
        _twinLeft = _slots[Slots].StartTime < time ? 0 : _twinLeft;
        for (int i = 0; i < Count; i++)
        {
            FilterHypothesis old = _slots[i];
            bool isFull = old.History.Count == FilterHistory.Room;

            // A rolling ball has fewer parameters, and its motion no longer depends on how it came to roll.
            if (isFull && old.MayEndFit && (old.StartTime < time || (old.Kind != FilterStart.Rolling && old.History[0].Rolls && old.History[Condensed].Rolls)))
            {
                Condense(old);
            }
        }
    }

    /// <summary>The earliest start of a hypothesis.</summary>
    public double EarliestStart
    {
        get
        {
            double time = _twinLeft > 0 ? _slots[Slots].StartTime : double.PositiveInfinity;
            for (int i = 0; i < Count; i++)
            {
                time = Math.Min(time, _slots[i].StartTime);
            }

            return time;
        }
    }

    public void Transfer(ref FilterStream stream)
    {
        Count = stream.Whole(Count);
        for (int i = 0; i <= Slots; i++)
        {
            // The slots keep their order: it decides between equal evidence.
            int slot = stream.Whole(_slots[i].Slot);
            int at = Array.FindIndex(_slots, hypothesis => hypothesis.Slot == slot);
            (_slots[i], _slots[at]) = (_slots[at], _slots[i]);
        }

        stream.Whole(ref _twinLeft);
        for (int i = 0; i <= Slots; i++)
        {
            if (i < Count || (i == Slots && _twinLeft > 0))
            {
                _slots[i].Transfer(ref stream);
            }
        }
    }

    private void Condense(FilterHypothesis old)
    {
        // Start at a moment of the middle of the history: earlier estimates are less certain, and later ones leave no points to find a kick in.
        FilterHistory history = old.History;
        int at = Condensed;
        while (at >= 0 && !(history[at].IsSmooth && history[at + 1].Time > history[at].Time && history[at].Coordinates > 0))
        {
            at--;
        }

        if (at < 0)
        {
            return;
        }

        FilterMoment moment = history[at];
        FilterStart kind = moment.Rolls ? FilterStart.Rolling : FilterStart.Free;
        _priors.SetMoment(old, moment, kind);
        old.Start(moment.Time, moment.Evidence, old.KickTime, old.KickDeviation, kind);
        old.IsKept = true;
        old.Fit(_points, 1);
    }

    /// <summary>Adds the kicks that may explain the last points.</summary>
    private void Branch(FilterHypothesis best)
    {
        FilterHistory history = best.History;
        int last = history.Count - 1;
        if (best.RejectsLast)
        {
            for (int at = last; at > Math.Max(best.IncludesStart ? Fresh : 0, last - 3); at--)
            {
                if (_model.MayBranch)
                {
                    Kick(best, at);
                }
            }

            if (best.RejectedInRow >= RejectedForStart)
            {
                FilterMoment first = history[Math.Max(0, last - StartAgo)];
                int point = _points.After(first.Time);
                if (_points[point].Kind == FilterPointKind.Position)
                {
                    StartAt(in _points[point], _points[point].Value, first.Evidence + LogStart);
                }
            }
        }

        int likely = _gain.Find(best, _model.Settings, LeastGain);

        // A slide that keeps moving away from the fit may have another spin.
        bool isDoubtful = likely > 0 || best.RejectsLast || (HasHeight && best.HasMoved && best.Touches);
        if (likely > 0)
        {
            // A fit that has not converged looks like a kick. Without time for it, the next update seeks the kick.
            bool mayFit = best.MayFit;
            if (mayFit)
            {
                best.Fit(_points, Again);
            }

            likely = mayFit ? _gain.Find(best, _model.Settings, LeastGain) : 0;
        }

        if (likely > 0)
        {
            Kick(best, likely);
        }

        BeginTwin(isDoubtful ? best : Oldest);
        FitTwin();
    }

    /// <summary>Adds a kick just before a moment of a hypothesis.</summary>
    private void Kick(FilterHypothesis best, int at)
    {
        FilterMoment before = best.History[at - 1];
        double end = best.History[at].Time;
        double span = end - before.Time;
        if (!(span > 0))
        {
            return;
        }

        BallState state = _model.Launch(best.MotionAt(before), before.Time, before.Rolls);
        BallState middle = state;
        _model.Run(ref middle, before.Time + (0.5 * span));
        Vector3d velocity = Velocity(in middle, best, at, out bool hasHeight);
        double prefix = before.Evidence + Elementary.Log(Math.Min(0.5, _model.Settings.KicksPerSecond * span));
        bool lies = _model.Touches(middle.Position.Y);
        for (FilterStart kind = FilterStart.Free; kind <= (lies ? FilterStart.Sliding : FilterStart.Free); kind++)
        {
            bool isSplit = kind == FilterStart.Free && !hasHeight;
            UpwardParts parts = isSplit ? lies ? UpwardParts.FromGround : UpwardParts.InAir : UpwardParts.None;
            for (int part = 0; part < parts.Count; part++)
            {
                if (_model.MayRun && IsNew(before.Time, kind, part, false))
                {
                    bool fits = Try(false);

                    // The first point after the kick may be a wrong one.
                    if (!fits && at < best.History.Count - 1 && IsNew(before.Time, kind, part, true))
                    {
                        Try(true);
                    }
                }

                bool Try(bool skipsFirst)
                {
                    FilterHypothesis kick = _slots[Count];
                    _priors.SetKick(kick, before, best.Count, span, kind);
                    Vector3d guess = velocity;
                    if (isSplit)
                    {
                        guess = new Vector3d(velocity.X, _priors.SetUpward(kick, parts, part), velocity.Z);
                    }

                    kick.Start(in state, end, prefix + (kind == FilterStart.Free ? parts.LogShare : LogOnGround), in guess, kind);
                    kick.Part = part;
                    kick.SkipsFirst = skipsFirst;
                    kick.Fit(_points, Iterations);
                    Keep();
                    return !kick.RejectsLast;
                }
            }
        }
    }

    /// <summary>True if there is no such kick yet; removes one that does not explain the last point.</summary>
    private bool IsNew(double time, FilterStart kind, int part, bool skipsFirst)
    {
        for (int i = 0; i < Count; i++)
        {
            FilterHypothesis other = _slots[i];
            if (other.Count == FilterHypothesis.Most && other.StartTime.Equals(time) && other.Kind == kind && other.Part == part && other.SkipsFirst == skipsFirst)
            {
                if (!other.RejectsLast || other.Used > 1 || Count == 1)
                {
                    return false;
                }

                Remove(i);
                return true;
            }
        }

        return true;
    }

    /// <summary>Keeps the candidate of the last slot if it is probable; if there is no room, in exchange for the least probable one.</summary>
    private void Keep()
    {
        FilterHypothesis candidate = _slots[Count];
        if (!double.IsFinite(candidate.Evidence) || (Count > 0 && candidate.Evidence < Best.Evidence - Improbable))
        {
            return;
        }

        Count++;
        if (Count > (HasHeight ? Kept : KeptWithoutHeight))
        {
            int worst = 0;
            for (int i = 1; i < Count; i++)
            {
                worst = _slots[i].Evidence < _slots[worst].Evidence ? i : worst;
            }

            Remove(worst);
        }
    }

    /// <summary>Drops improbable hypotheses, and of those that have converged to the same motion all but the most probable one.</summary>
    private void Drop()
    {
        for (int i = Count - 1; i > 0; i--)
        {
            for (int j = 0; j < i; j++)
            {
                if (_slots[i].StartsLike(_slots[j]) && _slots[i].AgreesWith(_slots[j]))
                {
                    Remove(_slots[i].Evidence > _slots[j].Evidence ? j : i);
                    break;
                }
            }
        }

        double least = Best.Evidence - Improbable;
        for (int i = Count - 1; i >= 0; i--)
        {
            if (!(_slots[i].Evidence >= least) && Count > 1)
            {
                Remove(i);
            }
        }
    }

    private void Remove(int index)
    {
        Count--;
        (_slots[index], _slots[Count]) = (_slots[Count], _slots[index]);
    }
}
