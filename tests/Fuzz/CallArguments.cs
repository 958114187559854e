using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Native;

namespace FootballPhysics.Fuzz;

/// <summary>The memory of a program that calls C: balls, scenes, and the arrays that a call reads and writes. It keeps the contract of the header: an array has the promised length.</summary>
internal sealed unsafe class CallArguments
{
    private const int Balls = 8;

    /// <summary>The largest count of balls, rows and events. A call starts at one of the first balls, so that all of them exist.</summary>
    private const int MostRows = 4;

    private const int Slots = 13;
    private const int SlotSize = 4096;
    private const int Null = 0xFF;
    private const int Wild = 0xFE;
    private const int Changed = 0xF8;
    private const int LastHandle = 0x20;
    private const double MostSteps = 400;
    private const double LongestRow = 10;

    /// <summary>Balls first, then one slot for each argument.</summary>
    private static readonly byte* s_memory = (byte*)NativeMemory.AllocZeroed((nuint)Size);

    private readonly ProgramBytes _program;
    private readonly string[] _texts;
    private readonly string[] _requests;
    private readonly List<nint> _scenes = [0];
    private readonly List<nint> _matches = [0];
    private readonly List<nint> _filters = [0];
    private readonly byte[] _before = new byte[Size];
    private readonly byte[] _snapshot = new byte[Snapshot.Size];
    private byte[] _saved = [];
    private int _text;

    public CallArguments(ProgramBytes program, string[] texts, string[] requests)
    {
        (_program, _texts, _requests) = (program, texts, requests);
        new Span<byte>(s_memory, Size).Clear();
    }

    private static int Size => (Balls * sizeof(NativeState)) + (Slots * SlotSize);

    /// <summary>The handles that the program got; some are freed.</summary>
    public IReadOnlyList<nint> Scenes => _scenes;

    /// <summary>The same for matches.</summary>
    public IReadOnlyList<nint> Matches => _matches;

    /// <summary>The handles of filters.</summary>
    public IReadOnlyList<nint> Filters => _filters;

    /// <summary>Reads the arguments of a call.</summary>
    public long[] Of(NativeCall call)
    {
        long[] values = [.. call.Parameters.Select((parameter, i) => Value(parameter, s_memory + (Balls * sizeof(NativeState)) + (i * SlotSize)))];
        Shorten(call, values);
        new Span<byte>(s_memory, Size).CopyTo(_before);
        return values;
    }

    /// <summary>Checks what a call wrote.</summary>
    /// <param name="call">The call.</param>
    /// <param name="values">Its arguments.</param>
    /// <param name="isDone">False if it was rejected: then it changes nothing.</param>
    public void Check(NativeCall call, long[] values, bool isDone)
    {
        // Undo the writes that are allowed; nothing else may differ.
        byte[] after = new Span<byte>(s_memory, Size).ToArray();
        byte[] rest = [.. after];
        for (int i = 0; i < values.Length; i++)
        {
            ParameterInfo parameter = call.Parameters[i];
            if (values[i] != 0 && IsWritten(parameter, isDone))
            {
                int at = (int)(values[i] - (nint)s_memory);
                int length = Length(parameter, Count(call, values, parameter));
                _before.AsSpan(at, length).CopyTo(rest.AsSpan(at));
                Keep(parameter, after.AsSpan(at, length));
            }
        }

        if (!rest.AsSpan().SequenceEqual(_before))
        {
            throw new FuzzException($"{call.Name} writes {(isDone ? "beyond its arrays" : "although it is rejected")}");
        }
    }

    /// <summary>The balls that a call wrote.</summary>
    public List<nint> BallsOf(NativeCall call, long[] values)
    {
        List<nint> balls = [];
        int argument = Array.FindIndex(call.Parameters, parameter => parameter.ParameterType == typeof(NativeState*) && IsWritten(parameter, isDone: true));
        for (int i = 0; argument >= 0 && values[argument] != 0 && i < Count(call, values, call.Parameters[argument]); i++)
        {
            nint ball = (nint)values[argument] + (i * sizeof(NativeState));
            if (!new Span<byte>((void*)ball, sizeof(NativeState)).SequenceEqual(_before.AsSpan((int)(ball - (nint)s_memory), sizeof(NativeState))))
            {
                balls.Add(ball);
            }
        }

        return balls;
    }

