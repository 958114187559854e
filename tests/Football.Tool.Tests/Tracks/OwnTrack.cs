namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>A track by an integrator of its own (RK4, drag with a crisis, lift, simple bounces): nothing of the product computes it. Metres, z up, seconds.</summary>
internal sealed record OwnTrack(string Name, double Rate, (double T, double X, double Y, double Z)[] Points)
{
    private const double Mass = 0.43;
    private const double Radius = 0.11;
    private const double Density = 1.2;

    /// <summary>Three tracks: 25, 50 and 29.97 a second, with noise of 5, 3 and 4 mm.</summary>
    public static IReadOnlyList<OwnTrack> All { get; } = WithNoise(0.005, 0.003, 0.004);

    /// <summary>When each kick is, s, and its velocity.</summary>
    public required IReadOnlyList<(double Time, Vector3d Velocity)> Kicks { get; init; }

    /// <summary>The same three tracks with other noise, m.</summary>
    public static IReadOnlyList<OwnTrack> WithNoise(double first, double second, double third) =>
    [
        Play("25 Hz", 25, 9, first, 5, [(0, -11, 14, 9, 0, 40), (3, 14, -12, 8, -10, -30), (6, 2, 18, 10, 20, -40)]),
        Play("50 Hz", 50, 8, second, 23, [(0.2, 17, 6, 9, 0, 50), (3.5, -16, -9, 7, 15, -20), (6, 8, -14, 8, -10, 25)]),
        Play("29.97 Hz", 30000.0 / 1001, 9, third, 31, [(0.1, 9, -17, 10, 20, 30), (3.2, -19, 5, 8, 0, -45), (6.1, 12, 12, 9, -15, 10)]),
    ];

    /// <summary>Plays kicks (time; velocity x, y, z; spin about x, about z).</summary>
    private static OwnTrack Play(string name, double rate, double seconds, double noise, int seed, (double T, double X, double Y, double Z, double Roll, double Side)[] kicks)
    {
        var random = new Random(seed);
        double[] state = [2, -6, Radius, 0, 0, 0];
        double[] spin = [0, 0, 0];
        var points = new List<(double, double, double, double)>();
        int next = 0;
        int steps = (int)(seconds * rate);
        const int Parts = 40;
        for (int i = 0; i < steps; i++)
        {
            double Noise() => noise * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
            points.Add((i / rate, state[0] + Noise(), state[1] + Noise(), state[2] + Noise()));
            for (int k = 0; k < Parts; k++)
            {
                double t = (i + (k / (double)Parts)) / rate;
                if (next < kicks.Length && t >= kicks[next].T)
                {
                    var kick = kicks[next++];
                    (state[3], state[4], state[5]) = (kick.X, kick.Y, kick.Z);
                    spin = [kick.Roll, 0, kick.Side];
                }

                Step(state, spin, 1 / (Parts * rate));
            }
        }

        return new OwnTrack(name, rate, [.. points]) { Kicks = [.. kicks.Select(kick => (kick.T, new Vector3d(kick.X, kick.Z, -kick.Y)))] };
    }

    private static void Step(double[] state, double[] spin, double dt)
    {
        if (state[2] <= Radius && Math.Abs(state[5]) < 0.3)
        {
            // Rolls: slows by 0.6 m/s².
            double speed = Math.Sqrt((state[3] * state[3]) + (state[4] * state[4]));
            double left = speed > 0 ? Math.Max(0, speed - (0.6 * dt)) / speed : 0;
            (state[3], state[4], state[5], state[2]) = (state[3] * left, state[4] * left, 0, Radius);
            state[0] += state[3] * dt;
            state[1] += state[4] * dt;
            return;
        }

        double[] a = Derivative(state, spin);
        double[] b = Derivative(At(state, a, dt / 2), spin);
        double[] c = Derivative(At(state, b, dt / 2), spin);
        double[] d = Derivative(At(state, c, dt), spin);
        for (int i = 0; i < 6; i++)
        {
            state[i] += dt / 6 * (a[i] + (2 * b[i]) + (2 * c[i]) + d[i]);
        }

        if (state[2] < Radius && state[5] < 0)
        {
            (state[2], state[3], state[4], state[5]) = (Radius, 0.72 * state[3], 0.72 * state[4], -0.6 * state[5]);
            (spin[0], spin[1], spin[2]) = (-state[4] / Radius, state[3] / Radius, 0.8 * spin[2]);
        }
    }

    private static double[] At(double[] state, double[] rate, double dt) => [.. state.Select((value, i) => value + (dt * rate[i]))];

    private static double[] Derivative(double[] s, double[] w)
    {
        double speed = Math.Sqrt((s[3] * s[3]) + (s[4] * s[4]) + (s[5] * s[5]));
        double reynolds = speed * 2 * Radius / 1.5e-5;
        double slow = 1 / (1 + Math.Exp((reynolds - 186_000) / 17_000));
        double along = speed > 0 ? ((w[0] * s[3]) + (w[1] * s[4]) + (w[2] * s[5])) / (speed * speed) : 0;
        double[] across = [w[0] - (along * s[3]), w[1] - (along * s[4]), w[2] - (along * s[5])];
        double turn = speed > 0 ? Radius * Math.Sqrt((across[0] * across[0]) + (across[1] * across[1]) + (across[2] * across[2])) / speed : 0;
        double fast = (reynolds - 230_000) / (1 + Math.Exp((230_000 - reynolds) / 17_000)) * 0.03 / 280_000;
        double drag = ((0.49 - 0.155) * slow) + 0.155 + fast + (0.3 * turn / Math.Sqrt((turn * turn) + (0.577 * 0.577)) * (1 - (0.5 * slow)));
        double lift = 0.32 / Math.Sqrt((turn * turn) + (0.14 * 0.14)) * (1 - (0.6 * slow));
        double k = 0.5 * Density * Math.PI * Radius * Radius / Mass;
        double buoyant = 9.81 * (1 - (Density * 4 / 3 * Math.PI * Radius * Radius * Radius / Mass));
        return
        [
            s[3], s[4], s[5],
            (-k * drag * speed * s[3]) + (k * lift * Radius * ((across[1] * s[5]) - (across[2] * s[4]))),
            (-k * drag * speed * s[4]) + (k * lift * Radius * ((across[2] * s[3]) - (across[0] * s[5]))),
            (-k * drag * speed * s[5]) + (k * lift * Radius * ((across[0] * s[4]) - (across[1] * s[3]))) - buoyant,
        ];
    }
}
