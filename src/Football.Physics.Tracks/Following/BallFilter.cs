using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Follows one ball through a stream of noisy points, with kicks that nobody announces, bounces, gaps and wrong points.</summary>
/// <remarks>
/// Between two kicks, the motion follows from position, velocity and spin just after the last kick. The filter fits these to the points since then, and weighs
/// hypotheses of a kick between two points by their evidence. Equal input gives equal bits on every machine. After the constructor, points do not allocate.
/// Not thread-safe: create one per ball.
/// </remarks>
public sealed partial class BallFilter
{
    /// <summary>The number of points that the window may contain.</summary>
    private const int Room = 2048;

    /// <summary>The greatest clock time, in s.</summary>
    private const double MostTime = 1e10;

    /// <summary>The time after a kick in which it is reported, in s, and the number of points in which it is also reported after a gap.</summary>
    private const double KickReport = 0.5;

    private const int KickPoints = 5;
    private const int ShownPoints = 3;

    /// <summary>A ball is held if this many kicks, of the last ones, are within this time, in s.</summary>
    private const int HeldKicks = 3;
    private const double HeldTime = 0.8;

    /// <summary>The number of points from which the interval of the stream is known.</summary>
    private const int Recent = 8;

    /// <summary>The least weight of a hypothesis in the estimate.</summary>
    private const double LeastWeight = 1e-4;

    /// <summary>The share of a difference of evidence that counts if points have no height: a linear fit of an unseen height misses much of the evidence.</summary>
    private const double TrustWithoutHeight = 0.5;

    /// <summary>The number of times of a path ahead at which its deviation is computed.</summary>
    private const int Knots = 24;

    /// <summary>The distance from a camera of the first guess if its ray does not hit the ground, in m.</summary>
    private const double GuessedDistance = 20;

    private const int Motion = FilterHypothesis.Motion;

    /// <summary>The index of the spin, and the factor of its standard deviation, by which 97 % of true spins are within three (lab follow).</summary>
    private const int Spin = 6;
    private const double SpinFactor = 1.35;

    private readonly FilterModel _model;
    private readonly FilterPoints _points = new(Room);
    private readonly FilterSearch _search;
    private readonly double[] _kicks = new double[HeldKicks];
    private readonly double[] _motions = new double[FilterSearch.Slots * Motion];
    private readonly double[] _weights = new double[FilterSearch.Slots];
    private readonly double[] _mean = new double[Motion];
    private readonly double[] _covariance = new double[Motion * Motion];
    private readonly double[] _factor = new double[Motion * Motion];
    private readonly double[] _ahead = new double[Knots + 1];
    private readonly BallState[] _rays = new BallState[Motion + 1];
    private LookAheadRequest _request = new();
    private double _aheadFrom;
    private double _aheadStep;

    /// <summary>Creates a filter.</summary>
    /// <param name="scene">The scene; null: the default scene. Describe the ball, the air and the ground as well as you know them.</param>
    /// <param name="settings">The settings; null: the defaults.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range; the message names the field, the value and the range.</exception>
    public BallFilter(Scene? scene = null, BallFilterSettings? settings = null)
    {
        Settings = settings ?? new BallFilterSettings();
        Settings.Check();
        Simulator = new Simulator(scene, new SolverSettings { Integrator = Integrator.Rk4 });
        _model = new FilterModel(Simulator, Settings);
        _search = new FilterSearch(_model, _points);
        Reset();
    }

    /// <summary>The compiled scene.</summary>
    public Simulator Simulator { get; }

    /// <summary>The settings.</summary>
    public BallFilterSettings Settings { get; }

    /// <summary>The estimate at the time of the last point; each point changes it.</summary>
    public BallEstimate Estimate { get; } = new();

    /// <summary>True after the first point.</summary>
    public bool HasEstimate => _points.Count > 0;

    /// <summary>The number of simulated steps so far.</summary>
    internal long Steps => _model.Steps;

    /// <summary>The work of the last update, in flight steps.</summary>
    internal double Work => _model.Work;

    internal FilterSearch Search => _search;

    /// <summary>Forgets all points.</summary>
    public void Reset()
    {
        _points.Clear();
        Array.Clear(_kicks, 0, _kicks.Length);
        for (int i = 0; i < HeldKicks; i++)
        {
            _kicks[i] = double.NegativeInfinity;
        }
    }

