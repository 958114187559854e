using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tracks;

/// <summary>The observations of a ball that a fit compares with a path.</summary>
internal abstract class Sightings
{
    /// <summary>The number of observations.</summary>
    public abstract int Count { get; }

    /// <summary>The number of residuals.</summary>
    public abstract int Rows { get; }

    /// <summary>The camera of the first observation; null for positions.</summary>
    public abstract TrackCamera? FirstCamera { get; }

    /// <summary>True if all observations are pixels from one viewpoint.</summary>
    public abstract bool IsOneView { get; }

    /// <summary>Returns the time of an observation, in s.</summary>
    public abstract double Time(int index);

    /// <summary>The root mean square of the stated noise of a point's coordinates, in m; NaN for pixels.</summary>
    public virtual double Noise => double.NaN;

    /// <summary>Computes the residuals of an observation, in standard deviations.</summary>
    /// <returns>Their sum of squares.</returns>
    public abstract double Miss(int index, in Vector3d position, double[] misses);

    /// <summary>Returns initial values for the launch with a given spin, and their cost if it was computed; null if there are none.</summary>
    public abstract double[]? Start(TrackFitRequest request, in Vector3d spin, Scene scene, out double cost);

    /// <summary>Returns the first observations.</summary>
    public virtual Sightings First(int count) => throw new NotSupportedException();

    /// <summary>Returns the same pixels with those cameras reversed that seem to have the ball behind them; null if there is no such camera.</summary>
    public virtual Sightings? Opposite(TrackFitRequest request, Scene scene) => null;

    /// <summary>Returns the exception for observations that no ball in front of the cameras explains.</summary>
    public virtual ArgumentOutOfRangeException Unseen(TrackFitRequest request, Scene scene) => throw new NotSupportedException();

    /// <summary>The duration, in s.</summary>
    public double Duration => Time(Count - 1) - Time(0);

    protected static double[] Launch(in Vector3d position, in Vector3d velocity, in Vector3d spin) =>
        [position.X, position.Y, position.Z, velocity.X, velocity.Y, velocity.Z, spin.X, spin.Y, spin.Z];

    /// <summary>Checks the duration.</summary>
    protected static void CheckDuration(double duration) => Check.Within("track's last time", duration, 0, 600, exclusiveLow: true);
}

/// <summary>The same observations with other residuals; it cannot start a search.</summary>
internal abstract class OtherResiduals(Sightings seen) : Sightings
{
    public override int Count => seen.Count;

    public override TrackCamera? FirstCamera => seen.FirstCamera;

    public override bool IsOneView => seen.IsOneView;

    public override double Time(int index) => seen.Time(index);

    public override double[]? Start(TrackFitRequest request, in Vector3d spin, Scene scene, out double cost) => throw new NotSupportedException();
}

/// <summary>Observed positions.</summary>
internal sealed class PositionSightings : Sightings
{
    /// <summary>The time span of the points that determine the initial velocity, in s.</summary>
    private const double Beginning = 0.25;

    private readonly TrackPoint[] _track;

    public PositionSightings(TrackPoint[] track)
    {
        TrackPoint.Validate(track, 4, Check.Positive);
        _track = track;
        CheckDuration(Duration);
    }

    public override int Count => _track.Length;

    public override int Rows => 3 * _track.Length;

    public override TrackCamera? FirstCamera => null;

    public override bool IsOneView => false;

    public override double Time(int index) => _track[index].Time;

    public override double Noise => Math.Sqrt(_track.Average(point => point.Noise * point.Noise));

    public override double Miss(int index, in Vector3d position, double[] misses)
    {
        Vector3d miss = (_track[index].Position - position) / _track[index].Noise;
        (misses[3 * index], misses[(3 * index) + 1], misses[(3 * index) + 2]) = (miss.X, miss.Y, miss.Z);
        return miss.LengthSquared;
    }

    /// <summary>Returns the initial values: v = Σ t (p − p₀ + ½ g t² ŷ)/Σ t² over the first points.</summary>
    public override double[]? Start(TrackFitRequest request, in Vector3d spin, Scene scene, out double cost)
    {
        cost = 0;
        Vector3d first = _track[0].Position;
        Vector3d sum = Vector3d.Zero;
        double squares = 0;
        double upward = Weight.UpwardAcceleration(scene);
        for (int i = 1; i < _track.Length && (i < 4 || _track[i].Time - _track[0].Time <= Beginning); i++)
        {
            double t = _track[i].Time - _track[0].Time;
            sum += t * (_track[i].Position - first - new Vector3d(0, 0.5 * upward * t * t, 0));
            squares += t * t;
        }

        return Launch(in first, request.Velocity ?? (squares > 0 ? sum / squares : Vector3d.Zero), in spin);
    }
}
