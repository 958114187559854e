using FootballPhysics.Aiming;

namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>What must hold of every kick that was found, whatever was asked for.</summary>
internal static class AimCheck
{
    private const double Degree = Math.PI / 180;

    /// <summary>Finite, of the speed asked for, within the bounds, and its miss is that of a look-ahead.</summary>
    public static void Holds(AimRequest request, in AimResult result, Scene? scene = null, double? speed = null)
    {
        string what = $"{result.Status}, miss {result.Miss}: {request}";
        Assert.True(result.Velocity.IsFinite && result.Spin.IsFinite && result.Closest.IsFinite && double.IsFinite(result.Miss) && double.IsFinite(result.Time), what);
        Assert.True(result.WaypointMiss is null == request.Waypoint is null && double.IsFinite(result.WaypointMiss ?? 0), what);
        double wanted = speed ?? request.Speed;
        Assert.True(Math.Abs(result.Velocity.Length - wanted) <= 1e-9 * wanted, what);
        double elevation = Math.Atan2(result.Velocity.Y, result.Velocity.Horizontal.Length);
        Assert.True(elevation >= (request.MinimumElevationDegrees * Degree) - 1e-9 && elevation <= (request.MaximumElevationDegrees * Degree) + 1e-9, what);
        Assert.True(result.Status == AimStatus.Degenerate || result.HitsTarget == result.Miss <= request.Tolerance, what);
        Assert.True(result.Iterations is >= 0 and <= 10_000 && result.Simulations is >= 0 and <= 10_000, $"{result.Iterations} iterations, {result.Simulations} simulations: {what}");
        if (request.TargetVelocity == Vector3d.Zero)
        {
            Assert.True(Math.Abs(TrueMiss(request, in result, scene) - result.Miss) <= 1e-6 * Math.Max(1, result.Miss), what);
        }
    }

    /// <summary>The closest approach before the first impact, in RK4 at 5 ms.</summary>
    public static double TrueMiss(AimRequest request, in AimResult result, Scene? scene = null) =>
        new TrueMiss(scene ?? Scene.Published).Of(request, result.Velocity, result.Spin);

    /// <summary>A request like those of a match.</summary>
    public static AimRequest Any(Shots random)
    {
        double distance = random.Uniform(5, 35);
        double angle = random.Uniform(0, 2 * Math.PI);
        return new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(distance * Math.Cos(angle), random.Uniform(0.2, 2.5), distance * Math.Sin(angle)),
            Speed = random.Uniform(14, 32),
            TopSpin = random.Uniform(-30, 30),
            SideSpin = random.Uniform(-30, 30),
            Tolerance = 1e-3,
        };
    }
}
