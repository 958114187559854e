using System.Globalization;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>Finds the pass that a team mate can reach earliest, before any opponent, in the air or on the ground.</summary>
/// <remarks>
/// A team mate must reach a pass in the air before it lands, and a pass on the ground before it comes to rest. SIMD lanes simulate the passes in the air;
/// passes on the ground are simulated step by step. At each step, the search bounds the earliest time at which any team mate can reach each pass, and detects
/// certain interceptions. It then evaluates the kicks on their exact paths, in the order of these bounds, until no other kick can be better. The result is the
/// same as if every kick were evaluated.
/// <para>Without team mates, the search considers kicks that no opponent can reach, and returns the one that lands, or comes to rest on the ground, closest to
/// a target. A pass that first hits an object of the scene, such as a post, a board or a net, is rejected.
/// Create one per scene and reuse it: searches with the same duration do not allocate. Not thread-safe. The constructor throws for scenes that
/// lanes do not support (see <see cref="BallBatch"/>), and for scenes with bodies or engine colliders.</para>
/// </remarks>
public sealed class PassFan
{
    /// <summary>The step of the lanes, in s.</summary>
    private const double Step = 0.04;

    /// <summary>The maximum error of a flight in lanes, in m.</summary>
    private const double LaneError = 0.002;

    private readonly Simulator _simulator;
    private readonly LaneFlight _lanes;
    private readonly LaneDomain _domain;
    private readonly LaneGroup _group = new();
    private readonly PassPlayers _players = new();
    private readonly PassWatch _watch;
    private readonly PassRolls _rolls;
    private readonly PassJudge _judge;
    private double[] _scores = new double[1000];

    /// <summary>The number of kicks that the last search judged on their exact paths.</summary>
    internal int Judged { get; private set; }

    /// <summary>Compiles a scene for the search.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or lanes do not support the scene; the message names field, value and range.</exception>
    public PassFan(Scene? scene = null)
    {
        // Bounds are computed on the open pitch. A kick that hits an object is lost, so these bounds are always optimistic.
        Scene whole = scene ?? Scene.Default;
        if (whole.Ground.IsNone)
        {
            throw Check.Conflict("ground", "ground is none, but passes are played on a level pitch. Use a scene with a ground.");
        }

        if (whole.Forces.KnuckleSeed is { } seed)
        {
            throw Check.Refusal("forces.knuckleSeed", seed.ToString(CultureInfo.InvariantCulture), "none, because PassFan would simulate thousands of passes one by one");
        }

        Simulator? amongThings = whole.HasThings ? new Simulator(whole) : null;
        _simulator = new Simulator(whole with { Obstacles = [], Nets = [], Goals = [] });
        Scene known = _simulator.Scene;
        if (!LaneFlight.Covers(known))
        {
            throw Check.Conflict("scene", "scene is not supported by PassFan. Use a level pitch with static obstacles, a steady wind, no custom forces, and force laws of one kind.");
        }

        _domain = new LaneDomain(known, Step);
        _lanes = LaneFlight.Create(known, fourthOrder: true, Step, LaneFlight.BestLanes);
        _watch = new PassWatch(_simulator, _players);
        _rolls = new PassRolls(_simulator, _players, _watch, _lanes.TimeStep);
        _judge = new PassJudge(_simulator, amongThings);
        _group.Watch = _watch;
    }

    /// <summary>Finds the best pass.</summary>
    /// <param name="request">The passes to try.</param>
    /// <param name="mates">The team mates at the time of the kick; may be empty.</param>
    /// <param name="opponents">The opponents at the time of the kick; may be empty.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public PassResult Find(PassFanRequest request, Player[] mates, Player[] opponents)
    {
        Check.Given(nameof(request), request);
        Check.Given(nameof(mates), mates);
        Check.Given(nameof(opponents), opponents);
        request.Validate();
        int count = request.Count;
        if (_scores.Length < count)
        {
            _scores = new double[count];
        }

        var from = new Vector3d(request.From.X, Math.Max(request.From.Y, _simulator.ContactHeight), request.From.Z);
        _players.Begin(mates, opponents, _lanes.TimeStep);
        _watch.Begin(in from, _simulator.Scene.Air.Wind, request.Duration, _lanes.TimeStep, request.Margin, FlightAcceleration(request, in from), LaneError);
        _judge.Begin(request.Duration);
        Score(request, in from);
        int open = 0;
        for (int i = 0; i < count; i++)
        {
            open += double.IsPositiveInfinity(_scores[i]) ? 0 : 1;
        }

        PassResult answer = default;
        double least = double.PositiveInfinity;
        int found = -1;
        Judged = 0;
        for (int best = Best(count, least); best >= 0; best = Best(count, least))
        {
            double score = _scores[best];
            Judged++;
            bool isJudged = _judge.Judge(request, best, mates, opponents, ref score, out PassResult choice);
            _scores[best] = isJudged ? double.PositiveInfinity : score;
            if (isJudged && score < least)
            {
                least = score;
                answer = choice;
                found = best;
            }
        }

        return found < 0
            ? new PassResult { Receiver = -1, Kicks = count, Open = open }
            : _judge.Completed(request, found, opponents, in answer, count, open);
    }

