namespace Football.Physics.Headless.Lab.Stability.Things;

/// <summary>Looks along the path of a ball how deep it is in anything: nothing is passed through.</summary>
internal sealed class PathSamples(World world) : PieceObserver
{
    /// <summary>Places of a piece that are looked at.</summary>
    private const int Samples = 8;

    public override bool WantsEndAcceleration => true;

    /// <summary>The deepest that it was in a thing that stands still, m.</summary>
    public double Deepest { get; private set; }

    public void Clear() => Deepest = 0;

    public override bool Add(in PathPiece piece)
    {
        for (int k = 1; k <= Samples; k++)
        {
            double time = piece.Time + (piece.Length * k / Samples);
            Vector3d place = piece.PositionAt(time);
            Bounds3d near = new Bounds3d(in place, in place).Grown(0.5);
            foreach (Collider collider in world.Colliders)
            {
                double reach = collider.Moves || !collider.Bounds.Touches(in near) ? 1 : collider.At(in place).Distance;
                Deepest = Math.Max(Deepest, world.Ball.Radius - reach);
            }
        }

        return false;
    }
}
