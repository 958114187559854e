using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tracks;

/// <summary>Finds an initial launch from pixels.</summary>
/// <remarks>
/// Along p(t) = p₀ + v t + d(t), each pixel gives two linear equations for p₀ and v (direct linear transform). The deflection d is initially that of
/// gravity, which reveals the depth even with one camera. Later it is that of the simulated ball, with drag, spin and bounces.
/// </remarks>
internal sealed class PixelStart
{
    private const int Unknowns = 6;

    /// <summary>The number of solutions, each with the deflections of the one before.</summary>
    private const int Passes = 4;

    /// <summary>The time spans from the first point whose points are used, in s; the whole track is the last.</summary>
    private static readonly double[] s_spans = [0.3, 0.6, 1.2, 2.4, double.PositiveInfinity];

    /// <summary>The depths that are tried, in m.</summary>
    private static readonly double[] s_depths = [10, 25, 50, 80, 120];

    /// <summary>The standard deviation of a launch on the ground, and of a depth that is tried, in m.</summary>
    private const double Ground = 0.01;
    private const double Tried = 0.1;

    /// <summary>The standard deviation of the speed along an axis, in m/s; used if nothing else gives a start.</summary>
    private const double Speed = 20;

    private readonly TrackCamera[] _cameras;
    private readonly PixelPoint[] _points;
    private readonly TrackModel _model;
    private readonly TrackFitRequest _request;
    private readonly double _upward;
    private readonly Vector3d[] _deflections;
    private readonly double[] _weights;
    private readonly double[] _normal = new double[Unknowns * Unknowns];
    private readonly double[] _right = new double[Unknowns];
    private readonly double[] _solution = new double[Unknowns];
    private readonly StepLog _log = new();

    public PixelStart(TrackCamera[] cameras, PixelPoint[] points, TrackFitRequest request, Scene scene)
    {
        _cameras = cameras;
        _points = points;
        _request = request with { Drag = false, Lift = false, Restitution = false, Friction = false };
        _model = new TrackModel(scene, _request);
        _upward = Weight.UpwardAcceleration(scene);
        _deflections = new Vector3d[points.Length];
        _weights = new double[points.Length];
    }

    /// <summary>Returns the launch with the lowest cost of those tried; null if the ball is behind a camera in all of them.</summary>
    public double[]? Find(Sightings seen, in Vector3d spin, out double least)
    {
        // 1. Solve for spans of points, with a free launch and with one on the ground. 2. Try assumed depths, for tracks that are too short to reveal
        // the depth. 3. Keep the lowest cost.
        var paths = new TrackPaths(seen, _request, _model);
        double[] misses = new double[seen.Rows];
        double[]? best = null;
        double lowest = double.PositiveInfinity;
        TrackCamera first = _cameras[_points[0].Camera];
        double contact = _model.Simulator(new double[TrackModel.Launch]).ContactHeight;
        void Try(double span, Vector3d axis, double value, double deviation, in Vector3d spin, double speed = double.PositiveInfinity, double depth = 1)
        {
            int count = CountWithin(span);
            StartOver(depth);
            for (int pass = 0; pass < Passes; pass++)
            {
                if (!Solve(count, in axis, value, deviation, speed))
                {
                    return;
                }

                if (!Weigh(count))
                {
                    return;
                }

                double[] values = [.. _solution, spin.X, spin.Y, spin.Z];
                if (!TrackModel.IsLaunch(values))
                {
                    return;
                }

                double cost = paths.Follow(values, misses);
                if (cost < lowest)
                {
                    (lowest, best) = (cost, values);
                }

                Deflect(values);
            }
        }

        foreach (double span in s_spans)
        {
            Try(span, Vector3d.Zero, 0, double.PositiveInfinity, in spin);
            Try(span, Vector3d.Up, contact, Ground, in spin);
        }

        double from = first.Depth(Vector3d.Zero);
        foreach (double depth in s_depths)
        {
            Try(s_spans[1], first.Forward, depth - from, Tried, in spin);
        }

        // A ball that hardly moves in the image can approach or recede at any speed. Limit the speed, so that the ball is not soon behind the camera.
        foreach (double depth in best is null ? s_depths : [])
        {
            Try(s_spans[1], first.Forward, depth - from, Tried, in spin, Speed, depth);
        }

        least = lowest;
        return best;
    }

