namespace FootballPhysics.Tests.Batch;

/// <summary>The laws in lanes against those of the single ball, over their whole domain: what they do in a tenth of a second.</summary>
public sealed class LaneLawTests
{
    private const double Duration = 0.1;

    public static TheoryData<string> Scenes() => BatchScenes.Names();

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Velocity_and_spin_change_as_the_laws_say(string name)
    {
        Scene scene = BatchScenes.All[name];
        Vector3d[] velocities = [.. Speeds().Select(speed => (speed * new Vector3d(0.8, 0.6, 0)) + scene.Air.Wind)];
        Vector3d[] spins = [.. Spins().Select(spin => spin * new Vector3d(0, 0.6, 0.8))];
        var launches = new BatchLaunches(velocities.Length * spins.Length);
        for (int i = 0; i < launches.Capacity; i++)
        {
            launches.Set(i, new Vector3d(0, 50, 0), velocities[i / spins.Length], spins[i % spins.Length]);
        }

        BatchFlights single = BatchScenes.Fly(new BallBatch(scene, new BatchSettings { TimeStep = 1e-3 }), launches, Duration);
        BatchFlights twice = BatchScenes.Fly(
            new BallBatch(scene, new BatchSettings { TimeStep = 1e-3, Precision = BatchPrecision.Double }), launches, Duration);
        int inLanes = 0;
        for (int i = 0; i < launches.Capacity; i++)
        {
            double speed = launches.Velocity[i].Length;
            double spin = launches.Spin[i].Length;
            double apart = Vector3d.Distance(single.Velocity[i], twice.Velocity[i]);
            inLanes += apart > 0 ? 1 : 0;
            Assert.True(apart < 2e-5 * Math.Max(1, speed / 20), $"{apart:e2} m/s at {speed} m/s, {spin} rad/s");
            double spinApart = Vector3d.Distance(single.Spin[i], twice.Spin[i]);
            Assert.True(spinApart < 3e-5 * Math.Max(1, spin), $"{spinApart:e2} rad/s at {speed} m/s, {spin} rad/s");
        }

        Assert.True(inLanes > launches.Capacity / 2, $"{inLanes} of {launches.Capacity} are not those of the ball that flies alone");
    }

    /// <summary>The slowest, both sides of the jump, and up to the end of the domain.</summary>
    private static IEnumerable<double> Speeds()
    {
        for (double speed = 0.01; speed < 127; speed *= 1.17)
        {
            yield return speed;
        }

        foreach (double speed in (double[])[12.18, 12.19, 12.2, 12.5, 127])
        {
            yield return speed;
        }
    }

    private static IEnumerable<double> Spins()
    {
        yield return 0;
        for (double spin = 1e-3; spin < 127; spin *= 1.6)
        {
            yield return spin;
        }

        yield return 127;
    }
}
