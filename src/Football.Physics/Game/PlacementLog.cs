using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Game;

/// <summary>The positions of the game's bodies by tick; a resimulation applies them again.</summary>
internal sealed class PlacementLog
{
    private Entry[] _entries = new Entry[64];

    // Entries are sorted by tick. Removed entries stay at the front of the array until they fill half of it.
    private int _first;
    private int _end;

    /// <summary>The number of entries.</summary>
    public int Count => _end - _first;

    /// <summary>Adds the bodies that the game moved for a tick's step.</summary>
    public void Record(long tick, KinematicBodies bodies)
    {
        for (int i = 0; i < bodies.Count; i++)
        {
            if (bodies.WasMoved(i))
            {
                Add(new Entry(tick, i, bodies[i].Motion));
            }
        }
    }

    /// <summary>Moves the bodies to their recorded positions for a tick's step.</summary>
    public void Apply(long tick, KinematicBodies bodies)
    {
        for (int i = FirstAt(tick); i < _end && _entries[i].Tick == tick; i++)
        {
            bodies.Repeat(_entries[i].Body, in _entries[i].Motion);
        }
    }

    /// <summary>Removes the entries before a tick.</summary>
    public void RemoveBefore(long tick)
    {
        while (_first < _end && _entries[_first].Tick < tick)
        {
            _first++;
        }

        // Compact the array once more than half of it is unused, so that each entry is copied about once overall.
        if (2 * _first > _entries.Length)
        {
            Array.Copy(_entries, _first, _entries, 0, Count);
            _end -= _first;
            _first = 0;
        }
    }

    /// <summary>Removes the entries at a tick and later.</summary>
    public void RemoveFrom(long tick) => _end = FirstAt(tick);

    /// <summary>Writes the entries from one tick up to, but excluding, another.</summary>
    public void Write(long from, long to, ref ByteWriter writer)
    {
        int start = FirstAt(from);
        int end = FirstAt(to);
        writer.Integer((ulong)(end - start));
        long last = 0;
        for (int i = start; i < end; i++)
        {
            // Tick differences are small, so most of them fit into one byte.
            writer.Integer((ulong)(_entries[i].Tick - last));
            writer.Integer((ulong)_entries[i].Body);
            Write(in _entries[i].Motion, ref writer);
            last = _entries[i].Tick;
        }
    }

    /// <summary>Reads a log written by <see cref="Write(long, long, ref ByteWriter)"/>.</summary>
    public static PlacementLog Read(ref ByteReader reader)
    {
        var log = new PlacementLog();

        // A corrupt count exceeds the bytes left divided by the minimum entry size: reject it before any allocation.
        int count = reader.Count(7);
        long tick = 0;
        for (int i = 0; i < count; i++)
        {
            tick += reader.Long();
            if (tick < 0)
            {
                throw ByteReader.Broken("a tick beyond 63 bits");
            }

            int body = reader.Int();
            log.Add(new Entry(tick, body, ReadMotion(ref reader)));
        }

        return log;
    }

    /// <summary>Returns the highest body index; −1 if the log is empty.</summary>
    public int HighestBody()
    {
        int highest = -1;
        for (int i = _first; i < _end; i++)
        {
            highest = Math.Max(highest, _entries[i].Body);
        }

        return highest;
    }

    /// <summary>Writes a motion: the forms of its numbers, then the numbers.</summary>
    public static void Write(in RigidMotion motion, ref ByteWriter writer)
    {
        // Five bytes hold 35 bits of forms: position 6, velocity 6, spin 6, rotation 6 + 2, time 2, pivot 6, withdrawn 1. The pivot is relative to
        // the position.
        Quaterniond q = motion.Orientation;
        ulong forms = PackedNumbers.Forms(motion.Origin) | (PackedNumbers.Forms(motion.Velocity) << 6) | (PackedNumbers.Forms(motion.Spin) << 12)
            | (PackedNumbers.Forms(new Vector3d(q.X, q.Y, q.Z)) << 18) | (PackedNumbers.Form(q.W) << 24) | (PackedNumbers.Form(motion.Time) << 26)
            | (PackedNumbers.Forms(motion.Pivot - motion.Origin) << 28) | (motion.IsWithdrawn ? 1UL << 34 : 0);
        writer.Bits(forms, 5);
        PackedNumbers.Write(motion.Origin, ref writer);
        PackedNumbers.Write(motion.Velocity, ref writer);
        PackedNumbers.Write(motion.Spin, ref writer);
        PackedNumbers.Write(new Vector3d(q.X, q.Y, q.Z), ref writer);
        PackedNumbers.Write(q.W, ref writer);
        PackedNumbers.Write(motion.Time, ref writer);
        PackedNumbers.Write(motion.Pivot - motion.Origin, ref writer);
    }

    /// <summary>Reads a motion.</summary>
    public static RigidMotion ReadMotion(ref ByteReader reader)
    {
        ulong forms = reader.Bits(5);
        var motion = new RigidMotion
        {
            Origin = PackedNumbers.Vector(forms, ref reader),
            Velocity = PackedNumbers.Vector(forms >> 6, ref reader),
            Spin = PackedNumbers.Vector(forms >> 12, ref reader),
        };
        Vector3d q = PackedNumbers.Vector(forms >> 18, ref reader);
        motion.Orientation = new Quaterniond(q.X, q.Y, q.Z, PackedNumbers.Number(forms >> 24, ref reader));

        // The rotation determines this number, so it is not stored.
        motion.IsTurned = motion.Orientation != Quaterniond.Identity;
        motion.IsWithdrawn = (forms >> 34 & 1) != 0;
        motion.Time = PackedNumbers.Number(forms >> 26, ref reader);
        motion.Pivot = motion.Origin + PackedNumbers.Vector(forms >> 28, ref reader);
        try
        {
            // A pushed obstacle may be farther away, and faster, than the bodies that a game may place.
            Check.Size("body.position", motion.Origin, double.MaxValue, "m");
            Check.Size("body.velocity", motion.Velocity, double.MaxValue, "m/s");
            Check.Size("body.spin", motion.Spin, Limits.Spin, "rad/s");
            Check.Within("body.orientation", motion.Orientation.LengthSquared, 1 - 1e-6, 1 + 1e-6);
            Check.Within("body.time", motion.Time, -Limits.Time, Limits.Time);
            Check.Size("body.pivot", motion.Pivot, double.MaxValue, "m");
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }

        return motion;
    }

    private void Add(in Entry entry)
    {
        if (_end == _entries.Length)
        {
            Array.Resize(ref _entries, 2 * _end);
        }

        _entries[_end++] = entry;
    }

    /// <summary>Returns the index of the first entry at a tick or later.</summary>
    private int FirstAt(long tick)
    {
        // Binary search: entries before low have earlier ticks; entries from high on do not.
        int low = _first;
        int high = _end;
        while (low < high)
        {
            int middle = (low + high) >>> 1;
            if (_entries[middle].Tick < tick)
            {
                low = middle + 1;
            }
            else
            {
                high = middle;
            }
        }

        return low;
    }

    private readonly struct Entry(long tick, int body, in RigidMotion motion)
    {
        public readonly long Tick = tick;
        public readonly int Body = body;
        public readonly RigidMotion Motion = motion;
    }
}
