namespace FootballPhysics.Tests.Laws;

/// <summary>Where one shot comes down by every form of the fitted laws: that of the single ball, of many balls, and both regularised.</summary>
internal static class FlightEnds
{
    /// <summary>By law and way, x and z of the first impact, m.</summary>
    public static IEnumerable<double> All()
    {
        foreach (AerodynamicModel form in (AerodynamicModel[])[AerodynamicModel.Published, AerodynamicModel.Regularized])
        {
            foreach (BatchPrecision precision in Enum.GetValues<BatchPrecision>())
            {
                var launches = new BatchLaunches(1);
                var flights = new BatchFlights(1);
                launches.Set(0, default, new Vector3d(3, 7, -24), new Vector3d(-8, 30, 0));
                var scene = Scene.Published with { Forces = ForceSet.Published with { Coefficients = form } };
                new BallBatch(scene, new BatchSettings { Precision = precision }).Fly(launches, flights, 1);
                yield return flights.Position.X[0];
                yield return flights.Position.Z[0];
            }
        }
    }
}
