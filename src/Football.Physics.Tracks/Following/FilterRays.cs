namespace FootballPhysics.Tracks;

/// <summary>The rays of a hypothesis: the simulated motion, and one with each parameter changed. Their differences are the derivatives of the fit.</summary>
internal sealed class FilterRays(FilterModel model)
{
    private const int Motion = FilterHypothesis.Motion;
    private const int Most = FilterHypothesis.Most;

    /// <summary>The greatest difference of the upward velocity between rays that move alike, in m/s.</summary>
    private const double MostChange = 1;

    /// <summary>The width of a ray, in standard deviations, and its bounds for position, velocity, spin and time.</summary>
    private const double RayWidth = 0.5;
    private static readonly double[] s_leastWidth = [1e-4, 1e-3, 0.02, 1e-5];
    private static readonly double[] s_mostWidth = [0.5, 2.0, 8.0, 0.02];

    private readonly BallState[] _from = new BallState[Most + 1];
    private readonly Vector3d[] _places = new Vector3d[Most + 1];

    /// <summary>The end of the last long step: the rays are there.</summary>
    private double _strideEnd = double.NegativeInfinity;

    /// <summary>The end of the last long step that had an event: until then, no other long step is tried.</summary>
    public double ShortUntil { get; set; } = double.NegativeInfinity;

    /// <summary>The number of parameters.</summary>
    public int Count { get; set; }

    /// <summary>True if the rays may stop because the work of an update is used up.</summary>
    public bool MayStop { get; set; }

    /// <summary>True if the rays stopped: their hypothesis is cut.</summary>
    public bool IsStopped { get; private set; }

    /// <summary>The states on the rays: first that of the motion itself, then one per parameter.</summary>
    public BallState[] States { get; } = new BallState[Most + 1];

    /// <summary>The change of each parameter.</summary>
    public double[] Widths { get; } = new double[Most];

    /// <summary>True for a parameter that does not change, and has no ray.</summary>
    public bool[] IsFixed { get; } = new bool[Most];

    /// <summary>Returns the width of a ray that suits the uncertainty of the estimate.</summary>
    public static double WidthOf(int parameter, double[] spread)
    {
        int kind = parameter / 3;
        double width = RayWidth * Math.Sqrt(Math.Max(0, spread[(parameter * Most) + parameter]));
        return Math.Min(s_mostWidth[kind], Math.Max(s_leastWidth[kind], width));
    }

    /// <summary>Sets the motion at a moment from the rays and their derivatives, which are those of the moment.</summary>
    public void Extrapolate(FilterMoment moment, double[] values, double[] start)
    {
        Span<double> changes = stackalloc double[Most];
        changes = changes.Slice(0, Count);
        for (int j = 0; j < changes.Length; j++)
        {
            changes[j] = values[j] - start[j];
        }

        Read(in States[0], moment.Motion);
        for (int i = 0; i < Motion; i++)
        {
            ReadOnlySpan<double> rates = moment.Jacobian.AsSpan(i * Most, changes.Length);
            double sum = moment.Motion[i];
            for (int j = 0; j < changes.Length; j++)
            {
                sum += rates[j] * changes[j];
            }

            moment.Motion[i] = sum;
        }
    }

    /// <summary>Moves the rays to the time of a point, unless they stop.</summary>
    /// <returns>True if the point lies within the last long step, at whose end the rays stay.</returns>
    public bool Move(double time)
    {
        bool isOld = time <= _strideEnd;
        CubicWeights within = isOld ? CubicWeights.Of(_from[0].Time, States[0].Time, time) : default;
        for (int j = 0; j <= Count; j++)
        {
            if (j > 0 && IsFixed[j - 1])
            {
                _places[j] = _places[0];
                continue;
            }

            if (!isOld && !Stops())
            {
                model.Run(ref States[j], time);
            }

            _places[j] = isOld ? within.Between(in _from[j], in States[j]) : States[j].Position;
        }

        return isOld;
    }

    /// <summary>Begins again.</summary>
    public void Begin() => IsStopped = false;

    /// <summary>True if the rays stop, now or before.</summary>
    public bool Stops()
    {
        IsStopped |= MayStop && !model.MayRun;
        return IsStopped;
    }

    /// <summary>Forgets the last long step.</summary>
    public void EndStride() => (_strideEnd, ShortUntil) = (double.NegativeInfinity, double.NegativeInfinity);

