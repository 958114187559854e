using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Zones;

/// <summary>football lab zones: compares events of zones with dense samples of the path.</summary>
internal static class ZonesLab
{
    private const long Most = 10_000_000;

    public static Lab Create() => new Lab(
        "zones",
        "Random kicks through zones of every shape, compared with a densely sampled path: each crossing is reported to within 1e-6 s, and no zone changes the path.",
        ["football lab zones", "football lab zones --paths 300 --seed 7"]).Plays(Lab.Number("--paths", "Kicks through zones.", 1, Most, 1000), Run);

    private static void Run(LabRun run, int paths)
    {
        var plays = new ZonePlays();
        run.Each(paths, "path", (_, i) => plays.Play(run.Seed, i));
        LabTable claims = run.Table("Zones", "what", "count", "worst", "verdict");
        foreach (string row in (string[])["paths", .. ZoneDraw.Shapes.Select(shape => "events: " + shape), .. ZonePlays.Faults])
        {
            claims.Add(row, plays.Counts[row], null, ZonePlays.Faults.Contains(row) ? Say(plays.Counts[row] == 0) : null);
        }

        claims.Add("time of a crossing, s", null, plays.WorstTime, Say(plays.WorstTime <= ZonePlays.Allowed));
        claims.Add("distance of an event from the border or the path, m", null, plays.WorstPlace, null);
        claims.Add(ZonePlays.Grazes, plays.Counts[ZonePlays.Grazes], null, null);
        claims.Add(ZonePlays.Short, plays.Counts[ZonePlays.Short], null, null);
        run.Failed = plays.Failed;
        if (plays.Failed)
        {
            run.Notes.Add(FormattableString.Invariant($"First failure: path {plays.FirstFailure} of seed {run.Seed}."));
        }
    }

    private static string Say(bool holds) => holds ? "holds" : "fails";
}

/// <summary>Simulates random kicks with and without zones, and compares the events with dense samples of the path.</summary>
internal sealed class ZonePlays
{
    /// <summary>Times that differ by no more than this, s, agree.</summary>
    public const double Allowed = 1e-6;

    /// <summary>The interval between two samples of the path, s.</summary>
    private const double Spacing = 2e-4;

    /// <summary>The time for which a kick is followed, s.</summary>
    private const double Duration = 1.5;

    /// <summary>A crossing that stays within this distance of the border, m, is a graze: its time is uncertain and it need not be reported.</summary>
    private const double Graze = 1e-8;

    private readonly PiecePath _path = new();
    private readonly List<Crossing> _expected = [];
    private readonly List<Crossing> _reported = [];

    /// <summary>The counts that must be 0: sampled crossings without an event, events without a crossing or out of order, and paths that zones changed.</summary>
    public static readonly string[] Faults = [Missed, Wrong, Disordered, Changed];

    /// <summary>The crossings that are too shallow to require a report.</summary>
    public const string Grazes = "grazes of less than 1e-8 m";

    /// <summary>The pairs of events between two samples, which the path confirms.</summary>
    public const string Short = "visits between two samples, confirmed";

    private const string Missed = "crossings that were not reported";
    private const string Wrong = "events without a crossing";
    private const string Disordered = "events out of order";
    private const string Changed = "paths that zones changed";

    /// <summary>The counts by these names, the kicks, and the events by shape.</summary>
    public LabCounts Counts { get; } = new();

    /// <summary>The largest difference of the time of a crossing, s.</summary>
    public double WorstTime { get; private set; }

    /// <summary>The largest distance of an event from the border, m.</summary>
    public double WorstPlace { get; private set; }

    /// <summary>The first case that failed; −1 if none did.</summary>
    public int FirstFailure { get; private set; } = -1;

    /// <summary>True if a crossing was missed, or another check failed.</summary>
    public bool Failed => Faults.Any(fault => Counts[fault] > 0) || WorstTime > Allowed || WorstPlace > Graze;

