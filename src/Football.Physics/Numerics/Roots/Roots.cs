namespace FootballPhysics;

/// <summary>Root finders that never leave the bracket they are given. What they evaluate is a struct that they are compiled for.</summary>
internal static class Roots
{
    /// <summary>Evaluations of <see cref="Newton"/> at most: enough to halve any bracket of doubles of one size down to its last bits.</summary>
    private const int MostNewton = 60;

    /// <summary>One step in so many of <see cref="Illinois"/> bisects: it guards against functions that are all but flat at one end.</summary>
    private const int BisectionEvery = 6;

    /// <summary>
    /// Newton's method inside a bracket: every value narrows it, and where the tangent leads out of it, it is bisected instead. The function is
    /// positive at its lower end, and not at its upper one.
    /// </summary>
    /// <param name="function">The function.</param>
    /// <param name="low">Lower end of the bracket.</param>
    /// <param name="high">Upper end.</param>
    /// <param name="start">The first guess, inside the bracket or at one of its ends.</param>
    /// <param name="closeness">It ends when a step is no longer than this share of where it starts.</param>
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

            // Positive below the root: what was evaluated becomes the end on its side.
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

            // Also where the slope is 0 or not a number.
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

    /// <summary>
    /// The Illinois method: regula falsi, in which an end that stays twice in a row counts with half its value, so that it moves too; and a
    /// bisection now and then. The function has opposite signs at the ends; its value at the lower one need not be known.
    /// </summary>
    /// <param name="function">The function.</param>
    /// <param name="low">One end of the bracket.</param>
    /// <param name="atLow">The function there, or not a number: then the bracket is bisected until it is known.</param>
    /// <param name="high">The other end.</param>
    /// <param name="atHigh">The function there.</param>
    /// <param name="width">It ends when an end moves by less than this.</param>
    /// <param name="most">Evaluations at most.</param>
    /// <returns>Where it was evaluated last.</returns>
    public static double Illinois<TFunction>(
        ref TFunction function, double low, double atLow, double high, double atHigh, double width, int most)
        where TFunction : struct, IFunction
    {
        double x = low;
        bool wasBelow = false;
        for (int i = 1; i <= most; i++)
        {
            // Where the chord between the ends is zero; where the value at the lower end is not known, the middle.
            double secant = low + ((high - low) * atLow / (atLow - atHigh));
            x = i % BisectionEvery == 0 || double.IsNaN(secant) ? 0.5 * (low + high) : secant;
            if (function.Evaluate(x, out double value) || value == 0)
            {
                break;
            }

            // On which side of the root: its sign is not that of the upper end.
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

    /// <summary>Bisection: halves the bracket at whose lower end a condition does not hold, and at whose upper end it does.</summary>
    /// <param name="condition">The condition.</param>
    /// <param name="low">The lower end, moved up.</param>
    /// <param name="high">The upper end, moved down.</param>
    /// <param name="halvings">How often at most; it ends where there is no number between the ends.</param>
    /// <returns>True where the condition ended the search; the end that moved last is where.</returns>
    public static bool Bisect<TCondition>(ref TCondition condition, ref double low, ref double high, int halvings)
        where TCondition : struct, ICondition
    {
        for (int i = 0; i < halvings; i++)
        {
            double middle = 0.5 * (low + high);

            // No double is left between the two.
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

/// <summary>A condition that holds from some place on, which is sought. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface ICondition
{
    /// <summary>Evaluates it.</summary>
    /// <param name="x">Where.</param>
    /// <param name="holds">Whether it holds there.</param>
    /// <returns>True where <paramref name="x"/> is close enough to the place: the search ends there.</returns>
    bool Evaluate(double x, out bool holds);
}

/// <summary>A function of which a root is sought. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface IFunction
{
    /// <summary>Evaluates it.</summary>
    /// <param name="x">Where.</param>
    /// <param name="value">Its value there.</param>
    /// <returns>True where <paramref name="x"/> is close enough to the root: the search ends there.</returns>
    bool Evaluate(double x, out double value);
}

/// <summary>A function with its slope, of which a root is sought. A struct, so that a search is compiled for it and allocates nothing.</summary>
internal interface IDifferentiableFunction
{
    /// <summary>Evaluates it.</summary>
    /// <param name="x">Where.</param>
    /// <param name="value">Its value there.</param>
    /// <param name="slope">Its slope there; a slope that is no number makes the search bisect.</param>
    /// <returns>True where <paramref name="x"/> is close enough to the root: the search ends there.</returns>
    bool Evaluate(double x, out double value, out double slope);
}
