using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Support;

/// <summary>The greatest height of the centre over a run, launch included.</summary>
/// <remarks>It ends a run that would never end by itself.</remarks>
internal sealed class ApexObserver : PieceObserver
{
    private readonly PieceLimit _limit = new(1_000_000);

    public ApexObserver(double launchHeight) => Apex = launchHeight;

    public double Apex { get; private set; }

    public override bool WantsEndAcceleration => true;

    public override bool Add(in PathSegment piece)
    {
        Apex = Math.Max(Apex, piece.Apex);
        return _limit.Add(in piece);
    }
}
