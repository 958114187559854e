namespace FootballPhysics.Batch;

/// <summary>Where the kicks of a player cross the plane of a goal.</summary>
public readonly record struct GoalChanceResult
{
    /// <summary>How it was found.</summary>
    public GoalChanceMethod Method { get; init; }

    /// <summary>Kicks that were flown for it.</summary>
    public int Kicks { get; init; }

    /// <summary>Share of the kicks that cross the plane, 0 … 1; the numbers below are of those.</summary>
    public double Crosses { get; init; }

    /// <summary>Mean of the places, m right of the goal's middle, seen by who stands in the goal and looks at the pitch.</summary>
    public double Aside { get; init; }

    /// <summary>Mean of the places, m above the goal's line; of the ball's centre.</summary>
    public double Height { get; init; }

    /// <summary>Mean time of the crossing, s since the kick.</summary>
    public double Time { get; init; }

    /// <summary>Standard deviation aside, m.</summary>
    public double AsideDeviation { get; init; }

    /// <summary>Standard deviation of the height, m.</summary>
    public double HeightDeviation { get; init; }

    /// <summary>Correlation of both, −1 … 1.</summary>
    public double Correlation { get; init; }

    /// <summary>Chance, 0 … 1, that the ball goes in if nobody stops it, as <see cref="BallEventKind.Goal"/> says: clear of the posts and the bar, or in off them.</summary>
    public double OnTarget { get; init; }

    /// <summary>Chance, 0 … 1, that it does so where the goalkeeper can be by then.</summary>
    public double Covered { get; init; }

    /// <summary>Chance, 0 … 1, that it goes in and the goalkeeper cannot be there.</summary>
    public double Scores => OnTarget - Covered;

    /// <summary>Half the long axis of the ellipse of one standard deviation, m.</summary>
    public double LongAxis => Axis(1.0);

    /// <summary>Half its short axis, m.</summary>
    public double ShortAxis => Axis(-1.0);

    /// <summary>Angle of its long axis above the line to the right, degrees, −90 … 90.</summary>
    public double AxisDegrees
    {
        get
        {
            // tan 2θ = 2 c/(a − b)
            double twice = Elementary.Atan2(2.0 * Covariance, (AsideDeviation * AsideDeviation) - (HeightDeviation * HeightDeviation));
            return 0.5 * twice * (180.0 / Math.PI);
        }
    }

    private double Covariance => Correlation * AsideDeviation * HeightDeviation;

    private double Axis(double sign)
    {
        double a = AsideDeviation * AsideDeviation;
        double b = HeightDeviation * HeightDeviation;
        double c = Covariance;
        return Math.Sqrt(Math.Max(0, 0.5 * (a + b + (sign * Math.Sqrt(((a - b) * (a - b)) + (4.0 * c * c))))));
    }
}
