using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>What is drawn: the ball as it is, and what is left of the last corrections, which goes within some tenths of a second.</summary>
public sealed class View
{
    private const double HalfLife = 0.08;
    private const double TooFar = 30;
    private static readonly double s_left = Math.Pow(0.5, Match.Step / HalfLife);
    private Vector3d _error;
    private Vector3d _drawn;
    private Vector3d _ball;

    /// <summary>Largest step from one frame to the next beyond what the ball has moved, m: without smoothing, and with it.</summary>
    public double RawJump { get; private set; }

    public double DrawnJump { get; private set; }

    public void Snap(in BallState ball) => (_error, _drawn, _ball) = (default, ball.Position, ball.Position);

    /// <summary>The ball is elsewhere at once: what is drawn is not.</summary>
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

/// <summary>What playing again changed, beside what it can have at most: who learns late that the ball is kicked sees it go as far as both ways are long since then.</summary>
public sealed class Corrections
{
    private readonly List<BallState> _before = [];
    private readonly List<double> _sizes = [];

    public int Replays { get; private set; }

    public int Ticks { get; private set; }

    public int Checked { get; set; }

    public int Divergences { get; private set; }

    public string? FirstDivergence { get; private set; }

    /// <summary>Corrections that were larger than told.</summary>
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

    public void Compare(Rollback rollback, long from)
    {
        Replays++;
        Ticks += _before.Count - 1;
        BallState now = rollback.Runner.State;
        if (Snapshot.Same(_before[^1], in now))
        {
            return;
        }

        // Both ways together, at the greatest speed of either end of each tick; a kick begins its tick with its own.
        double told = 0.01;
        for (int i = 1; i < _before.Count; i++)
        {
            BallState a = rollback.StateAt(from + i - 1);
            BallState b = rollback.StateAt(from + i);
            double kicked = KickSpeed(rollback.Runner.Kicks, from + i - 1);
            told += Match.Step * (Math.Max(_before[i - 1].Velocity.Length, _before[i].Velocity.Length) + Math.Max(kicked, Math.Max(a.Velocity.Length, b.Velocity.Length)));
        }

        double size = (now.Position - _before[^1].Position).Length;
        _sizes.Add(size);
        TooLarge += size > told ? 1 : 0;
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

/// <summary>The hash of the ball at every tick that is final, in a file: two machines' are compared afterwards, tick by tick.</summary>
public sealed class HashLog(string? file) : IDisposable
{
    private readonly BinaryWriter? _writer = file is null ? null : new BinaryWriter(File.Open(file, FileMode.Append));

    public void Add(long tick, ulong hash)
    {
        _writer?.Write(tick);
        _writer?.Write(hash);
    }

    public void Dispose() => _writer?.Dispose();

    public static Dictionary<long, ulong> Read(string file)
    {
        byte[] bytes = File.ReadAllBytes(file);
        var hashes = new Dictionary<long, ulong>();
        for (int at = 0; at + 16 <= bytes.Length; at += 16)
        {
            hashes[BitConverter.ToInt64(bytes, at)] = BitConverter.ToUInt64(bytes, at + 8);
        }

        return hashes;
    }
}
