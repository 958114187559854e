namespace Football.Physics;

/// <summary>The surfaces of the drag law's jump along a step: cubic Hermite interpolants, in fractions of the step.</summary>
internal readonly struct JumpPath
{
    private const int Halvings = 50;
    private readonly DragJump _from;
    private readonly DragJump _fromRate;
    private readonly DragJump _to;
    private readonly DragJump _toRate;
    private readonly double _h;

    public JumpPath(in DragJump from, in DragJump fromRate, in DragJump to, in DragJump toRate, double h)
    {
        _from = from;
        _fromRate = fromRate;
        _to = to;
        _toRate = toRate;
        _h = h;
    }

    /// <summary>G at a fraction of the step.</summary>
    public double Speed(double at) => Hermite(_from.Speed, _h * _fromRate.Speed, _to.Speed, _h * _toRate.Speed, at);

    /// <summary>S at a fraction of the step.</summary>
    public double Spin(double at) => Hermite(_from.Spin, _h * _fromRate.Spin, _to.Spin, _h * _toRate.Spin, at);

    /// <summary>Whether the law with spin holds there.</summary>
    public bool IsInside(double at) => Speed(at) > 0 && Spin(at) > 0;

    /// <summary>Whether one surface becomes positive between two fractions before the other ceases to be: a visit to the law with spin.</summary>
    /// <param name="low">Where the search starts; not inside.</param>
    /// <param name="high">Where it ends, not inside; then a fraction that is.</param>
    public bool PassesThrough(double low, ref double high)
    {
        bool spinRises = Speed(low) > 0 && Spin(high) > 0;
        if (!(spinRises || (Spin(low) > 0 && Speed(high) > 0)))
        {
            return false;
        }

        double before = low;
        double after = high;
        for (int i = 0; i < Halvings; i++)
        {
            double middle = 0.5 * (before + after);
            if (IsInside(middle))
            {
                high = middle;
                return true;
            }

            if ((spinRises ? Spin(middle) : Speed(middle)) > 0)
            {
                after = middle;
            }
            else
            {
                before = middle;
            }
        }

        return false;
    }

    private static double Hermite(double f0, double d0, double f1, double d1, double s)
    {
        double rise = f1 - f0;
        return f0 + (s * (d0 + (s * ((3.0 * rise) - (2.0 * d0) - d1 + (s * (d0 + d1 - (2.0 * rise)))))));
    }
}
