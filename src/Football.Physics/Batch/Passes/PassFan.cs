namespace Football.Physics;

/// <summary>Finds the best of many passes through the air: the earliest that a team mate meets before it comes down and before any opponent can meet it.</summary>
/// <remarks>
/// All kicks of a fan are flown in lanes, and looked at step by step; in the order of when they seem to be met, the first that holds on its exact path is the
/// answer. Without team mates it is the kick that no opponent can meet in the air and that comes down closest to a target. Made once for a scene and used again;
/// then nothing is allocated. Not for several threads at once. Scenes with what lanes do not know (see <see cref="BallBatch"/>) are refused.
/// </remarks>
public sealed class PassFan
{
    /// <summary>Step of the lanes, s.</summary>
    private const double Step = 0.04;

    /// <summary>How long a pass may be in the air, s.</summary>
    private const double Longest = 8;

    /// <summary>Passes that are looked at on their exact path at most.</summary>
    private const int MostLooks = 64;

    private readonly Simulator _simulator;
    private readonly LaneFlight _lanes;
    private readonly LaneDomain _domain;
    private readonly LaneGroup _group = new();
    private readonly PassWatch _watch = new();
    private readonly Trajectory _path = new();
    private readonly Interception _query = new();
    private readonly LookAheadRequest _request = new() { Duration = Longest, StopAt = StopAt.Impact };
    private double[] _scores = new double[1000];

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the scene has what lanes do not know; the message names field, value and range.</exception>
    public PassFan(Scene? scene = null)
    {
        _simulator = new Simulator(scene);
        Scene known = _simulator.Scene;
        if (!LaneFlight.Covers(known))
        {
            throw Check.Refusal("scene", "one with things, fields of wind or forces of its own", "a level pitch, steady wind and laws of one kind");
        }

        _domain = new LaneDomain(known, Step);
        _lanes = LaneFlight.Create(known, fourthOrder: true, Step, LaneFlight.BestLanes);
        _group.Watch = _watch;
    }

    /// <summary>Finds the best pass.</summary>
    /// <param name="request">Which passes to try.</param>
    /// <param name="mates">The team mates at the kick; may be none.</param>
    /// <param name="opponents">The opponents at the kick; may be none.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public PassChoice Find(PassFanRequest request, Runner[] mates, Runner[] opponents)
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
        _watch.Begin(mates, opponents, in from, _simulator.Scene.Air.Wind);
        int open = 0;
        for (int first = 0; first < count; first += LaneGroup.Size)
        {
            open += Fly(request, in from, mates.Length > 0, first, Math.Min(LaneGroup.Size, count - first));
        }

        for (int look = 0; look < MostLooks; look++)
        {
            int best = Best(count);
            if (best < 0)
            {
                break;
            }

            _scores[best] = double.PositiveInfinity;
            if (Holds(request, best, mates, opponents, out PassChoice choice))
            {
                return Counted(in choice, count, open);
            }
        }

        return new PassChoice { Receiver = -1, Kicks = count, Open = open };
    }

    /// <summary>Flies a group, and writes down when each kick seems to be met, or how far from the target it comes down; infinite for those that are lost.</summary>
    private int Fly(PassFanRequest request, in Vector3d from, bool hasMates, int first, int count)
    {
        _group.Clear();
        _watch.Clear();
        double contact = _simulator.ContactHeight;
        Vector3d wind = _simulator.Scene.Air.Wind;
        for (int i = 0; i < count; i++)
        {
            _scores[first + i] = double.PositiveInfinity;
            request.Kick(first + i, out Vector3d velocity, out Vector3d spin);
            Vector3d u = velocity - wind;
            double rate = spin.Length;
            if (velocity.Y >= _simulator.Scene.Ground.MinimumBounceSpeed && _domain.Covers(u.LengthSquared, rate, from.Y - contact, wind.Y, Longest))
            {
                _group.Add(i, in u, rate > 0 ? spin / rate : Vector3d.Up, rate, contact - from.Y, wind.Y);
                _scores[first + i] = 0;
            }
        }

        _lanes.Fly(_group, Longest);
        Vector3d target = request.Target ?? from;
        int open = 0;
        for (int i = 0; i < count; i++)
        {
            ref double score = ref _scores[first + i];
            if (score != 0)
            {
                continue;
            }

            double time = _watch.Time[i];
            if (hasMates)
            {
                score = time > 0 ? time : double.PositiveInfinity;
            }
            else
            {
                Vector3d end = from + _group.EndPath[i] + (_group.EndTime[i] * wind);
                score = time < 0 || !_group.Reached[i] ? double.PositiveInfinity : (end - target).Horizontal.Length;
            }

            open += double.IsPositiveInfinity(score) ? 0 : 1;
        }

        return open;
    }

    private int Best(int count)
    {
        int best = -1;
        double least = double.PositiveInfinity;
        for (int i = 0; i < count; i++)
        {
            if (_scores[i] < least)
            {
                least = _scores[i];
                best = i;
            }
        }

        return best;
    }

    /// <summary>Whether a pass holds on its exact path.</summary>
    private bool Holds(PassFanRequest request, int index, Runner[] mates, Runner[] opponents, out PassChoice choice)
    {
        request.Kick(index, out Vector3d velocity, out Vector3d spin);
        BallState ball = _simulator.Launch(request.From, velocity, spin);
        _simulator.LookAhead(in ball, _request, _path);
        BallState end = _path.Final;
        var meeting = new PathPoint(end.Time, end.Position, end.Velocity, 0);
        int receiver = mates.Length > 0 ? _query.FindFirst(_path, mates, out meeting) : -1;
        int opponent = _query.FindFirst(_path, opponents, out PathPoint lost);
        double lead = opponent < 0 ? double.PositiveInfinity : lost.Time - meeting.Time;
        choice = new PassChoice { IsFound = true, Velocity = velocity, Spin = spin, Receiver = receiver, Meeting = meeting, Lead = lead };
        return mates.Length > 0 ? receiver >= 0 && lead >= request.Margin : opponent < 0;
    }

    private static PassChoice Counted(in PassChoice of, int kicks, int open) => new()
    {
        IsFound = true,
        Velocity = of.Velocity,
        Spin = of.Spin,
        Receiver = of.Receiver,
        Meeting = of.Meeting,
        Lead = of.Lead,
        Kicks = kicks,
        Open = open,
    };
}
