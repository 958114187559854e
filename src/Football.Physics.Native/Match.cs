namespace FootballPhysics.Native;

/// <summary>A match, the object of a match handle in C: a runner of one or more balls with its own scene.</summary>
internal sealed class Match : Handled
{
    private readonly Recording? _replayed;
    private readonly Vector3d[] _impulses;
    private readonly int _firstBody;

    /// <summary>Creates a match.</summary>
    /// <param name="runner">The balls, in a scene that no other object uses.</param>
    /// <param name="replayed">The recording that the match replays; null if the caller plays.</param>
    public Match(FixedStepRunner runner, Recording? replayed)
    {
        Runner = runner;
        _replayed = replayed;
        Bodies = runner.Simulator.Scene.Bodies ?? new KinematicBodies();
        _impulses = new Vector3d[Bodies.Count];
        _firstBody = runner.Simulator.World.ThingOfNet(0) - Bodies.Count;
        Blob = new MatchBlob(this);
    }

    /// <summary>Serialises the calls of several threads.</summary>
    public Lock Gate { get; } = new();

    /// <summary>The balls.</summary>
    public FixedStepRunner Runner { get; }

    /// <summary>The bodies; empty if the scene has none.</summary>
    public KinematicBodies Bodies { get; }

    /// <summary>Saves and restores the match.</summary>
    public MatchBlob Blob { get; }

    /// <summary>The recording that the match replays.</summary>
    /// <exception cref="ArgumentException">The match does not replay a recording.</exception>
    public Recording Replayed => _replayed ?? throw new ArgumentException("match replays no recording. Create it with fp_match_replay.");

    /// <summary>Throws if the match replays a recording, which determines its kicks and bodies.</summary>
    public void Plays()
    {
        if (_replayed is not null)
        {
            throw new ArgumentException("match replays a recording. Create another match with fp_match_create to change its balls and bodies.");
        }
    }

    /// <summary>Takes a step.</summary>
    public void Step()
    {
        ForgetImpulses();
        Runner.Step();
        foreach (ref readonly BallEvent happened in Runner.Events)
        {
            if (happened.Kind == BallEventKind.Impact && BodyOf(in happened) is >= 0 and int body)
            {
                _impulses[body] -= Impulse(in happened);
            }
        }
    }

    /// <summary>Sets the impulses of the last step to zero.</summary>
    public void ForgetImpulses() => Array.Clear(_impulses);

    /// <summary>Returns the impulse of the balls on a body in the last step, N s.</summary>
    public Vector3d ImpulseOn(int body) => _impulses[body];

    /// <summary>Returns the impulse on the ball in an event, N s.</summary>
    public Vector3d Impulse(in BallEvent happened) =>
        happened.Kind == BallEventKind.Impact ? SimulatorOf(happened.Ball).Scene.Ball.Mass * (happened.Velocity - happened.VelocityBefore) : Vector3d.Zero;

    /// <summary>Returns the outputs of an impact.</summary>
    public Impact ImpactOf(in BallEvent happened) => SimulatorOf(happened.Ball).ImpactOf(in happened);

    /// <summary>Returns the compiled scene of a ball, which has its own properties.</summary>
    public Simulator SimulatorOf(int ball) => Runner.Group is { } group ? group.SimulatorOf(ball) : Runner.Simulator;

    /// <summary>Returns the index of the body in an event; -1 if the event has no body.</summary>
    public int BodyOf(in BallEvent happened)
    {
        int body = happened.ColliderIndex - _firstBody;
        return (uint)body < (uint)Bodies.Count ? body : -1;
    }

    /// <summary>Compares the match with the recording that it replays, from the start to the end.</summary>
    /// <returns>The first tick whose balls differ; -1 if all are bit-identical.</returns>
    public long FirstDivergence()
    {
        Recording recording = Replayed;
        recording.Seek(Runner, recording.StartTick);
        while (Runner.Tick < recording.EndTick)
        {
            Runner.Step();
            if (Snapshot.Hash(Runner.States) != recording.HashAt(Runner.Tick))
            {
                return Runner.Tick;
            }
        }

        return -1;
    }
}
