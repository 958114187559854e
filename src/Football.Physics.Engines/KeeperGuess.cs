using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>A dive to which a keeper commits before the kick: a time, and a point in the goal.</summary>
public readonly struct KeeperGuess
{
    /// <summary>The shares of keepers who dive to their left and who stay.</summary>
    private const double Left = 0.444;
    private const double Stay = 0.063;

    /// <summary>The distance of the target from the post, and its height, as shares of the goal.</summary>
    private const double FromPost = 0.15;
    private const double Height = 0.3;

    /// <summary>Creates a guess.</summary>
    /// <param name="time">The time at which he starts, on the clock of the ball, in s.</param>
    /// <param name="target">The point to which he dives, in m; components within ±1e6.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public KeeperGuess(double time, Vector3d target)
    {
        Check.Within(nameof(time), time, -Limits.Time, Limits.Time);
        Check.Place(nameof(target), target);
        Time = time;
        Target = target;
    }

    /// <summary>The time at which he starts, on the clock of the ball, in s; usually 0.1 … 0.3 s before the kick.</summary>
    public double Time { get; }

    /// <summary>The point to which he dives, in m. Within 0.3 m of his position, measured along the goal line, he stays.</summary>
    public Vector3d Target { get; }

    /// <summary>Draws the side of a dive at random, with the shares of real penalties.</summary>
    /// <remarks>
    /// Of 286 penalties, keepers dived to one side in 44.4 % and to the other in 49.3 %, and stayed in 6.3 % (Bar-Eli et al., J. Econ. Psychol. 28:606, 2007). The target is at
    /// 30 % of the height of the goal, and 15 % of its width from the post: a keeper decides the height only after the kick.
    /// </remarks>
    /// <param name="goal">His goal.</param>
    /// <param name="time">The time at which he starts, in s.</param>
    /// <param name="seed">The seed; any integer. Use the seed of the match.</param>
    /// <param name="kick">The number of the kick, at least 0: each number is a new draw.</param>
    /// <exception cref="ArgumentNullException"><paramref name="goal"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is not finite, or <paramref name="kick"/> is negative.</exception>
    public static KeeperGuess Draw(Goal goal, double time, long seed, int kick)
    {
        Check.Given(nameof(goal), goal);
        Check.Within(nameof(time), time, -Limits.Time, Limits.Time);
        Check.Within(nameof(kick), kick, 0, int.MaxValue);
        double number = SplitMix64.At(seed, kick);
        double side = number < Left ? -1 : number < Left + Stay ? 0 : 1;
        return new KeeperGuess(time, goal.Center + (side * (0.5 - FromPost) * goal.Width * goal.Right) + new Vector3d(0, Height * goal.Height, 0));
    }
}
