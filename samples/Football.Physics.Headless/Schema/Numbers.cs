using System.Globalization;
using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>Reads JSON numbers as doubles.</summary>
internal static class Numbers
{
    /// <summary>The value, or NaN where it is no number.</summary>
    public static double Of(JsonValue value) =>
        value.Kind == JsonKind.Number && double.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : double.NaN;

    /// <summary>The items of an array of so many finite numbers.</summary>
    /// <exception cref="RefusedException">It is none.</exception>
    public static double[] Array(string path, JsonValue value, int count, string allowed)
    {
        if (value.Kind != JsonKind.Array || value.Items.Count != count)
        {
            throw new RefusedException(path, value.ToString(), allowed);
        }

        var numbers = new double[count];
        for (int i = 0; i < count; i++)
        {
            numbers[i] = Of(value.Items[i]);
            if (!double.IsFinite(numbers[i]))
            {
                throw new RefusedException($"{path}[{i}]", value.Items[i].ToString(), $"a finite number ({path}: {allowed})");
            }
        }

        return numbers;
    }
}
