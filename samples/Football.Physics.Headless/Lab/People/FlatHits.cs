using Football.Physics.Yardsticks;

namespace Football.Physics.Headless.Lab.People;

/// <summary>A ball goes into the edge of board and ground at a flat angle, as along a touchline: when it rests, against the same kick on open ground.</summary>
internal sealed class FlatHits
{
    private const double Radius = 0.11;
    private const double Frame = 1.0 / 60;

    /// <summary>So long is waited for a rest, s.</summary>
    private const double Longest = 90;

    /// <summary>A slide in the edge that lasts longer is no slide, s.</summary>
    private const double LongSlide = 2;

    private readonly (Simulator Simulator, double Board)[] _pitches =
    [
        On(Pitch.Cage),
        On(Pitch.Stadium),
        (new Simulator(new Scene { Obstacles = [new Obstacle { Name = "right board", Shape = new BoxShape(new Vector3d(5.05, 0.5, 0), new Vector3d(0.05, 0.5, 400)), Surface = Surface.Board }] }), 5),
    ];

    private readonly Simulator _open = new(new Scene());
    private readonly StepLog _log = new();

    public StepMeter Meter { get; } = new();

    /// <summary>Hits of the board.</summary>
    public int Cases { get; private set; }

    /// <summary>That slid in the edge for long.</summary>
    public int SlidLong { get; private set; }

    /// <summary>Not at rest when no more was waited.</summary>
    public int Restless { get; private set; }

    /// <summary>At rest later than on open ground.</summary>
    public int Later { get; private set; }

    /// <summary>The latest of them, s.</summary>
    public double Latest { get; private set; }

    public string LatestAt { get; private set; } = "";

    /// <summary>Of the latest rest, s.</summary>
    public double Longer { get; private set; }

    /// <summary>Plays one kick; those that miss the board are not counted.</summary>
    public void Play(long seed, int index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        (Simulator simulator, double board) = _pitches[index % _pitches.Length];
        double speed = random.Chance(0.5) ? random.Uniform(2, 20) : random.Uniform(0.5, 12);
        double aside = random.Uniform(0, 0.6) * random.Uniform(0, 1);
        double up = random.Chance(0.5) ? 0 : random.Uniform(0, 0.35);
        Vector3d velocity = speed * new Vector3d(Math.Cos(up) * Math.Sin(aside), Math.Sin(up), -Math.Cos(up) * Math.Cos(aside));
        Vector3d spin = random.Below(3) switch
        {
            0 => Vector3d.Zero,
            1 => new Vector3d(velocity.Z / Radius, random.Uniform(-40, 40), -velocity.X / Radius),
            _ => new Vector3d(random.Uniform(-60, 60), random.Uniform(-60, 60), random.Uniform(-60, 60)),
        };
        var from = new Vector3d(board - Radius - random.Uniform(0, 1.2 * random.Next()), Radius, random.Uniform(0, 8));
        var ball = new Ball(simulator) { State = simulator.Launch(from, velocity, spin) };
        bool hit = false;
        double slid = 0;
        while (ball.Motion != MotionState.Stopped && ball.Time < Longest)
        {
            Meter.Step(ball, Frame, $"hit {index}, {ball.Time} s");
            foreach (ref readonly BallEvent item in ball.Events)
            {
                hit |= item.Thing > 0 && simulator.NameOf(item.Thing) == "right board";
            }

            Vector3d at = ball.State.Position;
            slid += ball.Motion == MotionState.Sliding && at.Y < Radius + 1e-4 && Math.Abs(board - Radius - at.X) < 1e-6 ? Frame : 0;
        }

        if (!hit)
        {
            return;
        }

        Cases++;
        SlidLong += slid > LongSlide ? 1 : 0;
        Restless += ball.Motion != MotionState.Stopped ? 1 : 0;
        Longer = Math.Max(Longer, ball.Time);
        BallState open = _open.Launch(from, velocity, spin);
        _log.Clear();
        _open.Run(ref open, Frame, Longest, StopAt.Rest, _log);
        double later = Math.Ceiling(ball.Time / Frame) - Math.Ceiling(open.Time / Frame);
        Later += later > 0 ? 1 : 0;
        if (later * Frame > Latest)
        {
            Latest = later * Frame;
            LatestAt = FormattableString.Invariant($"hit {index}: rests after {ball.Time:0.00} s, on open ground after {open.Time:0.00} s; velocity {velocity}, spin {spin}, from {from}");
        }
    }

    private static (Simulator Simulator, double Board) On(Pitch pitch) => (new Simulator(pitch.On()), (0.5 * pitch.Width) + pitch.BoardDistance);
}
