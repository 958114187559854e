namespace FootballPhysics.Batch;

/// <summary>Looks at the kicks of a fan that go along the ground.</summary>
/// <remarks>
/// Where nothing tells one direction from another (no wind across, the same bounce along x and z), all kicks of one speed and spin go the same way, turned about the
/// vertical: it is stepped once, and kept for the next fan. Else each kick is stepped, as far as needed.
/// </remarks>
internal sealed class PassRolls
{
    /// <summary>Ways that are kept.</summary>
    private const int MostKept = 64;

    /// <summary>How many of the watch's steps a step along the ground has.</summary>
    private const int Stride = 2;

    /// <summary>A track, and a turned one, is no further off, m.</summary>
    private const double Error = 0.001;

    private readonly Simulator _simulator;
    private readonly PassPlayers _players;
    private readonly PassWatch _watch;
    private readonly PassTrack _single = new();
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly PassTrack?[] _kept;
    private readonly double _length;

    public PassRolls(Simulator simulator, PassPlayers players, PassWatch watch, double length)
    {
        _simulator = simulator;
        _players = players;
        _watch = watch;
        _length = length;
        Scene scene = simulator.Scene;
        Vector3d wind = scene.Air.Wind;
        bool isRound = wind.X == 0 && wind.Z == 0 && (scene.Ground.TangentialRestitutionZ is not { } z || z == scene.Ground.Material.TangentialRestitution);
        _kept = isRound ? new PassTrack?[MostKept] : [];
    }

    /// <summary>True when a kick of a ball on the ground is too flat to leave it, unless its spin lifts it.</summary>
    public bool IsFlat(in Vector3d from, in Vector3d velocity) =>
        velocity.Y < _simulator.Scene.Ground.MinimumBounceSpeed && from.Y <= _simulator.ContactHeight;

    /// <summary>Bound of a kick's score: when a team mate meets it, or how far from the target it rests; infinite where it is lost, 0 where it is not known.</summary>
    /// <param name="request">The fan.</param>
    /// <param name="index">Which of its kicks.</param>
    /// <param name="from">Where it begins, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="spin">Its spin, rad/s.</param>
    /// <param name="acceleration">Nothing on the ground is accelerated more strongly, m/s².</param>
    public double Score(PassFanRequest request, int index, in Vector3d from, in Vector3d velocity, in Vector3d spin, double acceleration)
    {
        if (_simulator.LaunchAt(in from, in velocity, in spin, 0).Motion == MotionState.Airborne)
        {
            // Its spin lifts it off: it may be back at once.
            return 0;
        }

        if (_kept.Length == 0)
        {
            _single.Start(_simulator, in velocity, in spin, acceleration);
            return Score(request, _single, in from, new Vector3d(1, 0, 0));
        }

        int pair = index / request.Directions;
        PassTrack track = pair < _kept.Length ? _kept[pair] ??= new PassTrack() : _single;
        request.KickAlongX(pair, out Vector3d along, out Vector3d turning);
        track.Start(_simulator, in along, in turning, acceleration);
        return Score(request, track, in from, velocity.Horizontal / velocity.Horizontal.Length);
    }

    private double Score(PassFanRequest request, PassTrack track, in Vector3d from, in Vector3d turn)
    {
        double length = Stride * _length;
        double earliest = double.PositiveInfinity;
        double idle = 0;
        bool isKnown = false;
        int step = 0;
        while (!isKnown && idle < request.Duration)
        {
            // The first step that ends later than nothing happens.
            step = Math.Max(step, (int)(idle / length)) + 1;
            Advance(track, step, length);
            if (step > track.Steps)
            {
                break;
            }

            Vector3d start = from + Turned(in turn, in track.Place(step - 1));
            Vector3d end = from + Turned(in turn, in track.Place(step));
            _players.Reach(Stride * step);

            // In its last step the ball comes to rest, and after that nobody is asked any more.
            double last = track.Rests ? Math.Min(request.Duration, (track.Steps - 1) * length) : request.Duration;
            isKnown = _watch.Look(ref earliest, Stride * (step - 1), Stride * step, in start, in end, track.Slack(step) + Error, track.Fastest, last, out idle);
        }

        if (_players.Mates > 0 || double.IsNaN(earliest))
        {
            return double.IsNaN(earliest) ? double.PositiveInfinity : earliest;
        }

        // A track that is kept may go on for longer than is asked for.
        int whole = (int)(request.Duration / length) + 1;
        Advance(track, whole, length);
        return track.Rests && track.Steps <= whole
            ? (from + Turned(in turn, in track.Place(track.Steps)) - (request.Target ?? request.From)).Horizontal.Length - Error
            : double.PositiveInfinity;
    }

    /// <summary>Steps a kick as often as asked for, or to its rest.</summary>
    private void Advance(PassTrack track, int steps, double length)
    {
        while (track.Steps < steps && !track.Rests)
        {
            track.Advance(_simulator, length, _log);
        }
    }

    /// <summary>x → d, z → d × ŷ.</summary>
    private static Vector3d Turned(in Vector3d d, in Vector3d place) => new((d.X * place.X) - (d.Z * place.Z), place.Y, (d.Z * place.X) + (d.X * place.Z));
}
