using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Stability.Things;

/// <summary>Samples the depth of a ball in all objects along its path, to check that it passes through none.</summary>
internal sealed class PathSamples(World world) : PieceObserver
{
    /// <summary>The number of samples per piece.</summary>
    private const int Samples = 8;

    public override bool WantsEndAcceleration => true;

    /// <summary>The greatest depth in any object, m.</summary>
    public double Deepest { get; private set; }

    public void Clear() => Deepest = 0;

    public override bool Add(in PathSegment piece)
    {
        // Moving objects may overlap a squeezed ball. Sample only objects that are close enough to the path for the ball to reach them.
        Vector3d middle = 0.5 * (piece.StartPosition + piece.EndPosition);
        double around = (0.5 * (piece.EndPosition - piece.StartPosition).Length) + (0.25 * piece.Length * (piece.EndVelocity - piece.StartVelocity).Length) + 0.5;
        var near = new NearThings(world, new Bounds3d(in middle, in middle).Expanded(around), piece.Time, piece.Length);
        while (near.Next(out int i))
        {
            Collider collider = world.Colliders[i];
            if (collider.Moves ? piece.Motion == MotionState.Pinned : collider.At(in middle).Distance > around)
            {
                continue;
            }

            for (int k = 1; k <= Samples; k++)
            {
                double time = piece.Time + (piece.Length * k / Samples);
                Vector3d place = piece.PositionAt(time);
                Deepest = Math.Max(Deepest, world.Ball.Radius - collider.At(in place, time).Distance);
            }
        }

        return false;
    }
}
