using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Keeps the pieces of a ball in a net short enough for their paths, and ends them at kinks of the net's force.</summary>
/// <remarks>The force has a kink when the net goes slack or taut.</remarks>
internal sealed class NetGuard
{
    /// <summary>Factor by which a piece that bends too much is shortened.</summary>
    private const double Shorter = 0.8;

    /// <summary>Maximum number of times a piece next to a collider is shortened.</summary>
    private const int MostHalved = 4;

    /// <summary>Maximum number of times a piece is shortened whose end is not finite; at last to nothing.</summary>
    private const int MostShortened = 32;

    /// <summary>Maximum number of parts per piece: the cost of a step is only checked between pieces.</summary>
    private const int MostParts = 64;

    /// <summary>Maximum number of times a ball in a net may lose its grip per step.</summary>
    /// <remarks>
    /// A net that goes slack and taut makes the ball grip and slip in turn, ever faster. After this many times, the ball grips for the rest
    /// of the step, which adds no energy.
    /// </remarks>
    private const int MostSlips = 2;

    private readonly World _world;

    public NetGuard(World world) => _world = world;

    /// <summary>Shortens a piece in a net until its end is finite.</summary>
    /// <remarks>At a speed beyond any shot, a slide can pass from a straight surface to a curved one within a piece, where its parts are too long.</remarks>
    public static void KeepFinite<TSystem, TMethod>(ref MotionSweep<TSystem, TMethod> sweep, in BallState s)
        where TSystem : struct, IMotionSystem
        where TMethod : struct, IMotionMethod
    {
        for (int i = 0; i < MostShortened && s.Nets != 0 && !SetGuard.IsFinite(in sweep.Taken.End); i++)
        {
            sweep.Step(i < MostShortened - 1 ? 0.25 * sweep.Length : 0);
        }
    }

    /// <summary>True for a ball in a net that has lost its grip too often in this step.</summary>
    public static bool KeepsGrip(in BallState s, in StepRun run) => s.Nets != 0 && run.Spent.Slips >= MostSlips;

