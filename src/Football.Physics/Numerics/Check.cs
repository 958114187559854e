using System.Globalization;

namespace FootballPhysics;

/// <summary>Range checks whose message names the field, the value and what is allowed.</summary>
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

    /// <summary>Refuses null among the items of a list.</summary>
    /// <param name="list">Name of the list.</param>
    /// <param name="index">Place of the item in it.</param>
    /// <param name="item">The item.</param>
    /// <param name="what">The kind of item that it must be, with its article.</param>
    public static void GivenItem(string list, int index, object? item, string what)
    {
        if (item is null)
        {
            throw new ArgumentNullException(Item(list, index), $"{Item(list, index)} is null; allowed: {what}.");
        }
    }

    /// <summary>Refuses an index that nothing has.</summary>
    /// <param name="field">Its name.</param>
    /// <param name="index">The index.</param>
    /// <param name="count">How many there are.</param>
    public static void Index(string field, int index, int count)
    {
        if ((uint)index >= (uint)count)
        {
            throw Refusal(field, index.ToString(CultureInfo.InvariantCulture), count == 0 ? "none, because there are no items" : FormattableString.Invariant($"0 … {count - 1}"));
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

    /// <summary>Refuses a step that the clock's rounding would swallow: time would stand still.</summary>
    /// <param name="field">Its name.</param>
    /// <param name="step">The step, s.</param>
    /// <param name="time">The latest time that the clock must go on from, s.</param>
    public static void Advances(string field, double step, double time)
    {
        // With room: even a quarter of the step must move the clock.
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
        // Its norm is divided by: neither 0 nor infinite after squaring.
        double size = value.LengthSquared;
        if (!(size > 1e-200 && size < 1e200))
        {
            throw Refusal(field, value.ToString(), "a finite quaternion other than zero");
        }
    }

    /// <summary>A direction: the vector with length 1.</summary>
    public static Vector3d Direction(string field, in Vector3d value)
    {
        // Scaled first, so that the square of a very large or very small one is neither infinite nor zero.
        double largest = Math.Max(Math.Abs(value.X), Math.Max(Math.Abs(value.Y), Math.Abs(value.Z)));
        if (!(value.IsFinite && largest > 0))
        {
            throw Refusal(field, value.ToString(), "a finite vector other than zero");
        }

        // One that has length 1 to rounding stays as it is.
        Vector3d scaled = value / largest;
        return Math.Abs(value.LengthSquared - 1.0) <= 1e-15 ? value : scaled / scaled.Length;
    }

    /// <summary>Checks an enumeration whose values count up from 0; without boxing, for checks on the way to a run.</summary>
    /// <param name="field">Its name.</param>
    /// <param name="value">Its value.</param>
    /// <param name="index">The value as a number.</param>
    /// <param name="count">How many values there are.</param>
    public static void Defined<T>(string field, T value, int index, int count)
        where T : struct, Enum
    {
        if ((uint)index >= (uint)count)
        {
            throw Unknown(field, value);
        }
    }

    /// <summary>The refusal of a value that an enumeration does not have.</summary>
    public static ArgumentOutOfRangeException Unknown<T>(string field, T value)
        where T : struct, Enum => Refusal(field, value.ToString(), string.Join(" | ", Enum.GetNames(typeof(T))));

    public static ArgumentOutOfRangeException Refusal(string field, string value, string allowed) =>
        new(field, $"{field} is {value}; allowed: {allowed}.");

    /// <summary>The exception for a value that does not fit the other arguments.</summary>
    /// <param name="field">The name of the field; the sentence starts with it.</param>
    /// <param name="sentence">The problem, and its solution.</param>
    public static ArgumentOutOfRangeException Conflict(string field, string sentence) => new(field, sentence);

    /// <summary>The name of an item of a list.</summary>
    public static string Item(string list, int index) => $"{list}[{index.ToString(CultureInfo.InvariantCulture)}]";

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
