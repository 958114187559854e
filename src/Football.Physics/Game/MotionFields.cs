using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Game;

/// <summary>The fields of a body's motion, for comparison.</summary>
internal static class MotionFields
{
    private const int Count = 18;

    private static readonly string[] s_names =
    [
        "position.x", "position.y", "position.z", "velocity.x", "velocity.y", "velocity.z", "spin.x", "spin.y", "spin.z",
        "orientation.x", "orientation.y", "orientation.z", "orientation.w", "pivot.x", "pivot.y", "pivot.z", "time", "isWithdrawn",
    ];

    /// <summary>Returns the first body whose motions differ bitwise, and the field; null if all are bit-identical.</summary>
    public static StateDifference? Difference(long tick, World world, Span<RigidMotion> expected, Span<RigidMotion> actual)
    {
        Span<ulong> left = stackalloc ulong[Count];
        Span<ulong> right = stackalloc ulong[Count];
        for (int i = 0; i < expected.Length; i++)
        {
            Read(in expected[i], left);
            Read(in actual[i], right);
            for (int field = 0; field < Count; field++)
            {
                if (left[field] != right[field])
                {
                    return new StateDifference(tick, i, world.NameOfMover(i), s_names[field], field < Count - 1, left[field], right[field]);
                }
            }
        }

        return null;
    }

    private static void Read(in RigidMotion motion, Span<ulong> words)
    {
        Put(in motion.Origin, words);
        Put(in motion.Velocity, words.Slice(3));
        Put(in motion.Spin, words.Slice(6));
        Put(new Vector3d(motion.Orientation.X, motion.Orientation.Y, motion.Orientation.Z), words.Slice(9));
        words[12] = Word(motion.Orientation.W);
        Put(in motion.Pivot, words.Slice(13));
        words[16] = Word(motion.Time);
        words[17] = motion.IsWithdrawn ? 1UL : 0;
    }

    private static void Put(in Vector3d vector, Span<ulong> words)
    {
        words[0] = Word(vector.X);
        words[1] = Word(vector.Y);
        words[2] = Word(vector.Z);
    }

    private static ulong Word(double number) => (ulong)BitConverter.DoubleToInt64Bits(number);
}
