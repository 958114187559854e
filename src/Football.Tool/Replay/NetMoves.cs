using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>A net that is pushed out, at an instant.</summary>
/// <param name="Time">The instant, s.</param>
/// <param name="Net">Which net of the picture.</param>
/// <param name="Bulge">How deep, where and which way.</param>
internal readonly record struct NetMove(double Time, int Net, NetBulge Bulge);

/// <summary>How the nets of a scene move in a shot.</summary>
internal static class NetMoves
{
    /// <summary>What is flatter than this hangs still, m.</summary>
    private const double Flat = 0.004;

    /// <summary>What has changed by less than this is not told anew, m.</summary>
    private const double Fine = 0.006;

    /// <summary>All bulges of a shot, step by step; the last of each is flat.</summary>
    public static IEnumerable<NetMove> Of(Scenario scenario)
    {
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        var bulges = new NetBulges(simulator);
        if (bulges.Count == 0)
        {
            yield break;
        }

        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation);
        var log = new StepLog();
        var moving = new bool[bulges.Count];
        while (state.Time < scenario.Duration && state.Motion != MotionState.Rest)
        {
            log.Clear();
            scenario.BeforeStep?.Invoke(state);
            simulator.Step(ref state, scenario.TimeStep, log);
            bulges.Follow(in state);
            for (int net = 0; net < moving.Length; net++)
            {
                bool moves = bulges[net].Depth > Flat;
                if (moves || moving[net])
                {
                    yield return new NetMove(state.Time, net, bulges[net]);
                }

                moving[net] = moves;
            }
        }
    }

    /// <summary>As few of them as show the same.</summary>
    public static IEnumerable<NetMove> Thinned(IEnumerable<NetMove> moves)
    {
        foreach (IGrouping<int, NetMove> net in moves.GroupBy(move => move.Net))
        {
            NetMove[] all = [.. net];
            NetMove told = all[0];
            yield return told;
            for (int i = 1; i < all.Length; i++)
            {
                bool last = i == all.Length - 1 || all[i + 1].Bulge.Depth <= Flat || all[i].Bulge.Depth <= Flat;
                if (last || Math.Abs(all[i].Bulge.Depth - told.Bulge.Depth) > Fine || (all[i].Bulge.Position - told.Bulge.Position).Length > 3 * Fine)
                {
                    told = all[i];
                    yield return told;
                }
            }
        }
    }
}
