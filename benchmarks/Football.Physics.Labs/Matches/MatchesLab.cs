using System.CommandLine;
using FootballPhysics.Contacts;

namespace FootballPhysics.Labs.Matches;

/// <summary>football lab matches: players in time, touches at a player's feet, impacts between objects with a mass, several balls.</summary>
internal static class MatchesLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "matches",
            "Rollbacks of late kicks at four frame rates; dribbles, first-time shots and traps; energy and momentum of impacts; cost of fifty balls and of a jump in a recording.",
            ["football lab matches --count 5 --impacts 10000", "football lab matches --only dribbles --count 40 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Number of matches, dribbles, first-time shots and traps each.", 1, 1_000_000, 1000);
        Option<long> impacts = lab.Whole("--impacts", "Number of impacts to check.", 1, 1_000_000_000, 1_000_000);
        Option<string?> only = lab.Only("PART", "Run one part", ["rollbacks", "dribbles", "shots", "traps", "impacts", "cost", "jumps"]);
        return lab.Plays(run => Run(run, run.Int(count), run.Get(impacts), run.Get(only)));
    }

    private static void Run(LabRun run, int count, long impacts, string? only)
    {
        foreach ((string part, Action play) in new (string, Action)[]
        {
            ("rollbacks", () => RollbackCounts.Play(run, count)),
            ("dribbles", () => new TouchCounts(run, count).Dribbles()),
            ("shots", () => new TouchCounts(run, count).FirstTimeShots()),
            ("traps", () => new TouchCounts(run, count).Traps()),
            ("impacts", () => ImpactBalances.Play(run, impacts)),
            ("cost", () => SeveralCost.Play(run)),
            ("jumps", () => JumpCost.Play(run)),
        })
        {
            if (only is null || only == part)
            {
                play();
            }
        }
    }
}

/// <summary>Checks random impacts of two balls, and of a ball with an object that has a mass: momentum, angular momentum, energy, and the limit of infinite mass.</summary>
internal static class ImpactBalances
{
    private const double Rounding = 1e-12;

