using System.Globalization;

namespace Football.Physics;

/// <summary>Finds kicks that reach a target after bounces, and off named things: one bounce and in, off the wall, in off the post.</summary>
/// <remarks>
/// A kick is put together from legs: from the ball to a guess of where it touches the first thing, from there on, and to the target. Newton's method moves the kick and
/// the places until all legs meet (multiple shooting), and what is found is flown. Where that leads to no hit, kicks are tried over all directions. Made once for a scene
/// and used again, without allocating. Not for several threads at once.
/// </remarks>
public sealed class BankShotAimer
{
    /// <summary>A kick that misses by more than this does not go the way of its chain, m: something is in between.</summary>
    private const double Strange = 0.2;

    /// <summary>Kicks are the same that differ by less than this, rad.</summary>
    private const double Same = 1e-3;

    private readonly Simulator _simulator;
    private readonly Collider[] _colliders;
    private readonly Collider? _ground;
    private readonly int _first;
    private readonly BankShotFlight _flight;
    private readonly BankShotChain _chain;
    private readonly BankShotGuess _guess;
    private readonly BankShotGrid _grid;
    private readonly Kick[] _kicks = new Kick[BankShotGuess.Count];

    /// <summary>What is to be met, by how many that are.</summary>
    private readonly Dictionary<int, int[]> _things = [];
    private int _flown;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BankShotAimer(Scene? scene = null)
    {
        _simulator = new Simulator(scene);
        Scene made = _simulator.Scene;
        World world = _simulator.World;
        _ground = world.Ground;
        _colliders = world.Colliders;
        _first = world.FirstCollider;
        _flight = new BankShotFlight(_simulator);
        _chain = new BankShotChain(made);
        _guess = new BankShotGuess(made);
        _grid = new BankShotGrid(_flight, world, made.Ball.Radius);
    }

    /// <summary>Finds a kick.</summary>
    /// <param name="request">
    /// What the kick is to do: from, target, speed, spin, elevations, tolerance, time of the kick. Without a point on the way. <see cref="AimRequest.MaximumIterations"/> are
    /// those from one start; there are many.
    /// </param>
    /// <param name="after">The names of what it is to meet before, in order: "ground", an obstacle's, "left post", "crossbar" …; at least one. Of things of one name "left post[0]" is the first, "left post[1]" the second: obstacles and goals in the order in which the scene has them.</param>
    /// <returns>The best kick found. A hit passes the target within the tolerance after having met just these; all else is not converged: no other kick is ruled out.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, nothing is to be met, or the scene has nothing or several things of a name; the message says what it has.</exception>
    public AimResult Find(AimRequest request, params string[] after)
    {
        Check.Given(nameof(request), request);
        Check.Given("aim.after", after);
        request.Validate();
        if (request.Through is { } point)
        {
            throw Check.Refusal("aim.through", point.ToString(), "none, where something is to be met before");
        }

        // 1. Chains of legs from several guesses, each flown and corrected where it closes. 2. Where none hits, kicks over all directions.
        int[] things = Things(after);
        _flight.Begin(request);
        var frame = new TargetFrame(AimContext.Raised(_simulator, request.From), AimContext.Raised(_simulator, request.Target));
        BankShotStart best = Chained(request, in frame, things, Nothing(request, in frame));
        if (!best.IsHit(request))
        {
            best = _grid.Find(request, in frame, things, best);
        }

        best.Kick.Vectors(request.Speed, frame.Forward, out Vector3d velocity, out Vector3d spin);
        var measured = new MeasuredMiss(best.Miss, null, best.Time, best.Position);
        AimStatus status = best.IsHit(request) ? AimStatus.Hit : AimStatus.NotConverged;
        return new AimResult(status, in velocity, in spin, in measured, AimArc.Low, rolls: false, _flight.Iterations, _flight.Simulations, blockedBy: null);
    }