    /// <summary>A slot that the last call did not use.</summary>
    public static nint Spare => (nint)s_memory + Size - SlotSize;

    private static bool IsWritten(ParameterInfo parameter, bool isDone)
    {
        Type type = parameter.ParameterType;
        return IsHandle(type.GetElementType()) || (isDone && type.IsPointer && !IsHandle(type) && !parameter.IsDefined(typeof(InAttribute)));
    }

    private static bool IsHandle(Type? type) => type == typeof(NativeScene*) || type == typeof(NativeMatch*) || type == typeof(NativeFilter*);

    /// <summary>Saved matches and recordings.</summary>
    private static bool IsSaved(ParameterInfo parameter) => parameter.ParameterType == typeof(CByte*) && parameter.Name is "bytes" or "recording";

    /// <summary>The number of elements behind a pointer, or of balls or rows; 1 if no count belongs to it.</summary>
    private static int Count(NativeCall call, long[] values, ParameterInfo of)
    {
        string name = of.Name is "events" or "name" or "windows" or "pieces" || IsSaved(of) ? "capacity" : of.Name == "path" ? "rows" : of.Name is "count" or "written" || (of.Name == "out" && of.ParameterType != typeof(NativeState*)) || IsHandle(of.ParameterType.GetElementType()) ? "" : "n";
        int count = Array.FindIndex(call.Parameters, parameter => parameter.Name == name);
        return count < 0 ? 1 : (int)Math.Clamp(values[count], 0, IsSaved(of) ? SlotSize : MostRows * MostRows);
    }

    private static int Length(ParameterInfo parameter, int count) => parameter.GetCustomAttribute<CArrayAttribute>()?.Length * Element(parameter) ?? count * Rows(parameter) * Element(parameter);

    private static int Element(ParameterInfo parameter)
    {
        Type type = parameter.ParameterType.GetElementType()!;
        return type.IsPointer ? sizeof(nint) : Marshal.SizeOf(type);
    }

    /// <summary>The numbers of a row.</summary>
    private static int Rows(ParameterInfo parameter) => parameter.ParameterType != typeof(double*) || parameter.Name is "time" or "times" or "noise" or "airDistance" or "miss" ? 1 : parameter.Name == "path" ? 4 : 3;

    private long Value(ParameterInfo parameter, byte* slot)
    {
        Type type = parameter.ParameterType;
        return type == typeof(double) ? BitConverter.DoubleToInt64Bits(_program.Number())
            : type == typeof(int) || type == typeof(long) ? Whole(parameter)
            : type == typeof(NativeScene*) ? Handle(_scenes)
            : type == typeof(NativeMatch*) ? Handle(_matches)
            : type == typeof(NativeFilter*) ? Handle(_filters)
            : _program.Byte() is var token && token == Null ? 0
            : type == typeof(NativeState*) ? Ball(token)
            : (nint)Filled(parameter, slot, token);
    }

    private long Whole(ParameterInfo parameter)
    {
        if (parameter.Name is "bytes" or "jsonBytes")
        {
            return _program.Byte() is var token && token == Null ? -1 : token == Wild ? long.MaxValue : Math.Max(0, _text - (token >> 5));
        }

        int value = _program.Byte();
        ParameterInfo[] all = ((MethodInfo)parameter.Member).GetParameters();
        if (parameter.Position > 0 && IsSaved(all[parameter.Position - 1]) && value < 0x80)
        {
            return parameter.Name == "n" ? Math.Max(0, _saved.Length - (value >> 5)) : SlotSize;
        }

        return parameter.Name is "n" or "rows" or "capacity" or "steps" or "balls"
            ? value switch { Null => -1, Wild => int.MinValue, _ => value % ((parameter.Name is "n" or "balls" ? MostRows : MostRows * MostRows) + 1) }
            : value switch { Null => int.MaxValue, Wild => int.MinValue, _ => (sbyte)value };
    }

    /// <summary>The last handle, an earlier one (0 and freed ones included), or any number.</summary>
    private nint Handle(List<nint> of) => _program.Byte() is var token && token == Wild ? (nint)_program.Word() : of[token < LastHandle ? ^1 : token % of.Count];

