using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Observed pixels, by one or more cameras.</summary>
internal sealed class PixelSightings : Sightings
{
    /// <summary>The minimum depth of a position that a search tries, in m.</summary>
    private const double LeastDepth = 0.1;

    /// <summary>The maximum absolute value of a pixel coordinate: about a thousand images.</summary>
    private const double MostPixel = 1e7;

    /// <summary>The maximum distance between cameras with the same viewpoint, in m.</summary>
    private const double OneView = 1;

    private readonly TrackCamera[] _cameras;
    private readonly PixelPoint[] _points;

    public PixelSightings(TrackCamera[] cameras, PixelPoint[] points)
    {
        Check.AtLeast("cameras' number", cameras.Length, 1);
        for (int i = 0; i < cameras.Length; i++)
        {
            Check.GivenItem("cameras", i, cameras[i], "a camera");
        }

        Check.AtLeast("track's points", points.Length, 5);
        for (int i = 0; i < points.Length; i++)
        {
            string at = Check.Item("track", i);
            Check.Within(at + ".time", points[i].Time, i > 0 ? points[i - 1].Time : -Limits.Time, Limits.Time);
            Check.Within(at + ".camera", (long)points[i].Camera, 0, cameras.Length - 1);
            Check.Within(at + ".pixel[0]", points[i].U, -MostPixel, MostPixel);
            Check.Within(at + ".pixel[1]", points[i].V, -MostPixel, MostPixel);
            Check.Positive(at + ".noise", points[i].Noise);
        }

        _cameras = cameras;
        _points = points;
        CheckDuration(Duration);
    }

    private PixelSightings(TrackCamera[] cameras, ReadOnlySpan<PixelPoint> points)
    {
        _cameras = cameras;
        _points = points.ToArray();
    }

    public override int Count => _points.Length;

    public override int Rows => 2 * _points.Length;

    public override TrackCamera? FirstCamera => _cameras[_points[0].Camera];

    public override bool IsOneView => !_points.Any(point => Vector3d.Distance(_cameras[point.Camera].Position, FirstCamera!.Position) > OneView);

    public override double Time(int index) => _points[index].Time;

    public override double Miss(int index, in Vector3d position, double[] misses)
    {
        ref readonly PixelPoint point = ref _points[index];
        _cameras[point.Camera].Project(in position, LeastDepth, out double u, out double v);
        double across = (point.U - u) / point.Noise;
        double down = (point.V - v) / point.Noise;
        (misses[2 * index], misses[(2 * index) + 1]) = (across, down);
        return (across * across) + (down * down);
    }

    public override Sightings First(int count) => count < _points.Length ? new PixelSightings(_cameras, _points.AsSpan(0, count)) : this;

    public override double[]? Start(TrackFitRequest request, in Vector3d spin, Scene scene, out double cost) =>
        new PixelStart(_cameras, _points, request, scene).Find(this, in spin, out cost);

    public override Sightings? Opposite(TrackFitRequest request, Scene scene)
    {
        bool[] behind = new PixelStart(_cameras, _points, request, scene).Behind(out _);
        return behind.Contains(true) ? new PixelSightings([.. _cameras.Select((item, i) => behind[i] ? item.Opposite() : item)], _points) : null;
    }

    public override ArgumentOutOfRangeException Unseen(TrackFitRequest request, Scene scene)
    {
        int first = Array.IndexOf(new PixelStart(_cameras, _points, request, scene).Behind(out double depth), true);
        return first < 0
            ? Check.Conflict("track", "track has pixels that no position in front of the cameras gives. Check the matrices and the order of u and v.")
            : Check.Refusal(
                Check.Item("cameras", first) + ".matrix", FormattableString.Invariant($"one with the ball behind the camera, at a depth of {depth:0.#} m"),
                "a matrix with the ball in front of the camera, at a depth above 0");
    }
}
