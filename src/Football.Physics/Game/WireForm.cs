using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Game;

/// <summary>Encodes a state in 24 bytes, with numbers as integer multiples of a unit.</summary>
/// <remarks>
/// Derived numbers are omitted: the height of a ball on the ground, the spin of a rolling ball. To round a state, encode and decode it until it no
/// longer changes; it can then be stored without loss. Bits, lowest first: motion 3, goals entered 2 and passed 2, steps of the clock 22; x 18,
/// z 18, y 16 bits of 1/1024 m; velocity 3 × 16 bits of 1/512 m/s; spin 3 × 13 bits of 1/8 rad/s; rotation 23 bits: the index of the largest
/// component, and the other three with 7 bits each.
/// </remarks>
internal static class WireForm
{
    public const int Size = 24;

    // Units per m, m/s and rad/s. They are powers of two, so that decoding an integer is exact.
    private const double PerMetre = 1024;
    private const double PerSpeed = 512;
    private const double PerSpin = 8;

    /// <summary>The scale of the three smaller components of a unit quaternion, which are within ±√½.</summary>
    private const double PerPart = 63 * Elementary.Root2;

    /// <summary>The lowest height, in m below the ground; the range is 64 m.</summary>
    private const double Lowest = -4;

    /// <summary>A spin this close to an integer, in units, is not dithered: computed from axis and magnitude, it has rounding errors.</summary>
    private const double Rounding = 1e-6;

    /// <summary>The maximum number of rounding passes; nearly all states need one; some with two equal rotation components need two.</summary>
    private const int MostRounds = 4;

    /// <summary>The tolerance of the clock against a tick, relative to 1 s plus the time; a clock that is farther off is left unchanged.</summary>
    public const double ClockRounding = 1e-9;

    /// <summary>Rounds all balls of a runner, or none.</summary>
    public static void Round(FixedStepRunner runner)
    {
        BallState[] states = runner.States;

        // Round every clock, even if the ball is not quantised: bodies depend on the clock, and it must agree after a mispredicted kick.
        for (int i = 0; i < states.Length; i++)
        {
            double tick = Math.Round(states[i].Time / runner.TimeStep) * runner.TimeStep;
            states[i].Time = Math.Abs(tick - states[i].Time) <= ClockRounding * (1.0 + tick) ? tick : states[i].Time;
        }

        if (states.Length == 1)
        {
            if (TryRound(runner.SimulatorOf(0), runner.TimeStep, in states[0], out BallState rounded))
            {
                states[0] = rounded;
            }

            return;
        }

        // Several balls share one clock, so round all of them or none.
        for (int i = 0; i < states.Length; i++)
        {
            if (!TryRound(runner.SimulatorOf(i), runner.TimeStep, in states[i], out _))
            {
                return;
            }
        }

        for (int i = 0; i < states.Length; i++)
        {
            TryRound(runner.SimulatorOf(i), runner.TimeStep, in states[i], out states[i]);
        }
    }

    /// <summary>Writes a state if the bytes represent it exactly; returns false otherwise.</summary>
    public static bool TryWrite(Simulator simulator, double timeStep, in BallState state, Span<byte> destination)
    {
        Check.Bytes(nameof(destination), destination.Length, Size);
        var bits = default(WireBits);

        // Write only states that decode bit-identically: reject a ball that is not rounded, and a ball whose state the format cannot store.
        if (!TryEncode(simulator, timeStep, in state, ref bits) || !TryDecode(simulator, timeStep, in bits, out BallState read) || !Snapshot.Same(in state, in read))
        {
            return false;
        }

        bits.Write(destination);
        return true;
    }