    /// <summary>Computes a lower bound of each kick's score; infinite if the kick is lost.</summary>
    /// <remarks>The score is the time at which a team mate reaches the ball, or its final distance from the target.</remarks>
    private void Score(PassFanRequest request, in Vector3d from)
    {
        double rolling = RollAcceleration(request);
        for (int first = 0; first < request.Count; first += LaneGroup.Size)
        {
            int end = Math.Min(request.Count, first + LaneGroup.Size);
            _group.Clear();
            _watch.Clear();
            for (int index = first; index < end; index++)
            {
                request.Kick(index, out Vector3d velocity, out Vector3d spin);
                _scores[index] = _rolls.IsFlat(in from, in velocity)
                    ? _rolls.Score(request, index, in from, in velocity, in spin, rolling)
                    : Launch(request, in from, index - first, in velocity, in spin);
            }

            Fly(request, in from, first, end);
        }
    }

    /// <summary>Adds a kick to the group.</summary>
    /// <returns>NaN if the kick was added; 0 if lanes do not support it, so that it is judged in any case.</returns>
    private double Launch(PassFanRequest request, in Vector3d from, int ball, in Vector3d velocity, in Vector3d spin)
    {
        double contact = _simulator.ContactHeight;
        Vector3d wind = _simulator.Scene.Air.Wind;
        Vector3d u = velocity - wind;
        double rate = spin.Length;
        if (!_domain.Covers(u.LengthSquared, rate, from.Y - contact, wind.Y, request.Duration))
        {
            return 0;
        }

        _group.Add(ball, in u, rate > 0 ? spin / rate : Vector3d.Up, rate, contact - from.Y, wind.Y);
        return double.NaN;
    }

    /// <summary>Simulates the group.</summary>
    private void Fly(PassFanRequest request, in Vector3d from, int first, int end)
    {
        // Use full steps, so that players and balls are compared at the same times.
        _lanes.Fly(_group, Math.Ceiling(request.Duration / _lanes.TimeStep) * _lanes.TimeStep);
        Vector3d wind = _simulator.Scene.Air.Wind;
        Vector3d target = request.Target ?? request.From;
        for (int index = first; index < end; index++)
        {
            int ball = index - first;
            if (!double.IsNaN(_scores[index]))
            {
                continue;
            }

            bool isSeen = _watch.IsDecided(ball) || !_group.GivenUp[ball];
            Vector3d place = from + _group.EndPath[ball] + (_group.EndTime[ball] * wind);
            if (isSeen && !_watch.IsDecided(ball) && _group.Reached[ball])
            {
                _watch.LookAtEnd(ball, _group.EndTime[ball], in place, _group.EndVelocity[ball] + wind);
            }

            double earliest = _watch.Earliest[ball];
            _scores[index] = !isSeen ? 0
                : double.IsNaN(earliest) ? double.PositiveInfinity
                : _players.Mates > 0 ? earliest
                : _group.Reached[ball] ? Math.Max(0, (place - target).Horizontal.Length - LaneError)
                : double.PositiveInfinity;
        }
    }

    /// <summary>Returns the kick with the lowest score below a bound; −1 if there is none.</summary>
    private int Best(int count, double below)
    {
        int best = -1;
        for (int i = 0; i < count; i++)
        {
            if (_scores[i] < below)
            {
                below = _scores[i];
                best = i;
            }
        }

        return best;
    }

    /// <summary>Returns a bound on the acceleration of kicks in the air, in m/s². In the air's frame only gravity does work.</summary>
    private double FlightAcceleration(PassFanRequest request, in Vector3d from)
    {
        Scene scene = _simulator.Scene;
        double drop = from.Y - _simulator.ContactHeight + (Math.Abs(scene.Air.Wind.Y) * request.Duration);
        double speed = request.MaximumSpeed + scene.Air.Wind.Length;
        double fastest = Math.Sqrt((speed * speed) + (2.0 * Math.Abs(Weight.UpwardAcceleration(scene)) * drop));
        return _domain.AccelerationAtMost(fastest, request.SpinRate);
    }

    /// <summary>Returns a bound on the acceleration of kicks on the ground, in m/s².</summary>
    /// <remarks>Friction is at most its coefficient times weight and lift. A slide turns at most all its energy into spin.</remarks>
    private double RollAcceleration(PassFanRequest request)
    {
        Scene scene = _simulator.Scene;
        Ground ground = scene.Ground;
        double speed = request.MaximumSpeed + (scene.Ball.Radius * request.SpinRate) + (2.0 * scene.Air.Wind.Length);
        double spin = request.SpinRate + (speed / (Math.Sqrt(scene.Ball.InertiaFactor) * scene.Ball.Radius));
        double friction = Math.Max(ground.Material.SlidingFriction, ground.Material.RollingResistance + (ground.Material.RollingResistancePerSpeed * speed));
        return (1.0 + friction) * _domain.AccelerationAtMost(speed, spin);
    }
}
