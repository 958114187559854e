using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Game;

/// <summary>Complete match states at regular intervals, from which a replay can continue: balls, bodies and movable obstacles.</summary>
internal sealed class Keyframes(int balls, int movers)
{
    private BallState[] _states = [];
    private RigidMotion[] _motions = [];

    /// <summary>The number of keyframes.</summary>
    public int Count { get; private set; }

    /// <summary>Returns the ball states of a keyframe.</summary>
    public Span<BallState> StatesOf(int index) => _states.AsSpan(index * balls, balls);

    /// <summary>Returns the motions of bodies and movable obstacles in a keyframe.</summary>
    public Span<RigidMotion> MotionsOf(int index) => _motions.AsSpan(index * movers, movers);

    /// <summary>Adds a keyframe.</summary>
    public void Add(BallState[] states, World world)
    {
        Grow();
        states.CopyTo(StatesOf(Count - 1));
        world.ReadMotions(MotionsOf(Count - 1));
    }

    /// <summary>Removes all keyframes after the first <c>count</c>.</summary>
    public void Keep(int count) => Count = Math.Min(Count, count);

    /// <summary>Writes all keyframes.</summary>
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

    /// <summary>Reads keyframes written by <see cref="Write"/>.</summary>
    public void Read(ref ByteReader reader)
    {
        // The smallest keyframe has full states, and motions that consist of zeros only, which are omitted.
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
            // Grow both arrays together, so that a keyframe has the same index in both.
            int room = Math.Max(16, 2 * (Count - 1));
            Array.Resize(ref _states, room * balls);
            Array.Resize(ref _motions, room * movers);
        }
    }
}