    /// <summary>Reads a state, and rejects bytes that no state produces.</summary>
    public static BallState Read(Simulator simulator, double timeStep, ReadOnlySpan<byte> source)
    {
        Check.Bytes(nameof(source), source.Length, Size);
        // Older Mono runtimes cannot index a read-only span.
        Span<byte> bytes = stackalloc byte[Size];
        source.Slice(0, Size).CopyTo(bytes);

        // Each state has exactly one encoding: reject bytes that the encoder would write differently.
        var bits = WireBits.Read(bytes);
        var again = default(WireBits);
        if (!TryDecode(simulator, timeStep, in bits, out BallState state) || !TryEncode(simulator, timeStep, in state, ref again) || !again.Equals(in bits))
        {
            throw ByteReader.Broken("they are no state of a ball in the wire form");
        }

        try
        {
            simulator.Validate(in state);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }

        return state;
    }

    /// <summary>Finds the nearest state that the format represents exactly.</summary>
    private static bool TryRound(Simulator simulator, double timeStep, in BallState state, out BallState rounded)
    {
        rounded = state;
        for (int round = 0; round < MostRounds; round++)
        {
            var bits = default(WireBits);
            if (!TryEncode(simulator, timeStep, in rounded, ref bits) || !TryDecode(simulator, timeStep, in bits, out BallState next))
            {
                return false;
            }

            // If encoding and decoding leave a state unchanged, it can be sent without loss.
            if (Snapshot.Same(in next, in rounded))
            {
                // Rounding may move the ball through a goal mouth, so update the goals that contain it. The format stores two goals.
                Passages.PassMouths(simulator.World, ref rounded, state.Position);
                return rounded.GoalsEntered < 4;
            }

            rounded = next;
        }

        return false;
    }

    /// <summary>Encodes a state in rounded numbers; returns false if the format cannot represent it.</summary>
    private static bool TryEncode(Simulator simulator, double timeStep, in BallState s, ref WireBits bits)
    {
        bool flies = s.Motion == MotionState.Airborne;

        // The format cannot store nets, contacts other than with level ground, an active knuckle force, or a squeeze: do not round such balls.
        bool holds = (flies || (s.Motion != MotionState.Pinned && s.Carrier == 0 && simulator.World.IsLevel && s.Position.Y == simulator.ContactHeight))
            && s.Nets == 0 && s.AirDistance == 0 && (s.GoalsEntered | s.GoalsPassed) < 4;
        if (!holds)
        {
            return false;
        }

        // Layout, 191 of 192 bits, lowest bit first: motion 3, goals 2 + 2, time 22, x 18, z 18, height 16, velocity 3 × 16, spin 3 × 13, rotation 2
        // + 3 × 7.
        bits.Put((ulong)s.Motion, 3);
        bits.Put(s.GoalsEntered, 2);
        bits.Put(s.GoalsPassed, 2);

        // Store the time in whole steps. On the ground, store 0 for the height, because the ball is at contact height.
        double steps = Math.Round(s.Time / timeStep);
        holds = PutWhole(steps, 22, ref bits)
            & PutSigned(s.Position.X * PerMetre, 18, ref bits)
            & PutSigned(s.Position.Z * PerMetre, 18, ref bits)
            & PutWhole(flies ? Height(simulator, s.Position.Y) : 0, 16, ref bits);
        Vector3d v = s.Motion == MotionState.Rest ? Vector3d.Zero : s.Velocity;
        holds = holds & PutSigned(v.X * PerSpeed, 16, ref bits) & PutSigned(flies ? v.Y * PerSpeed : 0, 16, ref bits) & PutSigned(v.Z * PerSpeed, 16, ref bits);

        // A rolling ball's velocity determines its spin, except about the vertical axis.
        Vector3d w = s.Motion == MotionState.Rest ? Vector3d.Zero : s.Spin;
        bool rolls = s.Motion == MotionState.Rolling;
        long clock = steps >= 0 && steps < 1e9 ? (long)steps : 0;
        holds = holds & PutSigned(rolls ? 0 : Dither(w.X, clock, 0), 13, ref bits) & PutSigned(Dither(w.Y, clock, 1), 13, ref bits) & PutSigned(rolls ? 0 : Dither(w.Z, clock, 2), 13, ref bits);
        if (holds)
        {
            PutRotation(s.Orientation, ref bits);
        }

        return holds;
    }

