using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The laws and the priors that all hypotheses of a filter share.</summary>
internal sealed class FilterModel
{
    /// <summary>The least spin about the vertical axis of a ball that starts rolling, in rad/s; the end of a smaller one is soon, and costly to find.</summary>
    public const double LeastTwist = 0.5;

    /// <summary>The longest step of the simulation between two points, in s.</summary>
    public const double LongestStep = 0.05;

    /// <summary>The volume of positions, in m³, and the area of pixels that a wrong point may have; each value is equally likely.</summary>
    private const double OutlierLength = 10;
    private const double OutlierPixels = 500;

    /// <summary>The speed and the spin that a search does not exceed, in m/s and rad/s.</summary>
    private const double MostSpeed = 300;
    private const double MostSpin = 1000;

    /// <summary>A ball this close above the ground touches it, in m.</summary>
    private const double Touch = 2e-3;

    private const double LogTwoPi = 1.8378770664093453;

    /// <summary>The work of the fits of one update, in flight steps, if points are 10 ms apart; in longer intervals there is time for more.</summary>
    private const double MostWork = 4200;
    private const double ShortInterval = 0.01;
    private const double MostIntervals = 10;

    /// <summary>The work up to which kicks are tried, as a multiple of that of the fits: a missed kick costs more than a late fit.</summary>
    private const double MostBranching = 1.1;

    /// <summary>The work at which hypotheses are cut, as a multiple of that of the fits.</summary>
    /// <remarks>Above: with its last run, a point takes more than 6000 flight steps. Below: more kicks are cut while a ball begins to roll.</remarks>
    private const double MostTotal = 1.15;

    /// <summary>The share of the work of the fits that is kept for a second fit that waits; without it, fits that repeat at each point leave it no work.</summary>
    private const double MostReserve = 0.5;

    /// <summary>The work that the end of a slide adds to a ray, in flight steps: it is taken in pieces.</summary>
    public const double EndOfSlide = 30;

    /// <summary>The work of each update, of the inclusion of a point in a hypothesis, and of a point that is older than the history, in flight steps.</summary>
    private const double Always = 60;
    public const double OfPoint = 8;
    public const double OfOldPoint = 4;

    /// <summary>The work of a launch in the air, and on the ground, in flight steps.</summary>
    private const double OfLaunch = 2;
    private const double OfGroundLaunch = 7;

    /// <summary>The work of a run in flight beside its steps, of an impact, of a run on the ground, and of an evaluation of its forces if it is taken in pieces.</summary>
    private const double OfRun = 0.4;
    private const double OfImpact = 7;
    public const double OfGroundRun = 3;
    private const double OfEvaluation = 2.4;

    /// <summary>The number of force evaluations of a run that is a single step.</summary>
    private const long EvaluationsOfStep = 4;

    /// <summary>The step, in s, whose errors at the end of a slide are small compared with those of points.</summary>
    private const double CoarseStep = 0.2;

    private readonly StepLog _log = new() { CoarseStep = CoarseStep };
    private double _most = double.PositiveInfinity;

    public FilterModel(Simulator simulator, BallFilterSettings settings)
    {
        Simulator = simulator;
        Settings = settings;
        LogOutlier = Elementary.Log(settings.OutlierShare / (1 - settings.OutlierShare));
    }

    public Simulator Simulator { get; }

    public BallFilterSettings Settings { get; }

    /// <summary>The logarithm of the odds of a wrong point; −∞ if all points are right.</summary>
    public double LogOutlier { get; init; }

    /// <summary>The number of simulated steps, for measuring.</summary>
    public long Steps { get; set; }

    /// <summary>Returns the log density of a wrong point, relative to the greatest density of a right one.</summary>
    public static double LogOutlierDensity(in FilterPoint point) =>
        point.Rows * (Elementary.Log(point.Deviation / (point.Kind == FilterPointKind.Pixel ? OutlierPixels : OutlierLength)) + (0.5 * LogTwoPi));

