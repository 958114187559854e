using FootballPhysics.Prediction;
using FootballPhysics.Tracks;

namespace FootballPhysics.Live;

/// <summary>Passes the pixels of a feed to both filters, and compares their predictions with the true ball.</summary>
internal sealed class Follower
{
    /// <summary>The duration of the drawn path, the interval of its points, and the time ahead at which errors are measured, in s.</summary>
    public const double Duration = 1;
    public const double Every = 0.05;
    public const double Judged = 0.5;

    /// <summary>A kick is another one if it is this much later than the last, in s.</summary>
    private const double Apart = 0.1;

    private readonly Trajectory _path = new();
    private readonly Queue<Prediction> _open = new();
    private double _lastKick = double.NegativeInfinity;
    private double _squares;
    private double _lineSquares;
    private int _kicks;

    /// <summary>The filter. The scene is the one of the simulated ball.</summary>
    public BallFilter Filter { get; } = new(Scene.Default, new BallFilterSettings { PixelNoise = Feed.Noise });

    /// <summary>The filter to compare with.</summary>
    public ConstantVelocity Simple { get; } = new();

    /// <summary>The number of predictions that were compared with the true ball.</summary>
    public int Compared { get; private set; }

    /// <summary>Includes a picture.</summary>
    public Frame Follow(Picture picture)
    {
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            if (picture.Pixels[i] is { } pixel)
            {
                Filter.Update(picture.Time, Feed.Cameras[i], pixel.U, pixel.V);
            }
        }

        Simple.Update(picture);
        Compare(picture);
        BallEstimate estimate = Filter.Estimate;
        if (Filter.HasEstimate && estimate.HasKick && estimate.KickTime > _lastKick + Apart)
        {
            (_lastKick, _kicks) = (estimate.KickTime, _kicks + 1);
        }

        bool has = Filter.HasEstimate;
        Ahead[] path = has ? Path(picture.Time) : [];
        Ahead[] line = Simple.HasEstimate ? [.. Times(picture.Time).Select(time => Ahead.At(time, Simple.PositionAt(time), 0))] : [];
        if (has && Simple.HasEstimate)
        {
            double time = picture.Time + Judged;
            _open.Enqueue(new Prediction(time, _path.PositionAt(time), Simple.PositionAt(time)));
        }

        return new Frame(
            picture.Time, Ahead.At(picture.Time, picture.Truth.Position, 0), [.. picture.Pixels.Select(pixel => pixel is not null)],
            has ? estimate.State.Motion.ToString() : null, has ? Math.Round(estimate.State.Velocity.Length, 2) : 0,
            has && estimate.HasKick ? new FoundKick(estimate.KickTime, estimate.KickDeviation) : null, has && estimate.IsOutlier, path, line,
            Rms(_squares), Rms(_lineSquares), _kicks);
    }

    /// <summary>Predicts the path, also from an estimate that is old because no camera sees the ball.</summary>
    private Ahead[] Path(double now)
    {
        Filter.LookAhead(now - Filter.Estimate.State.Time + Duration, _path);
        return [.. Times(now).Select(time => Math.Min(time, _path.EndTime)).Select(time => Ahead.At(time, _path.PositionAt(time), Filter.DeviationAt(time)))];
    }

    private static IEnumerable<double> Times(double now) => Enumerable.Range(0, (int)Math.Round(Duration / Every) + 1).Select(i => now + (i * Every));

    /// <summary>Compares the predictions for this time with the true ball, unless it was kicked since then: no filter can predict that.</summary>
    private void Compare(Picture picture)
    {
        while (_open.Count > 0 && _open.Peek().Time <= picture.Time + (0.5 * Feed.Interval))
        {
            Prediction due = _open.Dequeue();
            if (picture.Kicked < due.Time - Judged)
            {
                _squares += (due.Position - picture.Truth.Position).LengthSquared;
                _lineSquares += (due.Line - picture.Truth.Position).LengthSquared;
                Compared++;
            }
        }
    }

    private double Rms(double squares) => Compared > 0 ? Math.Round(Math.Sqrt(squares / Compared), 3) : 0;

    private readonly record struct Prediction(double Time, Vector3d Position, Vector3d Line);
}
