namespace FootballPhysics.Benchmarks;

/// <summary>Makes the workloads of many balls and many aims.</summary>
internal static class BatchWorkloads
{
    private const int Balls = 256;
    private const int Aims = 2048;
    private const int AimsOfTwo = 16_384;

    /// <summary>Simulates flights of 1.2 s high up, in steps of 10 ms, on one thread.</summary>
    public static Workload Flight(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots, int lanes)
    {
        var batch = new BallBatch(scene, Settings(integrator), lanes);
        Shot[] high = [.. Shots.HighUp(shots)];
        var launches = new BatchLaunches(Balls);
        var flights = new BatchFlights(Balls);
        for (int i = 0; i < Balls; i++)
        {
            Shot shot = high[i % high.Length];
            launches.Set(i, shot.Position, shot.Velocity, shot.Spin);
        }

        return new Workload(
            () =>
            {
                batch.Fly(launches, flights, Balls, ShotSets.Steps * batch.TimeStep);
                return flights.Position.X[0];
            },
            Balls * ShotSets.Steps);
    }

    /// <summary>Finds kicks for targets 15 to 25 m away at 20 to 30 m/s with spin, to a millimetre, on one thread.</summary>
    public static Workload Aim(Scene scene, int lanes)
    {
        BatchAims aims = MakeAims(Aims);
        var kicks = new BatchKicks(Aims);
        var aimer = new BatchAimer(scene, 1, lanes);
        return new Workload(
            () =>
            {
                aimer.Find(aims, kicks, Aims);
                return kicks.Time[0];
            },
            Aims);
    }

    /// <summary>Finds these kicks on two threads, per aim and core.</summary>
    public static Workload AimOnTwoCores(Scene scene, int lanes)
    {
        BatchAims aims = MakeAims(AimsOfTwo);
        var kicks = new BatchKicks(AimsOfTwo);
        var aimer = new BatchAimer(scene, 2, lanes);
        return new Workload(
            () =>
            {
                aimer.Find(aims, kicks, AimsOfTwo);
                return kicks.Time[0];
            },
            AimsOfTwo / 2);
    }

    /// <summary>Returns the greatest distance of the first landings from the single ball's, in double precision with the same steps.</summary>
    public static double FromSingleBall(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        BatchFlights flights = Land(scene, Settings(integrator), shots);
        BatchFlights single = Land(scene, Settings(integrator) with { Precision = BatchPrecision.Double }, shots);
        return Enumerable.Range(0, shots.Count).Max(i => Vector3d.Distance(flights.Position[i], single.Position[i]));
    }

    /// <summary>Returns the mean distance of the first landings from RK4 at 0.5 ms.</summary>
    public static double LandingError(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        BatchFlights flights = Land(scene, Settings(integrator), shots);
        BatchFlights reference = Land(scene, new BatchSettings { Precision = BatchPrecision.Double, TimeStep = 0.5e-3 }, shots);
        return Enumerable.Range(0, shots.Count).Average(i => Vector3d.Distance(flights.Position[i], reference.Position[i]));
    }

    /// <summary>Returns the true misses of the kicks that were found.</summary>
    public static (double Mean, double Worst) Misses(Scene scene)
    {
        BatchAims aims = MakeAims(Aims);
        var kicks = new BatchKicks(Aims);
        new BatchAimer(scene).Find(aims, kicks, Aims);
        var meter = new AimContext(new Simulator(scene)).Miss;
        double[] misses = [.. Enumerable.Range(0, Aims)
            .Where(i => kicks.Status[i] == AimStatus.Hit)
            .Select(i => meter.Measure(aims.Request(i), kicks.Velocity[i], kicks.Spin[i]).Distance)];
        return (misses.Average(), misses.Max());
    }

    private static BatchFlights Land(Scene scene, BatchSettings settings, IReadOnlyList<Shot> shots)
    {
        var launches = new BatchLaunches(shots.Count);
        var flights = new BatchFlights(shots.Count);
        for (int i = 0; i < shots.Count; i++)
        {
            launches.Set(i, shots[i].Position, shots[i].Velocity, shots[i].Spin);
        }

        new BallBatch(scene, settings).Fly(launches, flights, shots.Count);
        return flights;
    }

    private static BatchSettings Settings(Integrator integrator) => new() { Integrator = integrator, TimeStep = ShotSets.TimeStep };

    private static BatchAims MakeAims(int count)
    {
        var random = new Random(7);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        var aims = new BatchAims(count);
        for (int i = 0; i < count; i++)
        {
            double distance = Between(15, 25);
            double azimuth = Between(0, 2.0 * Math.PI);
            var target = new Vector3d(distance * Math.Cos(azimuth), Between(0.3, 2.3), distance * Math.Sin(azimuth));
            aims.Set(i, Vector3d.Zero, target, Between(20, 30), Between(-20, 20), Between(-30, 30));
        }

        return aims;
    }
}
