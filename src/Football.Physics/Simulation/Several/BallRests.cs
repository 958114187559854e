namespace Football.Physics;

/// <summary>
/// Which balls lie on each other before a step: those that touch and move are a pile; those that rest lie as long as all are there on which they lean. All of it follows
/// from the states alone: what is kept from step to step only saves asking again.
/// </summary>
internal sealed class BallRests
{
    /// <summary>A ball alone of which this share of the forces on it is not held does not lie on anything.</summary>
    private const double Falls = 0.1;

    private readonly Simulator[] _simulators;
    private readonly Resting[] _resting;
    private readonly int[] _root;
    private readonly bool[] _isPile;
    private readonly bool[] _asks;
    private readonly BallState[] _asked;
    private readonly BallPile _pile;

    public BallRests(Simulator[] simulators, BallPile pile)
    {
        int count = simulators.Length;
        _simulators = simulators;
        _pile = pile;
        _resting = new Resting[count];
        _root = new int[count];
        _isPile = new bool[count];
        _asks = new bool[count];
        _asked = new BallState[count];
    }

    /// <summary>The number of the pile, or of the balls at rest, that a ball is one of: the lowest of its balls.</summary>
    public int RootOf(int ball)
    {
        while (_root[ball] != ball)
        {
            _root[ball] = _root[_root[ball]];
            ball = _root[ball];
        }

        return ball;
    }

    /// <summary>True when a ball is one of a pile that moves.</summary>
    public bool IsInPile(int ball) => _isPile[RootOf(ball)];

    /// <summary>True when a ball rests that other balls hold: by itself it would not.</summary>
    public bool IsHeld(int ball) => _resting[ball].Leans && _resting[ball].Touches && !IsInPile(ball);

    /// <summary>Looks at the balls before a step.</summary>
    /// <returns>Whether any of them moves in a pile.</returns>
    public bool Look(BallState[] states, BallNeighbours neighbours)
    {
        bool any = false;
        for (int i = 0; i < states.Length; i++)
        {
            _root[i] = i;
            _isPile[i] = false;
            _asks[i] = false;
            ref Resting rest = ref _resting[i];
            ref readonly BallState s = ref states[i];
            if (s.Motion != MotionState.Stopped)
            {
                rest.IsKnown = false;
                rest.Leans = false;
            }
            else if (!rest.IsKnown || rest.Position != s.Position)
            {
                Ask(i, states, ref rest);
            }

            rest.On = Vector3d.Zero;
            rest.Touches = false;
        }

        for (int k = 0; k < neighbours.Count; k++)
        {
            (int i, int j) = neighbours[k];
            Join(i, j, states);
        }

        // Those at rest stay so as long as those on which they lean are where they were.
        for (int i = 0; i < states.Length; i++)
        {
            ref Resting rest = ref _resting[i];
            if (rest.Leans && rest.On != rest.Leant)
            {
                _asks[RootOf(i)] = true;
            }
        }

        for (int i = 0; i < states.Length; i++)
        {
            if (_asks[i] && !_isPile[i])
            {
                _isPile[i] = !Holds(i, states);
            }

            any |= _isPile[i];
        }

        return any;
    }

    /// <summary>Two balls that touch: where either moves they are a pile, if they come together or apart gently; at rest they are one where one leans.</summary>
    private void Join(int i, int j, BallState[] states)
    {
        ref readonly BallState a = ref states[i];
        ref readonly BallState b = ref states[j];
        Vector3d apart = a.Position - b.Position;
        double most = _simulators[i].Scene.Ball.Radius + _simulators[j].Scene.Ball.Radius + BallPile.Leaning;
        if (!(apart.LengthSquared <= most * most))
        {
            return;
        }

        if (a.Motion == MotionState.Stopped && b.Motion == MotionState.Stopped)
        {
            if (_resting[i].Leans || _resting[j].Leans)
            {
                _resting[i].On += b.Position;
                _resting[j].On += a.Position;
                _resting[i].Touches = true;
                _resting[j].Touches = true;
                Unite(i, j);
            }

            return;
        }

        double distance = apart.Length;
        double rate = distance > 0 ? Vector3d.Dot(a.Velocity - b.Velocity, in apart) / distance : 0;
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
        int root = Math.Min(a, b);
        bool isPile = _isPile[a] || _isPile[b];
        _root[a] = root;
        _root[b] = root;
        _isPile[root] = isPile;
    }

    /// <summary>Asks whether a ball at rest would stay there without the other balls.</summary>
    private void Ask(int ball, BallState[] states, ref Resting rest)
    {
        rest.IsKnown = true;
        rest.Position = states[ball].Position;
        rest.Leant = new Vector3d(double.NaN, 0, 0);
        rest.Leans = false;
        if (_simulators[ball].World.HangsInNet(in states[ball]))
        {
            return;
        }

        _pile.Clear(states[ball].Time, 0);
        Take(ball, states);
        rest.Unheld = _pile.Unheld(_asked, BallPile.StillHeld, out bool moves);
        rest.Leans = rest.Unheld > 0 && !moves;
    }

    /// <summary>Asks whether balls at rest hold each other.</summary>
    private bool Holds(int root, BallState[] states)
    {
        _pile.Clear(states[root].Time, 0);
        for (int i = root; i < states.Length; i++)
        {
            if (RootOf(i) == root)
            {
                Take(i, states);
            }
        }

        // A ball by itself: what holds it is for the law of one ball to say, but that something does.
        bool holds = _pile.Count == 1 ? !(_resting[root].Unheld > Falls) : HoldsEachOther();
        for (int i = root; i < states.Length && holds; i++)
        {
            if (RootOf(i) == root)
            {
                _resting[i].Leant = _resting[i].On;
            }
        }

        return holds;
    }

    private bool HoldsEachOther()
    {
        _pile.Sort(_asked);
        return _pile.Unheld(_asked, BallPile.StillHeld, out _) == 0;
    }

    private void Take(int ball, BallState[] states)
    {
        _asked[ball] = states[ball];
        _pile.Add(ball, ref _asked[ball]);
    }

    private struct Resting
    {
        /// <summary>Where it was asked, m.</summary>
        public Vector3d Position;

        /// <summary>Sum of the places of the balls that it touches; and what that was when they held each other, m.</summary>
        public Vector3d On;
        public Vector3d Leant;

        /// <summary>Share of the forces on it that nothing but balls can hold.</summary>
        public double Unheld;

        /// <summary>True when it was asked there.</summary>
        public bool IsKnown;

        /// <summary>True when it would not rest without other balls.</summary>
        public bool Leans;

        /// <summary>True when it touches any that rest.</summary>
        public bool Touches;
    }
}
