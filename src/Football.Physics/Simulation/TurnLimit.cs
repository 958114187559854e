namespace Football.Physics;

/// <summary>
/// How far a slip or a roll may change in one piece. Its direction turns at the rate across/size, ever faster as the size falls: a piece in which it turns by θ,
/// and changes by the share x of what is left of it, is off by some hundredths of θ x⁴ (RK4).
/// </summary>
internal static class TurnLimit
{
    /// <summary>The largest turn θ, rad.</summary>
    private const double LargestTurn = 0.125;

    /// <summary>The largest θ x⁴: the reference cases of slides with sidespin and rolls in wind hold with it (WholeRun), and fail with a hundred times it.</summary>
    private const double LargestError = 1e-5;

    /// <summary>Whether a piece may be taken.</summary>
    /// <param name="size">Size at its start, m/s.</param>
    /// <param name="along">Change along its direction, m/s.</param>
    /// <param name="across">Change across it, m/s; not negative.</param>
    public static bool Allows(double size, double along, double across)
    {
        double left = size + along;
        double leftSquared = left * left;
        double changed = (along * along) + (across * across);
        return left > 0 && across <= LargestTurn * left && across * (changed * changed) <= LargestError * left * (leftSquared * leftSquared);
    }
}
