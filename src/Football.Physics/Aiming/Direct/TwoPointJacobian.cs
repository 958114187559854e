namespace Football.Physics;

/// <summary>How the crossings of both planes move with the four unknowns of a two-point kick.</summary>
internal sealed class TwoPointJacobian
{
    private const int N = TwoPointProblem.Size;

    /// <summary>Relative change of the spin by which its effect on the coefficients is found.</summary>
    private const double SpinChange = 0.05;

    /// <summary>Square of the angle, rad, that counts as much as 1 rad/s of spin.</summary>
    private const double SpinUnit = 1e-4;

    private readonly AimContext _context;
    private readonly double[] _j = new double[N * N];

    public TwoPointJacobian(AimContext context) => _context = context;

    /// <summary>How an equation's residual moves with an unknown.</summary>
    public double this[int equation, int unknown] => _j[(equation * N) + unknown];

    /// <summary>Reads it off the last flight: angles turn the way, spins bend it, as in the flight in closed form.</summary>
    public void ReadOff(TwoPointProblem problem, double[] x)
    {
        Kick kick = TwoPointProblem.KickOf(x);
        double speed = problem.Request.Speed;
        ref readonly TargetFrame frame = ref problem.Frame;
        Vector3d d = kick.Direction(in frame.Forward);
        var raise = new Vector3d(-d.Z, 0, d.X); // d × ŷ
        double spinRate = Math.Max(1.0, Math.Sqrt((kick.Top * kick.Top) + (kick.Side * kick.Side)));
        Vector3d axisTop = new(d.Z, 0, -d.X);
        kick.Vectors(1.0, in frame.Forward, out Vector3d launch, out _);
        double distance = Vector3d.Dot(frame.Target - frame.From, in frame.Forward);
        double way = distance / Math.Max(0.3, launch.Horizontal.Length);
        FlatFire model = _context.Model(speed, spinRate, way);
        double change = SpinChange;
        FlatFire more = _context.Model(speed, spinRate * (1.0 + change), way);
        if (Math.Abs(more.Drag - model.Drag) > 0.5 * SpinChange * model.Drag)
        {
            // Across the drag law's jump: the other way then.
            change = -change;
            more = _context.Model(speed, spinRate * (1.0 + change), way);
        }

        double perRate = 1.0 / (change * spinRate);
        Vector3d unit = ((kick.Top * axisTop) + (kick.Side * Vector3d.Up)) / spinRate;
        for (int plane = 0; plane < 2; plane++)
        {
            ref readonly PlaneCrossing crossing = ref plane == 0 ? ref problem.AtThrough : ref problem.AtTarget;
            double t = crossing.Time;
            Vector3d p = crossing.Offset + (plane == 0 ? problem.Through : frame.Target) - frame.From;
            Vector3d v = crossing.Velocity;
            model.Ways(speed, t, out double along, out _, out double fall, out double bend);
            more.Ways(speed, t, out double moreAlong, out _, out double moreFall, out double moreBend);
            Vector3d turning = p - new Vector3d(0, _context.Upward * fall, 0);
            Vector3d slope = v / Math.Max(1e-3, Vector3d.Dot(in v, in frame.Forward));

            // The mean direction is half-way between launch and end.
            Vector3d middle = launch + (v / v.Length);
            middle /= middle.Length;

            // More spin of the same axis: more lift, and more drag. Another axis: the bend turns with it.
            Vector3d byRate = perRate * (((moreAlong - along) * launch)
                + new Vector3d(0, _context.Upward * (moreFall - fall), 0)
                + (((more.Lift * moreBend) - (model.Lift * bend)) * Vector3d.Cross(in unit, in middle)));
            double byAxis = model.Lift / spinRate * bend;

            // A raised kick turns the way, and the axis of its top spin, but not that of its side spin.
            Vector3d upright = kick.Side * byAxis * Vector3d.Cross(in d, in launch);
            double top = Vector3d.Dot(in unit, in axisTop);
            Set(plane, TwoPointProblem.Elevation, Vector3d.Cross(in raise, in turning) + upright, in slope, in frame);
            Set(plane, TwoPointProblem.Azimuth, Vector3d.Cross(Vector3d.Up, in turning), in slope, in frame);
            Vector3d byTop = (top * byRate) + (byAxis * Vector3d.Cross(axisTop - (top * unit), in middle));
            Set(plane, TwoPointProblem.Top, in byTop, in slope, in frame);
            Vector3d bySide = (unit.Y * byRate) + (byAxis * Vector3d.Cross(Vector3d.Up - (unit.Y * unit), in middle));
            Set(plane, TwoPointProblem.Side, in bySide, in slope, in frame);
        }
    }

    /// <summary>Broyden's update: J += (Δr − J Δx) Δxᵀ / |Δx|², in units in which a radian and 100 rad/s of spin count alike.</summary>
    /// <param name="dx">What the unknowns changed by.</param>
    /// <param name="before">The residuals before.</param>
    /// <param name="after">The residuals after.</param>
    public void Update(double[] dx, double[] before, double[] after)
    {
        double squared = (dx[0] * dx[0]) + (dx[1] * dx[1]) + (SpinUnit * ((dx[2] * dx[2]) + (dx[3] * dx[3])));
        if (!(squared > 0))
        {
            return;
        }

        for (int i = 0; i < N; i++)
        {
            double error = after[i] - before[i];
            for (int k = 0; k < N; k++)
            {
                error -= _j[(i * N) + k] * dx[k];
            }

            for (int k = 0; k < N; k++)
            {
                _j[(i * N) + k] += error * (k < TwoPointProblem.Top ? 1 : SpinUnit) * dx[k] / squared;
            }
        }
    }

    /// <summary>An unknown's column at one plane, from how it moves the ball at the time of the crossing: back along the velocity to the plane.</summary>
    private void Set(int plane, int unknown, in Vector3d moved, in Vector3d slope, in TargetFrame frame)
    {
        Vector3d within = moved - (Vector3d.Dot(in moved, in frame.Forward) * slope);
        _j[(((2 * plane) + 0) * N) + unknown] = Vector3d.Dot(in within, in frame.Left);
        _j[(((2 * plane) + 1) * N) + unknown] = within.Y;
    }
}
