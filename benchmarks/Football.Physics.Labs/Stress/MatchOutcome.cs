namespace FootballPhysics.Labs.Stress;

/// <summary>One of the claims that a match is checked against.</summary>
internal enum MatchClaim
{
    Inside,
    Goals,
    Rests,
    Events,
    Stalled,
    Finite,
    Stays,
    Path,
    Throws,
}

/// <summary>The claims of one match, and the work of its steps.</summary>
internal sealed class MatchOutcome(long index)
{
    private static readonly int s_claims = Enum.GetValues<MatchClaim>().Length;

    private readonly long[] _broken = new long[s_claims];
    private readonly double[] _worst = new double[s_claims];
    private readonly string[] _at = [.. Enumerable.Repeat("", s_claims)];

    public long Index => index;

    public int Balls { get; init; }

    /// <summary>The evaluations of each step, per ball.</summary>
    public List<int> Evaluations { get; } = [];

    public Peak<int, FormattableString> MostEvaluations { get; } = new($"");

    /// <summary>Returns the number of violations of a claim.</summary>
    public long Broken(MatchClaim claim) => _broken[(int)claim];

    /// <summary>Returns the worst size of a claim.</summary>
    public double Worst(MatchClaim claim) => _worst[(int)claim];

    /// <summary>Returns the scene of the worst size, or of the first violation.</summary>
    public string At(MatchClaim claim) => _at[(int)claim];

    /// <summary>Adds a size that a claim bounds.</summary>
    public void See(MatchClaim claim, double size, bool holds, FormattableString at)
    {
        int i = (int)claim;
        _broken[i] += holds ? 0 : 1;
        if (size > _worst[i] || (!holds && _at[i].Length == 0))
        {
            _worst[i] = Math.Max(size, _worst[i]);
            _at[i] = FormattableString.Invariant($"match {index}, ") + FormattableString.Invariant(at);
        }
    }
}
