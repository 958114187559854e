using FootballPhysics.Simulation;

namespace FootballPhysics.Batch;

/// <summary>Finds the greatest height of the centre, located within the step.</summary>
internal sealed class HighestPoint : PieceObserver
{
    /// <summary>The greatest height so far, in m.</summary>
    public double Apex { get; private set; } = double.NegativeInfinity;

    /// <summary>Restarts from a launch.</summary>
    public void Reset(in BallState launch) => Apex = launch.Position.Y;

    public override bool Add(in PathSegment piece)
    {
        Apex = Math.Max(Apex, piece.Apex);
        return false;
    }
}
