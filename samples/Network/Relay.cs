using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace FootballPhysics.Network;

/// <summary>The quality of the network.</summary>
/// <param name="Delay">The delay from one machine to the other, ms.</param>
/// <param name="Jitter">The maximum additional delay, random for each packet, ms. It lets packets overtake one another.</param>
/// <param name="Loss">The share of the packets that are lost, 0 … 1.</param>
public sealed record Weather(double Delay, double Jitter, double Loss);

/// <summary>
/// The network between two machines, and their clock. At each tick, it sends both the packets that are due, over UDP, and receives theirs, which it delays, reorders or drops.
/// Its clock lets ten minutes of a match take only the time that two processors need for them; a speed of 1 is real time.
/// </summary>
public sealed class Relay : IDisposable
{
    public const byte Hello = 1;
    public const byte Tick = 2;
    public const byte Done = 3;
    public const byte End = 4;
    private const int Sides = 2;

    private readonly UdpClient _socket = new(new IPEndPoint(IPAddress.Loopback, 0));
    private readonly IPEndPoint?[] _sides = new IPEndPoint?[Sides];
    private readonly PriorityQueue<byte[], (long Due, long Order)>[] _waiting = [new(), new()];
    private readonly Weather _weather;
    private readonly Random _random;
    private long _order;

    public Relay(Weather weather, int seed)
    {
        _weather = weather;
        _random = new Random(seed);
        _socket.Client.ReceiveTimeout = 60_000;
    }

    public int Port => ((IPEndPoint)_socket.Client.LocalEndPoint!).Port;

    public long Now { get; private set; }

    public int Sent { get; private set; }

    /// <summary>The number of bytes that each side has sent, without the headers of UDP and IP (28 per packet).</summary>
    public long[] Bytes { get; } = new long[Sides];

    public int Lost { get; private set; }

    public int Overtaken { get; private set; }

    /// <summary>Waits until a side has sent its first packet.</summary>
    public void Await(int side)
    {
        while (_sides[side] is null)
        {
            Receive();
        }
    }

    /// <summary>Removes a side, and the packets on the way to it.</summary>
    public void Forget(int side)
    {
        _sides[side] = null;
        _waiting[side].Clear();
    }

    /// <summary>Runs the clock up to a tick.</summary>
    /// <param name="tick">The tick.</param>
    /// <param name="speed">The speed relative to real time; 0 for as fast as possible.</param>
    public void Run(long tick, double speed)
    {
        var watch = Stopwatch.StartNew();
        long start = Now;
        for (; Now < tick; Now++)
        {
            for (int side = 0; side < Sides; side++)
            {
                Send(side, Tick, Due(side));
            }

            // Wait for both in any order, but draw the random numbers in a fixed order, so that a seed reproduces a match.
            byte[][]?[] sent = [_sides[0] is null ? [] : null, _sides[1] is null ? [] : null];
            while (sent.Contains(null))
            {
                (int side, byte kind, byte[][] packets) = Receive();
                if (kind == Done && side >= 0)
                {
                    sent[side] = packets;
                }
            }

            for (int side = 0; side < Sides; side++)
            {
                foreach (byte[] packet in sent[side]!)
                {
                    Carry(1 - side, packet);
                }
            }

            double ahead = speed > 0 ? ((Now - start) * Match.Step / speed) - watch.Elapsed.TotalSeconds : 0;
            if (ahead > 0)
            {
                Thread.Sleep(TimeSpan.FromSeconds(ahead));
            }
        }
    }

    /// <summary>Ends the match for a side.</summary>
    public void Stop(int side)
    {
        Send(side, End, []);
        Forget(side);
    }

    public void Dispose() => _socket.Dispose();

    /// <summary>Returns a datagram: its kind, the tick, and packets.</summary>
    internal static byte[] Frame(byte kind, long tick, IReadOnlyList<byte[]> packets)
    {
        using var memory = new MemoryStream();
        using var writer = new BinaryWriter(memory);
        writer.Write(kind);
        writer.Write(tick);
        writer.Write((byte)packets.Count);
        foreach (byte[] packet in packets)
        {
            writer.Write((ushort)packet.Length);
            writer.Write(packet);
        }

        return memory.ToArray();
    }

    internal static (byte Kind, long Tick, byte[][] Packets) Parse(byte[] frame)
    {
        using var reader = new BinaryReader(new MemoryStream(frame));
        byte kind = reader.ReadByte();
        long tick = reader.ReadInt64();
        var packets = new byte[reader.ReadByte()][];
        for (int i = 0; i < packets.Length; i++)
        {
            packets[i] = reader.ReadBytes(reader.ReadUInt16());
        }

        return (kind, tick, packets);
    }

    private void Carry(int to, byte[] packet)
    {
        Sent++;
        Bytes[1 - to] += packet.Length;
        if (_random.NextDouble() < _weather.Loss || _sides[to] is null)
        {
            Lost++;
            return;
        }

        long due = Now + Math.Max(1, (long)Math.Round((_weather.Delay + (_weather.Jitter * _random.NextDouble())) / 1000 / Match.Step));
        _waiting[to].Enqueue(packet, (due, _order++));
    }

    private List<byte[]> Due(int side)
    {
        var due = new List<byte[]>();
        while (_waiting[side].TryPeek(out byte[]? packet, out (long Due, long Order) at) && at.Due <= Now)
        {
            _waiting[side].Dequeue();
            due.Add(packet);
            Overtaken += _waiting[side].UnorderedItems.Any(item => item.Priority.Order < at.Order) ? 1 : 0;
        }

        return due;
    }

    private void Send(int side, byte kind, IReadOnlyList<byte[]> packets)
    {
        if (_sides[side] is { } to)
        {
            _socket.Send(Frame(kind, Now, packets), to);
        }
    }

    private (int Side, byte Kind, byte[][] Packets) Receive()
    {
        IPEndPoint from = new(IPAddress.Any, 0);
        (byte kind, long tick, byte[][] packets) = Parse(_socket.Receive(ref from));
        if (kind == Hello)
        {
            _sides[(int)tick] = from;
            return ((int)tick, kind, packets);
        }

        return (Array.FindIndex(_sides, side => side is not null && side.Equals(from)), kind, packets);
    }
}

/// <summary>A machine's end of the network: calls the game once per tick with the received packets, and sends the packets that the game returns.</summary>
public static class Link
{
    /// <summary>Plays until the relay ends the match.</summary>
    public static void Run(int port, int side, Func<long, byte[][], IReadOnlyList<byte[]>> tick)
    {
        using var socket = new UdpClient();
        socket.Connect(IPAddress.Loopback, port);
        socket.Client.ReceiveTimeout = 60_000;
        socket.Send(Relay.Frame(Relay.Hello, side, []));
        while (true)
        {
            IPEndPoint? from = null;
            (byte kind, long now, byte[][] packets) = Relay.Parse(socket.Receive(ref from));
            if (kind == Relay.End)
            {
                return;
            }

            socket.Send(Relay.Frame(Relay.Done, now, tick(now, packets)));
        }
    }
}
