namespace Football.Physics;

/// <summary>What a piece of any motion but plain flight does to the derivatives by the launch.</summary>
internal sealed class PieceTangent<TAir>
    where TAir : struct, IAir
{
    /// <summary>The Gauss points of 0 … 1.</summary>
    private const double FirstGauss = 0.21132486540518713;
    private const double SecondGauss = 1.0 - FirstGauss;

    /// <summary>Share of the slip by which a motion is changed near the end of a slide.</summary>
    private const double SlipShare = 4e-3;

    /// <summary>Parts for a slip that ends within one piece.</summary>
    private const double PartsOfWhole = 32;

    /// <summary>A part of a flight changes the flow by no more than this share of it, and need not change it by less than this, m/s.</summary>
    private const double FlowShare = 0.1;
    private const double LeastFlow = 1e-3;

    /// <summary>Share of a speed by which it is changed for what a step makes of it, and the largest and the least change, m/s.</summary>
    private const double Share = 1e-4;
    private const double Largest = 2e-3;
    private const double Least = 1e-7;

    private readonly Tangent _tangent;
    private readonly StepTangent<TAir> _step;
    private readonly double _radius;
    private readonly double[] _map = new double[MotionVector.Size * MotionVector.Size];
    private readonly double[] _first = new double[MotionVector.Size * MotionVector.Size];
    private readonly double[] _second = new double[MotionVector.Size * MotionVector.Size];

    public PieceTangent(Tangent tangent, double radius, StepTangent<TAir> step)
    {
        _tangent = tangent;
        _step = step;
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
            Motion near = Quotient(now, time, in start, i, by, out double nearTime);
            Motion far = Quotient(now, time, in start, i, 2.0 * by, out double farTime);

            // Of fourth order, (4 q(h) − q(2h))/3
            MotionVector.Write(_map, 0, i, near.Position + ((1.0 / 3.0) * (near.Position - far.Position)));
            MotionVector.Write(_map, MotionVector.Velocity, i, near.Velocity + ((1.0 / 3.0) * (near.Velocity - far.Velocity)));
            MotionVector.Write(_map, MotionVector.Spin, i, near.Spin + ((1.0 / 3.0) * (near.Spin - far.Spin)));
            times[i] = nearTime + ((nearTime - farTime) / 3.0);
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

    /// <summary>How the end of a slide changes with one number of its start, by a central difference.</summary>
    private static Motion Quotient(LocalMotion<TAir> now, double time, in Motion start, int index, double width, out double byTime)
    {
        Motion high = now.EndSlide(time, MotionVector.Changed(in start, index, width), out double later);
        Motion low = now.EndSlide(time, MotionVector.Changed(in start, index, -width), out double sooner);
        double perWidth = 0.5 / width;
        byTime = perWidth * (later - sooner);
        return new Motion(perWidth * (high.Position - low.Position), perWidth * (high.Velocity - low.Velocity), perWidth * (high.Spin - low.Spin));
    }

    /// <summary>What a piece does: the variational equation along it; a whole step of flight or of a roll is differentiated as it was taken.</summary>
    public void Propagate(LocalMotion<TAir> now, double time, in Motion start, in Motion end, double h)
    {
        int parts = Parts(now, time, in start, in end, h);
        if (parts == 1 && now.Nets == 0 && now.Motion != MotionState.Sliding)
        {
            Step(now, time, in start, h);
            return;
        }

        now.Rates(time, in start, out MotionRates startRates);
        now.Rates(time + h, in end, out MotionRates endRates);
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

    /// <summary>A whole step, as the simulation takes it: how its end changes with its start.</summary>
    private void Step(LocalMotion<TAir> now, double time, in Motion start, double h)
    {
        // What does not depend on the place goes on with it.
        Array.Clear(_map, 0, _map.Length);
        _map[_map.Length - 1] = 1;
        for (int i = 0; i < MotionVector.Velocity; i++)
        {
            _map[i * (MotionVector.Size + 1)] = 1;
        }

        // The smaller the flow, its part across the spin, or a roll, the faster forces turn with it.
        double scale = now.FlowAt(in start);
        if (now.Motion != MotionState.Airborne)
        {
            scale = Math.Min(scale, now.SpeedOnSurface(time, in start));
        }
        else if (start.Spin.LengthSquared > 0)
        {
            scale = Math.Min(scale, now.AcrossAt(in start));
        }

        double width = Math.Max(Least, Math.Min(Largest, Share * scale));
        int last = now.DependsOnPlace ? MotionVector.Size : MotionVector.AirDistance;
        for (int i = now.DependsOnPlace ? 0 : MotionVector.Velocity; i < last; i++)
        {
            double by = i < MotionVector.Velocity || i == MotionVector.AirDistance ? MotionVector.Width(in start, i) : i < MotionVector.Spin ? width : width / _radius;
            Motion high = _step.End(now, time, MotionVector.Changed(in start, i, by), h);
            Motion low = _step.End(now, time, MotionVector.Changed(in start, i, -by), h);
            MotionVector.Write(_map, i, in high, in low, 2.0 * by);
        }

        _tangent.Map(_map);
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
