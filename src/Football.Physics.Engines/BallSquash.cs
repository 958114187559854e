using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The drawn squash of a ball: it flattens along the normal of its last impact, and keeps its volume.</summary>
/// <remarks>
/// The simulation does not depend on this object: pass the events of each step, and scale the drawn ball. The largest squash is
/// <see cref="Impact.Compression"/>. A real contact lasts about 10 ms, less than a frame, so the drawn one lasts at least <see cref="ShortestTime"/>.
/// </remarks>
public sealed class BallSquash
{
    /// <summary>The shortest time in which a squash is drawn, in s: 0.06 (guess: several frames).</summary>
    public const double ShortestTime = 0.06;

    /// <summary>The smallest compression that is drawn, in radii (guess).</summary>
    private const double Visible = 0.01;

    private readonly Simulator _simulator;
    private Vector3d _normal = Vector3d.Up;
    private double _compression;
    private double _start;
    private double _time;

    /// <summary>Creates the squash of a ball of a scene.</summary>
    /// <param name="simulator">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public BallSquash(Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        _simulator = simulator;
    }

    /// <summary>Starts a squash if an event is an impact that compresses the ball more than it is drawn at that time. Does not allocate.</summary>
    /// <param name="happened">An event of the ball.</param>
    public void Follow(in BallEvent happened)
    {
        if (happened.Kind != BallEventKind.Impact)
        {
            return;
        }

        Impact impact = _simulator.ImpactOf(in happened);
        if (impact.Compression > Visible * _simulator.Scene.Ball.Radius && impact.Compression >= DepthAt(happened.Time))
        {
            _normal = happened.Normal;
            _compression = impact.Compression;
            _start = happened.Time;
            _time = Math.Max(ShortestTime, impact.ContactTime);
        }
    }

    /// <summary>Makes the ball round. Call it when the clock of the ball begins again.</summary>
    public void Clear() => _compression = 0;

    /// <summary>Returns the stretch of the drawn ball at a time: x sin(π t/T) along the normal.</summary>
    /// <param name="time">The time at which the ball is drawn, on the clock of the ball, in s. Before the impact, and after the squash, the ball is round.</param>
    public BallStretch At(double time) => new(in _normal, DepthAt(time) / (2.0 * _simulator.Scene.Ball.Radius));

    /// <summary>Returns the compression at a time, in m.</summary>
    private double DepthAt(double time)
    {
        double since = time - _start;
        if (!(since > 0 && since < _time))
        {
            return 0;
        }

        Elementary.SinCos(Math.PI * since / _time, out double sine, out _);
        return _compression * sine;
    }
}
