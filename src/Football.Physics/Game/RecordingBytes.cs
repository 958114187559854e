using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Game;

/// <summary>The bytes of a recording. They are untrusted, so each number is checked as it is read.</summary>
internal static class RecordingBytes
{
    private const ulong Format = 0x35_47_53_42_46; // "FBSG5"
    private const ulong FormatWithoutPlaces = 0x34_47_53_42_46; // "FBSG4"
    private const ulong AnyFormat = 0x47_53_42_46; // "FBSG"
    private const int LongestVersion = 64;
    private const int MostBalls = 10_000;
    private const int MostMovers = 100_000;

    /// <summary>Serialises a recording; the bytes are the same on every machine.</summary>
    public static byte[] Write(Recording recording)
    {
        // The runner may have inputs outside the segment: write only inputs inside it.
        var inputs = new KickLog();
        inputs.Add(recording.Kicks, recording.StartTick, recording.EndTick);

        var writer = new ByteWriter();

        // The header: format, library version, scene hash, time step, first tick, quantisation, and whether an engine moved colliders.
        writer.Bits(Format, 5);
        writer.Integer((ulong)recording.Version.Length);
        foreach (char letter in recording.Version)
        {
            writer.Bits(letter, 1);
        }

        writer.Bits(recording.SceneHash, 8);
        writer.Bits((ulong)BitConverter.DoubleToInt64Bits(recording.TimeStep), 8);
        writer.Integer((ulong)recording.StartTick);
        writer.Integer((ulong)recording.QuantizationInterval);
        writer.Bits(recording.HasMovingColliders ? 1UL : 0, 1);

        // The initial state: the balls, then the bodies and movable obstacles.
        writer.Integer((ulong)recording.StartStates.Length);
        foreach (ref BallState state in recording.StartStates)
        {
            writer.State(in state);
        }

        writer.Integer((ulong)recording.StartMotions.Length);
        foreach (ref RigidMotion motion in recording.StartMotions)
        {
            PlacementLog.Write(in motion, ref writer);
        }

        // The inputs: kicks, restarts, then body positions.
        inputs.Write(ref writer);
        inputs.WritePlaces(ref writer);
        recording.Bodies.Write(recording.StartTick, recording.EndTick, ref writer);

        // The results: a hash per step, and the keyframes. ToArray appends the checksum.
        writer.Integer((ulong)recording.Hashes.Length);
        foreach (ulong hash in recording.Hashes)
        {
            writer.Bits(hash, 8);
        }

        recording.Keyframes.Write(ref writer);
        return writer.ToArray();
    }

    /// <summary>Reads a recording, in the same order.</summary>
    public static Recording Read(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);
        bool hasPlaces = ReadFormat(ref reader);
        string version = ReadVersion(ref reader);
        ulong sceneHash = reader.Bits(8);
        double timeStep = BitConverter.Int64BitsToDouble((long)reader.Bits(8));
        long startTick = reader.Long();
        if (startTick > Limits.Tick)
        {
            throw ByteReader.Broken("the first tick is too large");
        }

        int wireTicks = reader.Int();
        bool engineMoves = reader.Bits(1) != 0;
        BallState[] start = ReadBalls(ref reader);
        CheckSteps(wireTicks, timeStep, start);
        RigidMotion[] motions = ReadMotions(ref reader);
        KickLog kicks = KickLog.Read(ref reader);
        for (int i = 0; i < kicks.Count; i++)
        {
            if (kicks[i].Ball >= start.Length)
            {
                throw ByteReader.Broken("a ball is kicked that there is not");
            }
        }

        if (hasPlaces)
        {
            kicks.ReadPlaces(ref reader);
        }

        for (int i = 0; i < kicks.PlaceCount; i++)
        {
            if (kicks.PlaceAt(i).Ball >= start.Length)
            {
                throw ByteReader.Broken("a ball is placed that there is not");
            }
        }

        PlacementLog bodies = PlacementLog.Read(ref reader);

        // Check this now: otherwise, an unknown body index would fail in the middle of a replay.
        if (bodies.HighestBody() >= motions.Length)
        {
            throw ByteReader.Broken("a body is moved that is none of those at the start");
        }

        int count = reader.Count(sizeof(ulong));
        if (startTick + count > Limits.Tick)
        {
            throw ByteReader.Broken("the last tick is too large");
        }

        var recording = new Recording(timeStep, startTick, start, kicks, bodies, motions, count)
        {
            SceneHash = sceneHash,
            HasMovingColliders = engineMoves,
            Version = version,
            QuantizationInterval = wireTicks,
        };
        for (int i = 0; i < count; i++)
        {
            recording.Add(reader.Bits(8));
        }

        // All hashes are known now: compare the keyframes with them.
        recording.Keyframes.Read(ref reader);
        recording.CheckKeyframes();
        reader.End();
        return recording;
    }

    /// <summary>Reads the format; returns true if it contains restarts.</summary>
    private static bool ReadFormat(ref ByteReader reader)
    {
        ulong format = reader.Bits(5);
        if (format is not (Format or FormatWithoutPlaces))
        {
            // The message shows the last character only if it is a digit: any other may control a terminal.
            throw ByteReader.Broken((format & uint.MaxValue) == AnyFormat && format >> 32 is >= '0' and <= '9'
                ? $"they are a recording in the format FBSG{(char)(format >> 32)}, but this version of the library reads FBSG4 and FBSG5"
                : "a recording does not start like this");
        }

        return format == Format;
    }

    private static string ReadVersion(ref ByteReader reader)
    {
        int length = reader.Count(1);
        if (length > LongestVersion)
        {
            throw ByteReader.Broken("the name of the library's version is too long");
        }

        var letters = new char[length];
        for (int i = 0; i < length; i++)
        {
            letters[i] = (char)reader.Bits(1);
            if (letters[i] is < ' ' or > '~')
            {
                throw ByteReader.Broken("the name of the library's version is no plain text");
            }
        }

        return new string(letters);
    }

    private static BallState[] ReadBalls(ref ByteReader reader)
    {
        // Check each count against the number of bytes left, so that a corrupt count does not allocate memory.
        int balls = reader.Count(Snapshot.Size);
        if (balls is 0 or > MostBalls)
        {
            throw ByteReader.Broken("there is no ball, or more than 10 000");
        }

        var start = new BallState[balls];
        for (int i = 0; i < balls; i++)
        {
            start[i] = reader.State();
        }

        return start;
    }

    /// <summary>Reports a value that a runner would reject as corrupt bytes.</summary>
    private static void CheckSteps(int wireTicks, double timeStep, BallState[] start)
    {
        try
        {
            Check.Within("wireTicks", wireTicks, 0, FixedStepRunner.MostWireTicks);
            Check.Within("timeStep", timeStep, 0, Limits.Time, exclusiveLow: true);
            Check.Advances("timeStep", timeStep, start[0].Time);
            for (int i = 1; i < start.Length; i++)
            {
                Check.Within("time of a ball", start[i].Time, start[0].Time, start[0].Time);
            }
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }
    }

    private static RigidMotion[] ReadMotions(ref ByteReader reader)
    {
        // A motion takes many times more memory than bytes: limit their number too.
        int movers = reader.Count(5);
        if (movers > MostMovers)
        {
            throw ByteReader.Broken("there are more than 100 000 bodies");
        }

        var motions = new RigidMotion[movers];
        for (int i = 0; i < motions.Length; i++)
        {
            motions[i] = PlacementLog.ReadMotion(ref reader);
        }

        return motions;
    }
}