    /// <summary>Simulates a case.</summary>
    public void Play(long seed, int index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        bool failed = Failed;
        ZoneCase kick = ZoneDraw.Kick(random);
        BallState plain = Fly(kick, kick.Scene, new StepLog(mostEvents: 65_536));
        var log = new StepLog(mostEvents: 65_536) { Observer = _path };
        _path.Clear();
        Fly(kick, kick.Scene, log);

        // Draw zones near points of the path, then repeat the same kick with them.
        var zones = new Zone[(int)random.Uniform(1, 6)];
        for (int i = 0; i < zones.Length; i++)
        {
            zones[i] = ZoneDraw.Zone(random, i, _path.At(_path.Start + (random.Uniform(0, 1) * (_path.End - _path.Start))));
        }

        zones = [.. zones.Where(zone => zone.Shape.MaximumConcaveCurvature <= 0.5 / kick.Scene.Ball.Radius)];
        Scene scene = kick.Scene with { Zones = zones };
        log = new StepLog(mostEvents: 65_536);
        BallState among = Fly(kick, scene, log);
        Counts.AddIf(!among.Equals(plain), Changed);
        Compare(log.Events, new Simulator(scene), zones);
        Counts.Add("paths");
        FirstFailure = Failed && !failed ? index : FirstFailure;
    }

    private static BallState Fly(ZoneCase kick, Scene scene, StepLog log) =>
        new Simulator(scene, kick.Settings).Fly(kick.Position, kick.Velocity, kick.Spin, kick.Step, Duration, StopAt.Time, log);

    private void Compare(EventBuffer events, Simulator simulator, Zone[] zones)
    {
        for (int i = 1; i < events.Count; i++)
        {
            Counts.AddIf(events[i].Time < events[i - 1].Time, Disordered);
        }

        for (int z = 0; z < zones.Length; z++)
        {
            Zone zone = zones[z];
            var border = new Border(zone, simulator.Scene.Ball.Radius, _path);
            border.Sample(Spacing, _expected);
            _reported.Clear();
            foreach (BallEvent happened in events.Span)
            {
                if (happened.Kind is BallEventKind.EnterZone or BallEventKind.ExitZone && simulator.NameOf(happened.ColliderIndex) == zone.Name)
                {
                    _reported.Add(new Crossing(happened.Time, happened.Kind == BallEventKind.EnterZone));
                    WorstPlace = Math.Max(WorstPlace, Math.Max(Math.Abs(border.Of(happened.Position)), (happened.Position - _path.At(happened.Time)).Length - (happened.Velocity.Length * 1e-9)));
                    Counts.Add("events: " + zone.Name.Split(' ')[0]);
                }
            }

            Match(in border);
        }
    }

    /// <summary>Compares the reported crossings of one zone with the sampled ones.</summary>
    private void Match(in Border border)
    {
        int i = 0;
        int j = 0;
        while (i < _expected.Count || j < _reported.Count)
        {
            if (i < _expected.Count && j < _reported.Count && _expected[i].Enters == _reported[j].Enters
                && (Math.Abs(_expected[i].Time - _reported[j].Time) <= Allowed || border.Deepest(_expected[i].Time, _reported[j].Time) <= Graze))
            {
                double off = Math.Abs(_expected[i].Time - _reported[j].Time);
                Counts.AddIf(off > Allowed, Grazes);
                WorstTime = off <= Allowed ? Math.Max(WorstTime, off) : WorstTime;
                i++;
                j++;
            }
            else if (j + 1 < _reported.Count && (i == _expected.Count || _reported[j + 1].Time < _expected[i].Time + Allowed) && _reported[j + 1].Time - _reported[j].Time < Spacing * 1.01
                && border.IsIn(0.5 * (_reported[j].Time + _reported[j + 1].Time)) == _reported[j].Enters)
            {
                Counts.Add(Short);
                j += 2;
            }
            else if (i + 1 < _expected.Count && border.Deepest(_expected[i].Time, _expected[i + 1].Time) <= Graze)
            {
                Counts.Add(Grazes);
                i += 2;
            }
            else if (i < _expected.Count && (j == _reported.Count || _expected[i].Time <= _reported[j].Time))
            {
                Counts.Add(Missed);
                i++;
            }
            else
            {
                Counts.Add(Wrong);
                j++;
            }
        }
    }

