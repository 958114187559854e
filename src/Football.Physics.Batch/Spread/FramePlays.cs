using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>Decides which kicks go in.</summary>
/// <remarks>
/// A kick that crosses the mouth clear of the frame goes in. A kick that comes near a post or the crossbar is simulated with the frame until the entire ball is over
/// the line, or it is gone.
/// </remarks>
internal sealed class FramePlays
{
    /// <summary>The number of simulated points across the shadow of a post or the crossbar, and of bisections between two with different outcomes.</summary>
    private const int Places = 24;
    private const int Halvings = 8;

    /// <summary>Factors on the width of a shadow, because a kick may bend or fall more than a straight path.</summary>
    private const double Wider = 1.25;
    private const double WiderUp = 2.0;

    /// <summary>The distance before the mouth at which a shifted kick starts, in m.</summary>
    private const double Before = 1.0;

    /// <summary>The number of standard deviations from the mean that are covered.</summary>
    private const double Farthest = 6.0;

    /// <summary>A ball is gone this long after it came to the mouth, in s, or this far before it, in m.</summary>
    private const double Longest = 2.0;
    private const double Gone = 1.5;

    private const double TimeStep = 0.02;
    private const double ApproachStep = 0.08;

    private readonly Simulator _simulator;
    private readonly GoalMouth _mouth;
    private readonly Vector3d _right;
    private readonly double _axisAside;
    private readonly double _axisUp;
    private readonly double _reach;
    private readonly int _thing;
    private readonly int _firstPart;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly List<FrameSpan> _aside = [];
    private readonly List<FrameSpan> _up = [];
    private bool _hitsFrame;
    private BallState _near;
    private double _nearAside;
    private double _nearHeight;

    /// <param name="scene">The scene, with the goal.</param>
    /// <param name="goal">The goal.</param>
    public FramePlays(Scene scene, Goal goal)
    {
        _simulator = new Simulator(scene);
        _mouth = new GoalMouth(goal);
        _right = goal.Right;
        _axisAside = (0.5 * goal.Width) + goal.PostRadius;
        _axisUp = goal.Height + goal.PostRadius;
        _reach = scene.Ball.Radius + goal.PostRadius;
        int index = Array.FindIndex(_simulator.World.Goals, _mouth.IsAt);
        _thing = _simulator.World.ThingOfGoal(index);

        // The ground has the number 0. Obstacles follow, then the frames of the goals.
        _firstPart = 1 + scene.Obstacles.Count + (Goal.FrameCount * index);
    }

    /// <summary>The horizontal spans below the crossbar in which kicks go in, found by <see cref="Look"/>.</summary>
    public List<FrameSpan> Aside => _aside;

    /// <summary>The vertical spans between the posts in which kicks go in.</summary>
    public List<FrameSpan> Up => _up;

    /// <summary>Returns true if a kick goes in.</summary>
    /// <param name="kick">The start of the kick.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="at">The point at which it would cross the mouth without the frame.</param>
    /// <param name="hitsFrame">True if the ball hit a post or the bar.</param>
    public bool GoesIn(in SpreadKick kick, in Vector3d velocity, in Vector3d spin, in PlaneCrossingPoint at, out bool hitsFrame)
    {
        hitsFrame = false;
        if (!(at.Time >= 0))
        {
            return false;
        }

        _mouth.Place(at.Position, out double aside, out double height);
        double halfAside = Shadow(at.Position - kick.Position);
        double halfUp = WiderUp * _reach;
        double beyondPost = Math.Abs(aside) - _axisAside;
        double beyondBar = height - _axisUp;
        if (beyondPost <= -halfAside && beyondBar <= -halfUp)
        {
            return true;
        }

        if (!(beyondPost < halfAside && beyondBar < halfUp))
        {
            return false;
        }

        // Approach the frame in long steps; only the last metres need short ones.
        BallState ball = _simulator.LaunchAt(kick.Position, in velocity, in spin, 0, kick.Orientation);
        double closing = Math.Max(1e-3, Math.Abs(Vector3d.Dot(in velocity, _mouth.Out)));
        double lead = Math.Max(0.5 * at.Time, at.Time - (2.0 * Before / closing));
        _log.Clear();
        if (lead > 0)
        {
            _simulator.Run(ref ball, ApproachStep, lead, StopAt.Time, _log);
        }

        _hitsFrame = HitsFrame();
        bool goesIn = HasScored() || Play(ball, at.Time + Longest);
        hitsFrame = _hitsFrame;
        return goesIn;
    }

