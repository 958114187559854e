using System.Buffers.Binary;
using System.Globalization;
using FootballPhysics.Contacts;
using FootballPhysics.Game;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Native;

/// <summary>Saves a match between two steps as bytes, and restores it, without allocating.</summary>
/// <remarks>
/// The bytes are little-endian: the format, the session hash and the tick; each ball with its pending kick and restart; each body and movable obstacle; a checksum.
/// </remarks>
internal sealed class MatchBlob
{
    private const ulong Format = 0x32_48_43_54_41_4D_50_46; // "FPMATCH2"
    private const ulong FormatWithoutPlaces = 0x31_48_43_54_41_4D_50_46; // "FPMATCH1"
    private const int Header = 4 * sizeof(ulong);
    private const int KickSize = 7 * sizeof(double);
    private const int PlaceSize = 14 * sizeof(double);
    private const int MotionSize = 18 * sizeof(double);

    private const ulong Withdrawn = 1;
    private const ulong Moved = 2;

    private readonly Match _match;
    private readonly BallState[] _states;
    private readonly KickInput?[] _kicks;
    private readonly PlaceInput?[] _places;
    private readonly RigidMotion[] _motions;
    private readonly bool[] _moved;
    private ulong? _session;

    public MatchBlob(Match match)
    {
        _match = match;
        _states = new BallState[match.Runner.Balls];
        _kicks = new KickInput?[_states.Length];
        _places = new PlaceInput?[_states.Length];
        _motions = new RigidMotion[match.Runner.Simulator.World.Movers];
        _moved = new bool[_motions.Length];
    }

    /// <summary>The number of bytes; fixed for a match.</summary>
    public int Size => Header + (_states.Length * (Snapshot.Size + KickSize + PlaceSize)) + (_motions.Length * MotionSize) + Crc32.Size;

    /// <summary>A hash of the scene, the settings, the step and the version of the library.</summary>
    private ulong Session => _session ??= _match.Runner.SessionHash;

    /// <summary>Writes the match.</summary>
    /// <param name="into">Receives <see cref="Size"/> bytes.</param>
    public void Save(Span<byte> into)
    {
        FixedStepRunner runner = _match.Runner;
        var words = new Words(into);
        words.Write(Format);
        words.Write(Session);
        words.Write((ulong)runner.Tick);
        words.Write(((ulong)_motions.Length << 32) | (uint)_states.Length);
        Array.Clear(_kicks);
        for (int i = runner.Kicks.FirstAt(runner.Tick); i < runner.Kicks.Count; i++)
        {
            _kicks[runner.Kicks[i].Ball] = runner.Kicks[i];
        }

        Array.Clear(_places);
        for (int i = runner.Kicks.FirstPlaceAt(runner.Tick); i < runner.Kicks.PlaceCount; i++)
        {
            _places[runner.Kicks.PlaceAt(i).Ball] = runner.Kicks.PlaceAt(i);
        }

        for (int i = 0; i < _states.Length; i++)
        {
            Snapshot.Write(in runner.States[i], words.Take(Snapshot.Size));
            words.Write(_kicks[i] is null ? 0UL : 1);
            words.Write(_kicks[i]?.Velocity ?? default);
            words.Write(_kicks[i]?.Spin ?? default);
            words.Write(_places[i] is null ? 0UL : 1);
            words.Write(_places[i]?.Position ?? default);
            words.Write(_places[i]?.Velocity ?? default);
            words.Write(_places[i]?.Spin ?? default);
            words.Write(_places[i]?.Orientation ?? default);
        }

        runner.Simulator.World.ReadMotions(_motions);
        for (int i = 0; i < _motions.Length; i++)
        {
            ref readonly RigidMotion motion = ref _motions[i];
            words.Write(motion.Origin);
            words.Write(motion.Velocity);
            words.Write(motion.Spin);
            words.Write(motion.Pivot);
            words.Write(motion.Orientation);
            words.Write(motion.Time);
            words.Write((motion.IsWithdrawn ? Withdrawn : 0) | (i < _match.Bodies.Count && _match.Bodies.WasMoved(i) ? Moved : 0));
        }

        Crc32.Seal(into);
    }

    /// <summary>Restores a match; throws before anything changes.</summary>
    /// <exception cref="ArgumentException">The bytes are corrupt, or belong to another match.</exception>
    public unsafe void Restore(CByte* bytes, long n)
    {
        if (n >= sizeof(ulong) && BinaryPrimitives.ReadUInt64LittleEndian(new Span<byte>(bytes, sizeof(ulong))) == FormatWithoutPlaces)
        {
            throw new ArgumentException("bytes are in the format FPMATCH1 of an earlier version of the library, but this version reads FPMATCH2. Save the match with this version.");
        }

        if (n != Size)
        {
            throw Guard.Refusal("n", n.ToString(CultureInfo.InvariantCulture), FormattableString.Invariant($"{Size}, the size of a saved state of this match"));
        }

        long tick = Read(new Span<byte>(bytes, Size));
        FixedStepRunner runner = _match.Runner;
        World world = runner.Simulator.World;

        // Restore the bodies before the balls: the runner stores both.
        world.Bodies?.ForgetTimes();
        if (_motions.Length > 0)
        {
            world.WriteMotions(_motions);
        }

        runner.Kicks.RemoveFrom(tick);
        runner.GoTo(tick, _states);
        for (int i = 0; i < _states.Length; i++)
        {
            if (_kicks[i] is { } kick)
            {
                runner.Kicks.Add(in kick);
            }

            if (_places[i] is { } place)
            {
                runner.Kicks.Add(in place);
            }
        }

        // Repeat the moves since the last step, so that the next step checks their times and a recording stores them.
        for (int i = 0; i < _match.Bodies.Count; i++)
        {
            ref readonly RigidMotion motion = ref _motions[i];
            if (_moved[i] && motion.IsWithdrawn)
            {
                _match.Bodies[i].Withdraw();
            }
            else if (_moved[i])
            {
                _match.Bodies[i].MoveTo(motion.Origin, motion.Orientation, motion.Velocity, motion.Spin, motion.Time);
            }
        }

        _match.ForgetImpulses();
    }

