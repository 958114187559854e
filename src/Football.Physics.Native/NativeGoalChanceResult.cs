namespace FootballPhysics.Native;

/// <summary>How a player's kicks spread on the plane of a goal, and the probability that they score.</summary>
internal struct NativeGoalChanceResult
{
    /// <summary>The probability of a ball on target that the goalkeeper cannot reach, 0 ... 1.</summary>
    public double Scores;

    /// <summary>The probability of a goal if nobody stops the ball, 0 ... 1, including goals in off the frame.</summary>
    public double OnTarget;

    /// <summary>The probability of a ball on target that the goalkeeper can reach in time, 0 ... 1; 0 without a goalkeeper.</summary>
    public double Covered;

    /// <summary>The standard error of scores from the finite number of kicks; 0 if derivatives were used.</summary>
    public double StandardError;

    /// <summary>The share of the kicks that cross the plane of the goal, 0 ... 1; the following numbers refer to these kicks.</summary>
    public double Crosses;

    /// <summary>The mean offset to the right of the goal's centre, m, as the goalkeeper sees it.</summary>
    public double Aside;

    /// <summary>The mean height of the ball's centre above the goal line, m.</summary>
    public double Height;

    /// <summary>The mean time of the crossing, s since the kick.</summary>
    public double Time;

    /// <summary>The standard deviation of the offset, m.</summary>
    public double AsideDeviation;

    /// <summary>The standard deviation of the height, m.</summary>
    public double HeightDeviation;

    /// <summary>The correlation of offset and height, -1 ... 1.</summary>
    public double Correlation;

    /// <summary>The method, one of fp_chance_method.</summary>
    public int Method;

    /// <summary>The number of simulated kicks: the random kicks, or the test kicks if derivatives were used.</summary>
    public int Kicks;
}
