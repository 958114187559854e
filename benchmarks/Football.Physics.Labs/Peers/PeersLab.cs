namespace FootballPhysics.Labs.Peers;

/// <summary>football lab peers: matches of two peers over a bad line, which must agree on every ball and on the score.</summary>
internal static class PeersLab
{
    private const string Apart = "balls apart";
    private const string Unequal = "scores apart";
    private const string Elsewhere = "not as in time";

    public static Lab Create() => new Lab(
        "peers",
        "Matches of two peers with keepers, goals, restarts and kicks that arrive up to 20 ticks late, lost and doubled: equal states and equal scores.",
        ["football lab peers", "football lab peers --matches 5 --seed 7"]).Plays(Lab.Number("--matches", "Number of matches.", 1, 1_000_000, 1000), Play);

    /// <summary>Plays the matches on all processors.</summary>
    public static void Play(LabRun run, int matches)
    {
        var counts = new LabCounts();
        run.Parallel(0, matches, Environment.ProcessorCount, "match", i => Play(run, i, counts));
        LabTable table = run.Table("Two peers", "what", "count", "verdict");
        foreach (string what in (string[])["kicks", "restarts", "dives", "goals", "goals that count", "late inputs", "inputs that came again", "packets", "lost", "doubled", "ticks resimulated"])
        {
            table.Count(what, counts[what]);
        }

        for (int late = 0; late < Peer.MostLate; late += 5)
        {
            table.Count($"inputs {late + 1} to {late + 5} ticks late", counts[Peer.Lateness(late + 1)]);
        }

        table.Count("checkpoints and ends", counts["checkpoints"]);
        table.Count("checkpoints at which the balls are apart", counts[Apart], counts[Apart] == 0);
        table.Count("matches whose scores are apart", counts[Unequal], counts[Unequal] == 0);
        table.Count("matches that differ from one with all inputs in time", counts[Elsewhere], counts[Elsewhere] == 0);
        run.Notes.AddRange(counts.Examples);
    }

    private static void Play(LabRun run, long index, LabCounts counts)
    {
        var random = new SeededRandom(SeededRandom.Mix(run.Seed, index));
        int wire = random.Chance(0.3) ? 6 : 0;
        ulong seed = SeededRandom.Mix(run.Seed, ~index);
        var link = new Link(random);
        Peer[] peers = [.. Enumerable.Range(0, 2).Select(team => new Peer(team, new PeerMatch(new SeededRandom(seed), wire), new SeededRandom(seed + 1 + (ulong)team), link))];
        while (!peers.All(peer => peer.IsDone))
        {
            // The peers run at their own pace, until one of them has to wait for the other.
            link.Round();
            foreach (Peer peer in peers)
            {
                peer.Receive();
                if (random.Chance(0.85))
                {
                    peer.Advance();
                }

                peer.Send();
            }
        }

        // All inputs of both, in time.
        var inTime = new PeerMatch(new SeededRandom(seed), wire);
        var score = new Score();
        inTime.Runner.Kicks.Add(peers[0].Match.Runner.Kicks, 0, Peer.Ticks);
        while (inTime.Runner.Tick < Peer.Ticks)
        {
            inTime.Runner.Step();
            score.Add(inTime.Runner.Kicks, inTime.Runner.Tick - 1, [.. inTime.Runner.Events.Span]);
        }

        int apart = Enumerable.Range(0, peers[0].Checkpoints.Count).Count(i => peers[0].Checkpoints[i] != peers[1].Checkpoints[i]);
        bool isUnequal = peers[0].Score.Text != peers[1].Score.Text;
        bool isElsewhere = Snapshot.Hash(inTime.Runner.State) != peers[0].Checkpoints[^1] || score.Text != peers[0].Score.Text;
        counts.Add(Apart, apart);
        counts.AddIf(isUnequal, Unequal);
        counts.Require(
            apart == 0 && !isUnequal && !isElsewhere,
            Elsewhere,
            $"Match {index} of seed {run.Seed}: {apart} checkpoints apart, scores {peers[0].Score.Text} and {peers[1].Score.Text}, in time {score.Text}.");
        counts.Add("checkpoints", peers[0].Checkpoints.Count);
        counts.Add("kicks", inTime.Runner.Kicks.Count);
        counts.Add("restarts", inTime.Runner.Kicks.PlaceCount);
        counts.Add("dives", inTime.Dives);
        counts.Add("goals", score.Seen);
        counts.Add("goals that count", score.Counted);
        counts.Add("packets", link.Sent);
        counts.Add("lost", link.Lost);
        counts.Add("doubled", link.Doubled);
        foreach (Peer peer in peers)
        {
            peer.AddTo(counts);
        }
    }
}
