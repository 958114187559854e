namespace FootballPhysics.Native;

/// <summary>The parameters that all pieces of a match track share.</summary>
internal unsafe struct NativeFitMatchResult
{
    /// <summary>The number of parameters.</summary>
    public const int Parameters = 12;

    /// <summary>The parameters, in the order of fp_fit_parameter. A parameter that was not estimated has its value in the scene; a factor is then 1.</summary>
    public fixed double Values[Parameters];

    /// <summary>The standard errors of the parameters; 0 if a parameter was not estimated.</summary>
    public fixed double Deviations[Parameters];

    /// <summary>The root mean square of the residuals in flights of 0.3 s or longer, m.</summary>
    public double Rms;

    /// <summary>The share of the points above 0.5 m that belong to such flights, 0 ... 1.</summary>
    public double Covered;

    /// <summary>The standard deviation of the track's coordinates from one point to the next, m.</summary>
    public double Noise;

    /// <summary>The mean speed of the rolls, m/s; 0 if the ball never rolls untouched.</summary>
    public double RollingSpeed;

    /// <summary>The standard deviation of the rolling resistance at that speed.</summary>
    public double RollingDeviation;

    /// <summary>Bit i is set if parameter i was estimated.</summary>
    public int Estimated;

    /// <summary>The number of flights of 0.3 s or longer.</summary>
    public int Flights;

    /// <summary>The number of impacts from which the surface was estimated.</summary>
    public int Impacts;

    /// <summary>The number of intervals in which the ball slid or rolled untouched.</summary>
    public int Windows;

    /// <summary>The answers that are reliable to within their standard errors: the sum of values of fp_match_answers.</summary>
    public int GoodFor;

    /// <summary>The suspected faults of the track: the sum of values of fp_track_suspicions.</summary>
    public int Suspicions;
}

/// <summary>The parameters that a match fit can estimate.</summary>
internal enum NativeFitParameter
{
    /// <summary>The x component of the wind, m/s.</summary>
    WindX = 0,

    /// <summary>The z component of the wind, m/s.</summary>
    WindZ = 1,

    /// <summary>A factor of the drag.</summary>
    Drag = 2,

    /// <summary>The critical Reynolds number of the drag crisis.</summary>
    Crisis = 3,

    /// <summary>A factor of the Magnus force.</summary>
    Lift = 4,

    /// <summary>The height of the ground, m.</summary>
    GroundHeight = 5,

    /// <summary>The normal restitution of the ground.</summary>
    Restitution = 6,

    /// <summary>The increase of the restitution at grazing impacts.</summary>
    RestitutionRise = 7,

    /// <summary>The friction of impacts; infinite if an impact always stops the slip.</summary>
    Friction = 8,

    /// <summary>The friction of slides.</summary>
    SlidingFriction = 9,

    /// <summary>The rolling resistance.</summary>
    RollingFriction = 10,

    /// <summary>The increase of the rolling resistance with the speed, s/m.</summary>
    RollingFrictionBySpeed = 11,
}
