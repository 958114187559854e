namespace Football.Physics;

/// <summary>The thesis' Method B (4.2): bisection over the elevation, the azimuth corrected by the horizontal angle each time.</summary>
internal sealed class BisectionAim : IAimMethod
{
    private readonly AimContext _context;

    public BisectionAim(AimContext context) => _context = context;

    public AimAnswer Find(AimRequest request) => Find(request, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with spins other than the request's.</summary>
    public AimAnswer Find(AimRequest request, double top, double side)
    {
        var search = new FrameSearch(_context, request, top, side);
        if (!search.BetweenExtremes(out AimAnswer extreme))
        {
            return extreme;
        }

        double low = search.LowestElevation;
        double high = search.HighestElevation;
        int iterations = 0;
        double azimuth = search.Kick.Azimuth + search.HorizontalAngle();
        while (search.Miss > FrameSearch.Margin * request.Tolerance && iterations < request.MaximumIterations)
        {
            iterations++;
            Kick kick = search.Kick;
            kick.Elevation = 0.5 * (low + high);
            kick.Azimuth = azimuth;
            search.Fly(in kick);
            if (search.Closest.Y < request.Target.Y)
            {
                low = kick.Elevation;
            }
            else
            {
                high = kick.Elevation;
            }

            azimuth += search.HorizontalAngle();
        }

        return search.Best(iterations);
    }
}
