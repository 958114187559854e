using System.Globalization;

namespace FootballPhysics.Drawing;

/// <summary>Computes round values along an axis.</summary>
public static class Ticks
{
    /// <summary>Returns multiples of 1, 2 or 5 times a power of ten, about as many as requested.</summary>
    public static List<double> Linear(double min, double max, double about)
    {
        double rough = (max - min) / Math.Max(1, about);
        double power = Math.Pow(10, Math.Floor(Math.Log10(rough)));
        double step = power * ((rough / power) switch
        {
            <= 1 => 1,
            <= 2 => 2,
            <= 5 => 5,
            _ => 10,
        });
        var ticks = new List<double>();
        double first = Math.Ceiling((min / step) - 1e-9);
        double last = Math.Floor((max / step) + 1e-9);
        for (double i = first; i <= last; i++)
        {
            ticks.Add(i * step);
        }

        return ticks;
    }

    /// <summary>Returns powers of ten, at most about as many as requested. In a range of at most two decades, it adds 2 and 5 times the powers.</summary>
    public static List<double> Logarithmic(double min, double max, double about)
    {
        int first = (int)Math.Floor(Math.Log10(min));
        int last = (int)Math.Ceiling(Math.Log10(max));
        int every = (int)Math.Ceiling((last - first) / Math.Max(1, about));
        double[] factors = max <= 100 * min ? [1, 2, 5] : [1];
        var ticks = new List<double>();
        for (int exponent = first; exponent <= last; exponent += Math.Max(1, every))
        {
            foreach (double factor in factors)
            {
                double tick = factor * Math.Pow(10, exponent);
                if (tick >= min * (1 - 1e-9) && tick <= max * (1 + 1e-9))
                {
                    ticks.Add(tick);
                }
            }
        }

        return ticks;
    }

    /// <summary>Formats a value as briefly as possible.</summary>
    public static string Label(double value)
    {
        double size = Math.Abs(value);

        // −0 + 0 is 0, without a sign.
        return size is > 0 and (< 1e-3 or >= 1e6)
            ? value.ToString("0.##e0", CultureInfo.InvariantCulture)
            : (Math.Round(value, 6) + 0.0).ToString("0.######", CultureInfo.InvariantCulture);
    }
}
