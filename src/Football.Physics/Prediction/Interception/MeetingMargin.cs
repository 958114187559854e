using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A condition for a meeting on a path segment, as a function that falls through zero: the squared distance, or the height.</summary>
internal readonly struct MeetingMargin(in PathSpan span, in RunnerMotion runner, MeetingCondition what, bool reacts, bool falls) : IDifferentiableFunction
{
    /// <summary>The size of a correction at which a root is accepted, in s.</summary>
    private const double Closeness = 1e-13;

    private readonly PathSpan _span = span;
    private readonly RunnerMotion _runner = runner;
    private readonly MeetingCondition _what = what;
    private readonly double _sign = falls ? 1.0 : -1.0;
    private readonly bool _reacts = reacts;

    public bool Evaluate(double x, out double value, out double slope)
    {
        MeetingPoint.At(in _span, in _runner, x, _reacts, out MeetingPoint at);
        value = _sign * at.Value(_what);
        slope = _sign * at.Slope(_what);
        return Math.Abs(value) <= Closeness * Math.Abs(slope);
    }
}

/// <summary>The conditions for a player to reach the ball.</summary>
internal enum MeetingCondition
{
    /// <summary>(D + ρ)² − |p − c|² ≥ 0, horizontally.</summary>
    Near = 0,

    /// <summary>y − h₀ ≥ 0.</summary>
    NotTooLow = 1,

    /// <summary>h₁ − y ≥ 0.</summary>
    NotTooHigh = 2,
}
