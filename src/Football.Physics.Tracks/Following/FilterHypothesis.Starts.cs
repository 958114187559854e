namespace FootballPhysics.Tracks;

/// <content>The starts of a hypothesis, and its bytes.</content>
internal sealed partial class FilterHypothesis
{
    /// <summary>Starts without a kick. The caller has set <see cref="Mean"/> and <see cref="Prior"/>.</summary>
    public void Start(double time, double prefix, double kickTime, double kickDeviation, FilterStart kind)
    {
        Kind = kind;
        _rays.Count = Motion;
        StartTime = time;
        EndOfKick = time;
        IncludesStart = false;
        SkipsFirst = false;
        Part = 0;
        Prefix = prefix;
        KickTime = kickTime;
        KickDeviation = kickDeviation;
        IsKept = false;
        MayPause = false;
        IsPaused = false;
        _spent = 0;
        TwinPoints = 0;
        _rays.Begin();
        Array.Copy(Mean, Values, Most);
        Array.Copy(Prior, Spread, Prior.Length);
    }

    /// <summary>Starts with a kick between two times. The caller has set <see cref="Mean"/> and <see cref="Prior"/>.</summary>
    public void Start(in BallState before, double end, double prefix, in Vector3d velocity, FilterStart kind)
    {
        Start(before.Time, prefix, 0, 0, kind);
        _rays.Count = Most;
        EndOfKick = end;
        _kick.Begin(in before);
        Values[3] = velocity.X;
        Values[4] = velocity.Y;
        Values[5] = velocity.Z;
    }

    /// <summary>Sets the motion at which the first fit starts.</summary>
    public void Guess(in Vector3d position, in Vector3d velocity, in Vector3d spin)
    {
        (Values[0], Values[1], Values[2]) = (position.X, position.Y, position.Z);
        (Values[3], Values[4], Values[5]) = (velocity.X, velocity.Y, velocity.Z);
        (Values[6], Values[7], Values[8]) = (spin.X, spin.Y, spin.Z);
    }

    /// <summary>The number of points at the last second fit of this motion; 0 without one.</summary>
    public int TwinPoints { get; set; }

    public void Transfer(ref FilterStream stream)
    {
        _rays.Count = stream.Whole(Count);
        _rays.Begin();
        Kind = (FilterStart)stream.Whole((int)Kind);
        Part = stream.Whole(Part);
        StartTime = stream.Number(StartTime);
        EndOfKick = stream.Number(EndOfKick);
        IncludesStart = stream.Flag(IncludesStart);
        SkipsFirst = stream.Flag(SkipsFirst);
        RejectsLast = stream.Flag(RejectsLast);
        IsStale = stream.Flag(IsStale);
        Evidence = stream.Number(Evidence);
        Prefix = stream.Number(Prefix);
        Used = stream.Whole(Used);
        Points = stream.Whole(Points);
        TwinPoints = stream.Whole(TwinPoints);
        RejectedInRow = stream.Whole(RejectedInRow);
        KickTime = stream.Number(KickTime);
        KickDeviation = stream.Number(KickDeviation);
        stream.Numbers(Mean);
        stream.Numbers(Prior);
        stream.Numbers(Base);
        stream.Numbers(Values);
        stream.Numbers(Spread);
        stream.Numbers(_rays.Widths);
        stream.Numbers(_leastWidths);
        stream.Number(ref _fitWork);
        stream.Number(ref _spent);
        MayPause = stream.Flag(MayPause);
        IsPaused = stream.Flag(IsPaused);
        _rays.ShortUntil = stream.Number(_rays.ShortUntil);
        stream.Flag(ref _lies);
        stream.Plain<bool>(_rays.IsFixed);
        stream.Plain<BallState>(_rays.States);
        _kick.Transfer(ref stream);
        History.Transfer(ref stream);
    }

    /// <summary>Starts with the distribution of another hypothesis, at its estimate with another spin.</summary>
    /// <remarks>The fit then converges to another maximum of the same density, if there is one.</remarks>
    public void StartLike(FilterHypothesis other, in Vector3d spin)
    {
        Array.Copy(other.Mean, Mean, Most);
        Array.Copy(other.Prior, Prior, Prior.Length);
        Start(other.StartTime, other.Prefix, other.KickTime, other.KickDeviation, other.Kind);
        _rays.Count = other.Count;
        EndOfKick = other.EndOfKick;
        IncludesStart = other.IncludesStart;
        SkipsFirst = other.SkipsFirst;
        Part = other.Part;
        _kick.Begin(other._kick);
        _fitWork = other._fitWork;
        MayPause = true;
        TwinPoints = other.TwinPoints;
        Array.Copy(other.Values, Values, Most);
        (Values[6], Values[7], Values[8]) = (spin.X, spin.Y, spin.Z);
    }

    /// <summary>True if another hypothesis has the same distribution at its start.</summary>
    public bool StartsLike(FilterHypothesis other) => other.Count == Count && other.StartTime.Equals(StartTime) && other.Kind == Kind
        && other.Part == Part && other.SkipsFirst == SkipsFirst && other.Prefix.Equals(Prefix);

    /// <summary>True if the estimate of another hypothesis with the same start is that of this one, within its deviations.</summary>
    public bool AgreesWith(FilterHypothesis other)
    {
        for (int j = 0; j < Count; j++)
        {
            double off = Values[j] - other.Values[j];
            if (off * off > Spread[(j * Most) + j])
            {
                return false;
            }
        }

        return true;
    }
}
