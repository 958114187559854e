using FootballPhysics.Game;

namespace FootballPhysics.Engines;

/// <summary>The parts of a keeper's memory as bytes.</summary>
internal static class KeeperBytes
{
    public static void Write(in KeeperMotion motion, ref ByteWriter writer)
    {
        Write(motion.From.Pose, ref writer);
        Write(motion.From.Velocity, ref writer);
        Write(motion.From.Spin, ref writer);
        Write(motion.To, ref writer);
        Write(motion.Start, ref writer);
        Write(motion.End, ref writer);
    }

    public static void Write(BallPose pose, ref ByteWriter writer)
    {
        Write(pose.Position, ref writer);
        Write(new Vector3d(pose.Orientation.X, pose.Orientation.Y, pose.Orientation.Z), ref writer);
        Write(pose.Orientation.W, ref writer);
    }

    public static void Write(Vector3d vector, ref ByteWriter writer)
    {
        Write(vector.X, ref writer);
        Write(vector.Y, ref writer);
        Write(vector.Z, ref writer);
    }

    public static void Write(double number, ref ByteWriter writer) => writer.Bits((ulong)BitConverter.DoubleToInt64Bits(number), sizeof(double));

    public static KeeperMotion ReadMotion(ref ByteReader reader)
    {
        BallPose from = ReadPose(ref reader);
        Vector3d velocity = ReadVector(ref reader, Limits.Speed, "velocity");
        Vector3d spin = ReadVector(ref reader, Limits.Spin, "spin");
        BallPose to = ReadPose(ref reader);
        var motion = new KeeperMotion(new KeeperState(in from, in velocity, in spin), in to, ReadNumber(ref reader), ReadNumber(ref reader));
        return motion.IsValid ? motion : throw ByteReader.Broken("a motion of a keeper has no duration");
    }

    public static double ReadNumber(ref ByteReader reader) => BitConverter.Int64BitsToDouble((long)reader.Bits(sizeof(double)));

    public static Vector3d ReadVector(ref ByteReader reader, double most, string what)
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