    /// <summary>Returns for each camera whether the ball is behind it if only gravity acts, and computes the first negative depth.</summary>
    public bool[] Behind(out double depth)
    {
        depth = 0;
        bool[] behind = new bool[_cameras.Length];
        int count = CountWithin(s_spans[1]);
        StartOver();
        if (Solve(count, Vector3d.Zero, 0, double.PositiveInfinity))
        {
            for (int i = 0; i < count; i++)
            {
                double here = DepthAt(i);
                depth = here < 0 && depth == 0 ? here : depth;
                behind[_points[i].Camera] |= here < 0;
            }
        }

        return behind;
    }

    private int CountWithin(double span)
    {
        int count = _points.Length;
        while (count > 5 && _points[count - 1].Time - _points[0].Time > span)
        {
            count--;
        }

        return count;
    }

    /// <summary>Resets the deflections to those of gravity, and all weights to that of one depth.</summary>
    private void StartOver(double depth = 1)
    {
        for (int i = 0; i < _points.Length; i++)
        {
            double t = _points[i].Time - _points[0].Time;
            _deflections[i] = new Vector3d(0, 0.5 * _upward * t * t, 0);
            _weights[i] = 1 / depth;
        }
    }

    /// <summary>Solves for p₀ and v: (P₁ − u P₃)·(p₀ + v t + d, 1) = 0 and (P₂ − v P₃)·(p₀ + v t + d, 1) = 0, axis·p₀ = value and axis·v = 0.</summary>
    private bool Solve(int count, in Vector3d axis, double value, double deviation, double speed = double.PositiveInfinity)
    {
        Array.Clear(_normal, 0, _normal.Length);
        Array.Clear(_right, 0, _right.Length);
        for (int i = 0; i < count; i++)
        {
            ref readonly PixelPoint point = ref _points[i];
            double t = point.Time - _points[0].Time;
            for (int row = 0; row < 2; row++)
            {
                _cameras[point.Camera].Plane(row, row == 0 ? point.U : point.V, out Vector3d n, out double d);
                Add(in n, t, d - Vector3d.Dot(in n, in _deflections[i]), _weights[i] / point.Noise);
            }
        }

        Add(in axis, 0, value, double.IsInfinity(deviation) ? 0 : 1 / deviation);
        AddRow([0, 0, 0, axis.X, axis.Y, axis.Z], 0, double.IsInfinity(speed) ? 0 : 1 / speed);
        return Linear.Solve(_normal, _right, _solution, Unknowns);
    }

    private void Add(in Vector3d n, double t, double value, double weight) => AddRow([n.X, n.Y, n.Z, t * n.X, t * n.Y, t * n.Z], value, weight);

    private void AddRow(ReadOnlySpan<double> row, double value, double weight)
    {
        for (int i = 0; i < Unknowns; i++)
        {
            _right[i] += weight * weight * row[i] * value;
            for (int j = 0; j < Unknowns; j++)
            {
                _normal[(i * Unknowns) + j] += weight * weight * row[i] * row[j];
            }
        }
    }

    /// <summary>Sets the weight of each equation to 1/depth, so that its residual is in pixels.</summary>
    /// <returns>False if the ball is behind a camera.</returns>
    private bool Weigh(int count)
    {
        for (int i = 0; i < count; i++)
        {
            double depth = DepthAt(i);
            if (!(depth > 0))
            {
                return false;
            }

            _weights[i] = 1 / depth;
        }

        return true;
    }

    private double DepthAt(int i)
    {
        double t = _points[i].Time - _points[0].Time;
        var position = new Vector3d(_solution[0] + (t * _solution[3]), _solution[1] + (t * _solution[4]), _solution[2] + (t * _solution[5]));
        return _cameras[_points[i].Camera].Depth(position + _deflections[i]);
    }

    /// <summary>Computes the deflections of a simulated ball, d = p − p₀ − v t.</summary>
    private void Deflect(double[] values)
    {
        Simulator simulator = _model.Simulator(values);
        BallState ball = TrackModel.Ball(simulator, values);
        Vector3d from = ball.Position;
        Vector3d velocity = ball.Velocity;
        for (int i = 0; i < _points.Length; i++)
        {
            double wait = i > 0 ? _points[i].Time - _points[i - 1].Time : 0;
            if (wait > 0)
            {
                _log.Clear();
                simulator.RunChecked(ref ball, _request.TimeStep, wait, StopAt.Time, _log, null);
            }

            _deflections[i] = ball.Position - from - ((_points[i].Time - _points[0].Time) * velocity);
        }
    }
}
