namespace FootballPhysics.Labs.People;

/// <summary>The parts of a claim that a table shows.</summary>
[Flags]
internal enum ClaimParts
{
    Count = 1,
    Worst = 2,

    /// <summary>The claim fails if its count is not 0.</summary>
    Verdict = 4,
}

/// <summary>A claim over many cases: the number of violations, the worst size, and its scene.</summary>
internal sealed class PeopleClaim(string what, ClaimParts parts = ClaimParts.Count | ClaimParts.Verdict)
{
    private string _at = "";

    /// <summary>The number of cases, and the number that violate the claim.</summary>
    public long Of { get; private set; }

    public long Count { get; private set; }

    public double Worst { get; private set; }

    public bool Holds => !parts.HasFlag(ClaimParts.Verdict) || Count == 0;

    /// <summary>Adds a case.</summary>
    public void Case(bool isBroken, FormattableString? at = null)
    {
        Of++;
        Count += isBroken ? 1 : 0;
        _at = isBroken && at is not null ? FormattableString.Invariant(at) : _at;
    }

    /// <summary>Adds a number of cases.</summary>
    public void Add(long count)
    {
        Of++;
        Count += count;
    }

    /// <summary>Keeps a size if it is the worst so far.</summary>
    public void See(double size, FormattableString? at = null)
    {
        if (size > Worst)
        {
            Worst = size;
            _at = at is not null ? FormattableString.Invariant(at) : _at;
        }
    }

    /// <summary>Adds its row.</summary>
    public void Report(LabTable table, LabRun run)
    {
        table.Add(
            what, Of, parts.HasFlag(ClaimParts.Count) ? Count : null, parts.HasFlag(ClaimParts.Worst) ? Worst : null,
            parts.HasFlag(ClaimParts.Verdict) ? Verdict.Of(Holds) : null);
        run.Failed |= !Holds;
        if (_at.Length > 0 && (!Holds || !parts.HasFlag(ClaimParts.Verdict)))
        {
            run.Notes.Add(FormattableString.Invariant($"{what}: {_at}"));
        }
    }
}

/// <summary>Cases of one kind, and their claims.</summary>
/// <param name="name">The name of its balls in the table.</param>
internal abstract class PeopleCases(string name)
{
    protected const double Radius = 0.11;

    /// <summary>A ball that is deeper than this, m, is inside.</summary>
    protected const double Entered = 1e-6;

    public string Name => name;

    public StepMeter Meter { get; } = new();

    public int Cases { get; protected set; }

    public abstract PeopleClaim[] Claims { get; }

    /// <summary>Simulates a case.</summary>
    public abstract void Play(long seed, int index);
}