    /// <summary>A crossing of the border.</summary>
    private readonly record struct Crossing(double Time, bool Enters);

    /// <summary>The border of a zone along the path.</summary>
    private readonly struct Border(Zone zone, double radius, PiecePath path)
    {
        private readonly double _level = zone.Of == ZonePart.Ball ? radius : 0;

        public double Of(in Vector3d position) => zone.Shape.At(in position).Distance - _level;

        public bool IsIn(double time) => zone.Holds(path.At(time), radius);

        /// <summary>Returns the greatest distance from the border between two times, m.</summary>
        public double Deepest(double from, double to)
        {
            double deepest = 0;
            for (int i = 0; i <= 32; i++)
            {
                deepest = Math.Max(deepest, Math.Abs(Of(path.At(from + (i / 32.0 * (to - from))))));
            }

            return deepest;
        }

        /// <summary>Finds the sampled crossings, each by bisection.</summary>
        public void Sample(double spacing, List<Crossing> into)
        {
            into.Clear();
            int count = (int)Math.Ceiling((path.End - path.Start) / spacing);
            double before = path.Start;
            bool wasIn = IsIn(before);
            for (int i = 1; i <= count; i++)
            {
                double time = Math.Min(path.End, path.Start + (i * spacing));
                bool isIn = IsIn(time);
                if (isIn != wasIn)
                {
                    Border border = this;
                    into.Add(new Crossing(LabMath.Bisect(before, time, middle => border.IsIn(middle) == isIn), isIn));
                }

                before = time;
                wasIn = isIn;
            }
        }
    }

    /// <summary>The path of a kick, piece by piece.</summary>
    private sealed class PiecePath : PieceObserver
    {
        private readonly List<PathSegment> _pieces = [];
        private int _last;

        public override bool WantsEndAcceleration => true;

        public double Start => _pieces[0].Time;

        public double End => _pieces[^1].EndTime;

        public void Clear()
        {
            _pieces.Clear();
            _last = 0;
        }

        public override bool Add(in PathSegment piece)
        {
            _pieces.Add(piece);
            return false;
        }

        public Vector3d At(double time)
        {
            while (_last > 0 && time < _pieces[_last].Time)
            {
                _last--;
            }

            while (_last + 1 < _pieces.Count && time >= _pieces[_last + 1].Time)
            {
                _last++;
            }

            PathSegment piece = _pieces[_last];
            return piece.PositionAt(Math.Min(Math.Max(time, piece.Time), piece.EndTime));
        }
    }
}

/// <summary>Random kicks through zones of every shape.</summary>
internal static class ZoneDraw
{
    /// <summary>The shapes of zones.</summary>
    public static readonly string[] Shapes = ["box", "sphere", "capsule", "plane", "hills", "ring"];

    private static readonly double[] s_steps = [0.01, 1.0 / 60, 0.02, 0.05];
    private static readonly Integrator[] s_methods = [Integrator.Rk4, Integrator.Rk4, Integrator.Rk4, Integrator.Rk2, Integrator.SemiImplicitEuler];