    /// <summary>One of the balls; first, some of its bytes may be changed, because C can pass anything.</summary>
    private long Ball(int token)
    {
        byte* ball = s_memory + ((token % MostRows) * sizeof(NativeState));
        if (token >= Changed)
        {
            int field = _program.Byte() % (sizeof(NativeState) / sizeof(double));
            ((double*)ball)[field] = _program.Number();
        }

        return (nint)ball;
    }

    private byte* Filled(ParameterInfo parameter, byte* slot, int token)
    {
        if (parameter.ParameterType == typeof(byte*) && parameter.GetCustomAttribute<CArrayAttribute>() is not null)
        {
            _snapshot.CopyTo(new Span<byte>(slot, SlotSize));
            return slot;
        }

        if (!parameter.IsDefined(typeof(InAttribute)))
        {
            return slot;
        }

        if (parameter.ParameterType == typeof(byte*))
        {
            string[] texts = parameter.Name == "json" ? _texts : _requests;
            byte[] text = token < 0x80 ? Encoding.UTF8.GetBytes(texts[token % texts.Length]) : _program.Take(token & 0x7F);
            text.CopyTo(new Span<byte>(slot, SlotSize));
            _text = text.Length;
            return slot;
        }

        if (IsSaved(parameter))
        {
            _saved.CopyTo(new Span<byte>(slot, SlotSize));
            if (token >= Changed)
            {
                slot[_program.Word() % SlotSize] = (byte)_program.Byte();
            }

            return slot;
        }

        if (parameter.ParameterType == typeof(CByte*))
        {
            _program.Take(MostRows).CopyTo(new Span<byte>(slot, SlotSize));
            return slot;
        }

        int numbers = parameter.GetCustomAttribute<CArrayAttribute>()?.Length ?? (parameter.ParameterType == typeof(NativeEvent*) ? 1 : MostRows) * Rows(parameter) * Element(parameter) / sizeof(double);
        for (int i = 0; i < numbers; i++)
        {
            // Few bytes are enough: the later rows repeat the first one if its token says so.
            ((double*)slot)[i] = i >= 3 && token < 0x80 ? ((double*)slot)[i % 3] : _program.Number();
        }

        if (parameter.ParameterType == typeof(NativeEvent*))
        {
            (((NativeEvent*)slot)->Kind, ((NativeEvent*)slot)->Thing) = (token & 7, token >> 3 & 3);
        }

        return slot;
    }

    /// <summary>Keeps a handle, or the bytes of a state, for the calls that follow.</summary>
    private void Keep(ParameterInfo parameter, ReadOnlySpan<byte> written)
    {
        if (IsHandle(parameter.ParameterType.GetElementType()))
        {
            (parameter.ParameterType == typeof(NativeScene**) ? _scenes : parameter.ParameterType == typeof(NativeMatch**) ? _matches : _filters).Add(MemoryMarshal.Read<nint>(written));
        }
        else if (IsSaved(parameter))
        {
            _saved = written.ToArray();
        }
        else if (parameter.Name == "written" && _saved.Length == SlotSize)
        {
            _saved = _saved[..(int)Math.Clamp(MemoryMarshal.Read<long>(written), 0, SlotSize)];
        }
        else if (parameter.ParameterType == typeof(byte*) && parameter.GetCustomAttribute<CArrayAttribute>() is not null)
        {
            written.CopyTo(_snapshot);
        }
    }

    /// <summary>Shortens a run that C may start, but that takes hours.</summary>
    private static void Shorten(NativeCall call, long[] values)
    {
        int seconds = Array.FindIndex(call.Parameters, parameter => parameter.Name == "seconds");
        int step = Array.FindIndex(call.Parameters, parameter => parameter.Name is "dt" or "every");
        if (seconds >= 0 && step >= 0)
        {
            double length = BitConverter.Int64BitsToDouble(values[step]);
            length = call.Parameters[step].Name == "every" && length is > LongestRow and < 1e9 ? LongestRow : length;
            double most = MostSteps * length;
            double wanted = BitConverter.Int64BitsToDouble(values[seconds]);
            (values[step], values[seconds]) = (BitConverter.DoubleToInt64Bits(length), BitConverter.DoubleToInt64Bits(wanted > most && wanted < 1e15 && length > 0 ? most : wanted));
        }
    }
}