    /// <summary>Reads and checks all values, and returns the tick.</summary>
    private long Read(Span<byte> from)
    {
        if (!Crc32.Holds(from))
        {
            throw new ArgumentException("bytes are corrupt: the checksum is wrong. Pass what fp_match_save wrote.");
        }

        FixedStepRunner runner = _match.Runner;
        var words = new Words(from);
        ulong format = words.Read();
        ulong session = words.Read();
        ulong tick = words.Read();
        if (format != Format || session != Session || words.Read() != (((ulong)_motions.Length << 32) | (uint)_states.Length))
        {
            throw new ArgumentException("bytes belong to another match. Restore them in a match with the same scene, balls, step and library version.");
        }

        Check.Within("tick", unchecked((long)tick), 0, Limits.Tick);
        for (int i = 0; i < _states.Length; i++)
        {
            _states[i] = Snapshot.Read(words.Take(Snapshot.Size));
            runner.SimulatorOf(i).Validate(in _states[i]);
            Check.Within("time", _states[i].Time, _states[0].Time, _states[0].Time);
            Check.Advances("dt", runner.TimeStep, _states[i].Time);
            bool isKicked = words.Read() != 0;
            Vector3d velocity = words.Vector();
            Vector3d spin = words.Vector();
            _kicks[i] = isKicked ? new KickInput((long)tick, velocity, spin, ball: i) : null;
            bool isPlaced = words.Read() != 0;
            Vector3d position = words.Vector();
            velocity = words.Vector();
            spin = words.Vector();
            Quaterniond orientation = words.Rotation();
            _places[i] = isPlaced ? new PlaceInput((long)tick, 0, i, position, velocity, spin, orientation) : null;
        }

        for (int i = 0; i < _motions.Length; i++)
        {
            ref RigidMotion motion = ref _motions[i];
            motion = new RigidMotion
            {
                Origin = words.Vector(),
                Velocity = words.Vector(),
                Spin = words.Vector(),
                Pivot = words.Vector(),
                Orientation = words.Rotation(),
                Time = words.Number(),
            };
            ulong flags = words.Read();
            motion.IsTurned = motion.Orientation != Quaterniond.Identity;
            motion.IsWithdrawn = (flags & Withdrawn) != 0;
            _moved[i] = (flags & Moved) != 0;

            // A pushed object may be farther away, and faster, than a body that a game places.
            bool isFree = !_moved[i] || motion.IsWithdrawn;
            Check.Size("body.position", motion.Origin, isFree ? double.MaxValue : Limits.Length, "m");
            Check.Size("body.velocity", motion.Velocity, isFree ? double.MaxValue : Limits.Speed, "m/s");
            Check.Size("body.spin", motion.Spin, Limits.Spin, "rad/s");
            Check.Size("body.pivot", motion.Pivot, double.MaxValue, "m");
            Check.Within("body.orientation", motion.Orientation.LengthSquared, 1 - 1e-6, 1 + 1e-6);
            Check.Within("body.time", motion.Time, -Limits.Time, Limits.Time);
        }

        return (long)tick;
    }

    /// <summary>Reads or writes bytes in order, little-endian on every machine.</summary>
    private ref struct Words(Span<byte> bytes)
    {
        private Span<byte> _left = bytes;

        public Span<byte> Take(int count)
        {
            Span<byte> taken = _left[..count];
            _left = _left[count..];
            return taken;
        }

        public void Write(ulong word) => BinaryPrimitives.WriteUInt64LittleEndian(Take(sizeof(ulong)), word);

        public void Write(double number) => BinaryPrimitives.WriteDoubleLittleEndian(Take(sizeof(double)), number);

        public void Write(Vector3d vector)
        {
            Write(vector.X);
            Write(vector.Y);
            Write(vector.Z);
        }

        public void Write(Quaterniond rotation)
        {
            Write(rotation.X);
            Write(rotation.Y);
            Write(rotation.Z);
            Write(rotation.W);
        }

        public ulong Read() => BinaryPrimitives.ReadUInt64LittleEndian(Take(sizeof(ulong)));

        public double Number() => BinaryPrimitives.ReadDoubleLittleEndian(Take(sizeof(double)));

        public Vector3d Vector() => new(Number(), Number(), Number());

        public Quaterniond Rotation() => new(Number(), Number(), Number(), Number());
    }
}
