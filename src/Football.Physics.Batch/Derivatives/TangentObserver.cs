namespace FootballPhysics.Batch;

/// <summary>Watches a simulation and carries the derivatives by the launch along, piece by piece and through every event.</summary>
internal abstract class TangentObserver : PieceObserver
{
    private readonly Tangent _tangent = new();

    /// <summary>The derivatives.</summary>
    public Tangent Tangent => _tangent;

    /// <summary>When the last event happened, by the launch: δt of each column.</summary>
    public double[] EventTimes { get; } = new double[Tangent.Columns];

    /// <summary>Makes one for a scene.</summary>
    public static TangentObserver Of(Scene scene) => new SceneTangent(scene, SceneAir.Of(scene));

    public override bool Add(in PathSegment piece) => false;

    /// <summary>Starts at a launch.</summary>
    /// <param name="from">The ball.</param>
    /// <param name="log">The log that the run writes to; its events from here on are those of the run.</param>
    public abstract void Begin(in BallState from, StepLog log);

    /// <summary>A step begins.</summary>
    /// <param name="start">The ball.</param>
    /// <param name="dt">Its length, s.</param>
    public abstract void BeginStep(in BallState start, double dt);

    /// <summary>A step has ended.</summary>
    /// <param name="end">The ball.</param>
    /// <returns>Whether it was more than plain flight and impacts: the tangent is then that at its start, and <see cref="StepDifferences"/> carries it over.</returns>
    public abstract bool EndStep(in BallState end);

    /// <summary>Goes on from the end of a step that its differences have carried the tangent over.</summary>
    /// <param name="from">The ball.</param>
    public abstract void GoOn(in BallState from);

    /// <summary>
    /// Ends with a run. Where an event ended it, the tangent is that of the motion at the event, just before it, whose time is <see cref="EventTimes"/>.
    /// </summary>
    /// <param name="final">The ball.</param>
    /// <param name="ended">Whether an event ended it.</param>
    public abstract void Finish(in BallState final, bool ended);
}
