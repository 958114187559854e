using FootballPhysics.State;

namespace FootballPhysics.Game;

/// <summary>Visits the fields of a state in order, and may change them.</summary>
internal interface IFieldVisitor
{
    /// <summary>Visits a number.</summary>
    void Number(ref double value);

    /// <summary>Visits an enum value.</summary>
    void Member(ref int value);

    /// <summary>Visits flags, an index, or a number that is 0 for a plain ball on a level pitch.</summary>
    void Bits(ref ulong value);
}

/// <summary>The single list of the fields of a <see cref="BallState"/>, used by hash, comparison and serialisation.</summary>
internal static class StateFields
{
    /// <summary>The number of scalars; a test compares it with the struct.</summary>
    public const int Count = 28;

    /// <summary>The number of scalars that are in use; the others are 0.</summary>
    public const int Used = 26;

    // The order of Visit. ClearUntil and AirDistance are numbers, but are visited as bits, because they are 0 for a plain ball.
    private static readonly (string Name, bool IsNumber)[] s_names =
    [
        ("time", true), ("position.x", true), ("position.y", true), ("position.z", true), ("velocity.x", true), ("velocity.y", true), ("velocity.z", true),
        ("motion", false), ("spinAxis.x", true), ("spinAxis.y", true), ("spinAxis.z", true), ("spinRate", true), ("angle", true),
        ("orientation.x", true), ("orientation.y", true), ("orientation.z", true), ("orientation.w", true),
        ("dragRegion", false), ("carrier", false), ("nets", false), ("netSides", false), ("goalsPassed", false), ("clearUntil", true), ("clearIn", false),
        ("airDistance", true), ("goalsEntered", false), ("reserved", false), ("reservedToo", false),
    ];

    /// <summary>Returns the name of a scalar, and true if it is a number rather than flags or an index.</summary>
    public static (string Name, bool IsNumber) NameOf(int field) => s_names[field];

    /// <summary>Returns the index of a name.</summary>
    public static int IndexOf(string name) => Array.FindIndex(s_names, field => field.Name == name);

    /// <summary>Visits every scalar, in a fixed order.</summary>
    public static void Visit<TVisitor>(ref BallState state, ref TVisitor visitor)
        where TVisitor : struct, IFieldVisitor
    {
        // Read each property, visit it and write it back, so that a visitor's changes are kept.
        double time = state.Time;
        visitor.Number(ref time);
        state.Time = time;
        state.Position = Vector(state.Position, ref visitor);
        state.Velocity = Vector(state.Velocity, ref visitor);
        int motion = (int)state.Motion;
        visitor.Member(ref motion);
        state.Motion = (MotionState)motion;
        state.SpinAxis = Vector(state.SpinAxis, ref visitor);
        visitor.Number(ref state.Flight.SpinRate);
        visitor.Number(ref state.Angle);
        state.BaseOrientation = Rotation(state.BaseOrientation, ref visitor);
        int branch = (int)state.Branch;
        visitor.Member(ref branch);
        state.Branch = (DragBranch)branch;
        ulong carrier = (ulong)state.Carrier;
        visitor.Bits(ref carrier);
        state.Carrier = (long)carrier;
        visitor.Bits(ref state.Nets);
        visitor.Bits(ref state.NetSides);
        visitor.Bits(ref state.GoalsPassed);
        Bits(ref state.ClearUntil, ref visitor);
        visitor.Bits(ref state.ClearIn);
        Bits(ref state.AirDistance, ref visitor);
        visitor.Bits(ref state.GoalsEntered);
        visitor.Bits(ref state.Reserved);
        visitor.Bits(ref state.ReservedToo);
    }

    /// <summary>Copies the bits of a state into words.</summary>
    public static unsafe void Read(in BallState state, Span<ulong> words)
    {
        BallState copy = state;
        fixed (ulong* first = words)
        {
            var reader = new Reader { Next = first };
            Visit(ref copy, ref reader);
        }
    }

    /// <summary>Sets the bits of a state without validation; see <see cref="StateCheck"/>.</summary>
    public static unsafe void Write(Span<ulong> words, ref BallState state)
    {
        fixed (ulong* first = words)
        {
            var writer = new Writer { Next = first };
            Visit(ref state, ref writer);
        }
    }

    /// <summary>Visits a number that is 0 for a plain ball on a level pitch.</summary>
    private static void Bits<TVisitor>(ref double value, ref TVisitor visitor)
        where TVisitor : struct, IFieldVisitor
    {
        ulong bits = (ulong)BitConverter.DoubleToInt64Bits(value);
        visitor.Bits(ref bits);
        value = BitConverter.Int64BitsToDouble((long)bits);
    }

    private static Vector3d Vector<TVisitor>(Vector3d value, ref TVisitor visitor)
        where TVisitor : struct, IFieldVisitor
    {
        double x = value.X;
        double y = value.Y;
        double z = value.Z;
        visitor.Number(ref x);
        visitor.Number(ref y);
        visitor.Number(ref z);
        return new Vector3d(x, y, z);
    }

    private static Quaterniond Rotation<TVisitor>(Quaterniond value, ref TVisitor visitor)
        where TVisitor : struct, IFieldVisitor
    {
        double x = value.X;
        double y = value.Y;
        double z = value.Z;
        double w = value.W;
        visitor.Number(ref x);
        visitor.Number(ref y);
        visitor.Number(ref z);
        visitor.Number(ref w);
        return new Quaterniond(x, y, z, w);
    }

    private unsafe struct Reader : IFieldVisitor
    {
        public ulong* Next;

        public void Number(ref double value) => *Next++ = (ulong)BitConverter.DoubleToInt64Bits(value);

        public void Member(ref int value) => *Next++ = (uint)value;

        public void Bits(ref ulong value) => *Next++ = value;
    }

    private unsafe struct Writer : IFieldVisitor
    {
        public ulong* Next;

        public void Number(ref double value) => value = BitConverter.Int64BitsToDouble((long)*Next++);

        public void Member(ref int value)
        {
            // No enum value is that large or negative: return −1, because StateCheck rejects it.
            ulong word = *Next++;
            value = word <= int.MaxValue ? (int)word : -1;
        }

        public void Bits(ref ulong value) => value = *Next++;
    }
}
