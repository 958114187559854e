using System.Globalization;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Finds kicks that hit given objects before the target, such as the ground, a wall or a post.</summary>
/// <remarks>
/// The search divides a kick into legs: from the ball to an estimated first contact, on to the next contacts, and finally to the target. Newton's method
/// adjusts the kick and the contacts until all legs join (multiple shooting); the result is then simulated. If it is not a hit, the search tries kicks in all
/// directions. Create one per scene and reuse it: searches do not allocate. Not thread-safe.
/// </remarks>
public sealed class BankShotAimer
{
    /// <summary>The step of a leg, as a multiple of the step of a measurement.</summary>
    private const double LegStep = 4;

    /// <summary>The difference below which two kicks count as the same, in rad.</summary>
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

    /// <summary>The leg problems, by their number of contacts.</summary>
    private readonly Dictionary<int, BankShotProblem> _chains = [];

    /// <summary>Buffers for the objects to hit, by their number.</summary>
    private readonly Dictionary<int, int[]> _things = [];
    private int _flown;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
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

    /// <summary>Finds a kick that hits given objects before the target.</summary>
    /// <param name="request">
    /// The request, without a waypoint, for a target at rest: start, target, speed, spin, elevations, tolerance and time of the kick.
    /// <see cref="AimRequest.MaximumIterations"/> limits the iterations from each of many starts.
    /// </param>
    /// <param name="after">The names of the objects to hit first, in order, such as "ground", "left post" or "crossbar"; at least one. If several
    /// objects share a name, "left post[0]" is the first and "left post[1]" the second. They are numbered in the order of the obstacles and goals in the
    /// scene.</param>
    /// <returns>The best kick found. A hit passes within tolerance of the target after exactly these impacts. Any other result is "not converged": other kicks
    /// may still hit.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, no object is given, or a name matches no object of the scene, or several. The
    /// message lists the names in the scene.</exception>
    public AimResult Find(AimRequest request, params string[] after)
    {
        Check.Given(nameof(request), request);
        Check.Given("aim.after", after);
        request.Validate();
        if (request.Waypoint is not null)
        {
            throw Check.Conflict("aim.waypoint", "aim.waypoint cannot be combined with aim.after. Leave one of them unset.");
        }

        if (request.TargetVelocity != Vector3d.Zero)
        {
            throw Check.Conflict("aim.targetVelocity", "aim.targetVelocity cannot be combined with aim.after. Leave one of them unset.");
        }

        // 1. From several guesses, solve the legs from contact to contact; then correct each kick for its miss. 2. If none hits, search over all directions.
        int[] things = Things(after);
        var frame = new TargetFrame(AimContext.Raised(_simulator, request.From), AimContext.Raised(_simulator, request.Target), AimContext.OrientationOf(_simulator, request));
        _flight.Begin(request, in frame, things);
        FlyChains(request, in frame, things);
        if (!_flight.Hits)
        {
            _grid.Find(request, in frame, things);
        }

        _flight.Best.Vectors(request.Speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        AimReason reason = _flight.Hits ? AimReason.Hit : AimReason.NoSequence;
        return new AimResult(reason, in velocity, in spin, _flight.Miss, AimArc.Low, rolls: false, _flight.Iterations, _flight.Simulations, blockedBy: null);
    }

    /// <summary>Solves kicks from guesses of their contacts, and corrects them by their miss.</summary>
    private void FlyChains(AimRequest request, in TargetFrame frame, int[] things)
    {
        // For each guess, close the gaps as far as possible. The full flight, with nets, corrects the rest.
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

    /// <summary>Sets up the legs from object to object.</summary>
    private BankShotProblem Legs(int[] things)
    {
        // A leg includes its bounces on the ground; only the other objects are contacts.
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

    /// <summary>True if the kick differs from all earlier ones; it is then stored.</summary>
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

    /// <summary>Returns the object with a name, or for "name[k]" the k-th of several objects with that name.</summary>
    private int Thing(string name, int place)
    {
        int found = Find(name, 0, out int same);
        if (same > 1)
        {
            throw Check.Refusal(Check.Item("aim.after", place), name, FormattableString.Invariant($"{name}[0] … {name}[{same - 1}], because the scene has {same} colliders with this name"));
        }

        // "name[k]" means the k-th object with that name, unless an object has exactly this name.
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

    /// <summary>Returns the index-th object with a name, and the number of objects with that name.</summary>
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
