namespace Football.Physics;

/// <summary>The aerodynamic laws of a scene, composed: what the integrators ask.</summary>
internal interface IAerodynamics
{
    /// <summary>Whether drag acts.</summary>
    bool Drags { get; }

    /// <summary>Whether the Magnus force acts.</summary>
    bool Lifts { get; }

    /// <summary>Whether the laws read |ω̂ × u|², the spin across the motion; others are handed 0.</summary>
    bool NeedsSpinAcross { get; }

    /// <summary>Whether the fitted drag coefficient is used and jumps.</summary>
    bool Jumps { get; }

    /// <summary>Whether spin decays in the air.</summary>
    bool SpinDecays { get; }

    /// <summary>How fast the air can change the motion.</summary>
    RateBound Bound { get; }

    /// <summary>Reads the constants of all laws from the scene.</summary>
    void Prepare(Scene scene);

    /// <summary>Whether a step from here stays where this evaluation holds; the laws one by one hold everywhere.</summary>
    /// <param name="speedSquared">|u|² at its start.</param>
    /// <param name="spinRate">|ω| there.</param>
    /// <param name="h">Length of the step, s.</param>
    bool Covers(double speedSquared, double spinRate, double h);

    /// <summary>Up to which length, s, no step that is covered changes the motion too much to be taken whole, whatever its speed and spin; 0 where that is not known.</summary>
    /// <param name="bound">How fast the air and all else can change the motion.</param>
    double WholeUpTo(in RateBound bound);

    /// <summary>Computes what is constant over a step, or nearly so.</summary>
    /// <param name="spinRate">|ω| at its start.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="step">What <see cref="Evaluate"/> is handed.</param>
    void Begin(double spinRate, DragBranch branch, out AirStep step);

    /// <summary>Evaluates all laws: a = −drag · u + lift · (ω̂ × u), angular deceleration decay (rad/s²; at zero spin its limit).</summary>
    /// <param name="step">From <see cref="Begin"/>.</param>
    /// <param name="speedSquared">|u|².</param>
    /// <param name="spinRate">|ω|; slightly negative in a stage that overshoots zero.</param>
    /// <param name="acrossSquared">|ω̂ × u|².</param>
    /// <param name="drag">D.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">Angular deceleration.</param>
    void Evaluate(in AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);

    /// <summary>Evaluates all laws at a step's start, and keeps what <see cref="Expand"/> needs of it.</summary>
    /// <param name="step">From <see cref="Begin"/>.</param>
    /// <param name="speedSquared">|u|².</param>
    /// <param name="spinRate">|ω|, that of <see cref="Begin"/>.</param>
    /// <param name="acrossSquared">|ω̂ × u|².</param>
    /// <param name="drag">D.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">Angular deceleration.</param>
    void EvaluateStart(ref AirStep step, double speedSquared, double spinRate, double acrossSquared, out double drag, out double lift, out double decay);

    /// <summary>Makes series about a step's start for its other stages.</summary>
    /// <param name="step">From <see cref="EvaluateStart"/>.</param>
    /// <param name="speedChange">How much |u|² may change within the step.</param>
    /// <param name="spinChange">How much |ω| may change.</param>
    /// <param name="series">What <see cref="EvaluateNear"/> is handed.</param>
    /// <returns>False where there are none: then the stages ask <see cref="Evaluate"/>.</returns>
    bool Expand(in AirStep step, double speedChange, double spinChange, out AirSeries series);

    /// <summary>Evaluates all laws by the series.</summary>
    /// <param name="series">From <see cref="Expand"/>.</param>
    /// <param name="speedSquared">|u|².</param>
    /// <param name="spinRate">|ω|.</param>
    /// <param name="drag">D.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">Angular deceleration.</param>
    void EvaluateNear(in AirSeries series, double speedSquared, double spinRate, out double drag, out double lift, out double decay);
}
