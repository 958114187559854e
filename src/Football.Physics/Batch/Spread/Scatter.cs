namespace Football.Physics;

/// <summary>Where the kicks of a player cross the plane of a goal, and how surely they go in.</summary>
/// <remarks>
/// Where the spread is small, the derivatives of the kick that is meant map it to an ellipse; whether they do is tried with kicks at two standard deviations.
/// Else a hundred thousand kicks are drawn and flown. Made once for a scene and used again. Not for several threads at once.
/// </remarks>
public sealed class Scatter
{
    /// <summary>Kicks that are flown where the spread is not small.</summary>
    public const int Flights = 100_000;

    /// <summary>The most of their deviation by which kicks at two standard deviations may miss the place that the derivatives say, and what does not count, m.</summary>
    private const double LargestBend = 0.06;
    private const double SmallestBend = 2e-3;

    private const double TimeStep = 0.02;

    private readonly Simulator _simulator;
    private readonly LaunchDerivatives _derivatives;
    private readonly PlaneFlights _flights;
    private readonly double[] _factor = new double[KickSpread.Count * KickSpread.Count];
    private readonly double[] _by = new double[KickSpread.Count];
    private readonly double[] _draws = new double[KickSpread.Count];
    private readonly Vector3d[] _velocities = new Vector3d[LaneGroup.Size];
    private readonly Vector3d[] _spins = new Vector3d[LaneGroup.Size];
    private readonly PlaneCrossingPoint[] _crossings = new PlaneCrossingPoint[LaneGroup.Size];

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Scatter(Scene? scene = null)
    {
        _simulator = new Simulator(scene);
        _derivatives = new LaunchDerivatives(_simulator);
        _flights = new PlaneFlights(_simulator);
    }

    /// <summary>Finds the scatter of a kick: by derivatives where the spread is small, by flights where it is not.</summary>
    /// <param name="position">Where the ball is, m.</param>
    /// <param name="velocity">The velocity that is meant, m/s; not vertical.</param>
    /// <param name="spin">The spin that is meant, rad/s.</param>
    /// <param name="spread">How much the kicks spread.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="keeper">Its goalkeeper at the kick, with the reach and heights of his dive; default none.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public ScatterResult Find(Vector3d position, Vector3d velocity, Vector3d spin, KickSpread spread, Goal goal, Runner? keeper = null)
    {
        Prepare(position, velocity, spin, spread, goal, keeper, out SpreadKick kick, out GoalPlane plane);
        return TryDerivatives(in kick, in plane, out ScatterResult result) ? result : Fly(in kick, in plane, Flights, 0);
    }