    /// <summary>True if the ball hit a post or the bar in the last step.</summary>
    private bool HitsFrame()
    {
        foreach (ref readonly BallEvent happened in _log.Events.Span)
        {
            int part = happened.ColliderIndex - _firstPart;
            if (happened.Kind == BallEventKind.Impact && part >= 0 && part < Goal.FrameCount)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>True if a point of the mouth is in one of the spans in which kicks go in.</summary>
    public bool IsIn(double aside, double height) => IsIn(_aside, aside) && IsIn(_up, height);

    private static bool IsIn(List<FrameSpan> spans, double at)
    {
        foreach (FrameSpan span in spans)
        {
            if (at > span.From && at <= span.To)
            {
                return true;
            }
        }

        return false;
    }

    private bool HasScored()
    {
        foreach (ref readonly BallEvent happened in _log.Events.Span)
        {
            if (happened.Kind == BallEventKind.Goal && happened.ColliderIndex == _thing)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Finds the spans in which kicks like this one go in, as far as their crossing points spread.</summary>
    /// <param name="simulator">The scene without the goal.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="time">The time of the crossing, in s.</param>
    /// <param name="places">The spread of the crossing points.</param>
    public void Look(Simulator simulator, in SpreadKick kick, double time, in GoalChanceResult places)
    {
        // Start shortly before the mouth, and find where the kick would cross from there.
        BallState ball = simulator.LaunchAt(kick.Position, kick.Velocity, kick.Spin, 0, kick.Orientation);
        double closing = Math.Max(1e-3, Math.Abs(Vector3d.Dot(kick.Velocity, _mouth.Out)));
        simulator.Run(ref ball, TimeStep, Math.Max(0.5 * time, time - (Before / closing)), StopAt.Time, _log);
        _near = ball;
        _nearAside = places.Aside;
        _nearHeight = places.Height;
        double half = Shadow(_mouth.Center + (places.Aside * _right) - kick.Position);
        _aside.Clear();
        _up.Clear();

        // Scan across both posts at the mean height (kept below the bar), then across the bar at the mean offset (kept between the posts).
        double height = Math.Min(places.Height, _axisUp - (WiderUp * _reach));
        double aside = Math.Max(-_axisAside + half, Math.Min(_axisAside - half, places.Aside));
        double deviation = Farthest * places.AsideDeviation;
        Across(_aside, -_axisAside, half, 1, places.Aside - deviation, places.Aside + deviation, x => Scores(x, height));
        _aside.Add(new FrameSpan(-_axisAside + half, _axisAside - half));
        Across(_aside, _axisAside, half, -1, places.Aside - deviation, places.Aside + deviation, x => Scores(x, height));
        deviation = Farthest * places.HeightDeviation;
        _up.Add(new FrameSpan(double.NegativeInfinity, _axisUp - (WiderUp * _reach)));
        Across(_up, _axisUp, WiderUp * _reach, -1, places.Height - deviation, places.Height + deviation, y => Scores(aside, y));
    }

    /// <summary>Returns half the width of a post's shadow on the mouth for a straight path, in m.</summary>
    private double Shadow(in Vector3d way)
    {
        double across = Vector3d.Dot(in way, in _right);
        double off = Vector3d.Dot(in way, _mouth.Out);
        return Wider * _reach * Math.Sqrt((across * across) + (off * off)) / Math.Max(1e-3, Math.Abs(off));
    }

    /// <summary>Adds the spans of one shadow in which kicks go in. They do at its inner end, and do not at its outer end.</summary>
    private static void Across(List<FrameSpan> spans, double axis, double half, double outwards, double least, double most, Func<double, bool> scores)
    {
        if (axis - half > most || axis + half < least)
        {
            return;
        }

        double low = axis - half;
        double step = 2.0 * half / Places;
        bool last = outwards < 0;
        double from = low;
        for (int i = 1; i <= Places; i++)
        {
            double to = low + (i * step);
            bool here = i == Places ? outwards > 0 : scores(to);
            if (here == last)
            {
                continue;
            }

            // Bisect the position at which the outcome changes.
            double a = to - step;
            double b = to;
            for (int k = 0; k < Halvings; k++)
            {
                double middle = 0.5 * (a + b);
                (a, b) = scores(middle) == last ? (middle, b) : (a, middle);
            }

            if (last)
            {
                spans.Add(new FrameSpan(from, b));
            }

            from = b;
            last = here;
        }

        if (last)
        {
            spans.Add(new FrameSpan(from, axis + half));
        }
    }

    /// <summary>Returns true if the kick goes in when shifted to cross at a point.</summary>
    private bool Scores(double aside, double height)
    {
        Vector3d shift = ((aside - _nearAside) * _right) + ((height - _nearHeight) * Vector3d.Up);
        BallState ball = _simulator.LaunchOn(_near.Position + shift, _near.Velocity, _near.Spin, _near.Time, in _near);
        return Play(ball, _near.Time + (2.0 * Before / Math.Max(1.0, ball.Velocity.Length)) + Longest);
    }

    private bool Play(BallState ball, double until)
    {
        while (ball.Time < until && ball.Motion != MotionState.Rest)
        {
            _log.Clear();
            _simulator.Step(ref ball, TimeStep, _log);
            _hitsFrame |= HitsFrame();
            if (HasScored())
            {
                return true;
            }

            // Back on the pitch, past the goal, or behind the line beside it: the ball will not come back.
            double before = _mouth.BeforeMouth(ball.Position);
            double closing = Vector3d.Dot(ball.Velocity, _mouth.Out);
            _mouth.Place(ball.Position, out double aside, out double height);
            bool isBeside = before < 0 && (Math.Abs(aside) > _axisAside || height > _axisUp);
            if ((before > Gone && closing > 0) || before < -Gone || isBeside)
            {
                return false;
            }
        }

        return false;
    }
}

/// <summary>A span of a line across a goal.</summary>
/// <param name="From">The start, in m.</param>
/// <param name="To">The end, in m.</param>
internal readonly record struct FrameSpan(double From, double To);
