namespace Football.Physics;

/// <summary>The thesis' Method A (4.1): fly, and turn the velocity by the angle between where the ball went and the target.</summary>
internal sealed class AngleAim : IAimMethod
{
    private readonly AimContext _context;

    public AngleAim(AimContext context) => _context = context;

    public AimAnswer Find(AimRequest request)
    {
        var search = new FrameSearch(_context, request, request.TopSpin, request.SideSpin);
        return search.BetweenExtremes(out AimAnswer extreme) ? Iterate(ref search, request, FrameSearch.Margin) : extreme;
    }

    /// <summary>The iteration alone, from a kick that is not an extreme one: the two-point method's last resort.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="start">Where to begin.</param>
    /// <param name="margin">Share of the tolerance within which it ends.</param>
    public AimAnswer Refine(AimRequest request, in Kick start, double margin)
    {
        var search = new FrameSearch(_context, request, start.Top, start.Side);
        search.Fly(in start);
        return Iterate(ref search, request, margin);
    }

    private static AimAnswer Iterate(ref FrameSearch search, AimRequest request, double margin)
    {
        int iterations = 0;
        while (search.Miss > margin * request.Tolerance && iterations < request.MaximumIterations)
        {
            iterations++;
            Kick turned = Turned(in search);
            if (turned.Elevation == search.Kick.Elevation && turned.Azimuth == search.Kick.Azimuth)
            {
                break;
            }

            search.Fly(in turned);
        }

        return search.Best(iterations);
    }

    /// <summary>The kick with its velocity turned as u_guess must be turned to point along u_target.</summary>
    private static Kick Turned(in FrameSearch search)
    {
        Vector3d guess = search.Closest - search.From;
        Vector3d target = search.Target - search.From;
        Vector3d normal = Vector3d.Cross(in guess, in target);
        double sine = normal.Length;
        double cosine = Vector3d.Dot(in guess, in target);
        if (!(sine > 0))
        {
            return search.Kick;
        }

        search.Kick.Vectors(1.0, search.Forward, out Vector3d velocity, out _);
        double angle = Elementary.Atan2(sine, cosine);
        return search.WithDirection(Quaterniond.FromAxisAngle(normal / sine, angle).Rotate(in velocity));
    }
}
