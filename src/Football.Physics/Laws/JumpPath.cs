using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The surface functions of the drag jump along a step: cubic Hermite interpolants over fractions of the step.</summary>
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

    /// <summary>Returns G at a fraction of the step.</summary>
    public double Speed(double at) => _speed.At(at);

    /// <summary>Returns S at a fraction of the step.</summary>
    public double Spin(double at) => _spin.At(at);

    /// <summary>Returns true if the law with spin applies at a fraction of the step.</summary>
    public bool IsInside(double at) => Speed(at) > 0 && Spin(at) > 0;

    /// <summary>Narrows an interval in which the branch changes down to the change.</summary>
    /// <param name="low">A fraction before the change.</param>
    /// <param name="high">A fraction after the change.</param>
    /// <param name="inside">True if the law with spin holds before the change.</param>
    public void Narrow(ref double low, ref double high, bool inside)
    {
        var change = new Change(in this, inside);
        Roots.Bisect(ref change, ref low, ref high, Halvings);
    }

    /// <summary>Returns true if the law with spin applies temporarily between two fractions at which it does not apply.</summary>
    /// <param name="low">The start of the search; not inside.</param>
    /// <param name="high">The end of the search; not inside. On return, a fraction that is inside.</param>
    public bool PassesThrough(double low, ref double high)
    {
        // One function is positive at the start, the other at the end. If both are positive in between, the law with spin applies there.
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

    /// <summary>Condition: the law with spin has begun or ceased to apply.</summary>
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

    /// <summary>Condition: the rising function is positive. The search ends if the other function is still positive.</summary>
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
