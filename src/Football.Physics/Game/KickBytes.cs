namespace FootballPhysics.Game;

/// <summary>Encodes the ball, velocity and spin of a kick; ball 0 and zero components take no bytes.</summary>
internal static class KickBytes
{
    /// <summary>The minimum size of a kick in bytes, including tick and player.</summary>
    public const int Smallest = 4;

    /// <summary>Set if the kick is for a ball other than the first.</summary>
    private const ulong OtherBall = 1UL << 12;

    public static void Write(in KickInput kick, ref ByteWriter writer)
    {
        // Two bytes: 6 bits for the velocity, 6 bits for the spin, and a bit that is set if the kick is not for the first ball.
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
            // KickInput validates the values, just as for kicks from the game.
            return new KickInput(tick, velocity, spin, player, ball);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }
    }
}
