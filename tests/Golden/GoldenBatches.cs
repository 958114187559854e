using FootballPhysics.Batch;

// The batches whose bits every runtime must reproduce, whatever the width of its registers: many balls, and many aims.

namespace FootballPhysics.Golden;

internal static class GoldenBatches
{
    private const int Balls = 300;
    private const int Aims = 100;

    /// <summary>Every bit of the results, mixed: balls with both integrators, and aims.</summary>
    public static IEnumerable<KeyValuePair<string, ulong>> Hashes(Scene scene)
    {
        yield return GoldenShots.Named("balls Rk2", Fly(scene, Integrator.Rk2, 0.01));
        yield return GoldenShots.Named("balls Rk4", Fly(scene, Integrator.Rk4, 0.03));
        yield return GoldenShots.Named("aims", Aim(scene));
    }

    private static ulong Fly(Scene scene, Integrator integrator, double timeStep)
    {
        var launches = new BatchLaunches(Balls);
        var flights = new BatchFlights(Balls);
        var random = new Draws();
        for (int i = 0; i < Balls; i++)
        {
            // Some from above the ground; speeds at which many cross the drag law's jump.
            var place = new Vector3d(random.Between(-50, 50), i % 4 == 0 ? random.Between(3, 10) : 0.11, random.Between(-50, 50));
            var velocity = new Vector3d(random.Between(-18, 18), random.Between(2, 12), random.Between(-18, 18));
            launches.Set(i, place, velocity, new Vector3d(random.Between(-30, 30), random.Between(-30, 30), random.Between(-30, 30)));
        }

        var settings = new BatchSettings { Integrator = integrator, TimeStep = timeStep, FindApex = true };
        new BallBatch(scene, settings).Fly(launches, flights, Balls);
        ulong hash = 0;
        for (int i = 0; i < Balls; i++)
        {
            GoldenTrace.Add(flights.Position[i]);
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, (ulong)flights.End[i]), flights.Time[i]);
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, flights.Position[i]), flights.Velocity[i]);
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, flights.Spin[i]), flights.VelocityAfter[i]);
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, flights.SpinAfter[i]), flights.Apex[i]);
        }

        return hash;
    }

    private static ulong Aim(Scene scene)
    {
        var aims = new BatchAims(Aims);
        var kicks = new BatchKicks(Aims);
        var random = new Draws();
        for (int i = 0; i < Aims; i++)
        {
            var target = new Vector3d(random.Between(-20, 20), random.Between(0.2, 2.4), random.Between(-25, -10));
            aims.Set(i, Vector3d.Zero, target, random.Between(18, 32), random.Between(-20, 20), random.Between(-40, 40));
        }

        new BatchAimer(scene).Find(aims, kicks, Aims);
        ulong hash = 0;
        for (int i = 0; i < Aims; i++)
        {
            GoldenTrace.Add(kicks.Velocity[i]);
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, (ulong)kicks.Status[i]), kicks.Time[i]);
            hash = GoldenShots.Mix(GoldenShots.Mix(hash, kicks.Velocity[i]), kicks.Spin[i]);
            hash = GoldenShots.Mix(hash, kicks.Miss[i]);
        }

        return hash;
    }

    /// <summary>The same numbers everywhere: a linear congruential generator.</summary>
    private sealed class Draws
    {
        private ulong _state = 20240607;

        public double Between(double low, double high)
        {
            _state = unchecked((_state * 6364136223846793005UL) + 1442695040888963407UL);
            return low + ((high - low) * ((_state >> 40) / 16777216.0));
        }
    }
}
