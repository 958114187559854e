namespace FootballPhysics.Labs;

/// <summary>
/// The dense scan that verdicts are checked against. It tries elevations between the bounds and corrects the azimuth of each by the direction in which
/// the kick went. It judges a kick by the simulated closest approach before the first impact. It then searches every valley down to its minimum. In a
/// wind the closest kick need not point towards the point where it comes closest, so the scan also searches both angles from the best kick.
/// </summary>
internal sealed class AimScan(Scene scene)
{
    private const double Coarse = 0.05;
    private const double Fine = 0.005;
    private const double Degree = Math.PI / 180;

    private readonly Simulator _simulator = new(scene);
    private readonly Trajectory _path = new(16384);
    private readonly LookAheadRequest _look = new() { TimeStep = Coarse, Duration = 30, StopAt = StopAt.Impact };
    private readonly LookAheadRequest _lookFine = new() { TimeStep = Fine, Duration = 30, StopAt = StopAt.Impact };

    private readonly bool _windy = scene.Air.Wind != Vector3d.Zero;
    private double _bestMiss;
    private double _bestElevation;
    private double _bestAzimuth;

    /// <summary>Returns the smallest miss of any kick that the scan tries, m.</summary>
    /// <param name="request">The request.</param>
    /// <param name="elevations">The number of elevations between the bounds.</param>
    public double Best(AimRequest request, int elevations)
    {
        double low = request.MinimumElevationDegrees * Degree;
        double high = request.MaximumElevationDegrees * Degree;
        int count = high > low ? elevations : 1;
        _bestMiss = double.PositiveInfinity;
        var misses = new double[count];
        var azimuths = new double[count];
        Vector3d straight = request.Target - request.From;
        double azimuth = Math.Atan2(straight.Z, straight.X);
        double At(int i) => count == 1 ? low : low + ((high - low) * i / (count - 1));
        for (int i = 0; i < count; i++)
        {
            misses[i] = Miss(request, At(i), ref azimuth, i == 0 ? 12 : 4, _look);
            azimuths[i] = azimuth;
        }

        double best = double.PositiveInfinity;
        for (int i = 0; i < count; i++)
        {
            bool valley = (i == 0 || misses[i] <= misses[i - 1]) && (i == count - 1 || misses[i] <= misses[i + 1]);
            if (valley)
            {
                best = Math.Min(best, Bottom(request, At(Math.Max(0, i - 1)), At(Math.Min(count - 1, i + 1)), azimuths[i]));
            }
        }

        return _windy && best > request.Tolerance ? Math.Min(best, BothAngles(request, low, high)) : best;
    }

    /// <summary>Descends in both angles, from the best kick so far.</summary>
    private double BothAngles(AimRequest request, double low, double high)
    {
        for (double step = 0.02; step > 1e-4; step *= 0.5)
        {
            bool closer = true;
            while (closer)
            {
                double before = _bestMiss;
                (double elevation, double azimuth) = (_bestElevation, _bestAzimuth);
                foreach ((double up, double turn) in new[] { (step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step) })
                {
                    double turned = azimuth + turn;
                    Miss(request, Math.Clamp(elevation + up, low, high), ref turned, 1, _look);
                }

                closer = _bestMiss < before;
            }
        }

        return _bestMiss;
    }

    /// <summary>Finds the minimum of a valley by golden-section search.</summary>
    private double Bottom(AimRequest request, double a, double b, double azimuth)
    {
        const double Golden = 0.38196601125010515;
        double ends = Math.Min(Miss(request, a, ref azimuth, 6, _look), Miss(request, b, ref azimuth, 6, _look));
        double x = a + (Golden * (b - a));
        double y = b - (Golden * (b - a));
        double fx = Miss(request, x, ref azimuth, 6, _look);
        double fy = Miss(request, y, ref azimuth, 6, _look);
        while (b - a > 1e-6)
        {
            if (fx <= fy)
            {
                (b, y, fy) = (y, x, fx);
                x = a + (Golden * (b - a));
                fx = Miss(request, x, ref azimuth, 3, _look);
            }
            else
            {
                (a, x, fx) = (x, y, fy);
                y = b - (Golden * (b - a));
                fy = Miss(request, y, ref azimuth, 3, _look);
            }
        }

        return Math.Min(ends, Miss(request, 0.5 * (a + b), ref azimuth, 6, _lookFine));
    }

    private double Miss(AimRequest request, double elevation, ref double azimuth, int corrections, LookAheadRequest look)
    {
        double best = double.PositiveInfinity;
        for (int i = 0; i < corrections; i++)
        {
            (double up, double flat) = Math.SinCos(elevation);
            (double z, double x) = Math.SinCos(azimuth);
            var velocity = new Vector3d(request.Speed * flat * x, request.Speed * up, request.Speed * flat * z);
            Vector3d spin = new((request.TopSpin * z), request.SideSpin, -(request.TopSpin * x));
            BallState ball = _simulator.Launch(request.From, velocity, spin);
            _simulator.LookAhead(in ball, look, _path);
            PathPoint closest = _path.ClosestApproach(request.Target);
            best = Math.Min(best, closest.Distance);
            if (closest.Distance < _bestMiss)
            {
                (_bestMiss, _bestElevation, _bestAzimuth) = (closest.Distance, elevation, azimuth);
            }

            Vector3d went = closest.Position - ball.Position;
            Vector3d wanted = request.Target - ball.Position;
            double turn = Math.Atan2((went.X * wanted.Z) - (went.Z * wanted.X), (went.X * wanted.X) + (went.Z * wanted.Z));
            if (!(Math.Abs(turn) > 1e-7))
            {
                break;
            }

            azimuth += turn;
        }

        return best;
    }
}