    /// <summary>Returns the longest piece whose path in the nets follows from its ends, s.</summary>
    public double LongestPiece(in BallState s, double h)
    {
        h = s.Nets == 0 ? h : Math.Min(h, _world.NetForces.Longest(s.Nets, s.NetSides, s.Position, s.Velocity, MostParts));
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                // The deviation of the path scales with the sixth power of the piece's length.
                while (_world.Nets[i].Bends(s.Position, s.Velocity, NetSheet.SideOf(s.NetSides, i), h) > ContactTolerances.NetBend)
                {
                    h *= Shorter;
                }
            }
        }

        return h;
    }

    /// <summary>Returns how fast the nets around the ball change its motion at a position, 1/s.</summary>
    public double FastestRate(in BallState s, in Vector3d position)
    {
        double rate = 0;
        for (int i = 0; i < _world.Nets.Length; i++)
        {
            if ((s.Nets >> i & 1) != 0)
            {
                rate += _world.Nets[i].RateAt(Math.Max(0, _world.Nets[i].Depth(in position, NetSheet.SideOf(s.NetSides, i))));
            }
        }

        return rate;
    }

    /// <summary>Returns the nets around the ball that are slack from now on.</summary>
    public ulong? SlackAt(in BallState s, in Vector3d acceleration) =>
        s.Nets == 0 ? null : _world.NetForces.SlackAt(s.Nets, s.NetSides, s.Velocity, in acceleration);

    /// <summary>Ends a piece when a net that was slack from its start becomes taut, or the reverse.</summary>
    public void EndWhereSlack<TSweep>(ref TSweep sweep, in BallState s, ulong? slack)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < _world.Nets.Length && s.Nets != 0; i++)
        {
            if ((s.Nets >> i & 1) == 0)
            {
                continue;
            }

            // The force has a kink where 1 + b δ̇ changes sign. The piece continues one branch beyond it, so its path is smooth there.
            double sign = (slack >> i & 1) != 0 ? -1.0 : 1.0;
            var tension = new TensionLeft<TSweep>(_world.Nets[i], NetSheet.SideOf(s.NetSides, i), sign);
            if (tension.At(sweep.Velocity) < 0)
            {
                EventLocator.Locate(ref sweep, in tension, tension.FirstGuess(ref sweep, s.Velocity));
            }
        }
    }

    /// <summary>Shortens a piece next to a collider until the cubic that is searched matches the path, which a net or a stiff custom force bends
    /// strongly.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="run">The step of the ball.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    public void EndWhereBent<TSweep>(ref TSweep sweep, in BallState s, in StepRun run, int carrier)
        where TSweep : struct, ISweep
    {
        for (int i = 0; i < MostHalved && (s.Nets != 0 || run.Followed > 0) && sweep.Length > 0 && IsNear(ref sweep, in s, carrier); i++)
        {
            // The quintic minus the cubic at the middle: h (v₀ − v₁)/32 + h² (a₀ + a₁)/64, of fourth order in the length h. The ends have velocities
            // v and accelerations a.
            double h = sweep.Length;
            Vector3d off = (h / 32.0 * (s.Velocity - sweep.Velocity)) + (h * h / 64.0 * (sweep.StartAcceleration + sweep.EndAcceleration()));
            double share = ContactTolerances.NetBend / off.Length;
            if (!(share < 1))
            {
                return;
            }

            sweep.Step(h * Shorter * Math.Sqrt(Math.Sqrt(share)));
        }
    }

    /// <summary>True if a collider other than the carrier is next to a piece.</summary>
    private bool IsNear<TSweep>(ref TSweep sweep, in BallState s, int carrier)
        where TSweep : struct, ISweep
    {
        var path = PathCubic.Between(s.Position, s.Velocity, sweep.Position, sweep.Velocity, sweep.Length);
        double r = _world.Ball.Radius;
        var near = new NearThings(_world, path.Bounds.Expanded(r), s.Time, sweep.Length, s.Nets, s.NetSides);
        while (near.Next(out int i))
        {
            // Planes have no bounding box, so check their distance here.
            bool isFar = _world.ByIndex[i].StandingPlane is { } plane
                && Math.Min(plane.DistanceTo(s.Position), plane.DistanceTo(sweep.Position)) > r + path.Deviation;
            if (i != carrier && !isFar)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The remaining tension of a net before its sign change.</summary>
    private readonly struct TensionLeft<TSweep>(NetSheet net, double side, double sign) : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        /// <summary>The number of Newton steps on the cubic.</summary>
        private const int Guesses = 4;

        /// <summary>± (1 + b δ̇), positive until the kink.</summary>
        public double At(in Vector3d velocity) => sign * net.Tension(in velocity, side);

        /// <summary>Returns the zero of the cubic through the values and rates at both ends of a sweep, s.</summary>
        public double FirstGuess(ref TSweep sweep, in Vector3d start)
        {
            double h = sweep.Length;
            double from = At(in start);
            double to = At(sweep.Velocity);
            var cubic = new CubicHermite(from, h * sign * net.TensionRate(sweep.StartAcceleration, side), to, h * sign * net.TensionRate(sweep.EndAcceleration(), side));
            double x = from / (from - to);
            for (int i = 0; i < Guesses; i++)
            {
                x -= cubic.At(x) / cubic.SlopeAt(x);
            }

            return x > 0 && x < 1 ? x * h : 0.5 * h;
        }

        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            // A Newton step on ± (1 + b δ̇); its derivative needs the acceleration at the end.
            value = At(sweep.Velocity);
            bool isThere = Math.Abs(value) < ContactTolerances.NetSlack;
            double rate = isThere ? 0 : sign * net.TensionRate(sweep.EndAcceleration(), side);
            correction = rate < 0 ? -value / rate : double.NaN;
            return isThere;
        }
    }
}
