namespace Football.Physics.Tests.Support;

/// <summary>The greatest height of the centre over a run, launch included.</summary>
internal sealed class ApexObserver : PieceObserver
{
    public ApexObserver(double launchHeight) => Apex = launchHeight;

    public double Apex { get; private set; }

    public override void Add(in Piece piece) => Apex = Math.Max(Apex, piece.Apex);
}
