namespace FootballPhysics.Tracks;

/// <summary>One explanation of the points: the ball moves freely since a start, which is a kick or the first point.</summary>
/// <remarks>
/// The parameters are position, velocity and spin at the start; after a kick, the position is relative to the path before it, and the time of the kick is the
/// tenth. Each parameter has a ray: the motion with that parameter changed by about half its standard deviation. The differences of the rays are the derivatives
/// of a least-squares fit, which each point updates as a Kalman filter of the parameters does. If the estimate moves away from the rays, <see cref="Fit"/>
/// simulates them again (a Gauss–Newton step).
/// </remarks>
internal sealed partial class FilterHypothesis
{
    /// <summary>The number of parameters of a motion, and the largest number, with the time of a kick.</summary>
    public const int Motion = 9;
    public const int Most = 10;

    /// <summary>The index of the time of a kick, of the upward velocity, and of the spin about the vertical axis.</summary>
    private const int Moment = 9;
    private const int Upward = 4;
    private const int Twist = 7;

    /// <summary>The least change of the upward velocity of a ball on the ground, in m/s: more than <see cref="Ground.MinimumBounceSpeed"/>.</summary>
    private const double LeastHop = 0.3;

    /// <summary>The distance of the estimate from the rays, in widths, that requires a new fit.</summary>
    private const double Far = 2;

    /// <summary>The number of points from which a fit takes one iteration per update.</summary>
    private const int Long = 48;

    /// <summary>The greatest ratio of the width of a ray and that of the uncertainty.</summary>
    private const double MostRatio = 6;

    private readonly FilterModel _model;
    private readonly FilterRays _rays;
    private readonly FilterKick _kick;
    private readonly FilterUpdate _update = new();
    private readonly FilterMoment _old = new();
    private readonly double[] _leastWidths = new double[Most];
    private readonly double[] _bounded = new double[Most];

    public FilterHypothesis(FilterModel model, int slot)
    {
        _model = model;
        _rays = new FilterRays(model);
        _kick = new FilterKick(model);
        Slot = slot;
        History = new FilterHistory();
    }

    /// <summary>The number of the hypothesis, which saved filters contain.</summary>
    public int Slot { get; }

    public FilterHistory History { get; }

    /// <summary>The number of parameters.</summary>
    public int Count => _rays.Count;

    /// <summary>The time after which points belong to this hypothesis.</summary>
    public double StartTime { get; private set; }

    /// <summary>True if the points at the start time belong to this hypothesis too.</summary>
    public bool IncludesStart { get; set; }

    /// <summary>True if the first point is taken for a wrong one.</summary>
    public bool SkipsFirst { get; set; }

    /// <summary>True if a late point is not yet in the estimate.</summary>
    public bool IsStale { get; set; }

    /// <summary>The constraint of the motion at the start.</summary>
    public FilterStart Kind { get; private set; }

    /// <summary>The part of the distribution of the upward velocity; see <see cref="UpwardParts"/>.</summary>
    public int Part { get; set; }

    /// <summary>The latest time of the kick; the start without a kick.</summary>
    public double EndOfKick { get; private set; }

    /// <summary>The logarithm of the evidence: the density of all points, relative to the other hypotheses.</summary>
    public double Evidence { get; private set; }

    /// <summary>The number of points since the start that fit.</summary>
    public int Used { get; private set; }

    /// <summary>The number of points since the start.</summary>
    public int Points { get; private set; }

    /// <summary>True if the last point did not fit.</summary>
    public bool RejectsLast { get; private set; }

    /// <summary>The number of points in a row that did not fit.</summary>
    public int RejectedInRow { get; private set; }

    /// <summary>The time of the last kick and its standard deviation; −∞ without one.</summary>
    public double KickTime { get; private set; }

    public double KickDeviation { get; private set; }

    public double[] Mean { get; } = new double[Most];

    public double[] Prior { get; } = new double[Most * Most];

    public double[] Base { get; } = new double[Most];

    public double[] Values { get; } = new double[Most];

    public double[] Spread { get; } = new double[Most * Most];

    public double Prefix { get; private set; }

    /// <summary>True if the ball touches the ground at its start.</summary>
    private bool _lies;

    /// <summary>The work of the last iteration of a fit, with the impacts and the ends of slides since, in flight steps.</summary>
    private double _fitWork;

    /// <summary>The work so far of an iteration that is paused, in flight steps.</summary>
    private double _spent;

    public ref readonly BallState Ray => ref _rays.States[0];

    /// <summary>True if the hypothesis must not be cut: it is the best one.</summary>
    public bool IsKept
    {
        get => !_rays.MayStop;
        set => _rays.MayStop = !value;
    }

    /// <summary>True if the work of an update did not suffice. Its evidence is then −∞.</summary>
    public bool IsCut => _rays.IsStopped;

    /// <summary>True if a fit pauses when the work of an update is used up, so that the next update continues it: for a hypothesis that is not yet weighed.</summary>
    public bool MayPause { get; set; }

