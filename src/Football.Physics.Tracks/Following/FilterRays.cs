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
        Read(in States[0], moment.Motion);
        for (int i = 0; i < Motion; i++)
        {
            for (int j = 0; j < Count; j++)
            {
                moment.Motion[i] += moment.Jacobian[(i * Most) + j] * (values[j] - start[j]);
            }
        }
    }

    /// <summary>Moves the rays to the time of a point, unless they stop.</summary>
    /// <returns>True if the point lies within the last long step, at whose end the rays stay.</returns>
    public bool Move(double time)
    {
        bool isOld = time <= _strideEnd;
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

            _places[j] = isOld ? Between(in _from[j], in States[j], time) : States[j].Position;
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
    public void EndStride() => _strideEnd = double.NegativeInfinity;

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
        if (end < first + 2 || Count == Most && from < endOfKick)
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
                return first + 1;
            }
        }

        _strideEnd = last;
        return end;
    }

    /// <summary>Returns the position between two states of a smooth motion, by a cubic.</summary>
    private static Vector3d Between(in BallState from, in BallState to, double time)
    {
        double span = to.Time - from.Time;
        double s = (time - from.Time) / span;
        double r = 1 - s;
        return (r * r * (1 + (2 * s)) * from.Position) + (s * s * (1 + (2 * r)) * to.Position) + (span * s * r * ((r * from.Velocity) - (s * to.Velocity)));
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
        Vector3d expected = point.Of(_places[0]);
        Vector3d residual = point.Measured - expected;
        for (int row = 0; row < point.Rows; row++)
        {
            moment.Residual[row] = residual.Along(row);
        }

        for (int j = 0; j < Count; j++)
        {
            Vector3d change = (point.Of(_places[j + 1]) - expected) / Widths[j];
            for (int row = 0; row < point.Rows; row++)
            {
                moment.Rows[(row * Most) + j] = change.Along(row);
            }
        }

        const double Step = 1e-3;
        for (int axis = 0; axis < 3; axis++)
        {
            Vector3d change = (point.Of(_places[0] + (Step * Vector3d.Axis(axis))) - expected) / Step;
            for (int row = 0; row < point.Rows; row++)
            {
                moment.ByPosition[(row * 3) + axis] = change.Along(row);
            }
        }
    }

    /// <summary>Returns position, velocity and spin of a state.</summary>
    public static void Read(in BallState state, Span<double> motion)
    {
        (motion[0], motion[1], motion[2]) = (state.Position.X, state.Position.Y, state.Position.Z);
        (motion[3], motion[4], motion[5]) = (state.Velocity.X, state.Velocity.Y, state.Velocity.Z);
        Vector3d spin = state.Spin;
        (motion[6], motion[7], motion[8]) = (spin.X, spin.Y, spin.Z);
    }
}
