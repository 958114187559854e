using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>The longest piece of a ball on one or several surfaces.</summary>
internal sealed class PieceLength
{
    /// <summary>Maximum rotation of a normal per piece, rad.</summary>
    private const double LargestTurn = 0.05;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly NetGuard _nets;

    public PieceLength(Surroundings around, in StabilityLimit limit)
    {
        _around = around;
        _world = around.World;
        _limit = limit;
        _nets = new NetGuard(_world);
    }

    /// <summary>Returns the longest piece that stability, turning normals, nets and the narrowest patch of the carrier allow, s.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="from">Its motion.</param>
    /// <param name="damping">The largest c_ω of the surfaces, N m s.</param>
    /// <param name="slowing">The friction of all slips, m/s².</param>
    /// <param name="turning">The largest |ṅ|, 1/s.</param>
    /// <param name="run">The step.</param>
    public double Longest(in BallState s, in Motion from, double damping, double slowing, double turning, ref StepRun run)
    {
        double requested = run.Next;
        double h = _limit.PartOf(
            ref _around.Air, requested, (from.Velocity - _around.Wind).Length, from.Spin.Length, s.Branch, ref run.Spirals,
            damping / _world.Ball.MomentOfInertia, requested * slowing);
        h = turning * h > LargestTurn ? LargestTurn / turning : h;
        h = Math.Min(h, _nets.LongestPiece(in s, h));
        Collider carrier = _world.CarrierOf(in s);
        h = SurfaceBorder.LongestPiece(carrier, (from.Velocity - carrier.Velocity).Length, h);
        run.Keep(h, requested);
        return h;
    }
}
