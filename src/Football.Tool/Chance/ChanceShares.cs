namespace FootballPhysics.Tool.Chance;

/// <summary>The probabilities of the ends of a kick, which add up to 1, with their standard errors.</summary>
/// <param name="Kicks">The number of simulated kicks.</param>
/// <param name="Goal">A goal that the keeper cannot reach (<see cref="GoalChanceResult.Scores"/>), and its standard error.</param>
/// <param name="Save">A ball on target that the keeper reaches (<see cref="GoalChanceResult.Covered"/>), and its standard error.</param>
/// <param name="Post">A ball off the frame that does not go in, and its standard error.</param>
/// <param name="Wide">Every other ball, and its standard error.</param>
internal readonly record struct ChanceShares(int Kicks, (double Share, double Error) Goal, (double Share, double Error) Save, (double Share, double Error) Post, (double Share, double Error) Wide)
{
    /// <summary>Returns the shares of a result of simulated kicks.</summary>
    public static ChanceShares Of(in GoalChanceResult found)
    {
        double post = found.Post ?? double.NaN;
        double wide = found.Wide ?? double.NaN;
        return new ChanceShares(found.Kicks, (found.Scores, found.StandardError), (found.Covered, Error(found.Covered, found.Kicks)), (post, Error(post, found.Kicks)), (wide, Error(wide, found.Kicks)));
    }

    /// <summary>The standard error of a share of independent kicks, but at least half a kick. The kicks cover the spread evenly, so the true error is less.</summary>
    private static double Error(double share, int kicks) => Math.Max(0.5 / kicks, Math.Sqrt(share * (1 - share) / kicks));
}
