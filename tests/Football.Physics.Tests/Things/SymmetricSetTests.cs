namespace FootballPhysics.Tests.Things;

/// <summary>Contacts that bear the same load: rolling resistance must not pass to and fro between them.</summary>
public sealed class SymmetricSetTests
{
    private const double Radius = 0.11;

    /// <summary>A ball slides, then rolls down a gutter whose sides are alike: whole steps, but for the one in which the slip ends.</summary>
    [Theory]
    [InlineData(0.05, 20, 0.0)]
    [InlineData(0.1, 45, 0.0)]
    [InlineData(0.1, 45, 30.0)]
    [InlineData(0.3, 60, -20.0)]
    public void A_gutter_with_two_equal_sides_takes_whole_steps(double tilt, double side, double spin)
    {
        double angle = side * Math.PI / 180;
        var up = new Vector3d(0, Math.Cos(tilt), Math.Sin(tilt));
        var along = new Vector3d(0, -Math.Sin(tilt), Math.Cos(tilt));
        Vector3d left = (Math.Cos(angle) * up) + new Vector3d(Math.Sin(angle), 0, 0);
        Vector3d right = (Math.Cos(angle) * up) - new Vector3d(Math.Sin(angle), 0, 0);
        var scene = new Scene
        {
            Ground = Ground.None,
            Obstacles = [Side(left), Side(right)],
        };
        var simulator = new Simulator(scene);
        BallState s = simulator.Launch(Radius / Math.Cos(angle) * up, along, new Vector3d(spin, 0, 0));
        var log = new StepLog();
        int hard = 0;
        long most = 0;
        for (int i = 0; i < 100; i++)
        {
            log.Clear();
            simulator.Step(ref s, 0.01, log);
            hard += log.Evaluations > 16 ? 1 : 0;
            most = Math.Max(most, log.Evaluations);
            Assert.NotEqual(MotionState.Airborne, s.Motion);
            Assert.InRange(Math.Abs(s.Position.X), 0, 1e-9);
        }

        // The start, the ends of slips, and the turn of the roll at the top.
        Assert.InRange(hard, 0, 5);
        Assert.InRange(most, 0, 400);
    }

    private static Obstacle Side(in Vector3d normal) => new() { Name = "side", Shape = new PlaneShape(Vector3d.Zero, normal), Surface = SurfaceMaterial.Board };
}
