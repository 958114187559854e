using System.Globalization;

namespace Football.Physics.Headless.Schema;

/// <summary>The finite numbers that a field takes.</summary>
internal readonly record struct NumberRange(double Low, double High, bool LowExcluded)
{
    /// <summary>Any finite number.</summary>
    public static NumberRange Any => new(double.MinValue, double.MaxValue, false);

    /// <summary>Above 0.</summary>
    public static NumberRange Positive => new(0, double.MaxValue, true);

    /// <summary>0 or more.</summary>
    public static NumberRange NotNegative => new(0, double.MaxValue, false);

    public static NumberRange AtLeast(double low) => new(low, double.MaxValue, false);

    public static NumberRange Within(double low, double high) => new(low, high, false);

    public static NumberRange AboveZeroTo(double high) => new(0, high, true);

    public bool Contains(double value) => double.IsFinite(value) && value <= High && (LowExcluded ? value > Low : value >= Low);

    /// <summary>The range in words.</summary>
    public string Describe(string unit)
    {
        string of = unit.Length > 0 ? " " + unit : "";
        bool open = High == double.MaxValue;
        if (Low == double.MinValue && open)
        {
            return unit.Length > 0 ? $"a finite number ({unit})" : "a finite number";
        }

        if (open)
        {
            return LowExcluded ? $"a finite number above {Text(Low)}{of}" : $"a finite number, {Text(Low)}{of} or more";
        }

        return LowExcluded ? $"a number above {Text(Low)}, at most {Text(High)}{of}" : $"a number from {Text(Low)} to {Text(High)}{of}";
    }

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
