using System.Globalization;
using FootballPhysics.Game;

namespace FootballPhysics.Netcode;

/// <summary>The first field in which two states of a ball, or two motions of a body, differ, with both values.</summary>
public readonly struct StateDifference
{
    private readonly bool _isNumber;
    private readonly ulong _expected;
    private readonly ulong _actual;

    internal StateDifference(long tick, int ball, int field, ulong expected, ulong actual)
    {
        Tick = tick;
        Ball = ball;
        Body = -1;
        (Field, _isNumber) = StateFields.NameOf(field);
        _expected = expected;
        _actual = actual;
    }

    internal StateDifference(long tick, int body, string name, string field, bool isNumber, ulong expected, ulong actual)
    {
        Tick = tick;
        Ball = -1;
        Body = body;
        BodyName = name;
        (Field, _isNumber) = (field, isNumber);
        _expected = expected;
        _actual = actual;
    }

    /// <summary>The tick of the states; −1 if they do not belong to a tick.</summary>
    public long Tick { get; private init; }

    /// <summary>The index of the ball, 0 for the first; −1 if a body differs.</summary>
    public int Ball { get; private init; }

    /// <summary>The index of the body in <see cref="Scene.Bodies"/>, followed by the obstacles with a mass; −1 if a ball differs.</summary>
    public int Body { get; }

    /// <summary>The name of the body or obstacle; null if a ball differs.</summary>
    public string? BodyName { get; }

    /// <summary>The name of the field, such as "position.y" or "spinRate".</summary>
    public string Field { get; }

    /// <summary>The value in the first state, at full precision.</summary>
    public string Expected => Text(_expected);

    /// <summary>The value in the second state, at full precision.</summary>
    public string Actual => Text(_actual);

    /// <summary>The distance between the two numbers in units in the last place; 0 for flags and indices.</summary>
    public ulong Ulps => !_isNumber ? 0 : Ordered(_expected) > Ordered(_actual) ? Ordered(_expected) - Ordered(_actual) : Ordered(_actual) - Ordered(_expected);

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant(
        $"{(Tick < 0 ? "" : FormattableString.Invariant($"tick {Tick}, "))}{(Body >= 0 ? FormattableString.Invariant($"body {Body} ({BodyName}), ") : Ball == 0 ? "" : FormattableString.Invariant($"ball {Ball}, "))}{Field}: {Expected} and {Actual}{(_isNumber ? FormattableString.Invariant($", {Ulps} ulp apart") : "")}");

    /// <summary>Returns the same difference for a ball at a tick.</summary>
    internal StateDifference At(long tick, int ball) => this with { Tick = tick, Ball = ball };

    private string Text(ulong bits) =>
        _isNumber ? BitConverter.Int64BitsToDouble((long)bits).ToString("R", CultureInfo.InvariantCulture) : bits.ToString(CultureInfo.InvariantCulture);

    // Map the bits of a double to an integer with the same order as the values; negative values count downwards.
    private static ulong Ordered(ulong bits) => (bits & 0x8000000000000000UL) != 0 ? ~bits : bits | 0x8000000000000000UL;
}
