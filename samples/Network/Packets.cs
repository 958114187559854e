using System.Numerics;
using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>The kind of a packet.</summary>
public enum PacketKind : byte
{
    /// <summary>A machine joins, with the hash of its match.</summary>
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

    /// <summary>Writes the complete, exact state at a tick: the players and the ball.</summary>
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

        match.Restore(tick, players, Snapshot.Read(reader.ReadBytes(Snapshot.Size)));
    }

    private static void Write(this BinaryWriter writer, Vector3d vector)
    {
        writer.Write((float)vector.X);
        writer.Write((float)vector.Y);
        writer.Write((float)vector.Z);
    }

    private static Vector3d ReadVector(this BinaryReader reader) => new Vector3(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());
}
