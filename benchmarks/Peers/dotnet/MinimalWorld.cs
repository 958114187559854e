namespace FootballPhysics.Peers;

/// <summary>The state of a ball of <see cref="MinimalWorld"/>.</summary>
public record struct MinimalState(Vector3d Position, Vector3d Velocity, Vector3d Spin);

/// <summary>A minimal rigid body: semi-implicit Euler, one overlap test per step, restitution and Coulomb friction as impulses.</summary>
public sealed class MinimalWorld(PeerOptions options) : IPeerWorld<MinimalState>
{
    private MinimalState[] _balls = [];

    public void Add(Vector3d position, Vector3d velocity, Vector3d spin)
    {
        Array.Resize(ref _balls, _balls.Length + 1);
        _balls[^1] = new MinimalState(position, velocity, spin);
    }

    public void Step(double h)
    {
        for (int i = 0; i < _balls.Length; i++)
        {
            ref MinimalState s = ref _balls[i];
            s.Velocity -= h * Harness.Gravity * Vector3d.Up;
            s.Position += h * s.Velocity;
            if (options.Ground)
            {
                Touch(ref s, Vector3d.Up, Harness.Radius - s.Position.Y);
            }

            if (options.Post)
            {
                var foot = new Vector3d(0, Math.Clamp(s.Position.Y, 0, Harness.PostHeight), Harness.PostZ);
                Vector3d away = s.Position - foot;
                Touch(ref s, (1 / away.Length) * away, Harness.Radius + Harness.PostRadius - away.Length);
            }
        }
    }

    public MinimalState Save(int ball) => _balls[ball];

    public void Restore(int ball, in MinimalState state) => _balls[ball] = state;

    public Vector3d Position(int ball) => _balls[ball].Position;

    public Vector3d Velocity(int ball) => _balls[ball].Velocity;

    public ulong Hash(int ball)
    {
        MinimalState s = _balls[ball];
        ulong hash = 0;
        foreach (Vector3d v in (ReadOnlySpan<Vector3d>)[s.Position, s.Velocity, s.Spin])
        {
            foreach (double x in (ReadOnlySpan<double>)[v.X, v.Y, v.Z])
            {
                hash = (hash ^ (ulong)BitConverter.DoubleToInt64Bits(x)) * 0x9E3779B97F4A7C15UL;
                hash ^= hash >> 32;
            }
        }

        return hash;
    }

    private static void Touch(ref MinimalState s, Vector3d normal, double depth)
    {
        double approach = Vector3d.Dot(s.Velocity, normal);
        if (depth <= 0)
        {
            return;
        }

        s.Position += depth * normal;
        if (approach >= 0)
        {
            return;
        }

        double push = approach < -0.5 ? -(1 + Harness.Restitution) * approach : -approach;
        s.Velocity += push * normal;
        Vector3d slip = s.Velocity - (Vector3d.Dot(s.Velocity, normal) * normal) - (Harness.Radius * Vector3d.Cross(s.Spin, normal));
        if (slip.Length > 0)
        {
            // A thin shell grips when the impulse takes 2/5 of the slip.
            double impulse = Math.Min(Harness.Friction * push, 0.4 * slip.Length);
            Vector3d change = (-impulse / slip.Length) * slip;
            s.Velocity += change;
            s.Spin += (1 / (2.0 / 3.0 * Harness.Radius)) * Vector3d.Cross(-1 * normal, change);
        }
    }
}
