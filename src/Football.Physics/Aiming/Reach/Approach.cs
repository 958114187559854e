namespace FootballPhysics.Aiming;

/// <summary>A kick, and its closest approach to the target before its first impact.</summary>
internal struct Approach
{
    /// <summary>The kick; in still air already turned so that it passes the target with its closest point.</summary>
    public Kick Kick;

    /// <summary>Distance of the closest approach, m.</summary>
    public double Miss;

    /// <summary>True when the target is below the way, not above or beyond it.</summary>
    public bool Above;

    /// <summary>When the ball is closest, s.</summary>
    public double Time;

    /// <summary>Where it is then as seen from the target, m.</summary>
    public Vector3d Gap;

    /// <summary>The miss distance, negative where the kick is too low or too short: smooth in the elevation, and zero at a hit.</summary>
    public readonly double SignedMiss => Above ? Miss : -Miss;

    public readonly double Elevation => Kick.Elevation;
}

/// <summary>Three kicks of rising elevation, and the parabola of their miss distances.</summary>
internal struct ApproachBracket
{
    public Approach Low;
    public Approach Middle;
    public Approach High;

    public ApproachBracket(in Approach low, in Approach middle, in Approach high)
    {
        Low = low;
        Middle = middle;
        High = high;
    }

    /// <summary>From the low one to the middle, rad.</summary>
    public readonly double Left => Middle.Elevation - Low.Elevation;

    /// <summary>From the middle one to the high one, rad.</summary>
    public readonly double Right => High.Elevation - Middle.Elevation;

    /// <summary>True when one of them passes above the target.</summary>
    public readonly bool AnyAbove => Low.Above || Middle.Above || High.Above;

    /// <summary>The least miss distance of the three, m.</summary>
    public readonly double LeastMiss => Math.Min(Math.Min(Low.Miss, Middle.Miss), High.Miss);

    /// <summary>Lower bound of the miss between them, m: the least of their parabola, less its possible error.</summary>
    public readonly double LowerBound
    {
        get
        {
            double left = Left;
            double right = Right;
            if (!(left > 0 && right > 0))
            {
                return 0;
            }

            Parabola(out double slope, out double curvature);

            // The vertex, where the parabola opens upwards and has it between the outer two; else the least of the three.
            double x = curvature > 0 ? -slope / curvature : 0;
            bool within = curvature > 0 && x > -left && x < right;
            double vertex = within ? Middle.Miss - (0.5 * slope * slope / curvature) : LeastMiss;

            // Off by ½ |q| (l r)², with a third derivative like the second.
            double doubt = left * right;
            return vertex - (0.5 * Math.Abs(curvature) * doubt * doubt);
        }
    }

    /// <summary>The miss distance at another elevation, of the parabola through three that need not be in order.</summary>
    public static double Extrapolate(in Approach one, in Approach two, in Approach three, double elevation)
    {
        double x = elevation - three.Elevation;
        double x1 = one.Elevation - three.Elevation;
        double x2 = two.Elevation - three.Elevation;

        // Newton's divided differences, from the third point.
        double s1 = (one.Miss - three.Miss) / x1;
        double s2 = (two.Miss - three.Miss) / x2;
        double q = (s1 - s2) / (x1 - x2);
        return three.Miss + (x * (s2 + (q * (x - x2))));
    }

    /// <summary>The parabola through them: m(b + x) = m_b + s x + ½ q x².</summary>
    public readonly void Parabola(out double slope, out double curvature)
    {
        double left = Left;
        double right = Right;
        curvature = 2.0 * ((left * (High.Miss - Middle.Miss)) + (right * (Low.Miss - Middle.Miss))) / (left * right * (left + right));
        slope = ((High.Miss - Middle.Miss) / right) - (0.5 * curvature * right);
    }

    /// <summary>Takes a kick between the middle one and a neighbour into the three, and leaves one out.</summary>
    public void Insert(in Approach next, bool becomesMiddle)
    {
        // The least stays in the middle; at a bound, where an outer one is less, the three move towards that.
        bool left = next.Elevation < Middle.Elevation;
        double outer = left ? Low.Miss : High.Miss;
        if (becomesMiddle || next.Miss < Middle.Miss || outer < Middle.Miss)
        {
            (Low, High) = left ? (Low, Middle) : (Middle, High);
            Middle = next;
        }
        else
        {
            (Low, High) = left ? (next, High) : (Low, next);
        }
    }
}
