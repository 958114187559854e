using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>The path of a ball, divided into legs at its events. The ball has one motion in each leg.</summary>
internal sealed class Flight
{
    public Flight(Scenario scenario)
    {
        Outcome = ScenarioRun.Play(scenario with { Samples = true });
        Start = Outcome.Samples![0].Position;
        Events = Outcome.Events;
        Legs = [.. LegsOf(Outcome)];
    }

    public Outcome Outcome { get; }

    public Vector3d Start { get; }

    public IReadOnlyList<BallEvent> Events { get; }

    public IReadOnlyList<(MotionState Motion, IReadOnlyList<Vector3d> Points)> Legs { get; }

    /// <summary>The path to the first impact, or to the end if there is none.</summary>
    public IEnumerable<Vector3d> ToFirstTouchdown
    {
        get
        {
            BallEvent? first = FirstTouchdown(Outcome);
            IEnumerable<Vector3d> before = Outcome.Samples!.TakeWhile(sample => first is null || sample.Time < first.Value.Time).Select(sample => sample.Position);
            return first is null ? before : before.Append(first.Value.Position);
        }
    }

    /// <summary>The time of the first hit of an object or of a goal, in s; the end of the path if there is none.</summary>
    public double FirstMeeting => Events.Where(item => item.ColliderIndex != 0 && item.Kind is BallEventKind.Impact or BallEventKind.Goal).Select(item => item.Time).DefaultIfEmpty(Outcome.Samples![^1].Time).First();

    /// <summary>Returns the first impact on the ground; null if there is none.</summary>
    public static BallEvent? FirstTouchdown(Outcome outcome) => First(outcome, item => item.Kind == BallEventKind.Impact && item.ColliderIndex == 0);

    /// <summary>Returns the first event of a kind; null if there is none.</summary>
    public static BallEvent? First(Outcome outcome, Func<BallEvent, bool> isKind) => outcome.Events.Where(isKind).Cast<BallEvent?>().FirstOrDefault();

    /// <summary>Returns the legs of a shot with samples.</summary>
    public static IEnumerable<(MotionState Motion, IReadOnlyList<Vector3d> Points)> LegsOf(Outcome outcome)
    {
        // Steps end between the events. Corners at the positions of the events are sharp.
        IReadOnlyList<Moment> samples = outcome.Samples!;
        MotionState motion = samples[0].State;
        var points = new List<Vector3d>();
        int next = 0;
        foreach (BallEvent item in outcome.Events)
        {
            for (; next < samples.Count && samples[next].Time < item.Time; next++)
            {
                points.Add(samples[next].Position);
            }

            points.Add(item.Position);
            MotionState after = MotionAfter.Of(item.Kind, motion);
            if (after != motion)
            {
                yield return (motion, points);
                points = [item.Position];
                motion = after;
            }
        }

        points.AddRange(samples.Skip(next).Select(sample => sample.Position));
        if (motion != MotionState.Rest)
        {
            yield return (motion, points);
        }
    }
}
