using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The spread of a player's kicks on the plane of a goal.</summary>
public readonly struct GoalChanceResult
{
    /// <summary>The method that computed the result.</summary>
    public GoalChanceMethod Method { get; internal init; }

    /// <summary>The number of simulated kicks: the random kicks, or the test kicks if derivatives were used.</summary>
    public int Kicks { get; internal init; }

    /// <summary>The standard error of <see cref="Scores"/> from the finite number of kicks, 0 … 1; 0 if derivatives were used.</summary>
    /// <remarks>The error of derivatives is not random; it is at most about 0.005.</remarks>
    public double StandardError { get; internal init; }

    /// <summary>The share of the kicks that cross the plane, 0 … 1; the following statistics refer to these kicks.</summary>
    public double Crosses { get; internal init; }

    /// <summary>The mean offset to the right of the goal's centre, in m, as the goalkeeper sees it.</summary>
    public double Aside { get; internal init; }

    /// <summary>The mean height of the ball's centre above the goal line, in m.</summary>
    public double Height { get; internal init; }

    /// <summary>The mean time of the crossing, in s since the kick.</summary>
    public double Time { get; internal init; }

    /// <summary>The standard deviation of the offset, in m.</summary>
    public double AsideDeviation { get; internal init; }

    /// <summary>The standard deviation of the height, in m.</summary>
    public double HeightDeviation { get; internal init; }

    /// <summary>The correlation of offset and height, −1 … 1.</summary>
    public double Correlation { get; internal init; }

    /// <summary>The probability of a goal if nobody stops the ball, 0 … 1, including goals in off the frame.</summary>
    /// <remarks><see cref="BallEventKind.Goal"/> defines a goal.</remarks>
    public double OnTarget { get; internal init; }

    /// <summary>The probability of a ball on target that the goalkeeper can reach in time, 0 … 1.</summary>
    public double Covered { get; internal init; }

    /// <summary>The probability of a ball on target that the goalkeeper cannot reach, 0 … 1.</summary>
    public double Scores => OnTarget - Covered;

    /// <summary>The probability of a ball that hits the frame and does not go in, 0 … 1; null if no kicks were simulated.</summary>
    /// <remarks>Set <see cref="GoalChanceRequest.AlwaysSimulate"/> to simulate kicks.</remarks>
    public double? Post { get; internal init; }

    /// <summary>The probability of a ball that neither goes in nor hits the frame, 0 … 1; null if no kicks were simulated. Kicks that an obstacle stops are among them.</summary>
    public double? Wide => 1 - OnTarget - Post;

    /// <summary>Half the long axis of the one-standard-deviation ellipse, in m.</summary>
    public double LongAxis => Axis(1.0);

    /// <summary>Half the short axis of the one-standard-deviation ellipse, in m.</summary>
    public double ShortAxis => Axis(-1.0);

    /// <summary>The angle of the long axis above the horizontal to the right, in degrees, −90 … 90.</summary>
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
