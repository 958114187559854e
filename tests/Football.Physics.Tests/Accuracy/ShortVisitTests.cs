namespace FootballPhysics.Tests.Accuracy;

/// <summary>Shots near the corner of the drag law, which enter the law with spin and leave it again after a few milliseconds.</summary>
public sealed class ShortVisitTests
{
    [Fact]
    public void A_visit_to_the_law_with_spin_is_not_missed_by_a_large_step()
    {
        var simulator = new Simulator(Scene.Published);
        var random = new Random(5);
        var log = new StepLog();
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        Vector3d Landing(Vector3d velocity, Vector3d spin, double step)
        {
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, spin);
            simulator.Run(ref state, step, 30, StopAt.Impact, log);
            return state.Position;
        }

        int apart = 0;
        for (int i = 0; i < 4000; i++)
        {
            double elevation = Between(5, 35) * Math.PI / 180;
            Vector3d velocity = Between(12.3, 13.5) * new Vector3d(Math.Cos(elevation), Math.Sin(elevation), 0);
            double upright = Between(-1, 1);
            double turned = Between(0, 2 * Math.PI);
            double across = Math.Sqrt(1 - (upright * upright));
            Vector3d spin = Between(5.45, 5.8) * new Vector3d(across * Math.Cos(turned), upright, across * Math.Sin(turned));
            apart += Vector3d.Distance(Landing(velocity, spin, 0.08), Landing(velocity, spin, 0.01)) > 1e-4 ? 1 : 0;
        }

        // One that only grazes both surfaces may be, of hundreds of thousands.
        Assert.InRange(apart, 0, 1);
    }
}
