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

/// <summary>Tests a ball put on slopes in wind: it rests exactly if rolling friction holds it, and otherwise rolls as in a closed form or a textbook integration.</summary>
internal sealed class Slopes : SceneKind
{
    private const double Limit = 1e-6;
    private const double Radius = 0.11;
    private const double Mass = 0.43;
    private const double K = 2.0 / 3;
    private const double Gravity = 9.81;
    private const double Duration = 2;

    /// <summary>A ball that moved less than this, m, was only put back onto the surface.</summary>
    private const double Still = 1e-9;

    public override string Name => "slopes";

    public override string Claim => "A ball put on a slope in wind rests if |a_t|/(1 + k) ≤ c₀ N/m, and otherwise rolls as its equation says: 1e-6 m, or that share of the way.";

    protected override SceneOutcome Play(SeededRandom random)
    {
        while (true)
        {
            double tilt = random.Chance(0.2) ? 0 : random.Log(0.01, 0.75);
            Vector3d normal = (Math.Cos(tilt) * Vector3d.Up) + (Math.Sin(tilt) * random.Heading());
            var air = new AirModel(random.Chance(0.4) ? 0 : 1.2, 1.5e-5, random.Chance(0.3) ? default : random.Log(1, 25) * random.Heading());
            double rolling = random.Chance(0.2) ? 0 : random.Log(0.005, 0.3);
            double bySpeed = random.Chance(0.5) ? 0 : 0.006;
            Vector3d weight = Gravity * (air.Lifts - 1) * Vector3d.Up;
            Vector3d push = weight + air.Act(default, default).Acceleration;
            double load = -Vector3d.Dot(push, normal);
            double pull = LabMath.Along(push, normal).Length / (1 + K);

            // Skip cases at the limit of friction, and balls that the wind lifts.
            if (load < 2 || Math.Abs(pull - (rolling * load)) < 1e-5 * pull || (pull < 1e-12 && rolling > 0))
            {
                continue;
            }

            bool rests = pull <= rolling * load;
            PieceKind? kind = random.Any<PieceKind?>(null, null, PieceKind.Obstacles, PieceKind.Bodies, PieceKind.Colliders);
            Vector3d gone = rests ? default : Roll(normal, air, weight, rolling, bySpeed);
            double step = random.Any(1 / 240.0, 1 / 100.0, 1 / 60.0, 1 / 30.0);
            Vector3d from = default;
            BallState Run(int share) => Library(kind, normal, air, rolling, bySpeed, step / share, out from);
            double limit = Limit * Math.Max(1, gone.Length);
            int parts = Divide(limit, share => Vector3d.Distance(Run(share).Position, Run(4 * share).Position));
            BallState found = Run(parts);
            double error = Vector3d.Distance(found.Position - from, gone);
            string detail = FormattableString.Invariant(
                $"{tilt * 180 / Math.PI:0.0}°, wind {air.Wind.Length:0.0} m/s, air {air.Density}, c₀ {rolling:0.0000}, steps of {1000 * step:0.0} ms / {parts}: gone {(found.Position - from).Length:0.000000} m for {gone.Length:0.000000} m, {found.Motion}");
            bool agrees = rests == (Vector3d.Distance(found.Position, from) < Still && found.Motion == MotionState.Rest);
            return new SceneOutcome(
                FormattableString.Invariant($"{(rests ? "held" : "rolling")}, {kind?.ToString() ?? "Ground"}"), agrees, double.IsNaN(error) ? double.PositiveInfinity : error, limit, detail);
        }
    }

    /// <summary>Returns the path from rest: in closed form without air and without growth with speed, otherwise by the classical Runge-Kutta method in steps of 0.1 ms.</summary>
    private static Vector3d Roll(Vector3d normal, AirModel air, Vector3d weight, double rolling, double bySpeed)
    {
        Vector3d down = LabMath.Along(weight, normal);
        if (air.Density == 0 && bySpeed == 0)
        {
            double rate = (down.Length / (1 + K)) + (rolling * Vector3d.Dot(weight, normal));
            return 0.5 * rate * Duration * Duration * down.Normalized();
        }

        const double H = 1e-4;
        (Vector3d p, Vector3d v) = (default, default);
        int steps = (int)Math.Round(Duration / H);
        for (int i = 0; i < steps; i++)
        {
            Vector3d a1 = Rate(v);
            Vector3d a2 = Rate(v + (0.5 * H * a1));
            Vector3d a3 = Rate(v + (0.5 * H * a2));
            Vector3d a4 = Rate(v + (H * a3));
            p += (H * v) + (H * H / 6 * (a1 + a2 + a3));
            v += H / 6 * (a1 + (2 * a2) + (2 * a3) + a4);
        }

        return p;

        Vector3d Rate(Vector3d moves)
        {
            Vector3d spin = Vector3d.Cross(normal, moves) / Radius;
            (Vector3d acceleration, Vector3d torque) = air.Act(moves, spin);
            Vector3d all = weight + acceleration;
            Vector3d shared = (LabMath.Along(all, normal) + (Vector3d.Cross(torque, normal) / (Mass * Radius))) / (1 + K);

            // At zero speed the friction opposes the push. It also does so while it could reverse the motion within a step: rounding would reverse it there.
            Vector3d ahead = moves.Length > 10 * H * rolling * Gravity ? moves.Normalized() : shared.Normalized();
            return shared + ((rolling + (bySpeed * moves.Length)) * Vector3d.Dot(all, normal) * ahead);
        }
    }

