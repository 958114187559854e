using FootballPhysics.Simulation;

namespace FootballPhysics.Batch;

/// <summary>Observes a simulation, and updates the derivatives by the launch segment by segment and event by event.</summary>
internal abstract class TangentObserver : PieceObserver
{
    private readonly Tangent _tangent = new();

    /// <summary>The derivatives.</summary>
    public Tangent Tangent => _tangent;

    /// <summary>The derivative of the last event's time by the launch: δt of each column.</summary>
    public double[] EventTimes { get; } = new double[Tangent.Columns];

    /// <summary>Creates an observer for a scene.</summary>
    public static TangentObserver Of(Scene scene) => new SceneTangent(scene, SceneAir.Of(scene));

    public override bool Add(in PathSegment piece) => false;

    /// <summary>Starts at a launch.</summary>
    /// <param name="from">The ball.</param>
    /// <param name="log">The log of the run; events from here on belong to the run.</param>
    public abstract void Begin(in BallState from, StepLog log);

    /// <summary>Begins a step.</summary>
    /// <param name="start">The ball.</param>
    /// <param name="dt">The length of the step, in s.</param>
    public abstract void BeginStep(in BallState start, double dt);

    /// <summary>Ends a step.</summary>
    /// <param name="end">The ball.</param>
    /// <returns>True if it contained more than plain flight and impacts. The tangent is then that at its start, and <see cref="StepDifferences"/> must update it.</returns>
    public abstract bool EndStep(in BallState end);

    /// <summary>Continues after a step that <see cref="StepDifferences"/> has processed.</summary>
    /// <param name="from">The ball.</param>
    public abstract void GoOn(in BallState from);

    /// <summary>Ends the run.</summary>
    /// <remarks>If an event ended it, the tangent is that of the motion just before the event, at the time of <see cref="EventTimes"/>.</remarks>
    /// <param name="final">The ball.</param>
    /// <param name="ended">True if an event ended the run.</param>
    public abstract void Finish(in BallState final, bool ended);
}
