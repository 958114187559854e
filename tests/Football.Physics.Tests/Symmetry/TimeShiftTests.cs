namespace FootballPhysics.Tests.Symmetry;

/// <summary>Nothing depends on when it happens: a scene whose objects stand still gives the same motion at any time of the clock.</summary>
public sealed class TimeShiftTests
{
    // Steps and shifts that are exact in binary.
    private const double Step = 1.0 / 64;

    /// <summary>Balls that fall on each other between walls, roll, come together and rest.</summary>
    [Theory]
    [InlineData(4, 8.0)]
    [InlineData(7, 64.0)]
    [InlineData(10, 8.0)]
    public void A_heap_falls_the_same_at_any_time(int count, double shift)
    {
        BallState[] first = Play(count, 0, out StepLog log);
        BallState[] second = Play(count, shift, out StepLog other);
        for (int i = 0; i < count; i++)
        {
            Assert.Equal(first[i].Motion, second[i].Motion);
            Assert.InRange(Vector3d.Distance(first[i].Position, second[i].Position), 0, 1e-6);
            Assert.InRange(Vector3d.Distance(first[i].Velocity, second[i].Velocity), 0, 1e-5);
            Assert.Equal(first[i].Time + shift, second[i].Time, 1e-12);
        }

        Assert.Equal(log.Steps, other.Steps);
        Assert.InRange(log.Evaluations, 0.97 * other.Evaluations, 1.03 * other.Evaluations);
    }

    private static BallState[] Play(int count, double shift, out StepLog log)
    {
        var random = new Random(count);
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        SurfaceMaterial dull = SurfaceMaterial.DryTurf with { NormalRestitution = 0.2 };
        var scene = new Scene
        {
            Ground = Ground.Of(dull),
            Obstacles = [.. new[] { -0.35, 0.35 }.Select(x => new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(x, 0, 0), new Vector3d(x < 0 ? 1 : -1, 0, 0)), Surface = dull })],
        };
        var group = new BallGroup(scene, [.. Enumerable.Repeat(BallProperties.Tunnel, count)], null, SurfaceMaterial.Ball with { NormalRestitution = 0.2 });
        var states = new BallState[count];
        for (int i = 0; i < count; i++)
        {
            states[i] = group.SimulatorOf(i).Launch(new Vector3d(Any(-0.2, 0.2), 0.12 + (0.26 * (i / 2)), (i % 2 * 0.3) + Any(-0.03, 0.03)), new Vector3d(Any(-1, 1), 0, Any(-1, 1)), Vector3d.Zero);
            states[i].Time = shift;
        }

        log = new StepLog();
        for (int i = 0; i < 64; i++)
        {
            group.Step(states, Step, log);
        }

        return states;
    }
}
