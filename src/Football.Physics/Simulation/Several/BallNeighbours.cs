using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Finds pairs of balls that may collide in a step.</summary>
/// <remarks>
/// Each ball has a sphere that it does not leave for some steps. Balls whose spheres touch are neighbours, and only neighbours are tested.
/// Until a ball leaves its sphere, a step needs one comparison per ball.
/// </remarks>
internal sealed class BallNeighbours
{
    /// <summary>Minimum margin of a sphere around the ball, m: a resting ball may be nudged.</summary>
    private const double LeastRoom = 0.25;

    /// <summary>Maximum acceleration for which a sphere is valid, m/s².</summary>
    public const double Fall = 10;

    private readonly Sphere[] _spheres;
    private readonly int[] _order;
    private (int First, int Second)[] _pairs = new (int, int)[16];
    private int _count;
    private double _step;

    public BallNeighbours(double[] radii)
    {
        _spheres = new Sphere[radii.Length];
        _order = new int[radii.Length];
        for (int i = 0; i < radii.Length; i++)
        {
            _order[i] = i;
            _spheres[i].Radius = radii[i];
        }
    }

    /// <summary>Number of pairs of neighbours.</summary>
    public int Count => _count;

    /// <summary>A pair of neighbours, the lower index first.</summary>
    public (int First, int Second) this[int index] => _pairs[index];

    /// <summary>Maximum displacement per step of a ball that keeps to the bounds of its sphere, m.</summary>
    public double ReachOf(int ball) => _spheres[ball].Reach;

    /// <summary>True if a step without events keeps to the bounds of the ball's sphere.</summary>
    /// <param name="ball">Index of the ball.</param>
    /// <param name="before">The ball before the step.</param>
    /// <param name="after">The ball after it.</param>
    /// <param name="dt">Length of the step, s.</param>
    public bool Holds(int ball, in BallState before, in BallState after, double dt)
    {
        ref readonly Sphere sphere = ref _spheres[ball];

        // Check that the ball stays in its sphere, within the distance and speed for which the sphere was built.
        double x = before.Position.X - sphere.Center.X;
        double y = before.Position.Y - sphere.Center.Y;
        double z = before.Position.Z - sphere.Center.Z;

        // In a net, or while squeezed, a ball may be faster within a step than at either end.
        return (before.Nets | after.Nets) == 0 && before.Motion != MotionState.Pinned && dt <= _step && (x * x) + (y * y) + (z * z) <= sphere.RoomSquared
            && (after.Position - before.Position).LengthSquared <= sphere.Reach * sphere.Reach
            && before.Flight.Velocity.LengthSquared <= sphere.SpeedSquared && after.Flight.Velocity.LengthSquared <= sphere.SpeedSquared;
    }

    /// <summary>True if a ball is within its sphere, so that all balls that it touches are among its neighbours.</summary>
    public bool Covers(int ball, in BallState at) =>
        _step > 0 && (at.Position - _spheres[ball].Center).Length + _spheres[ball].Radius + ContactTolerances.Touching <= _spheres[ball].Outer;

    /// <summary>True if a ball's sphere allows a speed, given as its square, m²/s².</summary>
    public bool Allows(int ball, double speedSquared) => speedSquared <= _spheres[ball].SpeedSquared;

    /// <summary>True if a step with a given displacement stays within the ball's sphere, m.</summary>
    public bool Holds(int ball, in BallState before, double reach, double dt) =>
        dt <= _step && (before.Position - _spheres[ball].Center).Length + reach + _spheres[ball].Radius <= _spheres[ball].Outer;

    /// <summary>Builds the spheres around the positions before a step.</summary>
    /// <param name="before">The balls before the step.</param>
    /// <param name="reaches">Upper bound of each ball's displacement in the step, m.</param>
    /// <param name="dt">Length of the step, s.</param>
    public void Renew(BallState[] before, double[] reaches, double dt)
    {
        _step = dt;
        for (int i = 0; i < _spheres.Length; i++)
        {
            ref Sphere sphere = ref _spheres[i];
            double ahead = ClearFlight.Ahead * dt;

            // Bound the speed, allowing for a fall and a small push. From this speed, bound the distance in one step and in all steps ahead.
            double most = before[i].Velocity.Length + (Fall * ahead) + (LeastRoom / ahead);
            double reach = Math.Max(1.1 * most * dt, reaches[i]);
            double room = Math.Max(LeastRoom + ((before[i].Velocity.Length + (0.5 * Fall * ahead)) * ahead), reach);
            sphere.Center = before[i].Position;
            sphere.SpeedSquared = most * most;
            sphere.Reach = reach;
            sphere.RoomSquared = (room - reach) * (room - reach);
            sphere.Outer = sphere.Radius + room;
        }

        FindPairs();
    }

    /// <summary>Sweep and prune along x. Insertion sort, because the order hardly changes between calls.</summary>
    private void FindPairs()
    {
        for (int i = 1; i < _order.Length; i++)
        {
            int ball = _order[i];
            double key = _spheres[ball].Center.X - _spheres[ball].Outer;
            int j = i - 1;
            for (; j >= 0 && _spheres[_order[j]].Center.X - _spheres[_order[j]].Outer > key; j--)
            {
                _order[j + 1] = _order[j];
            }

            _order[j + 1] = ball;
        }

        _count = 0;

        // Test pairs whose spheres overlap along x for overlap in space.
        for (int i = 0; i < _order.Length; i++)
        {
            int a = _order[i];
            double end = _spheres[a].Center.X + _spheres[a].Outer;
            for (int j = i + 1; j < _order.Length && _spheres[_order[j]].Center.X - _spheres[_order[j]].Outer <= end; j++)
            {
                int b = _order[j];
                double reach = _spheres[a].Outer + _spheres[b].Outer;
                if ((_spheres[a].Center - _spheres[b].Center).LengthSquared <= reach * reach)
                {
                    Add(Math.Min(a, b), Math.Max(a, b));
                }
            }
        }
    }

    private void Add(int first, int second)
    {
        if (_count == _pairs.Length)
        {
            Array.Resize(ref _pairs, 2 * _count);
        }

        _pairs[_count++] = (first, second);
    }

    private struct Sphere
    {
        /// <summary>Position of the ball when the sphere was built, m.</summary>
        public Vector3d Center;

        /// <summary>Squared distance from the centre up to which a ball stays within the sphere for one more step, m².</summary>
        public double RoomSquared;

        /// <summary>Squared maximum speed, m²/s².</summary>
        public double SpeedSquared;

        /// <summary>Maximum displacement per step, m.</summary>
        public double Reach;

        /// <summary>Radius of the sphere, m. It contains the surface of the ball.</summary>
        public double Outer;

        /// <summary>Radius of the ball, m.</summary>
        public double Radius;
    }
}
