using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Caches the contact time of each pair of balls in a cluster, until the path of one of them changes.</summary>
internal sealed class BallMeetings
{
    private readonly BallTrial[] _trials;
    private readonly double[] _radii;
    private readonly int[] _changes;
    private Pair[] _pairs = new Pair[16];
    private bool _isOld = true;

    /// <param name="trials">The paths of all balls of the group.</param>
    /// <param name="radii">Their radii, m.</param>
    public BallMeetings(BallTrial[] trials, double[] radii)
    {
        _trials = trials;
        _radii = radii;
        _changes = new int[radii.Length];
    }

    /// <summary>Number of pairs that may collide.</summary>
    public int Count { get; private set; }

    /// <summary>The first ball of a pair.</summary>
    public int First(int pair) => _pairs[pair].Ball;

    /// <inheritdoc cref="First"/>
    public int Second(int pair) => _pairs[pair].Other;

    /// <summary>Marks the pairs as outdated.</summary>
    public void Forget() => _isOld = true;

    /// <summary>True if two balls with given reaches in this step may touch, m.</summary>
    public bool MayMeet(BallState[] before, int ball, double reach, int other, double otherReach)
    {
        double most = reach + otherReach + _radii[ball] + _radii[other] + ContactTolerances.Touching;
        return (before[ball].Position - before[other].Position).LengthSquared <= most * most;
    }

    /// <summary>Finds the pairs that may collide, in the order of the balls, if they are outdated.</summary>
    /// <param name="balls">The balls of the cluster.</param>
    /// <param name="count">Their number.</param>
    /// <param name="before">All balls before the step.</param>
    /// <param name="reaches">Upper bound of each ball's displacement in the step, m.</param>
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

    /// <summary>Marks the path of a ball as changed.</summary>
    public void Change(int ball) => _changes[ball]++;

    private void Add(int ball, int other)
    {
        if (Count == _pairs.Length)
        {
            Array.Resize(ref _pairs, 2 * Count);
        }

        _pairs[Count++] = new Pair { Ball = ball, Other = other, Changes = -1 };
    }

    /// <summary>Returns the time at which a pair touches, s; infinite if it does not.</summary>
    /// <param name="pair">Index of the pair.</param>
    /// <param name="until">The time up to which their paths are known, s.</param>
    /// <param name="atEnd">Whether to include a contact exactly at that time.</param>
    public double TimeOf(int pair, double until, bool atEnd)
    {
        ref Pair known = ref _pairs[pair];

        // The sum changes if either path changes.
        int changes = _changes[known.Ball] + _changes[known.Other];
        if (known.Changes != changes)
        {
            BallTrial mine = _trials[known.Ball];
            BallTrial its = _trials[known.Other];
            known.Changes = changes;
            known.Time = mine.Meets(its, _radii[known.Ball] + _radii[known.Other], Math.Max(mine.From, its.From), until, atEnd);
        }

        return known.Time;
    }

    private struct Pair
    {
        public int Ball;
        public int Other;

        /// <summary>Number of path changes at the last search; −1 if there was none.</summary>
        public int Changes;

        /// <summary>Contact time, s.</summary>
        public double Time;
    }
}