    /// <summary>Includes a measured position.</summary>
    /// <param name="time">The time, in s; the clock may start anywhere within ±1e10. A point may be late by at most <see cref="BallFilterSettings.Window"/>.</param>
    /// <param name="position">The position of the ball's centre, in m.</param>
    /// <param name="deviation">The standard deviation of each coordinate, in m, above 0; null: <see cref="BallFilterSettings.Noise"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range, or the time is before the window; nothing changes.</exception>
    public void Update(double time, Vector3d position, double? deviation = null)
    {
        Check.Place(nameof(position), position);
        Update(time, FilterPointKind.Position, position, deviation ?? Settings.Noise, default, position);
    }

    /// <summary>Includes a measured position without its height.</summary>
    /// <param name="time">The time, in s.</param>
    /// <param name="x">The first coordinate along the ground, in m.</param>
    /// <param name="z">The second coordinate along the ground, in m.</param>
    /// <param name="deviation">The standard deviation of each coordinate, in m, above 0; null: <see cref="BallFilterSettings.Noise"/>.</param>
    /// <inheritdoc cref="Update(double, Vector3d, double?)" path="/exception"/>
    public void Update(double time, double x, double z, double? deviation = null)
    {
        var value = new Vector3d(x, 0, z);
        Check.Finite(nameof(x), x);
        Check.Finite(nameof(z), z);
        Check.Place("position", value);
        Update(time, FilterPointKind.OnPlan, value, deviation ?? Settings.Noise, default, value + (Height * Vector3d.Up));
    }

    /// <summary>Includes a pixel of a camera.</summary>
    /// <param name="time">The time, in s.</param>
    /// <param name="camera">The camera. A camera that moves is another object for each frame.</param>
    /// <param name="u">The pixel to the right.</param>
    /// <param name="v">The pixel downwards.</param>
    /// <param name="deviation">The standard deviation of each coordinate, in pixels, above 0; null: <see cref="BallFilterSettings.PixelNoise"/>.</param>
    /// <exception cref="ArgumentNullException"><paramref name="camera"/> is null.</exception>
    /// <inheritdoc cref="Update(double, Vector3d, double?)" path="/exception"/>
    public void Update(double time, TrackCamera camera, double u, double v, double? deviation = null)
    {
        Check.Given(nameof(camera), camera);
        Check.Within(nameof(u), u, -Limits.Length, Limits.Length);
        Check.Within(nameof(v), v, -Limits.Length, Limits.Length);
        var value = new Vector3d(u, v, 0);
        CameraRows rows = CameraRows.Of(camera);
        Update(time, FilterPointKind.Pixel, value, deviation ?? Settings.PixelNoise, in rows, Guess(in rows, camera.Position, u, v));
    }

    /// <summary>Predicts the path from the estimate, and the standard deviation of the position along it.</summary>
    /// <remarks>Read the deviation with <see cref="DeviationAt"/>. A call allocates only if the duration differs from that of the last call.</remarks>
    /// <param name="duration">The duration, in s; above 0, at most 60.</param>
    /// <param name="trajectory">Receives the path and the events.</param>
    /// <exception cref="ArgumentNullException"><paramref name="trajectory"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="duration"/> is out of range.</exception>
    /// <exception cref="InvalidOperationException">There was no point yet.</exception>
    public void LookAhead(double duration, Trajectory trajectory)
    {
        Check.Given(nameof(trajectory), trajectory);
        Check.Within(nameof(duration), duration, 0, 60, exclusiveLow: true);
        RequireEstimate();
        if (!_request.Duration.Equals(duration))
        {
            _request = new LookAheadRequest { Duration = duration, StopAt = StopAt.Time };
        }

        Simulator.LookAhead(Estimate.State, _request, trajectory);
        Spread(duration);
    }

    /// <summary>Returns the standard deviation of a component of the position on the last path ahead, in m: the root mean square of the three axes.</summary>
    /// <param name="time">The time, in s, within the last path of <see cref="LookAhead"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is not within the path.</exception>
    public double DeviationAt(double time)
    {
        double rounding = 1e-9 * (1 + Math.Abs(_aheadFrom));
        Check.Within(nameof(time), time, _aheadFrom - rounding, _aheadFrom + (Knots * _aheadStep) + rounding);
        double at = _aheadStep > 0 ? Math.Min(Knots, Math.Max(0, (time - _aheadFrom) / _aheadStep)) : 0;
        int knot = Math.Min(Knots - 1, (int)at);
        return _ahead[knot] + ((at - knot) * (_ahead[knot + 1] - _ahead[knot]));
    }

