namespace FootballPhysics;

/// <summary>The surfaces of the drag law's jump along a step: cubic Hermite interpolants, in fractions of the step.</summary>
internal readonly struct JumpPath
{
    private const int Halvings = 50;
    private readonly CubicHermite _speed;
    private readonly CubicHermite _spin;

    public JumpPath(in DragJump from, in DragJump fromRate, in DragJump to, in DragJump toRate, double h)
    {
        _speed = new CubicHermite(from.Speed, h * fromRate.Speed, to.Speed, h * toRate.Speed);
        _spin = new CubicHermite(from.Spin, h * fromRate.Spin, to.Spin, h * toRate.Spin);
    }

    /// <summary>G at a fraction of the step.</summary>
    public double Speed(double at) => _speed.At(at);

    /// <summary>S at a fraction of the step.</summary>
    public double Spin(double at) => _spin.At(at);

    /// <summary>True when the law with spin holds there.</summary>
    public bool IsInside(double at) => Speed(at) > 0 && Spin(at) > 0;

    /// <summary>Narrows two fractions, at the later of which the ball has changed sides, down to the change.</summary>
    /// <param name="low">Before the change.</param>
    /// <param name="high">After it.</param>
    /// <param name="inside">Whether the law with spin holds before it.</param>
    public void Narrow(ref double low, ref double high, bool inside)
    {
        var change = new Change(in this, inside);
        Roots.Bisect(ref change, ref low, ref high, Halvings);
    }

    /// <summary>True when one surface becomes positive between two fractions before the other ceases to be: a visit to the law with spin.</summary>
    /// <param name="low">Where the search starts; not inside.</param>
    /// <param name="high">Where it ends, not inside; then a fraction that is.</param>
    public bool PassesThrough(double low, ref double high)
    {
        // One function is positive before, the other after: where they overlap the law with spin holds in between.
        bool spinRises = Speed(low) > 0 && Spin(high) > 0;
        if (!(spinRises || (Spin(low) > 0 && Speed(high) > 0)))
        {
            return false;
        }

        var visit = new Visit(in this, spinRises);
        double before = low;
        double after = high;
        if (!Roots.Bisect(ref visit, ref before, ref after, Halvings))
        {
            return false;
        }

        high = after;
        return true;
    }

    /// <summary>The law with spin has begun to hold, or ceased to.</summary>
    private readonly struct Change : ICondition
    {
        private readonly JumpPath _path;
        private readonly bool _inside;

        public Change(in JumpPath path, bool inside)
        {
            _path = path;
            _inside = inside;
        }

        public bool Evaluate(double x, out bool holds)
        {
            holds = _path.IsInside(x) != _inside;
            return false;
        }
    }

    /// <summary>The rising surface is positive; done where the other one still is.</summary>
    private readonly struct Visit : ICondition
    {
        private readonly JumpPath _path;
        private readonly bool _spinRises;

        public Visit(in JumpPath path, bool spinRises)
        {
            _path = path;
            _spinRises = spinRises;
        }

        public bool Evaluate(double x, out bool holds)
        {
            holds = (_spinRises ? _path.Spin(x) : _path.Speed(x)) > 0;
            return _path.IsInside(x);
        }
    }
}
