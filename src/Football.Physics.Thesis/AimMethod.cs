namespace FootballPhysics.Thesis;

/// <summary>By which method to find a kick.</summary>
public enum AimMethod
{
    /// <summary>That of <see cref="Aimer"/>: closed-form start, quasi-Newton on the crossing of the target's plane, bracketed fallback, verdict. For one and two points.</summary>
    Direct = 0,

    /// <summary>The thesis' Method A (4.1): the velocity is turned by the angle between where the ball went and the target.</summary>
    Angle = 1,

    /// <summary>The thesis' Method B (4.2): bisection over the elevation, with a correction of the azimuth.</summary>
    Bisection = 2,

    /// <summary>The thesis' two-point method (4.3): velocity towards the point on the way, spin to bend on to the target.</summary>
    TwoPoint = 3,
}
