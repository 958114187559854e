namespace FootballPhysics.Numerics;

/// <summary>Root finders that never leave their bracket. Functions are structs, so that the searches are specialized for them.</summary>
internal static class Roots
{
    /// <summary>The maximum number of evaluations in <see cref="Newton"/>: enough to bisect any bracket to its last bits.</summary>
    private const int MostNewton = 60;

    /// <summary>The interval between bisections in <see cref="Illinois"/>, a guard against functions that are nearly flat at one end.</summary>
    private const int BisectionEvery = 6;

    /// <summary>Newton's method within a bracket.</summary>
    /// <remarks>
    /// Every value narrows the bracket. If the tangent leads out of the bracket, the method bisects. The function must be positive at the lower end and not
    /// positive at the upper end.
    /// </remarks>
    /// <param name="function">The function.</param>
    /// <param name="low">The lower end of the bracket.</param>
    /// <param name="high">The upper end of the bracket.</param>
    /// <param name="start">The first guess, inside the bracket or at an end.</param>
    /// <param name="closeness">The tolerance: the search ends if a step is at most this fraction of x.</param>
    public static double Newton<TFunction>(ref TFunction function, double low, double high, double start, double closeness = 0)
        where TFunction : struct, IDifferentiableFunction
    {
        double x = start;
        for (int i = 0; i < MostNewton; i++)
        {
            if (function.Evaluate(x, out double value, out double slope))
            {
                break;
            }

            // The function is positive below the root, so this point replaces the end of the bracket on its side.
            if (value > 0)
            {
                low = x;
            }
            else
            {
                high = x;
            }

            // x' = x − f/f'
            double next = x - (value / slope);

            // A slope of 0 or NaN also leads to this line.
            if (!(next > low && next < high))
            {
                next = 0.5 * (low + high);
            }

            bool done = Math.Abs(next - x) <= closeness * x || high - low <= 0;
            x = next;
            if (done)
            {
                break;
            }
        }

        return x;
    }

    /// <summary>The Illinois method: regula falsi that halves the value at an end which stays twice in a row.</summary>
    /// <remarks>
    /// It bisects now and then. The function must have opposite signs at the ends; its value at the lower end may be unknown.
    /// </remarks>
    /// <param name="function">The function.</param>
    /// <param name="low">The lower end of the bracket.</param>
    /// <param name="atLow">The value at the lower end, or NaN: the search then bisects until it is known.</param>
    /// <param name="high">The upper end of the bracket.</param>
    /// <param name="atHigh">The value at the upper end.</param>
    /// <param name="width">The tolerance: the search ends if an end moves by less than this.</param>
    /// <param name="most">The maximum number of evaluations.</param>
    /// <returns>The point of the last evaluation.</returns>
    public static double Illinois<TFunction>(
        ref TFunction function, double low, double atLow, double high, double atHigh, double width, int most)
        where TFunction : struct, IFunction
    {
        double x = low;
        bool wasBelow = false;
        for (int i = 1; i <= most; i++)
        {
            // The zero of the chord between the ends, or the midpoint if the value at the lower end is unknown.
            double secant = low + ((high - low) * atLow / (atLow - atHigh));
            x = i % BisectionEvery == 0 || double.IsNaN(secant) ? 0.5 * (low + high) : secant;
            if (function.Evaluate(x, out double value) || value == 0)
            {
                break;
            }

            // The point is below the root if its sign differs from the sign at the upper end.
            bool below = value < 0 != atHigh < 0;
            double stays = i > 1 && below == wasBelow ? 0.5 : 1.0;
            double moved;
            if (below)
            {
                moved = x - low;
                low = x;
                atLow = value;
                atHigh *= stays;
            }
            else
            {
                moved = high - x;
                high = x;
                atHigh = value;
                atLow *= stays;
            }

            wasBelow = below;
            if (Math.Abs(moved) < width)
            {
                break;
            }
        }

        return x;
    }

    /// <summary>Bisects a bracket in which a condition is false at the lower end and true at the upper end.</summary>
    /// <param name="condition">The condition.</param>
    /// <param name="low">The lower end, which moves up.</param>
    /// <param name="high">The upper end, which moves down.</param>
    /// <param name="halvings">The maximum number of bisections. The search also ends if no double is left between the ends.</param>
    /// <returns>True if the condition ended the search, at the end that moved last.</returns>
    public static bool Bisect<TCondition>(ref TCondition condition, ref double low, ref double high, int halvings)
        where TCondition : struct, ICondition
    {
        for (int i = 0; i < halvings; i++)
        {
            double middle = 0.5 * (low + high);

            // There is no double left between the ends.
            if (!(middle > low && middle < high))
            {
                break;
            }

            bool ends = condition.Evaluate(middle, out bool holds);
            if (holds)
            {
                high = middle;
            }
            else
            {
                low = middle;
            }

            if (ends)
            {
                return true;
            }
        }

        return false;
    }
}

/// <summary>A condition that is false below an unknown point and true above it. A struct, so that a search is specialized for it and does not allocate.</summary>
internal interface ICondition
{
    /// <summary>Evaluates the condition.</summary>
    /// <param name="x">The argument.</param>
    /// <param name="holds">True if the condition holds.</param>
    /// <returns>True if <paramref name="x"/> is close enough to the point: the search ends.</returns>
    bool Evaluate(double x, out bool holds);
}

/// <summary>A function whose root is sought. A struct, so that a search is specialized for it and does not allocate.</summary>
internal interface IFunction
{
    /// <summary>Evaluates the function.</summary>
    /// <param name="x">The argument.</param>
    /// <param name="value">The value.</param>
    /// <returns>True if <paramref name="x"/> is close enough to the root: the search ends.</returns>
    bool Evaluate(double x, out double value);
}

/// <summary>A function with a derivative, whose root is sought. A struct, so that a search is specialized for it and does not allocate.</summary>
internal interface IDifferentiableFunction
{
    /// <summary>Evaluates the function.</summary>
    /// <param name="x">The argument.</param>
    /// <param name="value">The value.</param>
    /// <param name="slope">The slope; NaN makes the search bisect.</param>
    /// <returns>True if <paramref name="x"/> is close enough to the root: the search ends.</returns>
    bool Evaluate(double x, out double value, out double slope);
}
