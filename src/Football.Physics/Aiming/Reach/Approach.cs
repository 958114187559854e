namespace FootballPhysics.Aiming;

/// <summary>A kick, and its closest approach to the target before its first impact.</summary>
internal struct Approach
{
    /// <summary>The kick; in still air, it is already turned so that its closest point lies in the direction of the target.</summary>
    public Kick Kick;

    /// <summary>The distance of the closest approach, in m.</summary>
    public double Miss;

    /// <summary>True if the kick passes above the target, and not below it, and does not end short of it.</summary>
    public bool Above;

    /// <summary>The time of the closest approach, in s.</summary>
    public double Time;

    /// <summary>The ball's position relative to the target at the closest approach, in m.</summary>
    public Vector3d Gap;

    /// <summary>The miss, negative if the kick is too low or too short: smooth in the elevation, and zero at a hit.</summary>
    public readonly double SignedMiss => Above ? Miss : -Miss;

    public readonly double Elevation => Kick.Elevation;
}

/// <summary>Three kicks of increasing elevation, and the parabola through their misses.</summary>
internal struct ApproachBracket(in Approach low, in Approach middle, in Approach high)
{
    public Approach Low = low;
    public Approach Middle = middle;
    public Approach High = high;

    /// <summary>The angle from the low kick to the middle one, in rad.</summary>
    public readonly double Left => Middle.Elevation - Low.Elevation;

    /// <summary>The angle from the middle kick to the high one, in rad.</summary>
    public readonly double Right => High.Elevation - Middle.Elevation;

    /// <summary>True if any of the kicks passes above the target.</summary>
    public readonly bool AnyAbove => Low.Above || Middle.Above || High.Above;

    /// <summary>The smallest miss of the three, in m.</summary>
    public readonly double LeastMiss => Math.Min(Math.Min(Low.Miss, Middle.Miss), High.Miss);

    /// <summary>The lower bound of the miss between the kicks, in m: the minimum of the parabola, minus its possible error.</summary>
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

            // Use the vertex if the parabola opens upwards and its vertex is between the outer kicks. Otherwise, use the kick with the smallest of the three misses.
            double x = curvature > 0 ? -slope / curvature : 0;
            bool within = curvature > 0 && x > -left && x < right;
            double vertex = within ? Middle.Miss - (0.5 * slope * slope / curvature) : LeastMiss;

            // The error is ½ |q| (l r)² if the third derivative is about as large as the second one.
            double doubt = left * right;
            return vertex - (0.5 * Math.Abs(curvature) * doubt * doubt);
        }
    }

    /// <summary>Extrapolates the miss to another elevation, with the parabola through three kicks in any order.</summary>
    public static double Extrapolate(in Approach one, in Approach two, in Approach three, double elevation)
    {
        double x = elevation - three.Elevation;
        double x1 = one.Elevation - three.Elevation;
        double x2 = two.Elevation - three.Elevation;

        // Interpolate with Newton's divided differences, starting from the third point.
        double s1 = (one.Miss - three.Miss) / x1;
        double s2 = (two.Miss - three.Miss) / x2;
        double q = (s1 - s2) / (x1 - x2);
        return three.Miss + (x * (s2 + (q * (x - x2))));
    }

    /// <summary>Returns the parabola m(b + x) = m_b + s x + ½ q x².</summary>
    public readonly void Parabola(out double slope, out double curvature)
    {
        double left = Left;
        double right = Right;
        curvature = 2.0 * ((left * (High.Miss - Middle.Miss)) + (right * (Low.Miss - Middle.Miss))) / (left * right * (left + right));
        slope = ((High.Miss - Middle.Miss) / right) - (0.5 * curvature * right);
    }

    /// <summary>Inserts a kick between the middle kick and a neighbour, and drops one of the outer kicks.</summary>
    public void Insert(in Approach next, bool becomesMiddle)
    {
        // Keep the kick with the smallest miss in the middle. At a bound, an outer kick may be closer: then move towards that kick.
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
