using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Tool.Gallery;

/// <summary>How deep a shot bulges the nets of its scene.</summary>
internal static class DeepestBulges
{
    /// <summary>Less than this is not worth a line, m.</summary>
    private const double Shallow = 0.05;

    /// <summary>Lines along and across each net that was hit, through the deepest point of its bulge; and how deep the deepest is, m.</summary>
    public static (IReadOnlyList<Vector3d[]> Lines, double Depth) Of(Scenario scenario)
    {
        Net[] nets = [.. scenario.Scene.Nets.Concat(scenario.Scene.Goals.SelectMany(goal => goal.Nets()))];
        NetMove[] deepest = [.. NetMoves.Of(scenario).GroupBy(move => move.Net).Select(net => net.MaxBy(move => move.Bulge.Depth)).OrderBy(move => move.Net)];
        return ([.. deepest.Where(move => move.Bulge.Depth > Shallow).SelectMany(move => Lines(nets[move.Net], move.Bulge))], deepest.Select(move => move.Bulge.Depth).DefaultIfEmpty().Max());
    }

    private static IEnumerable<Vector3d[]> Lines(Net net, NetBulge bulge)
    {
        Vector3d along = net.Along.Normalized();
        Vector3d across = Vector3d.Cross(net.Normal.Normalized(), along);
        Vector3d from = bulge.Position - net.Center;
        Vector3d onAlong = Vector3d.Dot(in from, in along) * along;
        Vector3d onAcross = Vector3d.Dot(in from, in across) * across;
        yield return [net.Center - (net.HalfLength * along) + onAcross, bulge.Position, net.Center + (net.HalfLength * along) + onAcross];
        yield return [net.Center - (net.HalfWidth * across) + onAlong, bulge.Position, net.Center + (net.HalfWidth * across) + onAlong];
    }
}
