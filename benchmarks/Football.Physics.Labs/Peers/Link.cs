namespace FootballPhysics.Labs.Peers;

/// <summary>A line that delays, loses, doubles and reorders packets.</summary>
internal sealed class Link(SeededRandom random)
{
    private const double Loses = 0.25;
    private const double Doubles = 0.15;
    private const int MostDelay = 12;

    private readonly List<(int Due, int To, byte[] Packet)> _packets = [];
    private int _round;

    public int Sent { get; private set; }

    public int Lost { get; private set; }

    public int Doubled { get; private set; }

    /// <summary>Starts the next round.</summary>
    public void Round() => _round++;

    /// <summary>Sends a packet to a peer.</summary>
    public void Send(int to, byte[] packet)
    {
        Sent++;
        if (random.Chance(Loses))
        {
            Lost++;
            return;
        }

        for (int copies = random.Chance(Doubles) ? 2 : 1; copies > 0; copies--)
        {
            Doubled += copies - 1;
            _packets.Add((_round + 1 + random.Below(MostDelay), to, packet));
        }
    }

    /// <summary>Returns the packets that reach a peer in this round.</summary>
    public List<byte[]> Received(int to)
    {
        List<byte[]> due = [.. _packets.Where(packet => packet.To == to && packet.Due <= _round).Select(packet => packet.Packet)];
        _packets.RemoveAll(packet => packet.To == to && packet.Due <= _round);
        return due;
    }
}