    private static BallState Library(PieceKind? kind, Vector3d normal, AirModel air, double rolling, double bySpeed, double step, out Vector3d from)
    {
        Ground ground = Ground.Of(SurfaceMaterial.DryTurf with { SlidingFriction = 5, RollingResistance = rolling, RollingResistancePerSpeed = bySpeed });
        var scene = new Scene
        {
            Ball = BallProperties.Tunnel,
            Gravity = Gravity,
            Air = new Air { Density = air.Density, KinematicViscosity = air.Viscosity, Wind = air.Wind },
            Ground = kind is null ? ground with { Normal = normal } : ground with { Height = -1000 },
        };
        var pieces = new ScenePieces(kind ?? PieceKind.Obstacles);
        if (kind is not null)
        {
            pieces.Add(new BoxShape(-0.5 * normal, new Vector3d(200, 0.5, 200), LabMath.Upright(normal)), ground.Material);
        }

        pieces.MoveTo(default, Quaterniond.Identity, default, default, 0);
        var ball = new Ball(pieces.In(scene));
        ball.Place(kind is null ? new Vector3d(0, ball.Simulator.ContactHeight, 0) : Radius * normal);
        from = ball.Position;
        int steps = (int)Math.Round(Duration / step);
        for (int i = 0; i < steps; i++)
        {
            pieces.MoveTo(default, Quaterniond.Identity, default, default, ball.Time);
            ball.Step(step);
        }

        return ball.State;
    }
}

/// <summary>The measured laws of the air for the generic ball, as documented: drag, lift and the torque on a ball.</summary>
/// <param name="Density">Density of the air, kg/m³.</param>
/// <param name="Viscosity">Kinematic viscosity, m²/s.</param>
/// <param name="Wind">Wind, m/s.</param>
internal sealed record AirModel(double Density, double Viscosity, Vector3d Wind)
{
    private const double Radius = 0.11;
    private const double Mass = 0.43;
    private const double Inertia = 2.0 / 3 * Mass * Radius * Radius;
    private const double Area = Math.PI * Radius * Radius;

    /// <summary>The buoyancy, as an acceleration per m/s² of gravity.</summary>
    public double Lifts => 4.0 / 3 * Math.PI * Radius * Radius * Radius * Density / Mass;

    /// <summary>Returns force over mass, m/s², and torque, N m.</summary>
    public (Vector3d Acceleration, Vector3d Torque) Act(in Vector3d velocity, in Vector3d spin)
    {
        Vector3d u = velocity - Wind;
        double speed = u.Length;
        if (Density == 0 || speed < 1e-9)
        {
            return (default, -0.004 * Density / 1.2 * Inertia * spin);
        }

        double reynolds = 2 * Radius * speed / Viscosity;
        double across = Vector3d.Cross(spin, u).Length / speed;
        double s = Radius * across / speed;
        double slow = 1 / (1 + Math.Exp((reynolds - 186_000) / 17_000));
        double rise = (reynolds - 230_000) / (1 + Math.Exp(-(reynolds - 230_000) / 17_000)) * (0.185 - 0.155) / (510_000 - 230_000);
        double drag = ((0.49 - 0.155) * slow) + 0.155 + rise + (0.30 * s / Math.Sqrt((s * s) + (0.577 * 0.577)) * (1 - (0.5 * slow)));
        Vector3d lift = 0.5 * Density * Area * 0.32 * (1 - (0.6 * slow)) * Radius * speed
            / Math.Sqrt((Radius * Radius * across * across) + (0.14 * 0.14 * speed * speed)) * Vector3d.Cross(spin, u);
        Vector3d force = (-0.5 * Density * Area * drag * speed * u) + lift;
        return (force / Mass, -((0.0096 * Math.PI * Density * Math.Pow(Radius, 4) * speed) + (0.004 * Density / 1.2 * Inertia)) * spin);
    }
}