    /// <summary>Simulates a ball to a time.</summary>
    public void Run(ref BallState state, double time)
    {
        double left = time - state.Time;
        if (left > 0)
        {
            MotionState motion = state.Motion;
            _log.Clear();
            Simulator.RunChecked(ref state, LongestStep, left, StopAt.Time, _log, null);
            Steps += _log.Steps;
            bool flies = motion == MotionState.Airborne && state.Motion == MotionState.Airborne;
            Count(flies ? OfRun + _log.Steps + (OfImpact * _log.Events.Count) : _log.Evaluations <= EvaluationsOfStep ? OfGroundRun : OfEvaluation * _log.Evaluations);
        }
    }

    /// <summary>Simulates a ball to a time.</summary>
    /// <returns>False if there was an event.</returns>
    public bool RunSmoothly(ref BallState state, double time)
    {
        MotionState motion = state.Motion;
        Run(ref state, time);
        return _log.Events.Count == 0 && state.Motion == motion;
    }

    /// <summary>Limits the work of the fits of one update.</summary>
    /// <param name="interval">The time since the last point, in s.</param>
    public void Allow(double interval)
    {
        Work = Always;
        _most = MostWork * Math.Min(MostIntervals, Math.Max(1, interval / ShortInterval));
    }

    /// <summary>False if the fits of this update already took too long. The next update then does the others. Without a limit, always true.</summary>
    public bool MayFit => Work < _most;

    /// <summary>False if the work of this update no longer allows another kick to be tried. The next update then tries it.</summary>
    public bool MayBranch => Work < MostBranching * _most;

    /// <summary>False if the work of this update is used up. What is not yet simulated is cut.</summary>
    public bool MayRun => Affords(0);

    /// <summary>True if this update may take more work, in flight steps.</summary>
    public bool Affords(double work) => Work + work < MostTotal * _most;

    /// <summary>The work that fits of this update must leave to a second fit, in flight steps.</summary>
    public double Reserve { get; private set; }

    /// <summary>Keeps work of this update for a second fit, in flight steps, but not more than its share.</summary>
    public void KeepFor(double work) => Reserve = Math.Min(work, MostReserve * _most);

    /// <summary>The work of this update so far, in flight steps.</summary>
    public double Work { get; private set; }

    /// <summary>Adds to the work of this update, in flight steps.</summary>
    public void Count(double work) => Work += work;

    /// <summary>Launches a ball at parameters of a search, which may exceed the limits of a ball.</summary>
    public BallState Launch(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time)
    {
        Count(Touches(position.Y) ? OfGroundLaunch : OfLaunch);
        return Simulator.LaunchAt(in position, velocity * Math.Min(1, MostSpeed / velocity.Length), spin * Math.Min(1, MostSpin / spin.Length), time);
    }

    /// <summary>Launches a ball at an estimated motion: position, velocity and spin.</summary>
    public BallState Launch(ReadOnlySpan<double> motion, double time, bool rolls)
    {
        var position = new Vector3d(motion[0], motion[1], motion[2]);
        var velocity = new Vector3d(motion[3], motion[4], motion[5]);
        var spin = new Vector3d(motion[6], motion[7], motion[8]);

        // Errors of rounding would make a rolling ball slide first.
        bool twists = Math.Abs(spin.Y) >= LeastTwist;
        return rolls && Touches(position.Y)
            ? LaunchOnGround(in position, in velocity, twists ? spin : Vector3d.Zero, time, FilterStart.Rolling)
            : Launch(in position, in velocity, in spin, time);
    }

    /// <summary>Launches a ball on the ground.</summary>
    public BallState LaunchOnGround(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time, FilterStart kind)
    {
        double height = Simulator.ContactHeight;
        double radius = Simulator.Scene.Ball.Radius;
        Vector3d turn = kind == FilterStart.Rolling ? new Vector3d(velocity.Z / radius, spin.Y, -velocity.X / radius) : spin;
        return Launch(new Vector3d(position.X, height, position.Z), velocity.Horizontal, in turn, time);
    }

    /// <summary>True if a ball at this height lies on level ground.</summary>
    public bool Touches(double height) => height < Simulator.ContactHeight + Touch;
}
