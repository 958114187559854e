namespace FootballPhysics.Tool.Replay;

/// <summary>A camera behind the ball that looks in the direction of the kick; projects positions onto an image.</summary>
internal sealed class Eye
{
    private const double Behind = 7;
    private const double Above = 2.4;
    private const double Near = 0.3;

    private readonly Vector3d _place;
    private readonly Vector3d _right;
    private readonly Vector3d _up;
    private readonly Vector3d _forward;
    private readonly double _scale;
    private readonly double _middleX;
    private readonly double _middleY;

    /// <summary>Creates a camera with all relevant positions in its image.</summary>
    /// <param name="start">The position of the kick, in m.</param>
    /// <param name="end">The end of the kick, in m.</param>
    /// <param name="matter">The positions that must be visible, in m.</param>
    /// <param name="width">The width of the image.</param>
    /// <param name="height">The height of the image.</param>
    /// <param name="margin">The free margin on each side.</param>
    /// <param name="above">The height of the camera, in m.</param>
    /// <param name="aside">The distance of the camera to the right of the line of the kick, in m.</param>
    public Eye(Vector3d start, Vector3d end, IReadOnlyList<Vector3d> matter, double width, double height, double margin, double above = Above, double aside = 0)
    {
        Vector3d way = (end - start).Horizontal;
        Vector3d along = way.Length > 0 ? way / way.Length : new Vector3d(0, 0, -1);
        _place = start - (Behind * along) + new Vector3d(0, above, 0) + (aside * Vector3d.Cross(along, Vector3d.Up));
        _forward = (Vector3d.Lerp(start, end, 0.6) + new Vector3d(0, 0.6, 0) - _place).Normalized();
        _right = Vector3d.Cross(_forward, Vector3d.Up).Normalized();
        _up = Vector3d.Cross(_right, _forward);
        (double X, double Y)[] seen = [.. matter.Select(Slopes).OfType<(double X, double Y)>()];
        double left = seen.Min(at => at.X);
        double right = seen.Max(at => at.X);
        double low = seen.Min(at => at.Y);
        double high = seen.Max(at => at.Y);
        (Width, Height) = (width, height);
        _scale = Math.Min((width - (2 * margin)) / (right - left), (height - (2 * margin)) / (high - low));
        _middleX = (0.5 * width) - (0.5 * _scale * (left + right));
        _middleY = (0.5 * height) + (0.5 * _scale * (low + high));
        Vector3d level = _forward.Horizontal;
        Horizon = _middleY - (_scale * Vector3d.Dot(level, _up) / Vector3d.Dot(level, _forward));
    }

    /// <summary>The width of the image.</summary>
    public double Width { get; }

    /// <summary>The height of the image.</summary>
    public double Height { get; }

    /// <summary>The vertical position of the horizon in the image.</summary>
    public double Horizon { get; }

    /// <summary>Projects a position onto the image; returns also the size of one metre there. Returns null for a position behind the camera.</summary>
    public (double X, double Y, double Metre)? On(Vector3d place)
    {
        double depth = Vector3d.Dot(place - _place, _forward);
        return Slopes(place) is { } at ? (_middleX + (_scale * at.X), _middleY - (_scale * at.Y), _scale / depth) : null;
    }

    /// <summary>Returns the components of a direction to the right, upwards, and towards the camera.</summary>
    public (double Right, double Up, double Near) Towards(Vector3d direction) => (Vector3d.Dot(direction, _right), Vector3d.Dot(direction, _up), -Vector3d.Dot(direction, _forward));

    private (double X, double Y)? Slopes(Vector3d place)
    {
        Vector3d d = place - _place;
        double depth = Vector3d.Dot(d, _forward);
        return depth > Near ? (Vector3d.Dot(d, _right) / depth, Vector3d.Dot(d, _up) / depth) : null;
    }
}
