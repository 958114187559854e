using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// Up to four functions of one number by table: its exponent and top mantissa bits choose a segment, on it a cubic a function, through
/// the Chebyshev points. Coarse segments over the whole range, finer ones over the part that needs them.
/// </summary>
/// <remarks>
/// The cubics are in the number itself, and their terms are added in pairs, for a step waits for nothing longer than for these values: the
/// powers are ready before the coefficients. A function whose value is not used leaves no code.
/// </remarks>
internal sealed class FactorTable
{
    private readonly Segment[] _segments;
    private readonly long _fineLowest;
    private readonly ulong _fineSpan;
    private readonly int _fineShift;
    private readonly nint _fineOffset;
    private readonly int _coarseShift;
    private readonly nint _coarseOffset;

    /// <summary>Tabulates functions.</summary>
    /// <param name="functions">The functions.</param>
    /// <param name="whole">The range.</param>
    /// <param name="fine">The part with finer segments.</param>
    public FactorTable(Functions functions, Octaves whole, Octaves fine)
    {
        _segments = new Segment[fine.Segments + whole.Segments];
        _fineLowest = fine.LowestBits;
        _fineSpan = (ulong)fine.Span;
        _fineShift = fine.Shift;
        _fineOffset = (int)(fine.LowestBits >> fine.Shift);
        _coarseShift = whole.Shift;
        _coarseOffset = (int)(whole.LowestBits >> whole.Shift) - fine.Segments;

        // The fine segments come first in memory, then the coarse ones.
        for (int i = 0; i < fine.Segments; i++)
        {
            Fill(ref _segments[i], functions, fine.Start(i), fine.Start(i + 1));
        }

        // The coarse ones below and above the fine.
        int below = (fine.From - whole.From) << whole.SegmentBits;
        int above = (fine.To - whole.From) << whole.SegmentBits;
        for (int i = 0; i < whole.Segments; i = i + 1 == below ? above : i + 1)
        {
            Fill(ref _segments[fine.Segments + i], functions, whole.Start(i), whole.Start(i + 1));
        }
    }

    /// <summary>Up to four functions of one number.</summary>
    public delegate void Functions(double x, out LawFactors values);

    /// <summary>The values of the functions.</summary>
    /// <param name="x">A number within the range.</param>
    /// <param name="values">Their values.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Evaluate(double x, out LawFactors values)
    {
        // The bits of a number, shifted, are exponent and segment: the index, without a logarithm.
        long bits = BitConverter.DoubleToInt64Bits(x);
        nint index = (ulong)(bits - _fineLowest) < _fineSpan
            ? (nint)(bits >> _fineShift) - _fineOffset
            : (nint)(bits >> _coarseShift) - _coarseOffset;
        ref readonly Segment segment = ref _segments[index];
        double squared = x * x;
        double cubed = x * squared;
        values.First = (segment.First.A + (segment.First.B * x)) + ((segment.First.C * squared) + (segment.First.D * cubed));
        values.Second = (segment.Second.A + (segment.Second.B * x)) + ((segment.Second.C * squared) + (segment.Second.D * cubed));
        values.Third = (segment.Third.A + (segment.Third.B * x)) + ((segment.Third.C * squared) + (segment.Third.D * cubed));
        values.Fourth = (segment.Fourth.A + (segment.Fourth.B * x)) + ((segment.Fourth.C * squared) + (segment.Fourth.D * cubed));
    }

    private static void Fill(ref Segment segment, Functions functions, double low, double high)
    {
        // The cubic through the four Chebyshev points: nearly the best one for its greatest error.
        var at = new ChebyshevPoints(low, high);
        functions(at.X0, out LawFactors f0);
        functions(at.X1, out LawFactors f1);
        functions(at.X2, out LawFactors f2);
        functions(at.X3, out LawFactors f3);
        segment.First = Cubic.Through(in at, f0.First, f1.First, f2.First, f3.First);
        segment.Second = Cubic.Through(in at, f0.Second, f1.Second, f2.Second, f3.Second);
        segment.Third = Cubic.Through(in at, f0.Third, f1.Third, f2.Third, f3.Third);
        segment.Fourth = Cubic.Through(in at, f0.Fourth, f1.Fourth, f2.Fourth, f3.Fourth);
    }

    private struct Segment
    {
        public Cubic First;
        public Cubic Second;
        public Cubic Third;
        public Cubic Fourth;
    }
}
