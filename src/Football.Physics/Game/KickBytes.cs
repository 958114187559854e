namespace Football.Physics;

/// <summary>Velocity and spin of a kick as bytes: each number is left out when it is 0, and takes 4 bytes when single precision holds it.</summary>
internal static class KickBytes
{
    /// <summary>The fewest bytes that a kick takes, tick and player included.</summary>
    public const int Smallest = 4;

    private const int Zero = 0;
    private const int Single = 1;
    private const int Double = 2;

    public static void Write(in KickInput kick, ref ByteWriter writer)
    {
        int forms = Form(kick.Velocity.X) | (Form(kick.Velocity.Y) << 2) | (Form(kick.Velocity.Z) << 4)
            | (Form(kick.Spin.X) << 6) | (Form(kick.Spin.Y) << 8) | (Form(kick.Spin.Z) << 10);
        writer.Bits((ulong)forms, 2);
        Write(kick.Velocity, ref writer);
        Write(kick.Spin, ref writer);
    }

    public static KickInput Read(long tick, int player, ref ByteReader reader)
    {
        int forms = (int)reader.Bits(2);
        Vector3d velocity = Vector(forms, ref reader);
        Vector3d spin = Vector(forms >> 6, ref reader);
        try
        {
            return new KickInput(tick, velocity, spin, player);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }
    }

    private static void Write(Vector3d vector, ref ByteWriter writer)
    {
        Write(vector.X, ref writer);
        Write(vector.Y, ref writer);
        Write(vector.Z, ref writer);
    }

    private static void Write(double value, ref ByteWriter writer)
    {
        switch (Form(value))
        {
            case Single:
                writer.Bits((uint)BitConverter.SingleToInt32Bits((float)value), 4);
                break;
            case Double:
                writer.Bits((ulong)BitConverter.DoubleToInt64Bits(value), 8);
                break;
            default:
                break;
        }
    }

    private static Vector3d Vector(int forms, ref ByteReader reader)
    {
        double x = Number(forms & 3, ref reader);
        double y = Number((forms >> 2) & 3, ref reader);
        double z = Number((forms >> 4) & 3, ref reader);
        return new Vector3d(x, y, z);
    }

    private static double Number(int form, ref ByteReader reader) => form switch
    {
        Zero => 0,
        Single => BitConverter.Int32BitsToSingle((int)(uint)reader.Bits(4)),
        Double => BitConverter.Int64BitsToDouble((long)reader.Bits(8)),
        _ => throw ByteReader.Broken("an unknown form of a number"),
    };

    private static int Form(double value)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        return bits == 0 ? Zero : BitConverter.DoubleToInt64Bits((double)(float)value) == bits ? Single : Double;
    }
}
