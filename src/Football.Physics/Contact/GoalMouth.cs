namespace Football.Physics;

/// <summary>The plane that a ball must pass for a goal: a line as wide as the posts, and all of the ball over it.</summary>
internal sealed class GoalMouth
{
    /// <summary>A ball that rolls is at its lowest, to rounding.</summary>
    private const double Rounding = 1e-9;

    private readonly Vector3d _center;
    private readonly Vector3d _out;
    private readonly Vector3d _right;
    private readonly double _behind;
    private readonly double _halfWidth;
    private readonly double _height;

    public GoalMouth(Goal goal, BallProperties ball)
    {
        _center = goal.Center;
        _out = goal.Out;
        _right = goal.Right;
        _behind = goal.PostRadius + ball.Radius;
        _halfWidth = (0.5 * goal.Width) - ball.Radius;
        _height = goal.Height - ball.Radius;
    }

    /// <summary>Normal of the plane: towards the pitch.</summary>
    public ref readonly Vector3d Out => ref _out;

    /// <summary>A box around the opening of the plane.</summary>
    public Bounds3d Bounds
    {
        get
        {
            Vector3d low = _center - (_behind * _out);
            Vector3d left = low - (_halfWidth * _right);
            Vector3d right = low + (_halfWidth * _right) + new Vector3d(0, _height, 0);
            return Bounds3d.Around(left, 0, 0, 0).With(Bounds3d.Around(right, 0, 0, 0));
        }
    }

    /// <summary>Distance before the plane, m; negative behind it.</summary>
    public double Before(in Vector3d position) => Vector3d.Dot(position - _center, in _out) + _behind;

    /// <summary>Whether a place on the plane is in the opening, less the ball's radius on each side.</summary>
    public bool Contains(in Vector3d position)
    {
        Vector3d from = position - _center;
        return Math.Abs(Vector3d.Dot(in from, in _right)) <= _halfWidth && from.Y <= _height && from.Y >= -Rounding;
    }
}
