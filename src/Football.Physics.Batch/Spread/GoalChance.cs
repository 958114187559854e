namespace FootballPhysics.Batch;

/// <summary>Computes how a player's kicks spread on the plane of a goal, and their probability of a goal.</summary>
/// <remarks>
/// If the spread is small, the derivatives of the intended kick map it to an ellipse; test kicks at two standard deviations check this. Otherwise it
/// simulates 100,000 random kicks. Create one per scene and reuse it. Not thread-safe.
/// </remarks>
public sealed class GoalChance
{
    /// <summary>The number of simulated kicks if the spread is not small.</summary>
    public const int Flights = 100_000;

    /// <summary>Limits of the test kicks at two standard deviations, relative to two standard deviations along the short axis.</summary>
    /// <remarks>The first limits the error of the derivatives, the second the common bend of both sides, whose mean is corrected. Below the third, in m, neither counts.</remarks>
    private const double LargestError = 0.08;
    private const double LargestBend = 0.25;
    private const double Negligible = 1e-3;

    private const double TimeStep = 0.02;

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

    /// <summary>Computes the spread of a kick: by derivatives if it is small, otherwise by simulation.</summary>
    /// <param name="position">The position of the ball, in m.</param>
    /// <param name="velocity">The intended velocity, in m/s; not vertical.</param>
    /// <param name="spin">The intended spin, in rad/s.</param>
    /// <param name="spread">The spread of the player's kicks.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="keeper">The goalkeeper at the kick, with the reach and heights of his dive; default none.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public GoalChanceResult Find(Vector3d position, Vector3d velocity, Vector3d spin, KickSpread spread, Goal goal, Player? keeper = null)
    {
        Prepare(position, velocity, spin, spread, goal, keeper, out SpreadKick kick, out GoalPlane plane);
        return TryDerivatives(in kick, in plane, out GoalChanceResult result) ? result : Fly(in kick, in plane, Flights, 0);
    }