    private double Height => Math.Max(0, Simulator.ContactHeight);

    private void Update(double time, FilterPointKind kind, in Vector3d value, double deviation, in CameraRows camera, in Vector3d guess)
    {
        Check.Within(nameof(time), time, -MostTime, MostTime);
        Check.Within(nameof(deviation), deviation, 0, 1e4, exclusiveLow: true);
        bool begins = _points.Count == 0 || time - _points.LastTime > Settings.MaximumGap;
        if (!begins)
        {
            double first = _points.LastTime - Settings.Window;
            if (time < first)
            {
                throw Check.Refusal(nameof(time), time.ToString("R", System.Globalization.CultureInfo.InvariantCulture), FormattableString.Invariant($"at least {first:R}, the start of the window"));
            }
        }

        _model.Allow(begins ? 0 : Interval(time));
        var point = new FilterPoint { Time = time, Kind = kind, Value = value, Deviation = deviation, Camera = camera };
        if (begins)
        {
            Reset();
            _points.Insert(in point);
            _search.Begin(in guess);
        }
        else
        {
            if (_points.IsFull)
            {
                MakeRoom();
            }

            int at = _points.Insert(in point);
            if (at < 0)
            {
                return;
            }

            if (at == _points.Count - 1)
            {
                _search.Add();
            }
            else
            {
                _search.Insert(time);
            }
        }

        _search.Condense(_points.LastTime - Settings.Window);
        _points.Forget(Math.Min(_search.EarliestStart, _points.LastTime - Settings.Window));
        SetEstimate();
    }

    /// <summary>Returns the time since the last point, but at most that between the points before it: a gap does not mean that there is more time.</summary>
    private double Interval(double time)
    {
        double least = time - _points.LastTime;
        for (int i = Math.Max(1, _points.Count - Recent); i < _points.Count; i++)
        {
            double wait = _points[i].Time - _points[i - 1].Time;
            least = wait > 0 && wait < least ? wait : least;
        }

        return least;
    }

    /// <summary>Condenses points early if more than <see cref="Room"/> of them are in the window.</summary>
    private void MakeRoom()
    {
        _search.Condense(_points.LastTime);
        _points.Forget(_search.EarliestStart);
        if (_points.IsFull)
        {
            // More points than the history holds are at one time.
            Reset();
        }
    }

    /// <summary>Computes the mean and the covariance over all hypotheses.</summary>
    private void SetEstimate()
    {
        FilterHypothesis best = _search.Best;
        double trust = _search.HasHeight ? 1 : TrustWithoutHeight;
        double sum = 0;
        for (int i = 0; i < _search.Count; i++)
        {
            _weights[i] = Elementary.Exp(trust * (_search[i].Evidence - best.Evidence));
            sum += _weights[i];
        }

        double time = best.Ray.Time;
        double kick = 0;
        double kickTime = 0;
        double kickSquares = 0;
        Array.Clear(_mean, 0, Motion);
        for (int i = 0; i < _search.Count; i++)
        {
            FilterHypothesis hypothesis = _search[i];
            double weight = _weights[i] / sum;
            _weights[i] = weight;
            Span<double> motion = _motions.AsSpan(i * Motion, Motion);
            hypothesis.MotionAt(hypothesis.History.Last).CopyTo(motion);
            for (int k = 0; k < Motion; k++)
            {
                _mean[k] += weight * motion[k];
            }

            double ago = time - hypothesis.KickTime;
            // One point after a kick may be a wrong one.
            bool isShown = hypothesis.Count < FilterHypothesis.Most || hypothesis.Used >= ShownPoints;
            if (isShown && (ago <= KickReport || (hypothesis.Count == FilterHypothesis.Most && hypothesis.Points <= KickPoints)))
            {
                kick += weight;
                kickTime -= weight * ago;
                kickSquares += weight * ((ago * ago) + (hypothesis.KickDeviation * hypothesis.KickDeviation));
            }
        }

        SetCovariance();
        BallEstimate estimate = Estimate;
        estimate.State = State(best, time);
        estimate.KickProbability = Math.Min(1, kick);
        estimate.KickTime = kick > 0 ? time + (kickTime / kick) : double.NaN;
        estimate.KickDeviation = kick > 0 ? Math.Sqrt(Math.Max(0, (kickSquares / kick) - (kickTime / kick * (kickTime / kick)))) : 0;
        estimate.IsOutlier = best.RejectsLast;
        SetHeld(time);
    }

