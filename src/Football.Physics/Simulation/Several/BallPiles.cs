using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>The piles of a group in one step, and the pile of each ball.</summary>
internal sealed class BallPiles
{
    /// <summary>The index for no pile.</summary>
    private const int NoPile = -1;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly double _friction;
    private readonly int[] _pileOf;
    private BallPile[] _piles = [];

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">The material of impacts between balls.</param>
    /// <param name="friction">The friction coefficient of sustained contact between balls.</param>
    public BallPiles(Simulator[] simulators, in ContactMaterial contact, double friction)
    {
        _simulators = simulators;
        _contact = contact;
        _friction = friction;
        _pileOf = new int[simulators.Length];
    }

    /// <summary>Number of piles. A pile merged into another has no balls.</summary>
    public int Count { get; private set; }

    /// <summary>Returns a pile.</summary>
    public BallPile this[int index] => _piles[index];

    /// <summary>Removes all piles.</summary>
    public void Clear() => Count = 0;

    /// <summary>Marks a ball as outside all piles.</summary>
    public void Leave(int ball) => _pileOf[ball] = NoPile;

    /// <summary>True if a ball is in a pile.</summary>
    public bool Has(int ball) => _pileOf[ball] >= 0;

    /// <summary>True if two balls are in the same pile.</summary>
    public bool AreOne(int ball, int other) => _pileOf[ball] >= 0 && _pileOf[ball] == _pileOf[other];

    /// <summary>Returns the pile of a ball; null if it is in none.</summary>
    public BallPile? Of(int ball) => _pileOf[ball] < 0 ? null : _piles[_pileOf[ball]];

    /// <summary>Starts a new pile.</summary>
    /// <param name="time">Its start time, s.</param>
    /// <param name="step">Length of the step, s.</param>
    public BallPile Begin(double time, double step)
    {
        if (Count == _piles.Length)
        {
            Array.Resize(ref _piles, Count + 1);
            _piles[Count] = new BallPile(_simulators, in _contact, _friction);
        }

        BallPile pile = _piles[Count++];
        pile.Clear(time, step);
        return pile;
    }

    /// <summary>Adds a ball to a pile.</summary>
    public void Add(int ball, ref BallState s, BallPile pile)
    {
        pile.Add(ball, ref s);
        _pileOf[ball] = Array.IndexOf(_piles, pile);
    }

    /// <summary>Merges a pile into another at the same time.</summary>
    public void Unite(BallPile pile, BallPile other, BallState[] states, double step)
    {
        int number = Array.IndexOf(_piles, pile);
        for (int m = 0; m < other.Count; m++)
        {
            _pileOf[other[m]] = number;
        }

        pile.Absorb(other);
        other.Clear(other.Time, step);
        pile.Sort(states);
    }

    /// <summary>Returns the pile whose part ends first; null if all have reached a time, s.</summary>
    public BallPile? First(double end)
    {
        BallPile? first = null;
        for (int k = 0; k < Count; k++)
        {
            BallPile pile = _piles[k];
            first = pile.Count > 0 && pile.Time < end && !(first?.Until <= pile.Until) ? pile : first;
        }

        return first;
    }
}