    /// <summary>Puts kicks together from where they may touch things.</summary>
    private BankShotStart Chained(AimRequest request, in TargetFrame frame, int[] things, BankShotStart best)
    {
        // Bounces off the ground belong to the leg that makes them: only other things are places of their own. What moves cannot be put into a chain.
        int contacts = 0;
        foreach (int thing in things)
        {
            contacts += _colliders[thing - _first] == _ground ? 0 : 1;
        }

        _chain.Prepare(contacts);
        int leg = 0;
        _chain.Legs.Bounces[0] = 0;
        foreach (int index in things)
        {
            Collider thing = _colliders[index - _first];
            if (thing.Moves)
            {
                return best;
            }

            if (thing == _ground)
            {
                _chain.Legs.Bounces[leg]++;
                continue;
            }

            _chain.Legs.Contacts[leg++].Thing = thing;
            _chain.Legs.Bounces[leg] = 0;
        }

        _flown = 0;
        for (int i = 0; i < BankShotGuess.Count && !best.IsHit(request); i++)
        {
            if (!_guess.Make(_chain.Legs, _ground, request, in frame, i))
            {
                continue;
            }

            if (_chain.Close(request, in frame, _flight) && IsNew(_chain.Legs.Kick))
            {
                BankShotStart found = Flown(request, in frame, things);
                best = found.IsFine && (!best.IsFine || found.Miss < best.Miss) ? found : best;
            }
        }

        return best;
    }

    /// <summary>Whether no chain has led to a kick before; it is then remembered.</summary>
    private bool IsNew(in Kick kick)
    {
        for (int i = 0; i < _flown; i++)
        {
            if (Math.Abs(_kicks[i].Elevation - kick.Elevation) + Math.Abs(_kicks[i].Azimuth - kick.Azimuth) < Same)
            {
                return false;
            }
        }

        _kicks[_flown++] = kick;
        return true;
    }

    /// <summary>Flies the kick of a chain, and corrects it by what it misses.</summary>
    private BankShotStart Flown(AimRequest request, in TargetFrame frame, int[] things)
    {
        var bounds = ElevationBounds.Of(request);
        Kick kick = _chain.Legs.Kick;
        kick.Elevation = bounds.Clamp(kick.Elevation);
        BankShotStart best = _flight.Fly(request, in frame, things, in kick, _flight.FineStep);
        best.IsFine = best.Meets;
        return best.Meets && best.Miss < Strange && best.Miss > BankShotFlight.Enough * request.Tolerance ? _flight.Improve(request, in frame, things, in best) : best;
    }

    private int[] Things(string[] names)
    {
        if (names.Length == 0)
        {
            throw Check.Refusal("aim.after", "[]", "the names of one thing or more");
        }

        if (!_things.TryGetValue(names.Length, out int[]? things))
        {
            things = new int[names.Length];
            _things.Add(names.Length, things);
        }

        for (int i = 0; i < names.Length; i++)
        {
            things[i] = Thing(names[i] ?? "null", i);
        }

        return things;
    }

    /// <summary>The thing that is called so, or the k-th of those of one name by "name[k]".</summary>
    private int Thing(string name, int place)
    {
        int found = Find(name, 0, out int same);
        if (same > 1)
        {
            throw Check.Refusal(Check.Item("aim.after", place), name, FormattableString.Invariant($"{name}[0] … {name}[{same - 1}]: the scene has {same} of that name"));
        }

        int bracket = name.LastIndexOf('[');
        if (same == 0 && bracket > 0 && name[^1] == ']'
            && int.TryParse(name.AsSpan(bracket + 1, name.Length - bracket - 2), NumberStyles.None, CultureInfo.InvariantCulture, out int index))
        {
            found = Find(name[..bracket], index, out same);
            same = index < same ? 1 : 0;
        }

        if (same == 0)
        {
            int count = _colliders.Length;
            string known = count == 0 ? "none: the scene has nothing to meet" : string.Join(" | ", Enumerable.Range(_first, count).Select(_simulator.NameOf).Distinct());
            throw Check.Refusal(Check.Item("aim.after", place), name, known);
        }

        return found;
    }

    /// <summary>The index-th thing of a name, and how many there are.</summary>
    private int Find(string name, int index, out int same)
    {
        int found = -1;
        same = 0;
        for (int thing = _first; thing < _first + _colliders.Length; thing++)
        {
            if (_simulator.NameOf(thing) == name && same++ == index)
            {
                found = thing;
            }
        }

        return found;
    }

    /// <summary>A kick that meets nothing, for want of a better one.</summary>
    private static BankShotStart Nothing(AimRequest request, in TargetFrame frame)
    {
        BankShotStart nothing = default;
        nothing.Kick = Kick.Of(request, ElevationBounds.Of(request).Clamp(0.3), 0);
        nothing.Miss = Vector3d.Distance(frame.From, in frame.Target);
        nothing.Position = frame.From;
        return nothing;
    }
}
