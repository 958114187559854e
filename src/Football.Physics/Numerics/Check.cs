using System.Globalization;

namespace FootballPhysics.Numerics;

/// <summary>Range checks. Their messages name the field, its value and the allowed range.</summary>
internal static class Check
{
    /// <summary>Throws if an argument is null.</summary>
    public static void Given(string argument, object? value)
    {
        if (value is null)
        {
            throw new ArgumentNullException(argument, argument + " is null. Pass a value.");
        }
    }

    /// <summary>Throws if a member that has a default was set to null.</summary>
    public static void Member(string field, object? value)
    {
        if (value is null)
        {
            throw new ArgumentNullException(field, field + " is null. Leave it unset to use the default.");
        }
    }

    /// <summary>Throws if an item of a list is null.</summary>
    /// <param name="list">The name of the list.</param>
    /// <param name="index">The index of the item.</param>
    /// <param name="item">The item.</param>
    /// <param name="what">The required kind of item, with its article.</param>
    public static void GivenItem(string list, int index, object? item, string what)
    {
        if (item is null)
        {
            throw new ArgumentNullException(Item(list, index), $"{Item(list, index)} is null; allowed: {what}.");
        }
    }

    /// <summary>Throws if an index is out of range.</summary>
    /// <param name="field">The name of the index.</param>
    /// <param name="index">The index.</param>
    /// <param name="count">The number of items.</param>
    public static void Index(string field, int index, int count)
    {
        if ((uint)index >= (uint)count)
        {
            throw Refusal(field, index.ToString(CultureInfo.InvariantCulture), count == 0 ? "none, because there are no items" : FormattableString.Invariant($"0 … {count - 1}"));
        }
    }

    /// <summary>Throws if a span of bytes is too short.</summary>
    /// <param name="argument">The name of the span.</param>
    /// <param name="length">Its length.</param>
    /// <param name="least">The length required.</param>
    public static void Bytes(string argument, int length, int least)
    {
        if (length < least)
        {
            throw new ArgumentException(FormattableString.Invariant($"{argument} has {length} bytes; allowed: {least} or more."), argument);
        }
    }

    public static void Within(string field, long value, long low, long high)
    {
        if (!(value >= low && value <= high))
        {
            throw Refusal(field, value.ToString(CultureInfo.InvariantCulture), FormattableString.Invariant($"{low} … {high}"));
        }
    }

    public static void Positive(string field, double value)
    {
        if (!(value > 0 && double.IsFinite(value)))
        {
            throw Refusal(field, Text(value), "a finite number above 0");
        }
    }

    public static void NotNegative(string field, double value)
    {
        if (!(value >= 0 && double.IsFinite(value)))
        {
            throw Refusal(field, Text(value), "a finite number, 0 or more");
        }
    }

    public static void AtLeast(string field, double value, double low)
    {
        if (!(value >= low && double.IsFinite(value)))
        {
            throw Refusal(field, Text(value), $"a finite number, {Text(low)} or more");
        }
    }

    public static void Finite(string field, double value)
    {
        if (!double.IsFinite(value))
        {
            throw Refusal(field, Text(value), "a finite number");
        }
    }

    public static void Within(string field, double value, double low, double high, bool exclusiveLow = false)
    {
        if (!(value <= high && (exclusiveLow ? value > low : value >= low)))
        {
            string range = exclusiveLow ? $"above {Text(low)}, at most {Text(high)}" : $"{Text(low)} … {Text(high)}";
            throw Refusal(field, Text(value), range);
        }
    }

    /// <summary>Throws if a step is too small to advance the clock, because rounding would absorb it.</summary>
    /// <param name="field">The name of the step.</param>
    /// <param name="step">The step, in s.</param>
    /// <param name="time">The latest time to advance, in s.</param>
    public static void Advances(string field, double step, double time)
    {
        // Include a margin, because even a quarter of the step must advance the clock.
        if (!(time + (0.25 * step) > time && time <= double.MaxValue))
        {
            throw Refusal(field, Text(step), $"more than the rounding error of the clock at {Text(time)} s");
        }
    }

    public static void Size(string field, in Vector3d value, double high, string unit)
    {
        if (!(value.IsFinite && value.Length <= high))
        {
            throw Refusal(field, value.ToString(), $"finite components, size at most {Text(high)} {unit}");
        }
    }

    public static void Place(string field, in Vector3d value)
    {
        if (!(Math.Abs(value.X) <= Limits.Length && Math.Abs(value.Y) <= Limits.Length && Math.Abs(value.Z) <= Limits.Length))
        {
            throw Refusal(field, value.ToString(), $"finite components within ±{Text(Limits.Length)} m");
        }
    }

    public static void Rotation(string field, in Quaterniond value)
    {
        if (!IsRotation(in value))
        {
            throw Refusal(field, value.ToString(), "a finite quaternion other than zero");
        }
    }

    /// <summary>True if a quaternion can be normalized.</summary>
    public static bool IsRotation(in Quaterniond value)
    {
        // The norm is a divisor later, so its square must be neither 0 nor infinite.
        double size = value.LengthSquared;
        return size > 1e-200 && size < 1e200;
    }

    /// <summary>Returns the unit vector of a direction, or throws if it has none.</summary>
    public static Vector3d Direction(string field, in Vector3d value)
    {
        // Scale first, so that the square of a very long or very short vector neither overflows nor underflows.
        double largest = Math.Max(Math.Abs(value.X), Math.Max(Math.Abs(value.Y), Math.Abs(value.Z)));
        if (!(value.IsFinite && largest > 0))
        {
            throw Refusal(field, value.ToString(), "a finite vector other than zero");
        }

        // Keep a vector that is a unit vector to within rounding.
        Vector3d scaled = value / largest;
        return Math.Abs(value.LengthSquared - 1.0) <= 1e-15 ? value : scaled / scaled.Length;
    }

    /// <summary>Throws if an enumeration value is undefined. Does not box, because runs start with such checks.</summary>
    /// <param name="field">The name of the value.</param>
    /// <param name="value">The value.</param>
    /// <param name="index">The value as a number.</param>
    /// <param name="count">The number of defined values, which count up from 0.</param>
    public static void Defined<T>(string field, T value, int index, int count)
        where T : struct, Enum
    {
        if ((uint)index >= (uint)count)
        {
            throw Unknown(field, value);
        }
    }

    /// <summary>Returns the exception for an undefined enumeration value.</summary>
    public static ArgumentOutOfRangeException Unknown<T>(string field, T value)
        where T : struct, Enum => Refusal(field, value.ToString(), string.Join(" | ", Enum.GetNames(typeof(T))));

    public static ArgumentOutOfRangeException Refusal(string field, string value, string allowed) =>
        new(field, $"{field} is {value}; allowed: {allowed}.");

    /// <summary>Creates the exception for a value that does not fit the other arguments.</summary>
    /// <param name="field">The name of the field; the sentence starts with it.</param>
    /// <param name="sentence">The problem, and its solution.</param>
    public static ArgumentOutOfRangeException Conflict(string field, string sentence) => new(field, sentence);

    /// <summary>Returns the name of an item of a list, for messages.</summary>
    public static string Item(string list, int index) => $"{list}[{index.ToString(CultureInfo.InvariantCulture)}]";

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
