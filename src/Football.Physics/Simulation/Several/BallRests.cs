using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Finds the balls in sustained contact with each other before a step.</summary>
/// <remarks>
/// Touching balls that move form a pile. Balls that came to rest in a pile stay at rest while all their contacts remain. Each ball stores a
/// key of its
/// contacts in its state, so that no other memory is needed. The key includes touched objects that a game, an engine or an impact may move.
/// </remarks>
internal sealed class BallRests
{
    private readonly Simulator[] _simulators;
    private readonly double[] _radii;
    private readonly int[] _root;
    private readonly bool[] _isPile;
    private readonly ulong[] _keys;

    /// <param name="simulators">The scenes of all balls.</param>
    /// <param name="radii">The radii of all balls, m.</param>
    public BallRests(Simulator[] simulators, double[] radii)
    {
        _simulators = simulators;
        _radii = radii;
        _root = new int[radii.Length];
        _isPile = new bool[radii.Length];
        _keys = new ulong[radii.Length];
    }

    /// <summary>Returns the lowest index among the balls connected to a ball.</summary>
    public int RootOf(int ball)
    {
        while (_root[ball] != ball)
        {
            _root[ball] = _root[_root[ball]];
            ball = _root[ball];
        }

        return ball;
    }

    /// <summary>True if a ball is in a pile that moves.</summary>
    public bool IsInPile(int ball) => _isPile[RootOf(ball)];

    /// <summary>True if a ball rests in a pile.</summary>
    public bool IsHeld(int ball) => _keys[ball] != 0 && !IsInPile(ball);

    /// <summary>Processes the balls before a step.</summary>
    public void Look(BallState[] states, BallNeighbours neighbours)
    {
        for (int i = 0; i < states.Length; i++)
        {
            // An engine may have moved its colliders since the last step, and a pile takes no step of its own that looks again.
            World world = _simulators[i].World;
            world.Engine?.Forget();
            _root[i] = i;
            _isPile[i] = false;
            _keys[i] = states[i].RestsInPile ? FirstKey + KeyOfMovers(world, in states[i]) : 0;
        }

        for (int k = 0; k < neighbours.Count; k++)
        {
            (int i, int j) = neighbours[k];
            Join(i, j, states);
        }

        for (int i = 0; i < states.Length; i++)
        {
            // A ball of the pile was removed or woke, or an object near the pile has moved, so all balls of the pile may move.
            if (_keys[i] != 0 && _keys[i] != states[i].ClearIn)
            {
                _isPile[RootOf(i)] = true;
            }
        }
    }

    /// <summary>Connects two touching balls.</summary>
    /// <remarks>If either moves, they form a pile if their relative speed is low. At rest they are connected if both came to rest in a
    /// pile.</remarks>
    private void Join(int i, int j, BallState[] states)
    {
        ref readonly BallState a = ref states[i];
        ref readonly BallState b = ref states[j];
        if (!Touches(in a, _radii[i], in b, _radii[j]))
        {
            return;
        }

        if (a.Motion == MotionState.Rest && b.Motion == MotionState.Rest)
        {
            if (_keys[i] != 0 && _keys[j] != 0)
            {
                _keys[i] += KeyOf(b.Position);
                _keys[j] += KeyOf(a.Position);
                Unite(i, j);
            }

            return;
        }

        BallContact.Gap(in a, _radii[i], in b, _radii[j], out _, out double rate);
        if (Math.Abs(rate) <= BallContact.Gentle)
        {
            Unite(i, j);
            _isPile[RootOf(i)] = true;
        }
    }

    private void Unite(int i, int j)
    {
        int a = RootOf(i);
        int b = RootOf(j);
        bool isPile = _isPile[a] || _isPile[b];
        int root = Math.Min(a, b);
        _root[a] = root;
        _root[b] = root;
        _isPile[root] = isPile;
    }

    /// <summary>True if two balls touch.</summary>
    public static bool Touches(in BallState a, double radius, in BallState b, double other)
    {
        double most = radius + other + ContactTolerances.Leaning;
        return (a.Position - b.Position).LengthSquared <= most * most;
    }

    /// <summary>The key of no contact; the keys of all touched balls are added to it.</summary>
    /// <remarks>The key is even and nonzero, because keys of scenes are odd.</remarks>
    public const ulong FirstKey = 1UL << 63;

    /// <summary>Returns the key of a resting ball by its position, or of an object by its normal.</summary>
    public static ulong KeyOf(in Vector3d position)
    {
        var key = default(ClearKey);
        key.Add(in position);
        return key.Value << 1;
    }

    /// <summary>True if balls can rest on a surface: it is stationary in this step, and the ball is not inside it (contact.md,
    /// Rest).</summary>
    /// <param name="contact">The contact with the surface.</param>
    /// <param name="collider">Its object.</param>
    public static bool Bears(in Contact contact, Collider collider) =>
        !contact.Moves || (collider.StandsStill && contact.Gap >= -ContactTolerances.Leaning);

    /// <summary>Returns the key of touched objects that are stationary in this step but may move in another one.</summary>
    [SkipLocalsInit]
    public static ulong KeyOfMovers(World world, in BallState s)
    {
        ulong key = 0;
        if (world.Moves)
        {
            Span<Contact> room = stackalloc Contact[ContactSet.Room];
            foreach (ref readonly Contact contact in ContactSet.Near(world, in s, ContactTolerances.Leaning, room, world.Room))
            {
                key += contact.Moves && Bears(in contact, world.ByIndex[contact.Collider]) ? KeyOf(in contact.Normal) : 0;
            }
        }

        return key;
    }
}
