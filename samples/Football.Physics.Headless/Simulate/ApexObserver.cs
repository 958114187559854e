namespace Football.Physics.Headless.Simulate;

/// <summary>Finds the greatest height of a flight, between steps too.</summary>
internal sealed class ApexObserver(double launchHeight) : PieceObserver
{
    /// <summary>The greatest height so far, m.</summary>
    public double Apex { get; private set; } = launchHeight;

    public override void Add(in Piece piece) => Apex = Math.Max(Apex, piece.Apex);
}
