namespace Football.Physics.Headless.Gallery;

/// <summary>Something that stands or lies on the pitch, as a box in the frame of a shot; metres.</summary>
/// <param name="Name">What it is.</param>
/// <param name="AlongFrom">Nearest place along the view.</param>
/// <param name="AlongTo">Farthest place along the view.</param>
/// <param name="LeftFrom">Rightmost place; positive is to the left of the view.</param>
/// <param name="LeftTo">Leftmost place.</param>
/// <param name="Height">Its height; 0 for markings.</param>
internal sealed record Landmark(string Name, double AlongFrom, double AlongTo, double LeftFrom, double LeftTo, double Height)
{
    /// <summary>Height of a goal, m.</summary>
    public const double GoalHeight = 2.44;

    /// <summary>Half the width of a goal, m.</summary>
    public const double GoalHalfWidth = 3.66;

    /// <summary>A goal that is looked at from the front.</summary>
    public static Landmark Goal(double along) => new("goal", along, along + 2, -GoalHalfWidth, GoalHalfWidth, GoalHeight);

    /// <summary>The penalty area before a goal that is looked at from the front.</summary>
    public static Landmark PenaltyArea(double along) => new("penalty area", along - 16.5, along, -20.16, 20.16, 0);
}
