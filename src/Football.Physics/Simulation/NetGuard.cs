namespace Football.Physics;

/// <summary>Keeps the pieces of a ball in a net short enough for their paths, and ends them where a net becomes slack or tight: there its force has a kink.</summary>
internal sealed class NetGuard
{
    /// <summary>So far, m, the path of a piece may be off the one that its ends tell.</summary>
    private const double LargestBend = 3e-7;

    /// <summary>By what a piece is shortened that bends too much.</summary>
    private const double Shorter = 0.8;

    /// <summary>A kink is found to this tension; a piece that starts with less than the second starts at one.</summary>
    private const double Kink = 1e-12;
    private const double AtKink = 1e-9;

    private readonly World _world;

    public NetGuard(World world) => _world = world;

    /// <summary>The longest piece whose path between its ends is known from those, in the nets that the ball is in, s.</summary>
    public double LongestPiece(in BallState s, double h)
    {
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                // How far the path may be off falls with the sixth power of the length.
                while (_world.Nets[i].Bends(s.Position, s.Velocity, World.SideOf(s.NetSides, i), h) > LargestBend)
                {
                    h *= Shorter;
                }
            }
        }

        return h;
    }

    /// <summary>How fast the nets that the ball is in change its motion at a place, 1/s.</summary>
    public double FastestRate(in BallState s, in Vector3d position)
    {
        double rate = 0;
        for (int i = 0; i < _world.Nets.Length; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                rate += _world.Nets[i].RateAt(Math.Max(0, _world.Nets[i].Depth(in position, World.SideOf(s.NetSides, i))));
            }
        }

        return rate;
    }

    /// <summary>Ends a piece where the tension 1 + b δ̇ of a net changes its sign.</summary>
    public void EndWhereSlack<TSweep>(ref TSweep sweep, in BallState s)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) == 0)
            {
                continue;
            }

            // A change of sign of 1 + b δ̇ is the kink; a piece that begins at one has it behind itself.
            double side = World.SideOf(s.NetSides, i);
            double start = _world.Nets[i].Tension(s.Velocity, side);
            double end = _world.Nets[i].Tension(sweep.Velocity, side);
            if (Math.Abs(start) > AtKink && start < 0 != end < 0)
            {
                // Up to the kink the motion is smooth: its rate at the start leads there sooner than what lies beyond.
                double sign = start < 0 ? -1.0 : 1.0;
                double first = sign * start / Math.Max(0, -sign * _world.Nets[i].TensionRate(sweep.StartAcceleration, side));
                double secant = sweep.Length * start / (start - end);
                EventLocator.Locate(ref sweep, new TensionLeft<TSweep>(_world.Nets[i], side, sign), first < sweep.Length ? first : secant);
            }
        }
    }

    /// <summary>What is left until the tension of a net changes its sign.</summary>
    private readonly struct TensionLeft<TSweep>(NetSheet net, double side, double sign) : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            // Newton on ± (1 + b δ̇), whose rate takes the acceleration at the end.
            value = sign * net.Tension(sweep.Velocity, side);
            bool isThere = Math.Abs(value) < Kink;
            double rate = isThere ? 0 : sign * net.TensionRate(sweep.EndAcceleration(), side);
            correction = rate < 0 ? -value / rate : double.NaN;
            return isThere;
        }
    }
}
