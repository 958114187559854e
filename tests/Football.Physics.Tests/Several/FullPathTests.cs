namespace FootballPhysics.Tests.Several;

/// <summary>Look-aheads of several balls whose paths have more pieces than memory.</summary>
public sealed class FullPathTests
{
    /// <summary>A ball without room for its path goes on in whole steps: it ended its step after every piece, with all the pieces of a step before it again.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void A_ball_whose_path_is_full_goes_where_it_would(int capacity)
    {
        var simulator = new Simulator(Pitch.Cage.On());
        var group = new BallGroup(simulator, 2);
        BallState[] from =
        [
            simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(3, 4, -15), new Vector3d(20, 0, 5)),
            simulator.Launch(new Vector3d(0, 0.11, -4), new Vector3d(6, 2, 9), Vector3d.Zero),
        ];
        var request = new LookAheadRequest { TimeStep = 1 / 60.0, Duration = 3, StopAt = StopAt.Time };
        Trajectory[] full = [new Trajectory(new PathSegment[capacity]), new Trajectory(new PathSegment[capacity])];
        Trajectory[] whole = [new Trajectory(4096), new Trajectory(4096)];
        group.LookAhead(from, request, full);
        group.LookAhead(from, request, whole);
        for (int ball = 0; ball < from.Length; ball++)
        {
            Assert.Equal((false, true, capacity), (full[ball].IsComplete, whole[ball].IsComplete, full[ball].Pieces.Length));
            Assert.Equal(whole[ball].Final.ToString("R", null), full[ball].Final.ToString("R", null));
            Assert.Equal(Netcode.Snapshot.Hash(whole[ball].Final), Netcode.Snapshot.Hash(full[ball].Final));
            Assert.Equal(whole[ball].Events.Count, full[ball].Events.Count);
        }
    }
}
