namespace FootballPhysics;

/// <summary>The air as a one-step method asks it.</summary>
internal interface IFlightLaws
{
    /// <summary>True when <see cref="WindAt"/> is asked, and <see cref="HasSide"/>. A fact of the type but in <see cref="SceneAir"/>: where it is false, they leave no code.</summary>
    bool HasField { get; }

    /// <summary>True when <see cref="Side"/> is asked.</summary>
    bool HasSide { get; }

    /// <summary>The wind by place and time over the steady one, m/s.</summary>
    /// <param name="time">The time, s.</param>
    /// <param name="x">The place, m.</param>
    /// <param name="y">Its y.</param>
    /// <param name="z">Its z.</param>
    Vector3d WindAt(double time, double x, double y, double z);

    /// <summary>Acceleration beside drag and lift.</summary>
    /// <param name="u">Velocity relative to the air, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="distance">Distance flown through the air, m.</param>
    /// <returns>Its acceleration, m/s².</returns>
    Vector3d Side(in Vector3d u, in Vector3d spin, double distance);

    /// <summary>The factors at one instant: a = −drag · u + lift · (ω̂ × u), |ω|˙ = −decay.</summary>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    /// <param name="region">The branch of the drag law that the step is locked to.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">Angular deceleration, rad/s²; at zero spin its limit.</param>
    void Factors(double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay);
}
