namespace Football.Physics;

/// <summary>What a piece of any motion but plain flight does to the derivatives by the launch.</summary>
internal sealed class PieceTangent<TAir>
    where TAir : struct, IAir
{
    /// <summary>The Gauss points of 0 … 1.</summary>
    private const double FirstGauss = 0.21132486540518713;
    private const double SecondGauss = 1.0 - FirstGauss;

    /// <summary>Share of the slip by which a motion is changed near the end of a slide.</summary>
    private const double SlipShare = 1e-3;

    /// <summary>Parts for a slip that ends within one piece.</summary>
    private const double PartsOfWhole = 32;

    /// <summary>A part of a flight changes the flow by no more than this share of it, and need not change it by less than this, m/s.</summary>
    private const double FlowShare = 0.1;
    private const double LeastFlow = 1e-3;

    private readonly Tangent _tangent;
    private readonly double _radius;
    private readonly double[] _map = new double[MotionVector.Size * MotionVector.Size];
    private readonly double[] _first = new double[MotionVector.Size * MotionVector.Size];
    private readonly double[] _second = new double[MotionVector.Size * MotionVector.Size];

    public PieceTangent(Tangent tangent, double radius)
    {
        _tangent = tangent;
        _radius = radius;
    }

    /// <summary>The end of a slide in closed form, from the start of its last piece to the roll.</summary>
    public void EndSlide(LocalMotion<TAir> now, double time, in Motion start, double[] eventTimes)
    {
        Array.Clear(_map, 0, _map.Length);
        _map[_map.Length - 1] = 1;
        double width = SlipShare * now.SpeedOnSurface(time, in start);
        Span<double> times = stackalloc double[MotionVector.Size];
        for (int i = 0; i < MotionVector.AirDistance; i++)
        {
            double by = i < MotionVector.Velocity ? MotionVector.Width(in start, i) : i < MotionVector.Spin ? width : width / _radius;
            Motion high = now.EndSlide(time, MotionVector.Changed(in start, i, by), out double later);
            Motion low = now.EndSlide(time, MotionVector.Changed(in start, i, -by), out double sooner);
            MotionVector.Write(_map, i, in high, in low, 2.0 * by);
            times[i] = (later - sooner) / (2.0 * by);
            if (i < MotionVector.Spin)
            {
                // Place and velocity change by little.
                _map[(i * MotionVector.Size) + i] += 1;
            }
        }

        for (int c = 0; c < Tangent.Columns; c++)
        {
            double sum = 0;
            for (int i = 0; i < MotionVector.AirDistance; i++)
            {
                sum += times[i] * _tangent[i, c];
            }

            eventTimes[c] = sum;
        }

        _tangent.Map(_map);
    }

    /// <summary>The variational equation along a piece.</summary>
    public void Propagate(LocalMotion<TAir> now, double time, in Motion start, in Motion end, double h)
    {
        now.Rates(time, in start, out MotionRates startRates);
        now.Rates(time + h, in end, out MotionRates endRates);
        int parts = Parts(now, time, in start, in end, h);
        double part = h / parts;
        for (int i = 0; i < parts; i++)
        {
            double first = (i + FirstGauss) / parts;
            double second = (i + SecondGauss) / parts;
            MotionJacobian.At(now, time + (first * h), Between(first, h, in start, in startRates, in end, in endRates), _first);
            MotionJacobian.At(now, time + (second * h), Between(second, h, in start, in startRates, in end, in endRates), _second);
            _tangent.Integrate(part, _first, _second);
        }
    }

    /// <summary>How many parts to take a piece in: the direction of friction turns with 1/|s|, or 1/|v|, which must not change by much within a part.</summary>
    private static int Parts(LocalMotion<TAir> now, double time, in Motion start, in Motion end, double h)
    {
        if (now.IsPinned)
        {
            return 1;
        }

        // Where the flow all but stops it turns fast.
        double slowest = Math.Min(now.FlowAt(in start), now.FlowAt(in end));
        double turning = Vector3d.Distance(start.Velocity, end.Velocity) / ((FlowShare * slowest) + LeastFlow);
        double before = now.Motion == MotionState.Airborne ? 0 : now.SpeedOnSurface(time, in start);
        double after = now.Motion == MotionState.Airborne ? 0 : now.SpeedOnSurface(time + h, in end);
        double most = Math.Max(before, after);
        double stopping = most > 0 ? PartsOfWhole * (Math.Abs(before - after) / most) : 0;
        return 1 + (int)Math.Min(PartsOfWhole, Math.Max(turning, stopping));
    }

    /// <summary>The motion between both ends of a piece: cubic Hermite interpolants.</summary>
    private static Motion Between(double s, double h, in Motion start, in MotionRates startRates, in Motion end, in MotionRates endRates)
    {
        double t = s * h;
        return new Motion(
            new CubicHermite3d(start.Position, start.Velocity, end.Position, end.Velocity, h).PositionAt(t),
            new CubicHermite3d(start.Velocity, startRates.Acceleration, end.Velocity, endRates.Acceleration, h).PositionAt(t),
            new CubicHermite3d(start.Spin, startRates.SpinAcceleration, end.Spin, endRates.SpinAcceleration, h).PositionAt(t),
            start.AirDistance + (s * (end.AirDistance - start.AirDistance)));
    }
}
