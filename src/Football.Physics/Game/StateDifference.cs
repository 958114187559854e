using System.Globalization;

namespace FootballPhysics.Netcode;

/// <summary>The first field in which two states differ: which, and by how much.</summary>
public readonly struct StateDifference
{
    private readonly bool _isNumber;
    private readonly ulong _expected;
    private readonly ulong _actual;

    internal StateDifference(long tick, int ball, int field, ulong expected, ulong actual)
    {
        Tick = tick;
        Ball = ball;
        (Field, _isNumber) = StateFields.NameOf(field);
        _expected = expected;
        _actual = actual;
    }

    /// <summary>The tick of the states; −1 where they are of none.</summary>
    public long Tick { get; }

    /// <summary>Which of several balls; 0 for the first.</summary>
    public int Ball { get; }

    /// <summary>The field, as "position.y" or "spinRate".</summary>
    public string Field { get; }

    /// <summary>The value of the first state, all digits.</summary>
    public string Expected => Text(_expected);

    /// <summary>The value of the second state, all digits.</summary>
    public string Actual => Text(_actual);

    /// <summary>Units in the last place between the two, 1 or more, for a number; 0 for a field of flags or an index.</summary>
    public ulong Ulps => !_isNumber ? 0 : Ordered(_expected) > Ordered(_actual) ? Ordered(_expected) - Ordered(_actual) : Ordered(_actual) - Ordered(_expected);

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant(
        $"{(Tick < 0 ? "" : FormattableString.Invariant($"tick {Tick}, "))}{(Ball == 0 ? "" : FormattableString.Invariant($"ball {Ball}, "))}{Field}: {Expected} and {Actual}{(_isNumber ? FormattableString.Invariant($", {Ulps} ulp apart") : "")}");

    /// <summary>A copy of the difference, as that of a ball at a tick.</summary>
    internal StateDifference At(long tick, int ball) => new(tick, ball, StateFields.IndexOf(Field), _expected, _actual);

    private string Text(ulong bits) =>
        _isNumber ? BitConverter.Int64BitsToDouble((long)bits).ToString("R", CultureInfo.InvariantCulture) : bits.ToString(CultureInfo.InvariantCulture);

    // Bits of doubles in the order of their values: negative ones count downwards.
    private static ulong Ordered(ulong bits) => (bits & 0x8000000000000000UL) != 0 ? ~bits : bits | 0x8000000000000000UL;
}