    /// <summary>Moves the rays over several points that are older than the history, if no ray has an event on the way.</summary>
    /// <param name="points">The points.</param>
    /// <param name="first">The index of the first of them.</param>
    /// <param name="endOfKick">The latest time of a kick, if there is one.</param>
    /// <returns>The index after the last point that <see cref="Move"/> may now read.</returns>
    public int Stride(FilterPoints points, int first, double endOfKick)
    {
        int end = first;
        double from = States[0].Time;
        while (end < points.Count - FilterHistory.Room && points[end].Time - from <= FilterModel.LongestStep && points[end].Time > from)
        {
            end++;
        }

        _strideEnd = double.NegativeInfinity;
        if (end < first + 2 || from < ShortUntil || (Count == Most && from < endOfKick))
        {
            return first + 1;
        }

        double last = points[end - 1].Time;
        Array.Copy(States, _from, Count + 1);
        for (int j = 0; j <= Count; j++)
        {
            if (!(j > 0 && IsFixed[j - 1]) && (Stops() || !model.RunSmoothly(ref States[j], last)))
            {
                Array.Copy(_from, States, Count + 1);
                ShortUntil = points[end - 2].Time;
                return first + 1;
            }
        }

        _strideEnd = last;
        return end;
    }

    /// <summary>True if all rays move alike: none is before an impact that another one is after.</summary>
    public bool AreSmooth()
    {
        for (int j = 1; j <= Count; j++)
        {
            if (IsFixed[j - 1])
            {
                continue;
            }

            if (States[j].Motion != States[0].Motion || Math.Abs(States[j].Velocity.Y - States[0].Velocity.Y) > MostChange)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if all rays roll or rest.</summary>
    public bool Roll()
    {
        for (int j = 0; j <= Count; j++)
        {
            if (!(j > 0 && IsFixed[j - 1]) && States[j].Motion is not (MotionState.Rolling or MotionState.Rest))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Computes the derivatives of the motion, from the differences of the rays.</summary>
    public void Differentiate(double[] jacobian)
    {
        Span<double> motion = stackalloc double[Motion];
        Span<double> ray = stackalloc double[Motion];
        Read(in States[0], motion);
        for (int j = 0; j < Count; j++)
        {
            Read(in States[IsFixed[j] ? 0 : j + 1], ray);
            double inverse = 1 / Widths[j];
            for (int i = 0; i < Motion; i++)
            {
                jacobian[(i * Most) + j] = inverse * (ray[i] - motion[i]);
            }
        }
    }

    /// <summary>Computes the residual of a point at the base, its derivatives with respect to the parameters, and those with respect to the position.</summary>
    public void Observe(in FilterPoint point, FilterMoment moment)
    {
        Vector3d expected = point.Of(in _places[0]);
        Write(point.Measured - expected, moment.Residual, 0, 1);
        for (int j = 0; j < Count; j++)
        {
            Write((point.Of(in _places[j + 1]) - expected) * (1 / Widths[j]), moment.Rows, j, Most);
        }

        for (int axis = 0; axis < 3; axis++)
        {
            Write(point.Slope(in _places[0], in expected, Vector3d.Axis(axis)), moment.ByPosition, axis, 3);
        }
    }

    private static void Write(in Vector3d column, double[] rows, int at, int length) =>
        (rows[at], rows[at + length], rows[at + (2 * length)]) = (column.X, column.Y, column.Z);

    /// <summary>Returns position, velocity and spin of a state.</summary>
    public static void Read(in BallState state, Span<double> motion)
    {
        (motion[0], motion[1], motion[2]) = (state.Position.X, state.Position.Y, state.Position.Z);
        (motion[3], motion[4], motion[5]) = (state.Velocity.X, state.Velocity.Y, state.Velocity.Z);
        Vector3d spin = state.Spin;
        (motion[6], motion[7], motion[8]) = (spin.X, spin.Y, spin.Z);
    }
}

/// <summary>The weights of the two ends in the cubic of a smooth motion.</summary>
internal readonly record struct CubicWeights(double From, double To, double FromVelocity, double ToVelocity)
{
    /// <summary>Returns the weights at a time between the ends.</summary>
    public static CubicWeights Of(double from, double to, double time)
    {
        double span = to - from;
        double s = (time - from) / span;
        double r = 1 - s;
        return new CubicWeights(r * r * (1 + (2 * s)), s * s * (1 + (2 * r)), span * s * r * r, -span * s * r * s);
    }

    /// <summary>Returns the position.</summary>
    public Vector3d Between(in BallState from, in BallState to) =>
        (From * from.Position) + (To * to.Position) + (FromVelocity * from.Velocity) + (ToVelocity * to.Velocity);
}
