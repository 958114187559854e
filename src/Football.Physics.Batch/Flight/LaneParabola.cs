namespace FootballPhysics.Batch;

/// <summary>The parabola c0 + c1 s + c2 s² over 0 ≤ s ≤ 1.</summary>
internal readonly struct LaneParabola
{
    private readonly double _c0;
    private readonly double _c1;
    private readonly double _c2;

    /// <summary>Creates a parabola from its values at 0, ½ and 1.</summary>
    public LaneParabola(double start, double middle, double end)
    {
        _c0 = start;
        _c1 = (4.0 * middle) - (3.0 * start) - end;
        _c2 = (2.0 * start) - (4.0 * middle) + (2.0 * end);
        End = end;
    }

    public double Start => _c0;

    public double End { get; }

    public double StartSlope => _c1;

    /// <summary>Returns the minimum if it is not at an end; otherwise infinity.</summary>
    public double LeastWithin() => _c1 < 0 && _c1 + (2.0 * _c2) > 0 ? Extreme : double.PositiveInfinity;

    /// <summary>Returns the maximum, plus a margin if it is not at an end.</summary>
    public double Greatest(double margin) => _c1 > 0 && _c1 + (2.0 * _c2) < 0 ? Extreme + margin : _c0 > End ? _c0 : End;

    /// <summary>Returns true if it crosses zero with a slope below a bound. At the root, the squared slope is c1² − 4 c0 c2.</summary>
    public bool CrossesBelow(double slope) => (_c0 > 0) != (End > 0) && (_c1 * _c1) - (4.0 * _c0 * _c2) < slope * slope;

    private double Extreme => _c0 - (_c1 * _c1 / (4.0 * _c2));
}
