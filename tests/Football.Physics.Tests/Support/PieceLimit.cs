using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Support;

/// <summary>Ends a step that would never end: after too many pieces of motion it asks for a halt, and says so.</summary>
internal sealed class PieceLimit : PieceObserver
{
    private readonly int _most;
    private int _count;

    public PieceLimit(int most) => _most = most;

    public bool Reached => _count >= _most;

    public override bool WantsEndAcceleration => false;

    public override bool Add(in PathSegment piece) => ++_count >= _most;
}
