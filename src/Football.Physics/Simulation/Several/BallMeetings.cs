namespace FootballPhysics;

/// <summary>When the balls of a cluster meet, pair by pair: of those whose ways have not changed since it was asked, what was found then holds.</summary>
internal sealed class BallMeetings
{
    private readonly BallTrial[] _trials;
    private readonly double[] _radii;
    private readonly int[] _changes;
    private Pair[] _pairs = new Pair[16];
    private bool _isOld = true;

    /// <param name="trials">The ways of all balls of the group.</param>
    /// <param name="radii">Their radii, m.</param>
    public BallMeetings(BallTrial[] trials, double[] radii)
    {
        _trials = trials;
        _radii = radii;
        _changes = new int[radii.Length];
    }

    /// <summary>How many pairs may meet.</summary>
    public int Count { get; private set; }

    /// <summary>The balls of a pair.</summary>
    public int First(int pair) => _pairs[pair].Ball;

    /// <inheritdoc cref="First"/>
    public int Second(int pair) => _pairs[pair].Other;

    /// <summary>Others may meet than before.</summary>
    public void Forget() => _isOld = true;

    /// <summary>True when two balls may meet that get so far in the step, m.</summary>
    public bool MayMeet(BallState[] before, int ball, double reach, int other, double otherReach)
    {
        double most = reach + otherReach + _radii[ball] + _radii[other] + ContactSearch.Touching;
        return (before[ball].Position - before[other].Position).LengthSquared <= most * most;
    }

    /// <summary>Finds the pairs that may meet, in the order of the balls, where that may have changed.</summary>
    /// <param name="balls">The balls of the cluster.</param>
    /// <param name="count">How many they are.</param>
    /// <param name="before">All balls before the step.</param>
    /// <param name="reaches">Not less than how far each gets in it, m.</param>
    public void Find(int[] balls, int count, BallState[] before, double[] reaches)
    {
        if (!_isOld)
        {
            return;
        }

        _isOld = false;
        Count = 0;
        for (int a = 0; a < count; a++)
        {
            int i = balls[a];
            for (int b = 0; b < count; b++)
            {
                int j = balls[b];
                if (j > i && MayMeet(before, i, reaches[i], j, reaches[j]))
                {
                    Add(i, j);
                }
            }
        }
    }

    /// <summary>A ball goes another way than before.</summary>
    public void Change(int ball) => _changes[ball]++;

    private void Add(int ball, int other)
    {
        if (Count == _pairs.Length)
        {
            Array.Resize(ref _pairs, 2 * Count);
        }

        _pairs[Count++] = new Pair { Ball = ball, Other = other, Asked = -1 };
    }

    /// <summary>When the two of a pair meet, s; infinite where they do not.</summary>
    /// <param name="pair">Which.</param>
    /// <param name="until">Until when their ways are known, s.</param>
    /// <param name="atEnd">Whether what is there at that very time counts.</param>
    public double TimeOf(int pair, double until, bool atEnd)
    {
        ref Pair asked = ref _pairs[pair];

        // The sum changes whenever either path changes.
        int changes = _changes[asked.Ball] + _changes[asked.Other];
        if (asked.Asked != changes)
        {
            BallTrial mine = _trials[asked.Ball];
            BallTrial its = _trials[asked.Other];
            asked.Asked = changes;
            asked.Time = mine.Meets(its, _radii[asked.Ball] + _radii[asked.Other], Math.Max(mine.From, its.From), until, atEnd);
        }

        return asked.Time;
    }

    private struct Pair
    {
        public int Ball;
        public int Other;

        /// <summary>How often their ways had changed when it was asked; −1 where it was not.</summary>
        public int Asked;

        /// <summary>When they meet, s.</summary>
        public double Time;
    }
}
