using FootballPhysics.Game;

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

    private static void Write(in KeeperMotion motion, ref ByteWriter writer)
    {
        Write(motion.From.Pose, ref writer);
        Write(motion.From.Velocity, ref writer);
        Write(motion.From.Spin, ref writer);
        Write(motion.To, ref writer);
        Write(motion.Start, ref writer);
        Write(motion.End, ref writer);
    }

    private static void Write(BallPose pose, ref ByteWriter writer)
    {
        Write(pose.Position, ref writer);
        Write(new Vector3d(pose.Orientation.X, pose.Orientation.Y, pose.Orientation.Z), ref writer);
        Write(pose.Orientation.W, ref writer);
    }

    private static void Write(Vector3d vector, ref ByteWriter writer)
    {
        Write(vector.X, ref writer);
        Write(vector.Y, ref writer);
        Write(vector.Z, ref writer);
    }

    private static void Write(double number, ref ByteWriter writer) => writer.Bits((ulong)BitConverter.DoubleToInt64Bits(number), sizeof(double));

    private static KeeperMotion ReadMotion(ref ByteReader reader)
    {
        BallPose from = ReadPose(ref reader);
        Vector3d velocity = ReadVector(ref reader, Limits.Speed, "velocity");
        Vector3d spin = ReadVector(ref reader, Limits.Spin, "spin");
        BallPose to = ReadPose(ref reader);
        var motion = new KeeperMotion(new KeeperState(in from, in velocity, in spin), in to, ReadNumber(ref reader), ReadNumber(ref reader));
        return motion.IsValid ? motion : throw ByteReader.Broken("a motion of a keeper has no duration");
    }

    private static double ReadNumber(ref ByteReader reader) => BitConverter.Int64BitsToDouble((long)reader.Bits(sizeof(double)));

    private static Vector3d ReadVector(ref ByteReader reader, double most, string what)
    {
        var vector = new Vector3d(ReadNumber(ref reader), ReadNumber(ref reader), ReadNumber(ref reader));
        return vector.IsFinite && vector.Length <= most ? vector : throw ByteReader.Broken($"a {what} of a keeper is out of range");
    }

    private static BallPose ReadPose(ref ByteReader reader)
    {
        Vector3d middle = ReadVector(ref reader, Limits.Length, "position");
        Vector3d axis = ReadVector(ref reader, 2, "orientation");
        var turn = new Quaterniond(axis.X, axis.Y, axis.Z, ReadNumber(ref reader));
        return Math.Abs(turn.LengthSquared - 1) < 1e-6 ? new BallPose(in middle, in turn) : throw ByteReader.Broken("an orientation of a keeper is not of length 1");
    }
}
