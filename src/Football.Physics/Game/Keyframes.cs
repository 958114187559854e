namespace FootballPhysics;

/// <summary>The whole state of a match at equal distances in time, from which a segment is played on: balls, bodies, and obstacles that have a mass.</summary>
internal sealed class Keyframes(int balls, int movers)
{
    private BallState[] _states = [];
    private RigidMotion[] _motions = [];

    /// <summary>How many there are.</summary>
    public int Count { get; private set; }

    /// <summary>The states of one.</summary>
    public Span<BallState> StatesOf(int index) => _states.AsSpan(index * balls, balls);

    /// <summary>Where all is that is moved, of one.</summary>
    public Span<RigidMotion> MotionsOf(int index) => _motions.AsSpan(index * movers, movers);

    /// <summary>Adds one.</summary>
    public void Add(BallState[] states, World world)
    {
        Grow();
        states.CopyTo(StatesOf(Count - 1));
        if (movers > 0)
        {
            world.ReadMotions(MotionsOf(Count - 1));
        }
    }

    /// <summary>Forgets all but the first ones.</summary>
    public void Keep(int count) => Count = Math.Min(Count, count);

    /// <summary>Writes all.</summary>
    public void Write(ref ByteWriter writer)
    {
        writer.Integer((ulong)Count);
        for (int i = 0; i < Count; i++)
        {
            foreach (ref BallState state in StatesOf(i))
            {
                writer.State(in state);
            }

            foreach (ref RigidMotion motion in MotionsOf(i))
            {
                PlacementLog.Write(in motion, ref writer);
            }
        }
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    public void Read(ref ByteReader reader)
    {
        // The least that a keyframe takes: states in full, motions whose numbers are all left out.
        for (int count = reader.Count((Snapshot.Size * balls) + (5 * movers)); count > 0; count--)
        {
            Grow();
            foreach (ref BallState state in StatesOf(Count - 1))
            {
                state = reader.State();
            }

            foreach (ref RigidMotion motion in MotionsOf(Count - 1))
            {
                motion = PlacementLog.ReadMotion(ref reader);
            }
        }
    }

    private void Grow()
    {
        Count++;
        if (Count * balls > _states.Length)
        {
            // Both grow alike, so that a keyframe has the same place in each.
            int room = Math.Max(16, 2 * (Count - 1));
            Array.Resize(ref _states, room * balls);
            Array.Resize(ref _motions, room * movers);
        }
    }
}
