using System.Numerics;
using FootballPhysics.Engines;
using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>The kind of a packet.</summary>
public enum PacketKind : byte
{
    /// <summary>A machine joins, with the hash of its match and a number of this attempt.</summary>
    Join,

    /// <summary>The receiver is rejected, because the hash of its match differs: another version, scene or step.</summary>
    Refuse,

    /// <summary>The complete state, from which the receiver continues.</summary>
    Welcome,

    /// <summary>Inputs; from the server also the ball.</summary>
    Inputs,
}

/// <summary>Writes and reads packets. A packet repeats all inputs that the receiver has not confirmed, so a lost packet needs no reply.</summary>
public static class Packets
{
    private const int HasKick = 1 << 15;

    public static byte[] Of(PacketKind kind, Action<BinaryWriter> write)
    {
        using var memory = new MemoryStream();
        using var writer = new BinaryWriter(memory);
        writer.Write((byte)kind);
        write(writer);
        return memory.ToArray();
    }

    /// <summary>Returns the packet of a machine that joins. All packets of one attempt have the same number: one that is overtaken must not start a second attempt.</summary>
    public static byte[] OfJoin(ulong hash, int joins) => Of(PacketKind.Join, writer =>
    {
        writer.Write(hash);
        writer.Write(((long)Environment.ProcessId << 16) + joins);
    });

    /// <summary>Writes the inputs of a team from one tick up to another, exclusive: eleven bytes at first, then the changes; two bytes for a tick without any.</summary>
    public static void WriteInputs(this BinaryWriter writer, Match match, int team, long from, long to)
    {
        byte[] last = TeamInput.Stand.Moves;
        writer.Write(from);
        writer.Write((byte)(to - from));
        for (long tick = from; tick < to; tick++)
        {
            TeamInput input = match.InputAt(tick, team);
            int changed = Enumerable.Range(0, Match.TeamSize).Where(i => input.Moves[i] != last[i]).Sum(i => 1 << i);
            writer.Write((ushort)(changed | (input.Kick is null ? 0 : HasKick)));
            for (int i = 0; i < Match.TeamSize; i++)
            {
                if ((changed >> i & 1) != 0)
                {
                    writer.Write(input.Moves[i]);
                }
            }

            if (input.Kick is { } kick)
            {
                writer.Write((byte)kick.Player);
                writer.Write(kick.Velocity);
                writer.Write(kick.Spin);
            }

            last = input.Moves;
        }
    }

    public static (long From, TeamInput[] Inputs) ReadInputs(this BinaryReader reader)
    {
        byte[] last = TeamInput.Stand.Moves;
        long from = reader.ReadInt64();
        var inputs = new TeamInput[reader.ReadByte()];
        for (int n = 0; n < inputs.Length; n++)
        {
            int changed = reader.ReadUInt16();
            byte[] moves = [.. last];
            for (int i = 0; i < Match.TeamSize; i++)
            {
                moves[i] = (changed >> i & 1) != 0 ? reader.ReadByte() : last[i];
            }

            KickInput? kick = null;
            if ((changed & HasKick) != 0)
            {
                int player = reader.ReadByte();
                kick = new KickInput(from + n, reader.ReadVector(), reader.ReadVector(), player);
            }

            inputs[n] = new TeamInput(moves, kick);
            last = moves;
        }

        return (from, inputs);
    }

    /// <summary>Writes the complete, exact state at a tick: the players, the ball, the ruling with the next restart, and the decisions of the keepers.</summary>
    public static void WriteState(this BinaryWriter writer, Match match, long tick, in BallState ball)
    {
        writer.Write(tick);
        foreach (Player player in match.PlayersAt(tick))
        {
            writer.Write(player.Place.X);
            writer.Write(player.Place.Z);
            writer.Write(player.Velocity.X);
            writer.Write(player.Velocity.Z);
        }

        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(in ball, bytes);
        writer.Write(bytes);
        Ruling ruling = match.Referee.At(tick);
        writer.Write((byte)ruling.First);
        writer.Write((byte)ruling.Second);
        writer.Write((byte)ruling.Touched);
        var restarts = new KickLog();
        if (ruling.Restart is { } restart)
        {
            restarts.Add(in restart);
        }

        writer.WriteBytes(restarts.ToBytes());
        foreach (KeeperDive keeper in match.Keepers)
        {
            writer.WriteBytes(keeper.ToBytes(ball.Time));
        }
    }

    public static void ReadState(this BinaryReader reader, Match match)
    {
        long tick = reader.ReadInt64();
        var players = new Player[Match.Players];
        for (int i = 0; i < players.Length; i++)
        {
            players[i].Place = new Vector3d(reader.ReadDouble(), 0, reader.ReadDouble());
            players[i].Velocity = new Vector3d(reader.ReadDouble(), 0, reader.ReadDouble());
        }

        BallState ball = Snapshot.Read(reader.ReadBytes(Snapshot.Size));
        (byte first, byte second, byte touched) = (reader.ReadByte(), reader.ReadByte(), reader.ReadByte());
        var restarts = KickLog.FromBytes(reader.ReadByteArray());
        PlaceInput? restart = restarts.PlaceCount > 0 ? restarts.PlaceAt(0) : null;
        foreach (KeeperDive keeper in match.Keepers)
        {
            keeper.Restore(reader.ReadByteArray());
        }

        match.Restore(tick, players, in ball);
        match.Referee.Begin(tick, new Ruling(first, second, touched, restart));
        if (restart is { } place)
        {
            match.Runner.Kicks.Add(in place);
        }
    }

    private static void WriteBytes(this BinaryWriter writer, byte[] bytes)
    {
        writer.Write((ushort)bytes.Length);
        writer.Write(bytes);
    }

    private static byte[] ReadByteArray(this BinaryReader reader) => reader.ReadBytes(reader.ReadUInt16());

    private static void Write(this BinaryWriter writer, Vector3d vector)
    {
        writer.Write((float)vector.X);
        writer.Write((float)vector.Y);
        writer.Write((float)vector.Z);
    }

    private static Vector3d ReadVector(this BinaryReader reader) => new Vector3(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());
}
