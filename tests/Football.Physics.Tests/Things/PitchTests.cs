using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Pitches by law 1, and the bowl of boards round them.</summary>
public sealed class PitchTests
{
    [Fact]
    public void A_pitch_has_two_goals_that_face_each_other()
    {
        Scene scene = Pitch.Standard.On();
        Assert.Equal([-52.5, 52.5], scene.Goals.Select(goal => goal.Center.Z));
        Assert.Empty(scene.Obstacles);
        var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
        foreach (double side in new[] { -1.0, 1.0 })
        {
            BallState state = simulator.Launch(new Vector3d(1, 1, side * 45), new Vector3d(0, 1, side * 20), Vector3d.Zero);
            var log = new StepLog();
            simulator.Run(ref state, 0.01, 2, StopAt.Time, log);
            Assert.Contains(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Goal);
        }
    }

    [Fact]
    public void No_ball_leaves_a_cage_over_the_ground()
    {
        var simulator = new Simulator(Pitch.Cage.On(), Flight.With(Integrator.Rk2));
        for (int i = 0; i < 64; i++)
        {
            double angle = i * Math.PI / 32;
            BallState state = simulator.Launch(new Vector3d(0, Flight.Radius, 0), new Vector3d(15 * Math.Cos(angle), 0, 15 * Math.Sin(angle)), Vector3d.Zero);
            var log = new StepLog();
            simulator.Run(ref state, 0.02, 20, StopAt.Time, log);
            Assert.InRange(Math.Abs(state.Position.X), 0, 10);

            // Behind its line there is the goal.
            Assert.InRange(Math.Abs(state.Position.Z), 0, Math.Abs(state.Position.X) < 1.5 ? 21.5 : 20);
        }
    }

    [Fact]
    public void Boards_stand_where_they_are_asked_for()
    {
        Assert.Equal(4, Pitch.Stadium.Boards.Count);
        Assert.Equal(6, Pitch.Cage.Boards.Count);
        Assert.Equal("pitch.boardHeight", Assert.Throws<ArgumentOutOfRangeException>(() => (Pitch.Standard with { BoardHeight = -1 }).Boards).ParamName);
    }
}