    /// <summary>Computes the spread of a kick by simulating random kicks.</summary>
    /// <param name="position">The position of the ball, in m.</param>
    /// <param name="velocity">The intended velocity, in m/s; not vertical.</param>
    /// <param name="spin">The intended spin, in rad/s.</param>
    /// <param name="spread">The spread of the player's kicks.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="keeper">The goalkeeper at the kick, with the reach and heights of his dive; default none.</param>
    /// <param name="count">The number of kicks; 2 … 100 000 000.</param>
    /// <param name="seed">The seed of the random kicks; equal seeds give equal kicks.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public GoalChanceResult FindByFlights(
        Vector3d position, Vector3d velocity, Vector3d spin, KickSpread spread, Goal goal, Player? keeper = null, int count = Flights, long seed = 0)
    {
        Check.Within(nameof(count), count, 2, 100_000_000);
        Prepare(position, velocity, spin, spread, goal, keeper, out SpreadKick kick, out GoalPlane plane);
        return Fly(in kick, in plane, count, seed);
    }

    private void Prepare(
        in Vector3d position, in Vector3d velocity, in Vector3d spin, KickSpread spread, Goal goal, Player? keeper, out SpreadKick kick, out GoalPlane plane)
    {
        Check.Given(nameof(spread), spread);
        Check.Given(nameof(goal), goal);
        plane = new GoalPlane(goal, keeper);
        Compile(goal);
        BallState ball = _simulator.Launch(position, velocity, spin);
        spread.Factor(_factor);
        kick = new SpreadKick(ball.Position, in velocity, in spin);
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

    /// <summary>Tries the derivatives: A = M L maps normal numbers to the plane. False if kicks at ± two standard deviations disagree.</summary>
    private bool TryDerivatives(in SpreadKick kick, in GoalPlane plane, out GoalChanceResult result)
    {
        result = default;
        PlaneCrossingPoint meant = _flights.Alone(kick.Position, in plane, kick.Velocity, kick.Spin);
        if (!(meant.Time > 0))
        {
            return false;
        }

        BallState ball = _simulator.Launch(kick.Position, kick.Velocity, kick.Spin);
        _derivatives.Run(ref ball, TimeStep, meant.Time, StopAt.Time);
        plane.Place(meant.Position, out double aside, out double height);
        double a = 0;
        double b = 0;
        double c = 0;
        for (int j = 0; j < KickSpread.Count; j++)
        {
            Map(in kick, in plane, ball.Velocity, j, out double right, out double up);
            a += right * right;
            b += up * up;
            c += right * up;
        }

        double product = Math.Sqrt(a * b);
        result = new GoalChanceResult
        {
            Method = GoalChanceMethod.Derivatives,
            Kicks = 2 + (2 * KickSpread.Count),
            Crosses = 1,
            Aside = aside,
            Height = height,
            Time = meant.Time,
            AsideDeviation = Math.Sqrt(a),
            HeightDeviation = Math.Sqrt(b),
            Correlation = product > 0 ? Math.Min(1, Math.Max(-1, c / product)) : 0,
        };
        double shiftAside = 0;
        double shiftHeight = 0;
        for (int j = 0; j < KickSpread.Count; j++)
        {
            Map(in kick, in plane, ball.Velocity, j, out double right, out double up);
            if (!Holds(in kick, in plane, in result, right, up, out double bendAside, out double bendHeight))
            {
                return false;
            }

            // The mean of a curve x + ½ x'' z² is shifted by ½ x''.
            shiftAside += 0.5 * bendAside;
            shiftHeight += 0.5 * bendHeight;
        }

        result = result with { Aside = aside + shiftAside, Height = height + shiftHeight };
        _frame!.Look(_simulator, in kick, meant.Time, in result);
        plane.Chances(in result, _frame, out double onTarget, out double covered);
        result = result with { OnTarget = onTarget, Covered = covered };
        return true;
    }

    /// <summary>Maps one standard deviation along a column of L to the plane: δq = δp − v (n·δp)/(n·v).</summary>
    private void Map(in SpreadKick kick, in GoalPlane plane, in Vector3d velocity, int column, out double right, out double up)
    {
        Vector3d change = Vector3d.Zero;
        for (int i = 0; i < KickSpread.Count; i++)
        {
            kick.Derivative(i, out Vector3d velocityBy, out Vector3d spinBy);
            _by[i] = _factor[(i * KickSpread.Count) + column];
            change += _by[i] * ((_derivatives.PositionByVelocity * velocityBy) + (_derivatives.PositionBySpin * spinBy));
        }

        Vector3d normal = plane.Out;
        change -= Vector3d.Dot(in normal, in change) / Vector3d.Dot(in normal, in velocity) * velocity;
        plane.Change(in change, out right, out up);
    }

    /// <summary>Returns true if kicks at two standard deviations on both sides cross where the derivatives predict. Also returns their second derivative.</summary>
    private bool Holds(
        in SpreadKick kick, in GoalPlane plane, in GoalChanceResult at, double right, double up, out double bendAside, out double bendHeight)
    {
        bool crosses = Cross(in kick, in plane, 2.0, out double x1, out double y1);
        crosses &= Cross(in kick, in plane, -2.0, out double x0, out double y0);
        double oddX = (0.5 * (x1 - x0)) - (2.0 * right);
        double oddY = (0.5 * (y1 - y0)) - (2.0 * up);
        double evenX = x1 + x0 - (2.0 * at.Aside);
        double evenY = y1 + y0 - (2.0 * at.Height);
        bendAside = 0.25 * evenX;
        bendHeight = 0.25 * evenY;
        double axis = 2.0 * at.ShortAxis;
        return crosses && Math.Sqrt((oddX * oddX) + (oddY * oddY)) <= (LargestError * axis) + Negligible
            && 0.5 * Math.Sqrt((evenX * evenX) + (evenY * evenY)) <= (LargestBend * axis) + Negligible;
    }

    private bool Cross(in SpreadKick kick, in GoalPlane plane, double deviations, out double aside, out double height)
    {
        for (int i = 0; i < KickSpread.Count; i++)
        {
            _draws[i] = deviations * _by[i];
        }

        kick.With(_draws, out Vector3d velocity, out Vector3d spin);
        PlaneCrossingPoint at = _flights.Alone(kick.Position, in plane, in velocity, in spin);
        plane.Place(at.Position, out aside, out height);
        return at.Time > 0;
    }

    private GoalChanceResult Fly(in SpreadKick kick, in GoalPlane plane, int count, long seed)
    {
        var sum = new GoalChanceSum();
        int drawn = 0;
        while (drawn < count)
        {
            int group = Math.Min(LaneGroup.Size, count - drawn);
            for (int i = 0; i < group; i++)
            {
                Draw(seed, drawn + i);
                kick.With(_by, out _velocities[i], out _spins[i]);
            }

            _flights.Fly(kick.Position, in plane, _velocities, _spins, group, _crossings);
            for (int i = 0; i < group; i++)
            {
                bool goesIn = _frame!.GoesIn(in kick, in _velocities[i], in _spins[i], in _crossings[i]);
                sum.Add(in plane, in _crossings[i], goesIn);
            }

            drawn += group;
        }

        return sum.Result(count);
    }

    /// <summary>Draws four numbers with the covariance L Lᵀ.</summary>
    private void Draw(long seed, int index)
    {
        for (int i = 0; i < KickSpread.Count; i += 2)
        {
            int counter = (index * KickSpread.Count) + i;
            NormalDistribution.Draw(SplitMix64.At(seed, counter), SplitMix64.At(seed, counter + 1), out _draws[i], out _draws[i + 1]);
        }

        KickSpread.Correlate(_factor, _draws, _by);
    }
}