    private void SetCovariance()
    {
        double[] total = Estimate.Covariances;
        Array.Clear(total, 0, total.Length);
        for (int h = 0; h < _search.Count; h++)
        {
            if (_weights[h] < LeastWeight)
            {
                continue;
            }

            FilterMath.Covariance(_search[h].History.Last, _search[h].Count, _covariance);
            for (int i = 0; i < Motion; i++)
            {
                double offI = _motions[(h * Motion) + i] - _mean[i];
                for (int j = 0; j < Motion; j++)
                {
                    double offJ = _motions[(h * Motion) + j] - _mean[j];
                    // A linearized fit is too sure of the spin.
                    double factor = (i >= Spin ? SpinFactor : 1) * (j >= Spin ? SpinFactor : 1);
                    total[(i * Motion) + j] += factor * _weights[h] * (_covariance[(i * Motion) + j] + (offI * offJ));
                }
            }
        }
    }

    private BallState State(FilterHypothesis best, double time)
    {
        if (best.Ray.Motion == MotionState.Rest)
        {
            return Simulator.Placed(new Vector3d(_mean[0], _mean[1], _mean[2]), Vector3d.Zero, Vector3d.Zero, Quaterniond.Identity, time);
        }

        return _model.Launch(_mean, time, best.History.Last.Rolls);
    }

    private void SetHeld(double time)
    {
        BallEstimate estimate = Estimate;
        if (estimate.HasKick && estimate.KickTime - _kicks[HeldKicks - 1] > Math.Max(0.05, 4 * estimate.KickDeviation))
        {
            Array.Copy(_kicks, 1, _kicks, 0, HeldKicks - 1);
            _kicks[HeldKicks - 1] = estimate.KickTime;
        }

        estimate.IsHeld = time - _kicks[0] <= HeldTime;
    }

    /// <summary>Computes the deviation of the path ahead from balls that start at the ends of the axes of the covariance.</summary>
    private void Spread(double duration)
    {
        Array.Copy(Estimate.Covariances, _factor, _factor.Length);
        FilterMath.Factorize(_factor, Motion);
        BallState start = Estimate.State;
        _aheadFrom = start.Time;
        _aheadStep = duration / Knots;
        _rays[0] = start;
        Vector3d spin = start.Spin;
        for (int j = 0; j < Motion; j++)
        {
            _rays[j + 1] = _model.Launch(start.Position + Axis(j, 0), start.Velocity + Axis(j, 3), spin + Axis(j, 6), start.Time);
            if (start.Motion == MotionState.Rest && start.Velocity == _rays[j + 1].Velocity)
            {
                _rays[j + 1] = start;
            }
        }

        for (int knot = 0; knot <= Knots; knot++)
        {
            double sum = 0;
            for (int j = 0; j <= Motion; j++)
            {
                _model.Run(ref _rays[j], _aheadFrom + (knot * _aheadStep));
                sum += (_rays[j].Position - _rays[0].Position).LengthSquared;
            }

            // A held ball is likely to be kicked again.
            double kicks = Estimate.IsHeld ? Settings.KickVelocity * knot * _aheadStep : 0;
            _ahead[knot] = Math.Sqrt((sum / 3) + (kicks * kicks));
        }

        Vector3d Axis(int column, int row) =>
            new(_factor[(row * Motion) + column], _factor[((row + 1) * Motion) + column], _factor[((row + 2) * Motion) + column]);
    }

    /// <summary>Guesses the position of a ball from its first pixel: on the ground, or at a fixed distance above it.</summary>
    private Vector3d Guess(in CameraRows camera, in Vector3d position, double u, double v)
    {
        Vector3d ray = Vector3d.Cross(camera.U.Normal - (u * camera.W.Normal), camera.V.Normal - (v * camera.W.Normal));
        ray = Vector3d.Dot(in ray, in camera.W.Normal) < 0 ? -ray : ray;
        ray /= ray.Length;
        double distance = (position.Y - Height) / -ray.Y;
        return position + ((distance is > 0 and < 300 ? distance : GuessedDistance) * ray);
    }

    private void RequireEstimate()
    {
        if (!HasEstimate)
        {
            throw new InvalidOperationException("There is no estimate before the first point. Call Update first.");
        }
    }
}
