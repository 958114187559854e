using System.Diagnostics;

namespace FootballPhysics.Labs.Forces;

/// <summary>The force of a look-ahead, in addition to the air.</summary>
internal enum FootForce
{
    /// <summary>Gravity straight down.</summary>
    None,

    /// <summary>Gravity with a sideways part.</summary>
    TiltedGravity,

    /// <summary>A constant custom force.</summary>
    Constant,

    /// <summary>A weak custom spring.</summary>
    Spring,
}

/// <summary>A look-ahead of a ball next to one or two moving feet.</summary>
internal sealed class FootLook
{
    private const double Weight = 9.81;

    private readonly BodyMotion[] _feet;
    private readonly Vector3d _position;
    private readonly Vector3d _velocity;
    private readonly Vector3d _tilt;
    private readonly Vector3d _push;

    public FootLook(SeededRandom random)
    {
        _feet = [.. Enumerable.Range(0, random.Chance(0.3) ? 2 : 1).Select(_ => new BodyMotion(
            new Vector3d(random.Uniform(-0.1, 0.5), random.Uniform(0.9, 1.1), random.Uniform(-0.5, 0.5)), random.Uniform(-0.8, 0.8),
            new Vector3d(random.Uniform(-10, 1), random.Uniform(-1, 1), random.Uniform(-3, 3))))];
        _position = new Vector3d(0, random.Chance(0.7) ? 0.11 : random.Uniform(0.11, 0.6), 0);
        _velocity = random.Chance(0.4) ? Vector3d.Zero : new Vector3d(random.Uniform(-5, 5), random.Uniform(-1, 1), random.Uniform(-5, 5));
        _tilt = new Vector3d(random.Uniform(-1, 1), 0, random.Uniform(-1, 1));
        _push = new Vector3d(random.Uniform(-0.05, 0.05), 0, random.Uniform(-0.05, 0.05));
    }

    /// <summary>Predicts four seconds.</summary>
    /// <returns>The number of evaluations and the least time, ms; null if the look-ahead throws.</returns>
    public (long Evaluations, double Time)? Look(FootForce force, Trajectory path, int repeats)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < _feet.Length; i++)
        {
            KinematicBody foot = bodies.Add($"foot {i}", new CapsuleShape(new Vector3d(0, -0.9, 0.1), new Vector3d(0, -0.9, -0.1), 0.05), SurfaceMaterial.Boot);
            foot.MoveTo(_feet[i].Position, Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), _feet[i].Angle), _feet[i].Velocity, Vector3d.Zero, 0);
        }

        Vector3d push = _push;
        IForce[] own = force switch
        {
            FootForce.Constant => [IForce.From(_ => push)],
            FootForce.Spring => [IForce.From(ball => -0.2 * (ball.Position - push))],
            FootForce.None or FootForce.TiltedGravity => [],
            _ => throw new ArgumentOutOfRangeException(nameof(force)),
        };
        Vector3d gravity = (force == FootForce.TiltedGravity ? _tilt : Vector3d.Zero) + new Vector3d(0, -Weight, 0);
        var simulator = new Simulator(new Scene { GravityVector = gravity, Bodies = bodies, Forces = ForceSet.Measured with { CustomForces = own } });
        BallState start = simulator.Launch(_position, _velocity, Vector3d.Zero);
        double least = double.PositiveInfinity;
        for (int i = 0; i < repeats; i++)
        {
            long begin = Stopwatch.GetTimestamp();
            try
            {
                simulator.LookAhead(in start, new LookAheadRequest { Duration = 4 }, path);
            }
            catch (InvalidOperationException)
            {
                return null;
            }

            least = Math.Min(least, Stopwatch.GetElapsedTime(begin).TotalMilliseconds);
        }

        return (path.Evaluations, least);
    }

    private sealed record BodyMotion(Vector3d Position, double Angle, Vector3d Velocity);
}

/// <summary>The cost of the same look-aheads under one force.</summary>
/// <param name="Thrown">The look-aheads that threw.</param>
/// <param name="Evaluations">All evaluations.</param>
/// <param name="Dearest">The most evaluations of one look-ahead.</param>
/// <param name="Total">The time of all, ms.</param>
/// <param name="Slowest">The time of the slowest, ms.</param>
internal sealed record FootLooks(int Thrown, long Evaluations, long Dearest, double Total, double Slowest)
{
    /// <summary>The cost that a force may add, as a factor.</summary>
    public const double MostCost = 3;

    private const int Repeats = 3;

    public static FootLooks Of(FootLook[] looks, FootForce force)
    {
        var path = new Trajectory(1 << 14);
        looks[0].Look(force, path, Repeats);
        (long Evaluations, double Time)?[] all = [.. looks.Select(look => look.Look(force, path, Repeats))];
        return new FootLooks(
            all.Count(look => look is null), all.Sum(look => look?.Evaluations ?? 0), all.Max(look => look?.Evaluations ?? 0), all.Sum(look => look?.Time ?? 0), all.Max(look => look?.Time ?? 0));
    }
}
