using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>The bulge of a net at a time.</summary>
/// <param name="Time">The time, in s.</param>
/// <param name="Net">The index of the net in the picture.</param>
/// <param name="Bulge">The depth, position and direction of the bulge.</param>
internal readonly record struct NetMove(double Time, int Net, NetBulge Bulge);

/// <summary>Computes the movements of the nets of a scene in a shot.</summary>
internal static class NetMoves
{
    /// <summary>The depth below which a net counts as at rest, in m.</summary>
    private const double Flat = 0.004;

    /// <summary>The change of depth below which a movement is omitted, in m; for the position, three times as much.</summary>
    private const double Fine = 0.006;

    /// <summary>Returns all bulges of a shot, step by step. The last bulge of each movement is flat.</summary>
    public static IEnumerable<NetMove> Of(Scenario scenario)
    {
        var simulator = new Simulator(scenario.Scene, scenario.Settings);
        var bulges = new NetBulges(simulator);
        if (bulges.Count == 0)
        {
            yield break;
        }

        BallState state = simulator.Launch(scenario.Position, scenario.Velocity, scenario.Spin, scenario.Orientation ?? simulator.LaunchOrientation);
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

    /// <summary>Removes movements that hardly change the picture.</summary>
    public static IEnumerable<NetMove> Thinned(IEnumerable<NetMove> moves)
    {
        foreach (IGrouping<int, NetMove> net in moves.GroupBy(move => move.Net))
        {
            NetMove[] all = [.. net];
            NetMove kept = all[0];
            yield return kept;
            for (int i = 1; i < all.Length; i++)
            {
                bool last = i == all.Length - 1 || all[i + 1].Bulge.Depth <= Flat || all[i].Bulge.Depth <= Flat;
                if (last || Math.Abs(all[i].Bulge.Depth - kept.Bulge.Depth) > Fine || (all[i].Bulge.Position - kept.Bulge.Position).Length > 3 * Fine)
                {
                    kept = all[i];
                    yield return kept;
                }
            }
        }
    }
}
