namespace FootballPhysics.Game;

/// <summary>Encodes numbers: 0 takes no bytes, a single-precision value takes 4, and any other value takes 8. Two bits, written beforehand,
/// select the form.</summary>
internal static class PackedNumbers
{
    private const int Zero = 0;
    private const int Single = 1;
    private const int Double = 2;

    /// <summary>Returns the forms of a vector's components, six bits.</summary>
    public static ulong Forms(in Vector3d vector) => Form(vector.X) | (Form(vector.Y) << 2) | (Form(vector.Z) << 4);

    /// <summary>Returns the form of a number, two bits.</summary>
    public static ulong Form(double value)
    {
        // Compare bits: −0 does not count as zero, so that it is restored as −0.
        long bits = BitConverter.DoubleToInt64Bits(value);
        return bits == 0 ? Zero : BitConverter.DoubleToInt64Bits((double)(float)value) == bits ? (ulong)Single : Double;
    }

    public static void Write(in Vector3d vector, ref ByteWriter writer)
    {
        Write(vector.X, ref writer);
        Write(vector.Y, ref writer);
        Write(vector.Z, ref writer);
    }

    public static void Write(double value, ref ByteWriter writer)
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

    public static Vector3d Vector(ulong forms, ref ByteReader reader)
    {
        double x = Number(forms, ref reader);
        double y = Number(forms >> 2, ref reader);
        double z = Number(forms >> 4, ref reader);
        return new Vector3d(x, y, z);
    }

    public static double Number(ulong form, ref ByteReader reader) => (form & 3) switch
    {
        Zero => 0,
        Single => BitConverter.Int32BitsToSingle((int)(uint)reader.Bits(4)),
        Double => BitConverter.Int64BitsToDouble((long)reader.Bits(8)),
        _ => throw ByteReader.Broken("an unknown form of a number"),
    };
}
