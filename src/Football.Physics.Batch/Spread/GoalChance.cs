using System.Globalization;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>Computes how a player's kicks spread on the plane of a goal, and the probability that they score.</summary>
/// <remarks>
/// If the spread is small, the derivatives of the intended kick map it to an ellipse; test kicks at two standard deviations verify this. Otherwise it
/// simulates random kicks, at most <see cref="GoalChanceRequest.Kicks"/>. Equal requests give bit-identical results on every machine. Create one per
/// scene and reuse it. Not thread-safe.
/// <para>With <see cref="ForceSet.KnuckleSeed"/>, each kick is simulated alone: more than 1000 kicks are rejected. All kicks have the same orientation and wake.</para>
/// </remarks>
public sealed partial class GoalChance
{
    /// <summary>The default number of simulated kicks: 2000.</summary>
    public const int Flights = 2000;

    private readonly Scene _scene;
    private Simulator _simulator;
    private LaunchDerivatives _derivatives;
    private PlaneFlights _flights;
    private Goal? _goal;
    private FramePlays? _frame;
    private readonly double[] _factor = new double[KickSpread.Count * KickSpread.Count];
    private readonly double[] _by = new double[KickSpread.Count];
    private readonly double[] _draws = new double[KickSpread.Count];
    private readonly Vector3d[] _velocities = new Vector3d[LaneGroup.Size];
    private readonly Vector3d[] _spins = new Vector3d[LaneGroup.Size];
    private readonly PlaneCrossingPoint[] _crossings = new PlaneCrossingPoint[LaneGroup.Size];

    /// <summary>Creates a calculator for a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public GoalChance(Scene? scene = null)
    {
        _simulator = new Simulator(scene);
        _scene = _simulator.Scene;
        _derivatives = new LaunchDerivatives(_simulator);
        _flights = new PlaneFlights(_simulator);
    }

    /// <summary>Computes the spread of a kick: by derivatives if they are accurate, otherwise by simulation.</summary>
    /// <param name="request">The kick, its spread, the goal, and the number of kicks to simulate.</param>
    /// <param name="progress">Receives the progress of the simulation, 0 … 1, every 256 kicks; default none.</param>
    /// <param name="cancellation">Cancels the simulation; checked every 256 kicks.</param>
    /// <exception cref="ArgumentNullException">The request, its spread or its goal is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A number is out of range, or more than 1000 kicks must be simulated with a knuckle force; the message names field, value and range.
    /// </exception>
    /// <exception cref="OperationCanceledException">The simulation was cancelled.</exception>
    public GoalChanceResult Find(GoalChanceRequest request, IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        cancellation.ThrowIfCancellationRequested();
        Prepare(request, out SpreadKick kick, out GoalPlane plane);
        if (!request.AlwaysSimulate && TryDerivatives(in kick, in plane, out GoalChanceResult result))
        {
            progress?.Report(1);
            return result;
        }

        return Fly(in kick, in plane, request, progress, cancellation);
    }

    /// <summary>Computes the spread of a kick: by derivatives if they are accurate, otherwise by simulating 2,000 kicks.</summary>
    /// <param name="position">The position of the ball, in m.</param>
    /// <param name="velocity">The intended velocity, in m/s; not vertical.</param>
    /// <param name="spin">The intended spin, in rad/s.</param>
    /// <param name="spread">The spread of the player's kicks.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="keeper">The goalkeeper at the time of the kick, with the reach and heights of his dive; default none.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public GoalChanceResult Find(Vector3d position, Vector3d velocity, Vector3d spin, KickSpread spread, Goal goal, Player? keeper = null) =>
        Find(new GoalChanceRequest { Position = position, Velocity = velocity, Spin = spin, Spread = spread, Goal = goal, Keeper = keeper });

