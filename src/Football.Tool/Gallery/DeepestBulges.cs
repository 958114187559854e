using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Finds the depth to which a shot bulges the nets of its scene.</summary>
internal static class DeepestBulges
{
    /// <summary>The depth below which a bulge is not drawn, in m.</summary>
    private const double Shallow = 0.05;

    /// <summary>Returns lines along and across each net that was hit, through the deepest point of its bulge, and the greatest depth, in m.</summary>
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