    /// <summary>Draws a case: a scene without zones, a kick in it, and the step.</summary>
    public static ZoneCase Kick(SeededRandom random)
    {
        int among = (int)random.Uniform(0, 4);
        Scene scene = (random.Uniform(0, 1) < 0.7 ? Scene.Measured : Scene.Published) with
        {
            Obstacles = among == 1 ? [new Obstacle { Shape = new BoxShape(new Vector3d(0, 0, -6), new Vector3d(4, 3, 0.2)) }, new Obstacle { Shape = new SphereShape(new Vector3d(0, 0.4, 3), 0.5) }] : [],
            Goals = among == 2 ? [new Goal { Center = new Vector3d(0, 0, -8), Facing = new Vector3d(0, 0, 1) }] : [],
            Air = among == 3 ? new Air { Wind = new Vector3d(random.Uniform(-8, 8), 0, random.Uniform(-8, 8)) } : new Air(),
        };
        bool rolls = random.Uniform(0, 1) < 0.3;
        double speed = random.Uniform(0.2, rolls ? 12 : 32);
        Vector3d direction = random.Direction();
        Vector3d velocity = speed * (rolls ? new Vector3d(direction.X, 0, direction.Z) : new Vector3d(direction.X, Math.Abs(direction.Y) * random.Uniform(0, 1), direction.Z));
        Vector3d spin = random.Uniform(0, 90) * random.Direction();
        double height = rolls ? scene.Ball.Radius : scene.Ball.Radius + random.Uniform(0, 2);
        var settings = new SolverSettings { Integrator = s_methods[(int)random.Uniform(0, s_methods.Length)] };
        double step = s_steps[(int)random.Uniform(0, s_steps.Length)];
        return new ZoneCase(scene, settings, step, new Vector3d(random.Uniform(-3, 3), height, random.Uniform(-3, 3)), velocity, spin);
    }

    /// <summary>Draws a zone near a point of the path.</summary>
    public static Zone Zone(SeededRandom random, int index, Vector3d near)
    {
        int shape = (int)random.Uniform(0, Shapes.Length);
        double size = Math.Exp(random.Uniform(Math.Log(0.02), Math.Log(4)));
        Vector3d center = near + (size * random.Uniform(0, 1.3) * random.Direction());
        return new Zone
        {
            Name = FormattableString.Invariant($"{Shapes[shape]} {index}"),
            Of = random.Uniform(0, 1) < 0.5 ? ZonePart.Ball : ZonePart.Center,
            Shape = shape switch
            {
                0 => new BoxShape(center, new Vector3d(size * random.Uniform(0.1, 1), size * random.Uniform(0.1, 1), size * random.Uniform(0.1, 1)), Rotation(random)),
                1 => new SphereShape(center, size),
                2 => new CapsuleShape(center, center + (size * random.Direction()), size * random.Uniform(0.05, 0.6)),
                3 => new PlaneShape(center, random.Direction()),
                4 => LabMath.Hills(near.X - 6, near.Z - 6, 1.2, 12, (_, _) => near.Y + random.Uniform(-0.3, 0.3)),
                _ => new RingShape(center, 0.5 + size, Math.Max(0.01, 0.2 * size)),
            },
        };
    }

    private static Quaterniond Rotation(SeededRandom random)
    {
        while (true)
        {
            var q = new Quaterniond(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
            if (q.LengthSquared is > 1e-3 and <= 1)
            {
                return q.Normalized();
            }
        }
    }
}

/// <summary>A kick in a scene without zones.</summary>
internal sealed record ZoneCase(Scene Scene, SolverSettings Settings, double Step, Vector3d Position, Vector3d Velocity, Vector3d Spin);

/// <summary>A ring around a vertical axis, as a custom shape: it has a hole, and a hollow inside.</summary>
internal sealed class RingShape(Vector3d center, double radius, double thickness) : IShape
{
    public double MaximumConcaveCurvature => 1.0 / (radius - thickness);

    public Bounds3d Bounds => Bounds3d.Around(center, radius + thickness, thickness, radius + thickness);

    public ShapePoint At(in Vector3d point)
    {
        Vector3d from = point - center;
        Vector3d flat = from.Horizontal;
        Vector3d nearest = flat.Length > 0 ? radius / flat.Length * flat : new Vector3d(radius, 0, 0);
        Vector3d away = from - nearest;
        double distance = away.Length;
        Vector3d normal = distance > 0 ? away / distance : Vector3d.Up;
        return new ShapePoint(distance - thickness, in normal, SymmetricMatrix3d.AroundPoint(in normal, Math.Max(distance, 1e-9)));
    }
}