    /// <summary>Decodes a state, and derives the numbers that are not stored; returns false for invalid bits.</summary>
    private static bool TryDecode(Simulator simulator, double timeStep, in WireBits written, out BallState s)
    {
        WireBits bits = written.FromStart();
        s = default;
        ulong motion = bits.Take(3);

        // Three bits can also encode a pinned ball, which the format does not support, and values without a motion.
        if (motion > (ulong)MotionState.Rest)
        {
            return false;
        }

        s.Motion = (MotionState)motion;

        // Decode in the order of encoding, with inverse scales.
        s.GoalsEntered = bits.Take(2);
        s.GoalsPassed = bits.Take(2);
        s.Time = bits.Take(22) * timeStep;
        double x = bits.TakeSigned(18) / PerMetre;
        double z = bits.TakeSigned(18) / PerMetre;
        double y = (bits.Take(16) / PerMetre) + Lowest;
        bool flies = s.Motion == MotionState.Airborne;
        if (!flies && !(simulator.World.IsLevel && simulator.World.Ground is not null))
        {
            return false;
        }

        s.Position = new Vector3d(x, flies ? y : simulator.ContactHeight, z);
        double vx = bits.TakeSigned(16) / PerSpeed;
        double vy = bits.TakeSigned(16) / PerSpeed;
        double vz = bits.TakeSigned(16) / PerSpeed;
        var velocity = new Vector3d(vx, vy, vz);
        double wx = bits.TakeSigned(13) / PerSpin;
        double wy = bits.TakeSigned(13) / PerSpin;
        double wz = bits.TakeSigned(13) / PerSpin;
        var spin = new Vector3d(wx, wy, wz);
        if (!TryTakeRotation(ref bits, out s.BaseOrientation))
        {
            return false;
        }

        // In flight, store a spin axis and an angle about it. On the ground, store the spin as a vector.
        s.Velocity = velocity;
        if (flies)
        {
            s.SetFlightSpin(in spin);
            return true;
        }

        s.SetGroundSpin(s.Motion == MotionState.Rolling ? Slip.RollingSpin(in velocity, spin.Y, simulator.Scene.Ball.Radius) : spin);
        return true;
    }

    /// <summary>Returns the height of an airborne ball in units; on level ground, it is above the contact height.</summary>
    private static double Height(Simulator simulator, double y)
    {
        // Use at least one unit above the contact height, because rounding down would start the next step inside the ground.
        double least = Math.Floor((simulator.World.LevelContact - Lowest) * PerMetre) + 1;
        return Math.Max(Math.Round((y - Lowest) * PerMetre), least);
    }

    /// <summary>Returns a spin component in units, dithered: rounded up or down at random, so that rounding does not lose a slow decay.</summary>
    /// <remarks>The nearer unit is more likely. The random number comes from the clock, so it is the same on every machine.</remarks>
    private static double Dither(double spin, long clock, int component) =>
        Math.Floor((spin * PerSpin) + Rounding + ((1 - (2 * Rounding)) * SplitMix64.At(clock, component)));

    private static bool PutSigned(double units, int count, ref WireBits bits) => PutWhole(Math.Round(units) + (1L << (count - 1)), count, ref bits);

    private static bool PutWhole(double units, int count, ref WireBits bits)
    {
        // NaN and values out of range fail the comparison, so zeros are written.
        bool holds = units >= 0 && units < 1L << count;
        bits.Put(holds ? (ulong)units : 0, count);
        return holds;
    }

