namespace FootballPhysics.Thesis;

/// <summary>The method that finds a kick.</summary>
public enum AimMethod
{
    /// <summary>The method of <see cref="Aimer"/>, for one or two points.</summary>
    /// <remarks>The method starts from a closed form. It then uses quasi-Newton iterations on the crossing of the target's plane, a bracketed fallback, and a
    /// final check.</remarks>
    Direct = 0,

    /// <summary>The thesis' Method A (4.1), which rotates the velocity by the angle between the ball's path and the target.</summary>
    Angle = 1,

    /// <summary>The thesis' Method B (4.2), which bisects the elevation and corrects the azimuth.</summary>
    Bisection = 2,

    /// <summary>The thesis' two-point method (4.3), which aims the velocity at the waypoint and bends the path to the target by spin.</summary>
    TwoPoint = 3,
}
