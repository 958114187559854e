namespace Football.Physics.Tests.Support;

/// <summary>The greatest height of the centre over a run, launch included.</summary>
internal sealed class ApexObserver : PieceObserver
{
    public ApexObserver(double launchHeight) => Apex = launchHeight;

    public double Apex { get; private set; }

    public override bool WantsEndAcceleration => true;

    public override bool Add(in PathPiece piece)
    {
        Apex = Math.Max(Apex, piece.Apex);
        return false;
    }
}