    /// <summary>True if the last point moved the estimate away from the rays.</summary>
    public bool HasMoved { get; private set; }

    /// <summary>True if the ball touches the ground, at the start or now: friction then depends on the direction of the slip.</summary>
    public bool Touches => _lies || Ray.Motion != MotionState.Airborne;

    /// <summary>True if the fit is paused.</summary>
    public bool IsPaused { get; private set; }

    /// <summary>The work that a fit may still take, in flight steps: that of the last one, with a slide that ends on each ray.</summary>
    public double WorkOfFit => Math.Max(0, _fitWork - _spent) + ((Count + 1) * FilterModel.EndOfSlide);

    /// <summary>True if the work of this update suffices for a fit, and leaves the reserve.</summary>
    public bool MayEndFit => _model.Affords(WorkOfFit + _model.Reserve);

    /// <summary>True if there is also time for it.</summary>
    public bool MayFit => _model.MayFit && MayEndFit;

    /// <summary>Fits the motion to the points since the start.</summary>
    /// <returns>True if the rays suit the estimate, so that another iteration would hardly change it, or if the hypothesis is cut; false if the fit is paused.</returns>
    public bool Fit(FilterPoints points, int iterations)
    {
        bool ends = false;
        IsStale = false;
        for (int i = 0; i < iterations && !ends && (i == 0 || MayFit); i++)
        {
            double before = _model.Work;
            Begin();
            int first = IncludesStart ? points.From(StartTime) : points.After(StartTime);
            for (int k = first + Points; k < points.Count && !IsCut;)
            {
                // The history needs the motion at each point; before it, positions between long steps suffice.
                int end = _rays.Stride(points, k, EndOfKick);
                for (; k < end && !IsCut; k++)
                {
                    Points++;
                    Include(in points[k], first == points.Count - 1);
                }
            }

            _spent += _model.Work - before;
            IsPaused = IsCut && MayPause;
            if (IsPaused)
            {
                return false;
            }

            _rays.EndStride();
            End();
            _fitWork = _spent;
            _spent = 0;
            ends = IsCut || !IsFar(1);
        }

        SetKick();
        return ends;
    }

    /// <summary>Includes the next point.</summary>
    public void Add(FilterPoints points)
    {
        Points++;
        double before = _model.Work;
        Include(in points[points.Count - 1], false);
        End();

        // The next fit repeats the impacts and the ends of slides.
        _fitWork += Math.Max(0, _model.Work - before - FilterModel.OfPoint - ((Count + 1) * FilterModel.OfGroundRun));
        HasMoved = IsFar(Far);
        if ((IsStale || HasMoved) && MayFit)
        {
            Fit(points, Points > Long ? 1 : 2);
        }
        else
        {
            SetKick();
        }
    }

    /// <summary>Returns the estimated motion at a moment: position, velocity and spin.</summary>
    /// <remarks>Between rays before and after an impact there is no linear motion. It is simulated, but only if it is needed.</remarks>
    public double[] MotionAt(FilterMoment moment)
    {
        if (!moment.HasMotion)
        {
            Array.Copy(moment.Values, _bounded, Most);
            _bounded[Twist] = Bounded(moment.Values, Twist);
            _bounded[Upward] = Bounded(moment.Values, Upward);
            _bounded[Moment] = Bounded(moment.Values, Moment);
            BallState state = Launch(_bounded, 0, 0);
            _model.Run(ref state, moment.Time);
            FilterRays.Read(in state, moment.Motion);
            moment.HasMotion = true;
        }

        return moment.Motion;
    }

    /// <summary>Computes the motion at the last point, unless the hypothesis is cut.</summary>
    private void End()
    {
        if (_rays.Stops())
        {
            Evidence = double.NegativeInfinity;
        }
        else if (History.Count > 0)
        {
            MotionAt(History.Last);
        }
    }

    /// <summary>Begins an iteration of a fit, or continues one that paused.</summary>
    private void Begin()
    {
        if (IsPaused)
        {
            _rays.Begin();
            return;
        }

        Linearize();
        Array.Copy(Mean, Values, Most);
        Array.Copy(Prior, Spread, Prior.Length);
        Evidence = Prefix;
        Used = 0;
        Points = 0;
        RejectedInRow = 0;
        History.Clear();
    }

    /// <summary>Lets an iteration that is paused begin from scratch, because a late point belongs to it.</summary>
    public void Restart()
    {
        if (IsPaused)
        {
            IsPaused = false;
            _spent = 0;
            _rays.Begin();
            _rays.EndStride();
            Array.Copy(Base, Values, Most);
        }
    }

