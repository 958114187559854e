namespace FootballPhysics;

/// <summary>Which ball, velocity and spin of a kick as bytes: the first ball, and numbers that are 0, take none.</summary>
internal static class KickBytes
{
    /// <summary>The fewest bytes that a kick takes, tick and player included.</summary>
    public const int Smallest = 4;

    /// <summary>Set where the kick is of another ball than the first.</summary>
    private const ulong OtherBall = 1UL << 12;

    public static void Write(in KickInput kick, ref ByteWriter writer)
    {
        // Two bytes: 6 bits for the velocity, 6 for the spin, one for another ball than the first.
        ulong forms = PackedNumbers.Forms(kick.Velocity) | (PackedNumbers.Forms(kick.Spin) << 6) | (kick.Ball > 0 ? OtherBall : 0);
        writer.Bits(forms, 2);
        if (kick.Ball > 0)
        {
            writer.Integer((ulong)kick.Ball);
        }

        PackedNumbers.Write(kick.Velocity, ref writer);
        PackedNumbers.Write(kick.Spin, ref writer);
    }

    public static KickInput Read(long tick, int player, ref ByteReader reader)
    {
        ulong forms = reader.Bits(2);
        int ball = (forms & OtherBall) != 0 ? reader.Int() : 0;
        Vector3d velocity = PackedNumbers.Vector(forms, ref reader);
        Vector3d spin = PackedNumbers.Vector(forms >> 6, ref reader);
        try
        {
            // What a kick of the game may not be, one of the bytes may not be either.
            return new KickInput(tick, velocity, spin, player, ball);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }
    }
}