    public static void Play(LabRun run, long count)
    {
        double worstMomentum = 0;
        double worstAngular = 0;
        double worstGain = double.NegativeInfinity;
        long other = 0;
        SeededRandom random = run.Random(77);
        for (long i = 0; i < count; i++)
        {
            if (i % 4096 == 0)
            {
                run.Progress.Report(i, count, () => "impacts");
            }

            BallProperties ball = Ball(random);
            ContactMaterial material = Material(random, i);
            Vector3d n = random.Direction();
            Vector3d v = random.Uniform(0, 40) * random.Direction();
            Vector3d w = random.Uniform(0, 100) * random.Direction();
            Vector3d v2 = random.Uniform(0, 40) * random.Direction();
            if (!(Vector3d.Dot(v - v2, n) < 0))
            {
                (v, v2) = (v2, v);
            }

            BallState first = State(v, w, 0.2 * n);
            double scale;
            double angular;
            double gain;
            Vector3d momentum;
            if (i % 2 == 0)
            {
                BallProperties second = Ball(random);
                Vector3d w2 = random.Uniform(0, 100) * random.Direction();
                BallState its = State(v2, w2, Vector3d.Zero);
                ImpactLaw.Apply(ball, second, in material, in n, in first, in its, out Motion a, out Motion b);
                momentum = (ball.Mass * (a.Velocity - v)) + (second.Mass * (b.Velocity - v2));
                scale = (ball.Mass * v.Length) + (second.Mass * v2.Length);

                // Angular momentum about the contact: the levers are r₁ n and −r₂ n.
                Vector3d turned = (ball.MomentOfInertia * (a.Spin - w)) + Vector3d.Cross(ball.Radius * n, ball.Mass * (a.Velocity - v));
                Vector3d itsTurned = (second.MomentOfInertia * (b.Spin - w2)) + Vector3d.Cross(-second.Radius * n, second.Mass * (b.Velocity - v2));
                double own = Math.Max((turned - (Vector3d.Dot(turned, n) * n)).Length, (itsTurned - (Vector3d.Dot(itsTurned, n) * n)).Length);
                angular = Math.Max(own, (turned + itsTurned).Length) / ((ball.Radius * ball.Mass * v.Length) + (ball.MomentOfInertia * w.Length) + (second.Radius * second.Mass * v2.Length) + (second.MomentOfInertia * w2.Length));
                double before = Energy(ball, v, w) + Energy(second, v2, w2);
                gain = (Energy(ball, a.Velocity, a.Spin) + Energy(second, b.Velocity, b.Spin) - before) / before;
            }
            else
            {
                double mass = random.Log(0.05, 500);
                ImpactLaw.Apply(ball, in material, in n, in v2, in v, in w, out Vector3d after, out Vector3d spin, ball.Mass / mass);
                Vector3d impulse = ball.Mass * (after - v);
                Vector3d thing = v2 - (impulse / mass);
                momentum = impulse + (mass * (thing - v2));
                scale = (ball.Mass * v.Length) + (mass * v2.Length);
                angular = ((ball.MomentOfInertia * (spin - w)) + Vector3d.Cross(ball.Radius * n, impulse)).Length / ((ball.Radius * ball.Mass * (v.Length + v2.Length)) + (ball.MomentOfInertia * w.Length));
                double before = Energy(ball, v, w) + (0.5 * mass * v2.LengthSquared);
                gain = (Energy(ball, after, spin) + (0.5 * mass * thing.LengthSquared) - before) / before;
                ImpactLaw.Apply(ball, in material, in n, in v2, in v, in w, out Vector3d fixedV, out Vector3d fixedW, ball.Mass / double.PositiveInfinity);
                ImpactLaw.Apply(ball, in material, in n, in v2, in v, in w, out Vector3d oldV, out Vector3d oldW);
                other += fixedV == oldV && fixedW == oldW ? 0 : 1;
            }

            worstMomentum = Math.Max(worstMomentum, momentum.Length / scale);
            worstAngular = Math.Max(worstAngular, angular);
            worstGain = Math.Max(worstGain, gain);
        }

        LabTable table = run.Table("Impacts of two balls, and of a ball with what has a mass", "balance, by what came", "worst", "verdict");
        table.Count("impacts", count);
        table.Count("momentum", worstMomentum, worstMomentum <= Rounding);
        table.Count("angular momentum about the contact", worstAngular, worstAngular <= Rounding);
        table.Count("energy gained", worstGain, worstGain <= Rounding);
        table.Count("an infinite mass that gives other bits than none", other, other == 0);
    }

    private static ContactMaterial Material(SeededRandom random, long i) => new(SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = random.Next(),
        RestitutionSpeedScale = random.Chance(0.5) ? double.PositiveInfinity : random.Log(3, 300),
        TangentialRestitution = random.Uniform(-1, 1),
        ImpactFriction = random.Uniform(0, 1.5),

        // Spin of two balls about the normal. An object with a mass does not turn, so there is no angular momentum balance for it.
        SpinRestitution = i % 4 == 0 ? random.Next() : 1,
        SlidingFriction = random.Uniform(0, 1),
        TorsionalPatchRadius = i % 4 == 0 ? random.Uniform(0, 0.02) : 0,
    });

    private static BallProperties Ball(SeededRandom random) => new()
    {
        Mass = random.Log(0.1, 3),
        Radius = random.Uniform(0.05, 0.25),
        InertiaFactor = random.Uniform(0.4, 0.667),
    };

    private static BallState State(Vector3d velocity, Vector3d spin, Vector3d position)
    {
        BallState state = default;
        state.Position = position;
        state.Velocity = velocity;
        state.SetGroundSpin(spin);
        return state;
    }

    private static double Energy(BallProperties ball, Vector3d v, Vector3d w) => 0.5 * ((ball.Mass * v.LengthSquared) + (ball.MomentOfInertia * w.LengthSquared));
}
