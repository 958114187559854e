using FootballPhysics.Labs.Stability;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Stress;

/// <summary>Draws the kicks of an arena: at goals, into nets and corners, touches, lobs, and launches of hostile scenes at speeds of a game.</summary>
internal sealed class ArenaKicks(SeededRandom random, double halfWidth, double halfLength, Goal goal)
{
    private const double Fastest = 45;

    /// <summary>The spin of a hostile launch is cut to this size, rad/s.</summary>
    private const double MostSpin = 200;

    /// <summary>A kick of a ball at a position.</summary>
    public (Vector3d Velocity, Vector3d Spin) Draw(Vector3d ball)
    {
        double end = random.Chance(0.5) ? -1 : 1;
        Vector3d spin = random.Chance(0.4) ? Vector3d.Zero : random.Uniform(0, 80) * random.Direction();
        return random.Below(8) switch
        {
            0 or 1 => (At(ball, new Vector3d(random.Uniform(-0.7, 0.7) * goal.Width, random.Uniform(0.11, 1.2) * goal.Height, end * halfLength), random.Uniform(4, 36)), spin),
            2 => (At(ball, new Vector3d((random.Chance(0.5) ? -1 : 1) * halfWidth, 0.11, end * halfLength), random.Uniform(2, 30)), spin),
            3 => (At(ball, new Vector3d((random.Chance(0.5) ? -0.5 : 0.5) * goal.Width, random.Uniform(0.11, goal.Height), end * halfLength), random.Uniform(3, 30)), spin),
            4 => (random.Uniform(0.1, 4) * random.Heading(), spin),
            5 => (random.Velocity(6, 20, 30, 75), spin),
            6 => Hostile(),
            _ => (random.Uniform(0.5, 25) * random.Direction(), spin),
        };
    }

    private static Vector3d At(Vector3d ball, Vector3d target, double speed)
    {
        Vector3d way = target - ball;
        double lift = way.Length > 1 ? Math.Min(8, 0.5 * 9.81 * way.Length / speed) : 0;
        return (speed / Math.Max(way.Length, 0.1) * way) + new Vector3d(0, target.Y > 0.2 ? lift : 0, 0);
    }

    private (Vector3d Velocity, Vector3d Spin) Hostile()
    {
        StressScene scene = HostileGenerator.Make((ulong)random.Below(int.MaxValue));
        return (Cut(scene.Velocity, Fastest), Cut(scene.Spin, MostSpin));
    }

    private static Vector3d Cut(Vector3d vector, double most) => vector.Length > most ? most / vector.Length * vector : vector;
}
