namespace FootballPhysics;

/// <summary>Numbers from 2^From to 2^To, every octave in 2^SegmentBits equal segments.</summary>
internal readonly record struct Octaves(int From, int To, int SegmentBits)
{
    /// <summary>How many segments there are.</summary>
    public int Segments => (To - From) << SegmentBits;

    /// <summary>The lowest number.</summary>
    public double Lowest => BitConverter.Int64BitsToDouble(LowestBits);

    /// <summary>The bits of the lowest number.</summary>
    public long LowestBits => (From + 1023L) << 52;

    /// <summary>How many bit patterns there are.</summary>
    public long Span => (To - (long)From) << 52;

    /// <summary>By how much a number's bits are shifted to leave exponent and segment.</summary>
    public int Shift => 52 - SegmentBits;

    /// <summary>The number at which a segment begins.</summary>
    public double Start(int segment) => BitConverter.Int64BitsToDouble(LowestBits + ((long)segment << Shift));
}
