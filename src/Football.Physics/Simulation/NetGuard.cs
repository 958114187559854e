namespace Football.Physics;

/// <summary>Keeps the pieces of a ball in a net short enough for their paths, and ends them where a net becomes slack or tight: there its force has a kink.</summary>
internal sealed class NetGuard
{
    /// <summary>So far, m, the path of a piece may be off the one that its ends tell.</summary>
    private const double LargestBend = 3e-7;

    /// <summary>By what a piece is shortened that bends too much.</summary>
    private const double Shorter = 0.8;

    private readonly World _world;

    public NetGuard(World world) => _world = world;

    /// <summary>The longest piece whose path between its ends is known from those, in the nets that the ball is in, s.</summary>
    public double LongestPiece(in BallState s, double h)
    {
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
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

            double side = World.SideOf(s.NetSides, i);
            double start = _world.Nets[i].Tension(s.Velocity, side);
            double end = _world.Nets[i].Tension(sweep.Velocity, side);
            if (Math.Abs(start) > 1e-9 && start < 0 != end < 0)
            {
                var tension = new NetTension<TSweep>(_world.Nets[i], side, in sweep);
                Roots.Illinois(ref tension, 0, start, sweep.Length, end, 1e-12 * sweep.Length, 60);
                sweep = tension.Sweep;
            }
        }
    }

    private struct NetTension<TSweep> : IFunction
        where TSweep : struct, ISweep
    {
        public TSweep Sweep;
        private readonly NetSheet _net;
        private readonly double _side;

        public NetTension(NetSheet net, double side, in TSweep sweep)
        {
            _net = net;
            _side = side;
            Sweep = sweep;
        }

        public bool Evaluate(double x, out double value)
        {
            Sweep.Step(x);
            value = _net.Tension(Sweep.Velocity, _side);
            return Math.Abs(value) < 1e-13;
        }
    }
}