    /// <summary>Starts the rays at the estimate.</summary>
    private void Linearize()
    {
        Array.Copy(Values, Base, Most);
        if (Count == Most)
        {
            Base[Moment] = Bounded(Values, Moment);
        }

        // A ball on the ground does not move into it, and its height is that of the ground.
        BallState start = Launch(Base, 0, 0);
        _lies = _model.Touches(start.Position.Y);
        Base[Twist] = Bounded(Values, Twist);
        Base[Upward] = Bounded(Values, Upward);
        start = _lies ? Launch(Base, 0, 0) : start;

        _rays.States[0] = start;
        for (int j = 0; j < Count; j++)
        {
            double width = FilterRays.WidthOf(j, Spread);
            _leastWidths[j] = 0;
            _rays.IsFixed[j] = Prior[(j * Most) + j] == 0;
            if (_rays.IsFixed[j])
            {
                _rays.Widths[j] = width;
                continue;
            }

            if (j == Upward && _lies && Base[Upward] < LeastHop)
            {
                width = Math.Max(LeastHop, width);
                _leastWidths[j] = width;
            }
            else if (j == Moment)
            {
                // The ray stays between the two points.
                width = Math.Min(width, 0.4 * (EndOfKick - StartTime));
                width = Base[Moment] > 0.5 * (StartTime + EndOfKick) ? -width : width;
            }

            _rays.Widths[j] = width;
            _rays.States[j + 1] = Launch(Base, j, width);
        }
    }

    private BallState Launch(double[] p, int changed, double width)
    {
        double keep = p[changed];
        p[changed] += width;
        var position = new Vector3d(p[0], p[1], p[2]);
        double time = StartTime;
        if (Count == Most)
        {
            time = p[Moment];
            position += _kick.PositionAt(time);
        }

        var velocity = new Vector3d(p[3], p[4], p[5]);
        var spin = new Vector3d(p[6], p[7], p[8]);
        BallState start = Kind == FilterStart.Free ? _model.Launch(in position, in velocity, in spin, time) : _model.LaunchOnGround(in position, in velocity, in spin, time, Kind);
        p[changed] = keep;
        return start;
    }

    /// <summary>Moves the rays to a point and updates the estimate.</summary>
    private void Include(in FilterPoint point, bool isOnly)
    {
        bool isOld = _rays.Move(point.Time);
        _model.Count(isOld ? FilterModel.OfOldPoint : FilterModel.OfPoint);
        if (IsCut)
        {
            // A fit that pauses includes the point when it continues.
            Evidence = MayPause ? Evidence : double.NegativeInfinity;
            Points -= MayPause ? 1 : 0;
            return;
        }

        FilterMoment moment = isOld ? _old : History.Push();
        _rays.Observe(in point, moment);

        // Update a copy, and keep it unless a wrong point is more likely.
        double right = _update.Try(this, in point, moment);
        double wrong = _model.LogOutlier + FilterModel.LogOutlierDensity(in point);

        // A start without a path before it is at its first point. A kick that one point shows explains that point.
        RejectsLast = (SkipsFirst && Points == 1) || (!(right > wrong) && !(Used == 0 && (IncludesStart || isOnly)));
        if (RejectsLast)
        {
            Evidence += wrong;
            RejectedInRow++;
        }
        else
        {
            Evidence += right;
            RejectedInRow = 0;
            Used++;
            _update.Keep(this);
        }

        if (isOld)
        {
            return;
        }

        _rays.Differentiate(moment.Jacobian);
        moment.IsSmooth = _rays.AreSmooth();
        moment.Rolls = _rays.Roll();
        moment.Take(in point, RejectsLast, this);
        moment.HasMotion = moment.IsSmooth;
        if (moment.IsSmooth)
        {
            _rays.Extrapolate(moment, Values, Base);
        }
    }

    /// <summary>True if the estimate is this many widths from the rays, or the rays are much wider than the uncertainty.</summary>
    private bool IsFar(double most)
    {
        for (int j = 0; j < Count; j++)
        {
            double width = Math.Max(FilterRays.WidthOf(j, Spread), _leastWidths[j]);
            if (!_rays.IsFixed[j] && !(Math.Abs(Bounded(Values, j) - Base[j]) <= most * width) || (!_rays.IsFixed[j] && Math.Abs(_rays.Widths[j]) > MostRatio * width))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Returns an estimated parameter, within its bounds: the time of a kick, and the upward velocity of a ball on the ground.</summary>
    private double Bounded(double[] values, int parameter)
    {
        double value = values[parameter];
        if (parameter == Moment)
        {
            double margin = 1e-3 * (EndOfKick - StartTime);
            return Math.Min(EndOfKick - margin, Math.Max(StartTime + margin, value));
        }

        // A ball on the ground that hardly spins about the vertical axis soon stops doing so, at a high cost.
        bool isSmall = parameter == Twist && _lies && Math.Abs(value) < FilterModel.LeastTwist;
        return isSmall ? 0 : parameter == Upward && _lies ? Math.Max(0, value) : value;
    }

    private void SetKick()
    {
        if (Count == Most)
        {
            KickTime = Math.Min(EndOfKick, Math.Max(StartTime, Values[Moment]));
            KickDeviation = Math.Sqrt(Math.Max(0, Spread[(Moment * Most) + Moment]));
        }
    }
}
