namespace FootballPhysics.Game;

/// <summary>Encodes the ball and the numbers of a restart; ball 0 and zero components take no bytes.</summary>
internal static class PlaceBytes
{
    /// <summary>The minimum size of a restart in bytes, including tick and player.</summary>
    public const int Smallest = 6;

    /// <summary>Set if the restart is for a ball other than the first.</summary>
    private const ulong OtherBall = 1UL << 26;

    private const int UnusedFrom = 27;

    public static void Write(in PlaceInput place, ref ByteWriter writer)
    {
        // Four bytes: 6 bits each for position, velocity and spin, 8 for the orientation, and a bit that is set if the restart is not for the first ball.
        Quaterniond q = place.Orientation;
        var axis = new Vector3d(q.X, q.Y, q.Z);
        ulong forms = PackedNumbers.Forms(place.Position) | (PackedNumbers.Forms(place.Velocity) << 6) | (PackedNumbers.Forms(place.Spin) << 12)
            | (PackedNumbers.Forms(in axis) << 18) | (PackedNumbers.Form(q.W) << 24) | (place.Ball > 0 ? OtherBall : 0);
        writer.Bits(forms, 4);
        if (place.Ball > 0)
        {
            writer.Integer((ulong)place.Ball);
        }

        PackedNumbers.Write(place.Position, ref writer);
        PackedNumbers.Write(place.Velocity, ref writer);
        PackedNumbers.Write(place.Spin, ref writer);
        PackedNumbers.Write(in axis, ref writer);
        PackedNumbers.Write(q.W, ref writer);
    }

    public static PlaceInput Read(long tick, int player, ref ByteReader reader)
    {
        ulong forms = reader.Bits(4);
        if (forms >> UnusedFrom != 0)
        {
            throw ByteReader.Broken("an unknown form of a restart");
        }

        int ball = (forms & OtherBall) != 0 ? reader.Int() : 0;
        Vector3d position = PackedNumbers.Vector(forms, ref reader);
        Vector3d velocity = PackedNumbers.Vector(forms >> 6, ref reader);
        Vector3d spin = PackedNumbers.Vector(forms >> 12, ref reader);
        Vector3d axis = PackedNumbers.Vector(forms >> 18, ref reader);
        double w = PackedNumbers.Number(forms >> 24, ref reader);
        try
        {
            // PlaceInput validates the values, just as for restarts from the game.
            return new PlaceInput(tick, player, ball, position, velocity, spin, new Quaterniond(axis.X, axis.Y, axis.Z, w));
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }
    }
}