    /// <summary>Computes the spread of a kick by simulating random kicks.</summary>
    /// <param name="position">The position of the ball, in m.</param>
    /// <param name="velocity">The intended velocity, in m/s; not vertical.</param>
    /// <param name="spin">The intended spin, in rad/s.</param>
    /// <param name="spread">The spread of the player's kicks.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="keeper">The goalkeeper at the time of the kick, with the reach and heights of his dive; default none.</param>
    /// <param name="count">The number of kicks; 2 … 100 000 000, default 2000.</param>
    /// <param name="seed">The seed of the random kicks; equal seeds give equal kicks.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public GoalChanceResult FindByFlights(
        Vector3d position,
        Vector3d velocity,
        Vector3d spin,
        KickSpread spread,
        Goal goal,
        Player? keeper = null,
        int count = Flights,
        long seed = 0)
    {
        // Check the count under the name of this parameter.
        Check.Within(nameof(count), count, 2, GoalChanceRequest.MostKicks);
        return Find(new GoalChanceRequest
        {
            Position = position,
            Velocity = velocity,
            Spin = spin,
            Spread = spread,
            Goal = goal,
            Keeper = keeper,
            Kicks = count,
            Seed = seed,
            AlwaysSimulate = true,
        });
    }

    private void Prepare(GoalChanceRequest request, out SpreadKick kick, out GoalPlane plane)
    {
        plane = new GoalPlane(request.Goal, request.Keeper);
        Compile(request.Goal);
        Quaterniond orientation = request.Orientation ?? _simulator.LaunchOrientation;
        BallState ball = _simulator.Launch(request.Position, request.Velocity, request.Spin, orientation);
        request.Spread.Factor(_factor);
        kick = new SpreadKick(ball.Position, request.Velocity, request.Spin, ball.Orientation);
    }

    /// <summary>Compiles the scene twice: without the goal, to find crossings of its plane, and with it, to simulate kicks near its frame.</summary>
    private void Compile(Goal goal)
    {
        if (_frame is not null && ReferenceEquals(goal, _goal))
        {
            return;
        }

        // If the scene has a goal at this position, use that goal with its own material.
        var mouth = new GoalMouth(goal);
        Goal[] others = [.. _scene.Goals.Where(other => !new GoalMouth(other).IsAt(mouth))];
        bool stands = others.Length < _scene.Goals.Count;
        if (_simulator.Scene.Goals.Count != others.Length || others.Length > 0)
        {
            _simulator = new Simulator(_scene with { Goals = others });
            _derivatives = new LaunchDerivatives(_simulator);
            _flights = new PlaneFlights(_simulator);
        }

        _frame = new FramePlays(stands ? _scene : _scene with { Goals = [.. _scene.Goals, goal] }, goal);
        _goal = goal;
    }

    /// <summary>Simulates random kicks, in groups.</summary>
    private GoalChanceResult Fly(
        in SpreadKick kick, in GoalPlane plane, GoalChanceRequest request, IProgress<double>? progress, CancellationToken cancellation)
    {
        int count = request.Kicks;
        if (_scene.Forces.KnuckleSeed is not null && count > GoalChanceRequest.MostAlone)
        {
            throw Check.Refusal("goalChance.kicks", count.ToString(CultureInfo.InvariantCulture), FormattableString.Invariant($"2 … {GoalChanceRequest.MostAlone} with forces.knuckleSeed, because each kick is then simulated alone"));
        }

        var sum = new GoalChanceSum();
        var draws = new KickDraws(request.Seed);
        int drawn = 0;
        while (drawn < count)
        {
            cancellation.ThrowIfCancellationRequested();
            int group = Math.Min(LaneGroup.Size, count - drawn);
            for (int i = 0; i < group; i++)
            {
                draws.Draw(drawn + i, _draws);
                KickSpread.Correlate(_factor, _draws, _by);
                kick.With(_by, out _velocities[i], out _spins[i]);
            }

            _flights.Fly(in kick, in plane, _velocities, _spins, group, _crossings);
            for (int i = 0; i < group; i++)
            {
                bool goesIn = _frame!.GoesIn(in kick, in _velocities[i], in _spins[i], in _crossings[i], out bool hitsFrame);
                sum.Add(in plane, in _crossings[i], goesIn, hitsFrame);
            }

            drawn += group;
            progress?.Report((double)drawn / count);
        }

        return sum.Result(count);
    }
}
