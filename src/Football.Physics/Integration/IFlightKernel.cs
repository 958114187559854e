namespace Football.Physics;

/// <summary>The factors of the air's forces along one step of flight: what a one-step method asks.</summary>
/// <typeparam name="TStep">What the kernel computes once a step and keeps for its stages.</typeparam>
internal interface IFlightKernel<TStep>
    where TStep : struct
{
    /// <summary>Whether drag acts. A fact of the type, as the next two: what does not act leaves no code.</summary>
    bool Drags { get; }

    /// <summary>Whether the Magnus force acts.</summary>
    bool Lifts { get; }

    /// <summary>Whether spin decays.</summary>
    bool SpinDecays { get; }

    /// <summary>Computes what is constant over a step, or nearly so.</summary>
    /// <param name="spinRate">|ω| at its start, rad/s.</param>
    /// <param name="branch">The branch of the drag law that the step is locked to.</param>
    /// <param name="step">What the other members are handed.</param>
    void Begin(double spinRate, DragBranch branch, out TStep step);

    /// <summary>The factors at the start of the step: a = −drag · u + lift · (ω̂ × u), angular deceleration decay.</summary>
    /// <param name="step">From <see cref="Begin"/>.</param>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, that of <see cref="Begin"/>, rad/s.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">Angular deceleration, rad/s²; at zero spin its limit.</param>
    void AtStart(ref TStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);

    /// <summary>Says how far the later stages go, so that the kernel can make series about the start for them.</summary>
    /// <param name="step">From <see cref="AtStart"/>.</param>
    /// <param name="speedChange">How much |u|² may change within the step, m²/s².</param>
    /// <param name="spinChange">How much |ω| may change, rad/s.</param>
    void Expand(ref TStep step, double speedChange, double spinChange);

    /// <summary>The factors at a later stage.</summary>
    /// <param name="step">From <see cref="Expand"/>.</param>
    /// <param name="speedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">|ω|, rad/s; slightly negative in a stage that overshoots zero.</param>
    /// <param name="acrossSquared">|ω̂ × u|², m²/s².</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">Angular deceleration, rad/s².</param>
    void AtStage(in TStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);
}
