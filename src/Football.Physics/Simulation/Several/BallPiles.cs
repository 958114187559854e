namespace FootballPhysics;

/// <summary>The piles of a group in one step, and which ball is of which.</summary>
internal sealed class BallPiles
{
    /// <summary>The number of no pile.</summary>
    private const int NoPile = -1;

    private readonly Simulator[] _simulators;
    private readonly ContactMaterial _contact;
    private readonly double _friction;
    private readonly int[] _pileOf;
    private BallPile[] _piles = [];
    private ClusterRoom? _room;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="contact">What two balls are to each other where they bounce.</param>
    /// <param name="friction">The friction of that, where they press each other.</param>
    public BallPiles(Simulator[] simulators, in ContactMaterial contact, double friction)
    {
        _simulators = simulators;
        _contact = contact;
        _friction = friction;
        _pileOf = new int[simulators.Length];
    }

    /// <summary>How many there are; one that has become a part of another has no balls.</summary>
    public int Count { get; private set; }

    /// <summary>One of them.</summary>
    public BallPile this[int index] => _piles[index];

    /// <summary>Forgets all of them.</summary>
    public void Clear() => Count = 0;

    /// <summary>A ball is of none.</summary>
    public void Leave(int ball) => _pileOf[ball] = NoPile;

    /// <summary>True when a ball is of one.</summary>
    public bool Has(int ball) => _pileOf[ball] >= 0;

    /// <summary>True when two balls are of one.</summary>
    public bool AreOne(int ball, int other) => _pileOf[ball] >= 0 && _pileOf[ball] == _pileOf[other];

    /// <summary>The pile of a ball; null where it is of none.</summary>
    public BallPile? Of(int ball) => _pileOf[ball] < 0 ? null : _piles[_pileOf[ball]];

    /// <summary>A new one.</summary>
    /// <param name="time">When it begins, s.</param>
    /// <param name="step">Length of the step, s.</param>
    public BallPile Begin(double time, double step)
    {
        if (Count == _piles.Length)
        {
            Array.Resize(ref _piles, Count + 1);
            _piles[Count] = new BallPile(_simulators, in _contact, _friction, _room ??= new ClusterRoom());
        }

        BallPile pile = _piles[Count++];
        pile.Clear(time, step);
        return pile;
    }

    /// <summary>A ball becomes one of a pile.</summary>
    public void Add(int ball, ref BallState s, BallPile pile)
    {
        pile.Add(ball, ref s);
        _pileOf[ball] = Array.IndexOf(_piles, pile);
    }

    /// <summary>A pile becomes a part of another, of the same time.</summary>
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

    /// <summary>The pile that comes first to the end of its part; null where all are at a time, s.</summary>
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
