namespace Football.Physics;

/// <summary>The step of a flight that leaves no doubt by what it misses a target: its own error is far below a millimetre.</summary>
internal static class MeasuringStep
{
    /// <summary>Step of an ordinary flight, s; and of one that the air rules, that spins faster than it flies, or in a storm.</summary>
    private const double Ordinary = 0.02;
    private const double Fine = 0.005;

    /// <summary>Wind of a storm, m/s.</summary>
    private const double Storm = 25;

    /// <summary>The air rules where drag or lift are so much stronger than gravity.</summary>
    private const double Ruling = 3;

    /// <summary>The step for a kick, s.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="speed">Speed of the kick, m/s.</param>
    /// <param name="spinRate">Its spin, rad/s.</param>
    public static double Of(Simulator simulator, double upward, double speed, double spinRate) =>
        IsRuledByAir(simulator, upward, speed, spinRate) || simulator.Scene.Air.Wind.Length > Storm
            || simulator.Scene.Ball.Radius * spinRate > speed ? Fine : Ordinary;

    /// <summary>Whether, at a speed, drag or lift are so much stronger than gravity that ways bend into loops, or end in the air.</summary>
    public static bool IsRuledByAir(Simulator simulator, double upward, double speed, double spinRate)
    {
        double most = speed + simulator.Scene.Air.Wind.Length;
        simulator.AirFactors(most, spinRate, out double drag, out double lift);
        return most * Math.Max(drag, Math.Abs(lift)) > Ruling * Math.Abs(upward);
    }
}
