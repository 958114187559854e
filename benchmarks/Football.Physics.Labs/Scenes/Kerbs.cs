namespace FootballPhysics.Labs.Scenes;

/// <summary>Compares a ball that rolls against a dead, rough kerb with the balance of angular momentum and energy.</summary>
internal sealed class Kerbs : SceneKind
{
    private const double Gravity = 9.81;
    private const double Limit = 1e-6;
    private const double Edge = 1;

    private static readonly SurfaceMaterial s_dead = SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = 0,
        RestitutionSpeedScale = double.PositiveInfinity,
        TangentialRestitution = 0,
        ImpactFriction = 100,
        SlidingFriction = 10,
        RollingResistance = 0,
    };

    public override string Name => "kerbs";

    public override string Claim => "A dead, rough kerb is climbed from v² = 2 g h (1 + k)/(1 + k − h/r)² on, and the ball goes on with what energy leaves it: 1e-6 m/s. Steps of 2 to 8 ms, shorter where their own error is more than a fifth of that.";

    protected override SceneOutcome Play(SeededRandom random)
    {
        PieceKind kind = random.Any(PieceKind.Obstacles, PieceKind.Bodies, PieceKind.Colliders);
        double k = random.Any(2.0 / 3, 0.4);
        double radius = random.Chance(0.5) ? 0.11 : random.Uniform(0.06, 0.2);

        // If the kerb is higher or the ball faster, nothing presses the ball against the edge and it flies: v'² ≤ g (r − h) with v' = v (1 + k − h/r)/(1 + k). Near this limit, it slips.
        double height, fastest, share;
        do
        {
            height = random.Log(0.005, 0.4) * radius;
            fastest = Math.Min(1.6, 0.9 * Math.Sqrt((radius - height) * (1 + k) / (2 * height)));
        }
        while (fastest < 1.05);
        share = random.Chance(0.5) ? random.Uniform(0.5, 0.995) : random.Uniform(1.005, fastest);
        double lever = (1 + k - (height / radius)) / (1 + k);
        double least = Math.Sqrt(2 * Gravity * height / (1 + k)) / lever;
        double speed = share * least;
        double step = random.Log(0.002, 0.008);

        var scene = new Scene
        {
            Ball = BallProperties.Tunnel with { Radius = radius, InertiaFactor = k },
            Air = new Air { Density = 0 },
            Ground = new Ground
            {
                Material = SurfaceMaterial.DryTurf with
                {
                    ImpactFriction = 10,
                    SlidingFriction = 10,
                    RollingResistance = 0,
                    RollingResistancePerSpeed = 0,
                    TorsionalPatchRadius = 0,
                },
                RestEnergy = 1e-12,
            },
        };
        double end = 60 * radius / speed;
        double rest = (speed * lever * speed * lever) - (2 * Gravity * height / (1 + k));
        BallState In(int share) => Roll(kind, scene, height, radius, speed, step, share, end);
        int parts = Divide(Limit, share => Math.Abs(In(share).Velocity.X - In(4 * share).Velocity.X));
        BallState state = In(parts);
        bool climbs = state.Position.X > Edge;
        string group = kind.ToString();
        string detail = FormattableString.Invariant($"h {1000 * height:0.00} mm of r {1000 * radius:0.0} mm, k {k:0.000}, {share:0.000} of the least speed {least:0.000} m/s: at x {state.Position.X - Edge:0.000} m, {state.Velocity.X:0.000000} m/s, steps of {1000 * step:0.0} ms / {parts}");
        if (climbs != share > 1)
        {
            return new SceneOutcome(group, false, 0, Limit, detail);
        }

        double error = climbs ? Math.Abs(state.Velocity.X - Math.Sqrt(rest)) + Math.Abs(state.Position.Y - height - radius) : 0;
        return new SceneOutcome(group, true, double.IsNaN(error) ? double.PositiveInfinity : error, Limit, detail);
    }

    private static BallState Roll(PieceKind kind, Scene scene, double height, double radius, double speed, double step, int parts, double end)
    {
        var pieces = new ScenePieces(kind);
        pieces.Add(new BoxShape(new Vector3d(Edge + 9, height - 0.5, 0), new Vector3d(9, 0.5, 9)), s_dead);
        pieces.MoveTo(default, Quaterniond.Identity, default, default, 0);
        var simulator = new Simulator(pieces.In(scene));
        BallState state = simulator.Launch(new Vector3d(Edge - (2.5 * radius), radius, 0), new Vector3d(speed, 0, 0), new Vector3d(0, 0, -speed / radius));
        while (state.Time < end && state.Position.X < Edge + radius && state.Position.X > Edge - (4 * radius))
        {
            pieces.Step(simulator, ref state, step / parts, default, Quaterniond.Identity, default, default);
        }

        return state;
    }
}
