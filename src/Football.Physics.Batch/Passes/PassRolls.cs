namespace FootballPhysics.Batch;

/// <summary>Evaluates the kicks of a fan that stay on the ground.</summary>
/// <remarks>
/// All directions are equivalent if there is no wind across, and the bounce is the same along x and z. Kicks of one speed and spin then differ only by a rotation
/// about the vertical: one of them is stepped, and cached for the next fan. Otherwise each kick is stepped, as far as needed.
/// </remarks>
internal sealed class PassRolls
{
    /// <summary>The maximum number of cached tracks.</summary>
    private const int MostKept = 64;

    /// <summary>The number of watch steps per step on the ground.</summary>
    private const int Stride = 2;

    /// <summary>The maximum error of a track, rotated or not, in m.</summary>
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

    /// <summary>Returns true if a kick is too flat to leave the ground, unless its spin lifts the ball.</summary>
    public bool IsFlat(in Vector3d from, in Vector3d velocity) =>
        velocity.Y < _simulator.Scene.Ground.MinimumBounceSpeed && from.Y <= _simulator.ContactHeight;

    /// <summary>Returns a lower bound of a kick's score; infinite if it is lost, 0 if unknown.</summary>
    /// <remarks>The score is the time at which a team mate reaches the ball, or the distance from the target at rest.</remarks>
    /// <param name="request">The fan.</param>
    /// <param name="index">The index of the kick.</param>
    /// <param name="from">The start, in m.</param>
    /// <param name="velocity">The velocity of the kick, in m/s.</param>
    /// <param name="spin">The spin of the kick, in rad/s.</param>
    /// <param name="acceleration">A bound on the acceleration on the ground, in m/s².</param>
    public double Score(PassFanRequest request, int index, in Vector3d from, in Vector3d velocity, in Vector3d spin, double acceleration)
    {
        if (_simulator.LaunchAt(in from, in velocity, in spin, 0).Motion == MotionState.Airborne)
        {
            // The spin lifts the ball off the ground: it may come back at once.
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
            // Skip to the first step that ends after the idle time.
            step = Math.Max(step, (int)(idle / length)) + 1;
            Advance(track, step, length);
            if (step > track.Steps)
            {
                break;
            }

            Vector3d start = from + Turned(in turn, in track.Place(step - 1));
            Vector3d end = from + Turned(in turn, in track.Place(step));
            _players.Reach(Stride * step);

            // The ball comes to rest in the last step; after that, no opponent counts.
            double last = track.Rests ? Math.Min(request.Duration, (track.Steps - 1) * length) : request.Duration;
            isKnown = _watch.Look(ref earliest, Stride * (step - 1), Stride * step, in start, in end, track.Slack(step) + Error, track.Fastest, last, out idle);
        }

        if (_players.Mates > 0 || double.IsNaN(earliest))
        {
            return double.IsNaN(earliest) ? double.PositiveInfinity : earliest;
        }

        // A cached track may be longer than needed.
        int whole = (int)(request.Duration / length) + 1;
        Advance(track, whole, length);
        return track.Rests && track.Steps <= whole
            ? (from + Turned(in turn, in track.Place(track.Steps)) - (request.Target ?? request.From)).Horizontal.Length - Error
            : double.PositiveInfinity;
    }

    /// <summary>Steps a kick as far as needed, or until it rests.</summary>
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