    private static void PutRotation(Quaterniond q, ref WireBits bits)
    {
        // Store the three smallest components. The largest follows from the norm 1; the others are within ±√½.
        Span<double> parts = stackalloc double[] { q.X, q.Y, q.Z, q.W };
        int largest = 0;
        for (int i = 1; i < 4; i++)
        {
            largest = Math.Abs(parts[i]) > Math.Abs(parts[largest]) ? i : largest;
        }

        // q and −q represent the same rotation: make the largest component positive.
        double sign = parts[largest] < 0 ? -1 : 1;

        int truncated = Exceeding(parts, largest);
        bits.Put((ulong)largest, 2);
        for (int i = 0; i < 4; i++)
        {
            if (i != largest)
            {
                double units = sign * parts[i] * PerPart;
                bits.Put((ulong)((i == truncated ? Math.Truncate(units) : Math.Round(units)) + 63), 7);
            }
        }
    }

    /// <summary>Returns the index of the component that must be rounded down; −1 if none.</summary>
    /// <remarks>Rounded to the nearest, it would exceed the largest component, which the reader computes from the others. Rounded down, encoding and
    /// decoding change nothing.</remarks>
    private static int Exceeding(ReadOnlySpan<double> parts, int largest)
    {
        double rest = 1;
        double most = 0;
        int second = -1;
        for (int i = 0; i < 4; i++)
        {
            double part = i == largest ? 0 : Math.Round(parts[i] * PerPart) / PerPart;
            rest -= part * part;
            if (part * part > most)
            {
                (most, second) = (part * part, i);
            }
        }

        return most >= rest ? second : -1;
    }

    private static bool TryTakeRotation(ref WireBits bits, out Quaterniond q)
    {
        int largest = (int)bits.Take(2);
        Span<double> parts = stackalloc double[4];
        double rest = 1;
        for (int i = 0; i < 4; i++)
        {
            if (i != largest)
            {
                parts[i] = ((double)bits.Take(7) - 63) / PerPart;
                rest -= parts[i] * parts[i];
            }
        }

        // The squares add up to 1, and the encoder made the largest component positive.
        parts[largest] = Math.Sqrt(Math.Max(rest, 0));
        q = new Quaterniond(parts[0], parts[1], parts[2], parts[3]);
        return rest > 0;
    }
}

/// <summary>A buffer of 192 bits, written and read from the lowest bit.</summary>
internal struct WireBits
{
    private ulong _low;
    private ulong _middle;
    private ulong _high;
    private int _at;

    /// <summary>Writes the lowest bits of a word.</summary>
    public void Put(ulong word, int count)
    {
        for (int i = 0; i < count; i++, _at++)
        {
            // Write without a branch: the bit goes into the word, one of three, that contains position _at.
            ulong bit = (word >> i & 1) << (_at & 63);
            _low |= _at < 64 ? bit : 0;
            _middle |= _at is >= 64 and < 128 ? bit : 0;
            _high |= _at >= 128 ? bit : 0;
        }
    }

    /// <summary>Reads a number of bits.</summary>
    public ulong Take(int count)
    {
        ulong word = 0;
        for (int i = 0; i < count; i++, _at++)
        {
            word |= ((_at < 64 ? _low : _at < 128 ? _middle : _high) >> (_at & 63) & 1) << i;
        }

        return word;
    }

    /// <summary>Returns the same bits, with the read position at the start.</summary>
    public readonly WireBits FromStart()
    {
        WireBits bits = this;
        bits._at = 0;
        return bits;
    }

    /// <summary>Reads a signed number.</summary>
    public long TakeSigned(int count) => (long)Take(count) - (1L << (count - 1));

    /// <summary>True if two buffers contain the same bits.</summary>
    public readonly bool Equals(in WireBits other) => _low == other._low && _middle == other._middle && _high == other._high;

    /// <summary>Writes all bits as bytes.</summary>
    public readonly void Write(Span<byte> destination)
    {
        WireBits bits = FromStart();
        for (int i = 0; i < WireForm.Size; i++)
        {
            destination[i] = (byte)bits.Take(8);
        }
    }

    /// <summary>Reads all bits from bytes.</summary>
    public static WireBits Read(Span<byte> source)
    {
        var bits = default(WireBits);
        for (int i = 0; i < WireForm.Size; i++)
        {
            bits.Put(source[i], 8);
        }

        return bits;
    }
}
