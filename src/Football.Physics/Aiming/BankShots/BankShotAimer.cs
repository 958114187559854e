using System.Globalization;

namespace FootballPhysics.Aiming;

/// <summary>Finds kicks that reach a target after bounces, and off named things: one bounce and in, off the wall, in off the post.</summary>
/// <remarks>
/// A kick is put together from legs: from the ball to a guess of where it touches the first thing, from there on, and to the target. Newton's method moves the kick and
/// the places until all legs meet (multiple shooting), and what is found is flown. Where that leads to no hit, kicks are tried over all directions. Made once for a scene
/// and used again, without allocating. Not for several threads at once.
/// </remarks>
public sealed class BankShotAimer
{
    /// <summary>Step of a leg in steps of a measurement.</summary>
    private const double LegStep = 4;

    /// <summary>Kicks are the same that differ by less than this, rad.</summary>
    private const double Same = 1e-3;

    private readonly Simulator _simulator;
    private readonly Collider[] _colliders;
    private readonly Collider? _ground;
    private readonly int _first;
    private readonly BankShotFlight _flight;
    private readonly Simulator _open;
    private readonly Simulator _grounded;
    private readonly BankShotGuess _guess;
    private readonly BankShotGrid _grid;
    private readonly Kick[] _kicks = new Kick[BankShotGuess.Count];

    /// <summary>Chains, by how many contacts they have.</summary>
    private readonly Dictionary<int, BankShotProblem> _chains = [];

    /// <summary>The chains of things to be met, by their length.</summary>
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
        Scene empty = AimContext.WithoutThings(made);
        _grounded = new Simulator(empty);
        _open = new Simulator(AimContext.WithoutGround(empty));
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
        if (request.Waypoint is not null)
        {
            throw Check.Conflict("aim.waypoint", "aim.waypoint cannot be combined with aim.after. Leave one of them unset.");
        }

        // 1. Chains of legs from several guesses, closed and then corrected by what they miss. 2. Where none hits, kicks over all directions.
        int[] things = Things(after);
        var frame = new TargetFrame(AimContext.Raised(_simulator, request.From), AimContext.Raised(_simulator, request.Target));
        _flight.Begin(request, in frame, things);
        FlyChains(request, in frame, things);
        if (!_flight.Hits)
        {
            _grid.Find(request, in frame, things);
        }

        _flight.Best.Vectors(request.Speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        AimStatus status = _flight.Hits ? AimStatus.Hit : AimStatus.NotConverged;
        return new AimResult(status, in velocity, in spin, _flight.Miss, AimArc.Low, rolls: false, _flight.Iterations, _flight.Simulations, blockedBy: null);
    }

    /// <summary>Puts kicks together from where they may touch things, and corrects them by what they miss.</summary>
    private void FlyChains(AimRequest request, in TargetFrame frame, int[] things)
    {
        // Each guess is closed as far as it goes: what is left open, a net on the way may close.
        BankShotProblem legs = Legs(things);
        _flown = 0;
        for (int i = 0; i < BankShotGuess.Count && !_flight.Hits; i++)
        {
            if (!_guess.Make(legs, _ground, request, in frame, i, out Kick kick))
            {
                continue;
            }

            legs.Close(request, in frame, in kick, LegStep * _flight.FineStep, _flight);
            if (IsNew(legs.Kick))
            {
                _flight.Improve(legs.Kick.Elevation, legs.Kick.Azimuth);
            }
        }
    }

    /// <summary>The legs that lead over things.</summary>
    private BankShotProblem Legs(int[] things)
    {
        // Bounces off the ground belong to the leg that makes them: only other things are places of their own.
        int contacts = 0;
        foreach (int thing in things)
        {
            contacts += _colliders[thing - _first] == _ground ? 0 : 1;
        }

        if (!_chains.TryGetValue(contacts, out BankShotProblem? legs))
        {
            legs = new BankShotProblem(_open, _grounded, contacts);
            _chains.Add(contacts, legs);
        }

        int leg = 0;
        Array.Clear(legs.Bounces, 0, contacts + 1);
        foreach (int index in things)
        {
            Collider thing = _colliders[index - _first];
            if (thing == _ground)
            {
                legs.Bounces[leg]++;
            }
            else
            {
                legs.Contacts[leg++].Thing = thing;
            }
        }

        return legs;
    }

    /// <summary>True when no chain has led to a kick before; it is then remembered.</summary>
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

    private int[] Things(string[] names)
    {
        if (names.Length == 0)
        {
            throw Check.Refusal("aim.after", "[]", "at least one name of a collider");
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
            throw Check.Refusal(Check.Item("aim.after", place), name, FormattableString.Invariant($"{name}[0] … {name}[{same - 1}], because the scene has {same} colliders with this name"));
        }

        // "name[k]" is the k-th of that name, unless a thing is called just so.
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
            string known = count == 0 ? "none, because the scene has no colliders" : string.Join(" | ", Enumerable.Range(_first, count).Select(_simulator.NameOf).Distinct());
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
}
