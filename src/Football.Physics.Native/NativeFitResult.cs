namespace FootballPhysics.Native;

/// <summary>The launch estimated from a track, with its uncertainty.</summary>
internal unsafe struct NativeFitResult
{
    /// <summary>The time of the launch, s: that of the first point.</summary>
    public double Time;

    /// <summary>The position at the launch, m.</summary>
    public fixed double Position[3];

    /// <summary>The velocity at the launch, m/s.</summary>
    public fixed double Velocity[3];

    /// <summary>The spin at the launch, rad/s.</summary>
    public fixed double Spin[3];

    /// <summary>The factors of drag, lift, restitution and friction relative to the scene; 1 if a factor was not estimated.</summary>
    public fixed double Factors[4];

    /// <summary>The standard error of each component of the position, m.</summary>
    public fixed double PositionDeviation[3];

    /// <summary>The standard error of each component of the velocity, m/s.</summary>
    public fixed double VelocityDeviation[3];

    /// <summary>The standard error of each component of the spin, rad/s.</summary>
    public fixed double SpinDeviation[3];

    /// <summary>The standard errors of the factors; 0 if a factor was not estimated.</summary>
    public fixed double FactorDeviations[4];

    /// <summary>The spin of another launch that fits about as well, rad/s; zero unless has_other_spin is 1.</summary>
    public fixed double OtherSpin[3];

    /// <summary>The sum of (observed - fitted)^2/noise^2 over all coordinates.</summary>
    public double ChiSquared;

    /// <summary>The probability of an equal or larger chi_squared if the scene and the noise are correct.</summary>
    public double Probability;

    /// <summary>The number of observed coordinates minus the number of parameters.</summary>
    public int DegreesOfFreedom;

    /// <summary>The number of search steps.</summary>
    public int Iterations;

    /// <summary>The verdict, one of fp_fit_verdict.</summary>
    public int Verdict;

    /// <summary>1 if the search ended at a minimum; otherwise 0.</summary>
    public int Converged;

    /// <summary>Bit i is set if the track determines parameter i better than the prior: 0-2 position, 3-5 velocity, 6-8 spin, 9-12 factors.</summary>
    public int Identified;

    /// <summary>1 if there is another spin; otherwise 0.</summary>
    public int HasOtherSpin;

    /// <summary>The answers that are reliable to within their standard errors: the sum of values of fp_match_answers.</summary>
    public int GoodFor;

    /// <summary>The suspected faults of the track: the sum of values of fp_track_suspicions.</summary>
    public int Suspicions;
}
