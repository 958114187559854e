using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Caches the states of resting balls that a step left unchanged while no object moved.</summary>
/// <remarks>
/// A step from such a state only advances the time, until the game moves a body or an impact pushes an object.
/// </remarks>
internal sealed unsafe class KnownRests
{
    /// <summary>Number of cache slots, a power of two. Several balls can share a stepper.</summary>
    private const int Slots = 16;

    private readonly World _world;

    // A ball that was launched never has the zero state of an empty slot.
    private readonly BallState[] _states = new BallState[Slots];
    private readonly long[] _versions = new long[Slots];

    public KnownRests(World world) => _world = world;

    /// <summary>True if a step from this state changes only the time.</summary>
    public bool Has(in BallState s)
    {
        int slot = SlotOf(in s);
        return _versions[slot] == _world.MotionVersion && AreSame(in _states[slot], in s);
    }

    /// <summary>Stores the state of a ball that a step left unchanged, if no object moves.</summary>
    /// <param name="before">The ball before the step, at rest.</param>
    /// <param name="after">The ball after the step.</param>
    public void Learn(in BallState before, in BallState after)
    {
        if (AreSame(in before, in after) && !_world.IsMoving)
        {
            int slot = SlotOf(in after);
            _states[slot] = after;
            _versions[slot] = _world.MotionVersion;
        }
    }

    private static int SlotOf(in BallState s)
    {
        long bits = BitConverter.DoubleToInt64Bits(s.Position.X) ^ (BitConverter.DoubleToInt64Bits(s.Position.Z) << 1) ^ BitConverter.DoubleToInt64Bits(s.Position.Y);
        return (int)(((ulong)bits * 0x9E3779B97F4A7C15UL) >> 60) & (Slots - 1);
    }

    /// <summary>True if two states differ only in their times.</summary>
    /// <remarks>A state has no padding, and the time is its first field.</remarks>
    private static bool AreSame(in BallState a, in BallState b)
    {
        fixed (BallState* first = &a, second = &b)
        {
            int rest = sizeof(BallState) - sizeof(double);
            return new Span<byte>((double*)first + 1, rest).SequenceEqual(new Span<byte>((double*)second + 1, rest));
        }
    }
}
