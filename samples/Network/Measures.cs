using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>The drawn ball: its position, plus the rest of the last corrections, which decays within some tenths of a second.</summary>
public sealed class View
{
    private const double HalfLife = 0.08;
    private const double TooFar = 30;
    private static readonly double s_left = Math.Pow(0.5, Match.Step / HalfLife);
    private Vector3d _error;
    private Vector3d _drawn;
    private Vector3d _ball;

    /// <summary>The largest jump between two frames beyond the motion of the ball, m, without smoothing.</summary>
    public double RawJump { get; private set; }

    public double DrawnJump { get; private set; }

    public void Snap(in BallState ball) => (_error, _drawn, _ball) = (default, ball.Position, ball.Position);

    /// <summary>Keeps the drawn position when a correction moves the ball.</summary>
    public void Corrected(in BallState ball)
    {
        Vector3d jump = ball.Position - _ball;
        RawJump = Math.Max(RawJump, jump.Length);
        _error = (_error - jump).Length < TooFar ? _error - jump : Vector3d.Zero;
        _ball = ball.Position;
    }

    public Vector3d Draw(in BallState ball)
    {
        Vector3d moved = ball.Position - _ball;
        _error = s_left * _error;
        Vector3d drawn = ball.Position + _error;
        DrawnJump = Math.Max(DrawnJump, (drawn - _drawn - moved).Length);
        _ball = ball.Position;
        _drawn = drawn;
        return drawn;
    }
}

/// <summary>Measures the corrections by replays against an upper bound: until a machine learns of a kick, the ball can travel the sum of both paths since that kick.</summary>
public sealed class Corrections
{
    private readonly List<BallState> _before = [];
    private readonly List<double> _sizes = [];

    public int Replays { get; private set; }

    public int Ticks { get; private set; }

    public int Checked { get; set; }

    public int Divergences { get; private set; }

    public string? FirstDivergence { get; private set; }

    /// <summary>The number of corrections that were larger than their bound.</summary>
    public int TooLarge { get; private set; }

    public int Count => _sizes.Count;

    public double Size(double share)
    {
        _sizes.Sort();
        return _sizes.Count == 0 ? 0 : _sizes[Math.Min(_sizes.Count - 1, (int)(share * _sizes.Count))];
    }

    public void Keep(Rollback rollback, long from)
    {
        _before.Clear();
        for (long tick = from; tick <= rollback.Runner.Tick; tick++)
        {
            _before.Add(rollback.StateAt(tick));
        }
    }

    /// <summary>Compares the ball with the one before the correction.</summary>
    /// <param name="rollback">The states after the correction.</param>
    /// <param name="from">The first tick that was played again.</param>
    /// <param name="isRestart">True if a late restart placed the ball: it can be anywhere.</param>
    public void Compare(Rollback rollback, long from, bool isRestart = false)
    {
        Replays++;
        Ticks += _before.Count - 1;
        BallState now = rollback.Runner.State;
        if (isRestart || Snapshot.Same(_before[^1], in now))
        {
            return;
        }

        // The length of both paths together, from the larger speed at the ends of each tick. A kick starts its tick with its own speed.
        double bound = 0.01;
        for (int i = 1; i < _before.Count; i++)
        {
            BallState a = rollback.StateAt(from + i - 1);
            BallState b = rollback.StateAt(from + i);
            double kicked = KickSpeed(rollback.Runner.Kicks, from + i - 1);
            bound += Match.Step * (Math.Max(_before[i - 1].Velocity.Length, _before[i].Velocity.Length) + Math.Max(kicked, Math.Max(a.Velocity.Length, b.Velocity.Length)));
        }

        double size = (now.Position - _before[^1].Position).Length;
        _sizes.Add(size);
        TooLarge += size > bound ? 1 : 0;
    }

    public void Diverged(string what)
    {
        Divergences++;
        FirstDivergence ??= what;
    }

    private static double KickSpeed(KickLog kicks, long tick)
    {
        double speed = 0;
        for (int i = kicks.FirstAt(tick); i < kicks.Count && kicks[i].Tick == tick; i++)
        {
            speed = Math.Max(speed, kicks[i].Velocity.Length);
        }

        return speed;
    }
}

/// <summary>Writes the hash of the ball and the score at every final tick to a file, so that the files of two machines can be compared tick by tick.</summary>
public sealed class HashLog(string? file) : IDisposable
{
    /// <summary>Divides the buffer of a file, so that a killed process leaves whole rows.</summary>
    private const int RowSize = 32;

    private readonly BinaryWriter? _writer = file is null ? null : new BinaryWriter(File.Open(file, FileMode.Append));

    public void Add(long tick, ulong hash, in Ruling ruling)
    {
        _writer?.Write(tick);
        _writer?.Write(hash);
        _writer?.Write((long)ruling.First);
        _writer?.Write((long)ruling.Second);
    }

    public void Dispose() => _writer?.Dispose();

    public static Dictionary<long, (ulong Hash, long First, long Second)> Read(string file)
    {
        byte[] bytes = File.ReadAllBytes(file);
        var rows = new Dictionary<long, (ulong Hash, long First, long Second)>();
        for (int at = 0; at + RowSize <= bytes.Length; at += RowSize)
        {
            rows[BitConverter.ToInt64(bytes, at)] = (BitConverter.ToUInt64(bytes, at + 8), BitConverter.ToInt64(bytes, at + 16), BitConverter.ToInt64(bytes, at + 24));
        }

        return rows;
    }
}
