namespace FootballPhysics.Labs.Penalties;

/// <summary>The keeper of a penalty.</summary>
/// <param name="Name">His name in the table.</param>
/// <param name="Abilities">His abilities; null for an empty goal.</param>
/// <param name="Guesses">True if he commits to a side before the kick.</param>
internal sealed record PenaltyKeeper(string Name, Player? Abilities, bool Guesses)
{
    public static IReadOnlyList<PenaltyKeeper> All { get; } =
    [
        new("none", null, false),
        new("reacts, Typical", KeeperDive.Typical, false),
        new("guesses, Typical", KeeperDive.Typical, true),
        new("reacts, Penalty", KeeperDive.Penalty, false),
        new("guesses, Penalty", KeeperDive.Penalty, true),
    ];
}

/// <summary>The target of a penalty.</summary>
/// <param name="Name">Its name in the table.</param>
/// <param name="Aside">Its distance from the middle of the goal, in m.</param>
/// <param name="Height">Its height, in m.</param>
internal sealed record PenaltyAim(string Name, double Aside, double Height)
{
    /// <summary>The shares of kicks to the two sides, the rest goes to the middle: of 286 penalties (Bar-Eli et al., J. Econ. Psychol. 28:606, 2007).</summary>
    private const double Left = 0.392;
    private const double Right = 0.322;

    public static IReadOnlyList<PenaltyAim> All { get; } =
    [
        new("middle, low", 0, 0.5),
        new("middle, high", 0, 1.8),
        new("half a side, low", 1.5, 0.4),
        new("side, low", 2.4, 0.3),
        new("side, middle", 2.4, 1.2),
        new("corner, low", 2.9, 0.3),
        new("corner, high", 2.9, 1.9),
        new("as people", double.NaN, double.NaN),
    ];

    /// <summary>Returns the target of a kick; its side is drawn.</summary>
    public Vector3d Target(SeededRandom random, double z)
    {
        double number = random.Next();
        double more = random.Next();
        double height = random.Next();
        if (!double.IsNaN(Aside))
        {
            return new Vector3d(number < 0.5 ? -Aside : Aside, Height, z);
        }

        // The sides have the middle of 60 % of the way from the middle third to the post.
        double aside = number < Left ? -1 : number < Left + Right ? 1 : 0;
        return new Vector3d((aside * (1.4 + (1.6 * more))) + (aside == 0 ? more - 0.5 : 0), 0.2 + (1.7 * height * height), z);
    }
}

/// <summary>The end of a penalty.</summary>
internal enum PenaltyEnd
{
    Scored,
    Saved,
    Post,
    Missed,
}