    /// <summary>Finds the scatter of a kick by kicks that are drawn and flown.</summary>
    /// <param name="position">Where the ball is, m.</param>
    /// <param name="velocity">The velocity that is meant, m/s; not vertical.</param>
    /// <param name="spin">The spin that is meant, rad/s.</param>
    /// <param name="spread">How much the kicks spread.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="keeper">Its goalkeeper at the kick, with the reach and heights of his dive; default none.</param>
    /// <param name="count">How many kicks; 2 … 100 000 000.</param>
    /// <param name="seed">Which kicks are drawn; the same ones for the same seed.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public ScatterResult FindByFlights(
        Vector3d position, Vector3d velocity, Vector3d spin, KickSpread spread, Goal goal, Runner? keeper = null, int count = Flights, long seed = 0)
    {
        Check.Within(nameof(count), count, 2, 100_000_000);
        Prepare(position, velocity, spin, spread, goal, keeper, out SpreadKick kick, out GoalPlane plane);
        return Fly(in kick, in plane, count, seed);
    }

    private void Prepare(
        in Vector3d position, in Vector3d velocity, in Vector3d spin, KickSpread spread, Goal goal, Runner? keeper, out SpreadKick kick, out GoalPlane plane)
    {
        Check.Given(nameof(spread), spread);
        Check.Given(nameof(goal), goal);
        BallState ball = _simulator.Launch(position, velocity, spin);
        spread.Factor(_factor);
        kick = new SpreadKick(ball.Position, in velocity, in spin);
        plane = new GoalPlane(goal, _simulator.Scene.Ball.Radius, keeper);
    }

    /// <summary>By derivatives: A = M L maps normal numbers to the plane, where kicks at ± two standard deviations are where it says.</summary>
    private bool TryDerivatives(in SpreadKick kick, in GoalPlane plane, out ScatterResult result)
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
        Vector3d normal = plane.Out;
        for (int j = 0; j < KickSpread.Count; j++)
        {
            // One standard deviation along a column of L; where it crosses the plane δq = δp − v (n·δp)/(n·v).
            Vector3d change = Vector3d.Zero;
            for (int i = 0; i < KickSpread.Count; i++)
            {
                kick.Derivative(i, out Vector3d velocity, out Vector3d spin);
                _by[i] = _factor[(i * KickSpread.Count) + j];
                change += _by[i] * ((_derivatives.PositionByVelocity * velocity) + (_derivatives.PositionBySpin * spin));
            }

            change -= Vector3d.Dot(in normal, in change) / Vector3d.Dot(in normal, ball.Velocity) * ball.Velocity;
            plane.Change(in change, out double right, out double up);
            if (!Holds(in kick, in plane, aside, height, 2.0 * right, 2.0 * up, 2.0) || !Holds(in kick, in plane, aside, height, -2.0 * right, -2.0 * up, -2.0))
            {
                return false;
            }

            a += right * right;
            b += up * up;
            c += right * up;
        }

        double product = Math.Sqrt(a * b);
        result = new ScatterResult
        {
            Method = ScatterMethod.Derivatives,
            Kicks = 2 + (2 * KickSpread.Count),
            Crosses = 1,
            Aside = aside,
            Height = height,
            Time = meant.Time,
            AsideDeviation = Math.Sqrt(a),
            HeightDeviation = Math.Sqrt(b),
            Correlation = product > 0 ? Math.Min(1, Math.Max(-1, c / product)) : 0,
        };
        plane.Chances(in result, out double onTarget, out double covered);
        result = With(in result, onTarget, covered);
        return true;
    }

    /// <summary>Whether a kick some standard deviations off crosses where the derivatives say.</summary>
    private bool Holds(in SpreadKick kick, in GoalPlane plane, double aside, double height, double right, double up, double deviations)
    {
        for (int i = 0; i < KickSpread.Count; i++)
        {
            _draws[i] = deviations * _by[i];
        }

        kick.With(_draws, out Vector3d velocity, out Vector3d spin);
        PlaneCrossingPoint at = _flights.Alone(kick.Position, in plane, in velocity, in spin);
        plane.Place(at.Position, out double aside2, out double height2);
        double x = aside2 - aside - right;
        double y = height2 - height - up;
        return at.Time > 0 && Math.Sqrt((x * x) + (y * y)) <= (LargestBend * Math.Sqrt((right * right) + (up * up))) + SmallestBend;
    }

    private ScatterResult Fly(in SpreadKick kick, in GoalPlane plane, int count, long seed)
    {
        var sum = new ScatterSum();
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
                sum.Add(in plane, in _crossings[i]);
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

        for (int i = 0; i < KickSpread.Count; i++)
        {
            double sum = 0;
            for (int j = 0; j <= i; j++)
            {
                sum += _factor[(i * KickSpread.Count) + j] * _draws[j];
            }

            _by[i] = sum;
        }
    }

    private static ScatterResult With(in ScatterResult of, double onTarget, double covered) => new()
    {
        Method = of.Method,
        Kicks = of.Kicks,
        Crosses = of.Crosses,
        Aside = of.Aside,
        Height = of.Height,
        Time = of.Time,
        AsideDeviation = of.AsideDeviation,
        HeightDeviation = of.HeightDeviation,
        Correlation = of.Correlation,
        OnTarget = onTarget,
        Covered = covered,
    };
}
