using FootballPhysics.Game;
using static FootballPhysics.Engines.KeeperBytes;

namespace FootballPhysics.Engines;

/// <content>His memory as bytes, for a peer that joins.</content>
public sealed partial class KeeperDive
{
    private const ulong Format = 0x32_50_45_45_4B_42_46; // "FBKEEP2"
    private const int FormatSize = 7;

    /// <summary>Serialises the decision on which his next moves depend: the ball for which he made it, and his dive.</summary>
    /// <remarks>The state of a ball does not contain it. Send these bytes with the state to a peer that joins during a match.</remarks>
    /// <param name="time">The time of the ball in that state, in s: <see cref="BallState.Time"/>. At most 10 s before the last step.</param>
    public byte[] ToBytes(double time)
    {
        int last = _count - 1;
        while (last >= 0 && !(_past[last].Seen.Time < time))
        {
            last--;
        }

        var writer = new ByteWriter();
        writer.Bits(Format, FormatSize);
        if (last >= 0)
        {
            ref readonly Decision decision = ref _past[last];
            writer.State(in decision.Seen);
            Write(in decision.Before, ref writer);
            Write(in decision.Dive, ref writer);
            Write(decision.Target, ref writer);
            Write(decision.Look, ref writer);
            writer.Integer((ulong)decision.Count);
        }

        return writer.ToArray();
    }

    /// <summary>Restores the decision that <see cref="ToBytes"/> of the same keeper wrote on another machine; the next steps then move him in the same way.</summary>
    /// <remarks><see cref="Answer"/> is empty until his next decision.</remarks>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are not from a keeper, or are corrupt; nothing has changed.</exception>
    public void Restore(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);
        if (reader.Bits(FormatSize) != Format)
        {
            throw ByteReader.Broken("they are not the memory of a keeper");
        }

        Decision decision = default;
        bool decided = !reader.IsAtEnd;
        if (decided)
        {
            decision.Seen = reader.State();
            decision.Before = ReadMotion(ref reader);
            decision.Dive = ReadMotion(ref reader);
            decision.Target = ReadVector(ref reader, Limits.Length, "position");
            decision.Look = ReadNumber(ref reader);
            decision.Count = reader.Int();
            reader.End();
            try
            {
                _ahead.Validate(in decision.Seen);
            }
            catch (ArgumentOutOfRangeException refusal)
            {
                throw ByteReader.Broken(refusal);
            }
        }

        // Later than any time: the next step goes back to this decision.
        _now = double.PositiveInfinity;
        _count = decided ? 1 : 0;
        _past[0] = decision;
        _last = decision;
    }
}
