namespace FootballPhysics.Yardsticks;

/// <summary>Checks the plain yardstick against the library: a yardstick for another motion would measure nothing.</summary>
public static class PlainCheck
{
    /// <summary>Returns the largest difference in position (m) after a flight of a shot, over a set.</summary>
    /// <param name="law">The law. The published law agrees only on shots that do not cross its jump. All laws agree only if no spin decays to zero.</param>
    /// <param name="integrator">The method.</param>
    /// <param name="shots">The shots, which are launched high up.</param>
    /// <param name="h">Step, s.</param>
    /// <param name="steps">Steps of the flight.</param>
    public static double LargestGap(
        PlainLawKind law, Integrator integrator, IReadOnlyList<Shot> shots, double h = ShotSets.TimeStep, int steps = ShotSets.Steps)
    {
        var simulator = new Simulator(PlainFlight.SceneOf(law), new SolverSettings { Integrator = integrator });
        var flight = PlainFlight.Create(law, integrator);
        var log = new StepLog();
        double largest = 0;
        foreach (Shot shot in shots)
        {
            Shot high = shot.From(ShotSets.HighUp);
            BallState ball = simulator.Launch(high.Position, high.Velocity, high.Spin);
            var plain = PlainState.Of(high);
            for (int i = 0; i < steps; i++)
            {
                simulator.Step(ref ball, h, log);
                flight.Step(ref plain, h);
            }

            largest = Math.Max(largest, Vector3d.Distance(ball.Position, plain.Position));
        }

        return largest;
    }
}
