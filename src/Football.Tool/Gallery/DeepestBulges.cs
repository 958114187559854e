using Football.Scenarios;

namespace Football.Tool.Gallery;

/// <summary>How deep a shot bulges the nets of its scene.</summary>
internal static class DeepestBulges
{
    /// <summary>Less than this is not worth a line, m.</summary>
    private const double Shallow = 0.05;

    /// <summary>Lines along and across each net that was hit, through the deepest point of its bulge; and how deep the deepest is, m.</summary>
    public static (IReadOnlyList<Vector3d[]> Lines, double Depth) Of(Scenario scenario)
    {
        Net[] nets = [.. scenario.Scene.Nets.Concat(scenario.Scene.Goals.SelectMany(goal => goal.Nets()))];
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        var bulges = new NetBulges(simulator);
        var deepest = new NetBulge[bulges.Count];
        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin);
        var log = new StepLog();
        while (nets.Length > 0 && state.Time < scenario.Duration && state.Motion != MotionState.Stopped)
        {
            simulator.Step(ref state, scenario.TimeStep, log);
            bulges.Follow(in state);
            for (int i = 0; i < deepest.Length; i++)
            {
                deepest[i] = bulges[i].Depth > deepest[i].Depth ? bulges[i] : deepest[i];
            }
        }

        return ([.. deepest.SelectMany((bulge, i) => bulge.Depth > Shallow ? Lines(nets[i], bulge) : [])], deepest.Select(bulge => bulge.Depth).DefaultIfEmpty().Max());
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
