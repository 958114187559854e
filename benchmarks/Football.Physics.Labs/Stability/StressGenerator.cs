using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Stability;

/// <summary>Makes the scenes of the stress matrix.</summary>
internal static class StressGenerator
{
    private const double CriticalSpeed = 12.19;
    private const double CriticalSpin = 0.05;

    public static IReadOnlyList<StressKind> Kinds { get; } = Enum.GetValues<StressKind>();

    public static IReadOnlyList<Integrator> Integrators { get; } = Enum.GetValues<Integrator>();

    /// <summary>Returns the number of a scene of a kind with a method.</summary>
    /// <param name="kind">The kind.</param>
    /// <param name="integrator">The method.</param>
    /// <param name="round">The index of the scene, from 0.</param>
    public static long Index(StressKind kind, Integrator integrator, long round) => (int)kind + (Kinds.Count * ((int)integrator + (Integrators.Count * round)));

    /// <summary>Returns the scene with a number: kinds and methods alternate.</summary>
    public static StressScene Make(long seed, long index)
    {
        StressKind kind = Kinds[(int)(index % Kinds.Count)];
        Integrator integrator = Integrators[(int)(index / Kinds.Count % Integrators.Count)];
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        random.Next();
        BallProperties ball = Ball(random, kind);
        Air air = AnyAir(random, kind);
        if (kind == StressKind.Absurd)
        {
            ball = ball with { Mass = Math.Min(100, Math.Max(ball.Mass, 0.06 * Buoyancy.DisplacedMass(ball, air))) };
            air = air with { Density = Math.Min(air.Density, 10 * ball.Mass / Buoyancy.DisplacedMass(ball, new Air { Density = 1 })) };
        }

        Ground ground = AnyGround(random, kind);
        ground = ground with { Material = ground.Material with { SpinDamping = Math.Min(ground.Material.SpinDamping, ball.MostDamping) } };
        double gravity = kind switch
        {
            StressKind.Absurd => random.Any(0, 1e-9, 1e-3, 9.81, 100, 1000),
            StressKind.ComesToRest => random.Log(1, 30),
            _ => random.Chance(0.1) ? 0 : random.Log(1, 30),
        };
        ForceSet forces = Forces(random, kind);
        forces = forces with { SpinDecayCoefficient = Math.Min(forces.SpinDecayCoefficient, ball.MostDamping) };
        forces = kind == StressKind.ComesToRest ? Sinking(forces, ball, air) : forces;
        var scene = Scene.Published with { Ball = ball, Air = air, Ground = ground, Gravity = gravity, Forces = forces };
        (Vector3d position, Vector3d velocity, Vector3d spin) = Launch(random, kind, scene);
        double[] frames = Frames(random, kind);
        var made = new StressScene
        {
            Number = index,
            Kind = kind,
            Scene = scene,
            Settings = new SolverSettings
            {
                Integrator = integrator,
                RollingTransition = random.Chance(0.1) ? RollingTransition.Heuristic : RollingTransition.Exact,
                CollisionTiming = random.Chance(0.1) ? CollisionTiming.Bisection : CollisionTiming.Exact,
            },
            Position = position,
            Velocity = velocity,
            Spin = spin,
            Frames = frames,
        };
        return kind == StressKind.ComesToRest ? made with { RestsBy = RestsBy(made) } : made;
    }

    /// <summary>Returns the guaranteed time by which a ball is at rest, s, without wind and with every loss above its minimum.</summary>
    /// <remarks>
    /// V = |v| + r|ω| + √(2 g h) is never exceeded. Bounces: 2V/(g(1 − e)); slide and roll: V/(μ g) each; the spin about the vertical falls by
    /// c/I a second until its energy is below the rest energy.
    /// </remarks>
    public static double RestsBy(StressScene s)
    {
        Ground ground = s.Scene.Ground;
        double g = -s.Upward;
        double height = Math.Max(0, s.Position.Y - ground.Height - s.Scene.Ball.Radius);
        double v = s.Velocity.Length + (s.Scene.Ball.Radius * s.Spin.Length) + Math.Sqrt(2 * s.Scene.Gravity * height);
        double inertia = s.Scene.Ball.MomentOfInertia;
        double spinEnergy = 0.5 * inertia * s.Spin.LengthSquared;
        double decades = Math.Max(1, 0.5 * Math.Log(Math.Max(1, (spinEnergy + (s.Scene.Ball.Mass * v * v)) / ground.RestEnergy)));
        double floats = 30 + (height / 0.3) + (v / g);

        // Explicit Euler loses only a third as much per bounce.
        double slower = s.Integrator == Integrator.Euler ? 3 : 1;
        return floats + (slower * 2 * v / (g * (1 - ground.Material.NormalRestitution))) + (v / (ground.Material.SlidingFriction * g)) + (v / (ground.Material.RollingResistance * g))
            + (decades * inertia / ground.Material.SpinDamping);
    }

    private static BallProperties Ball(SeededRandom random, StressKind kind)
    {
        if (kind == StressKind.Absurd)
        {
            return new BallProperties
            {
                Mass = random.Chance(0.3) ? random.Log(0.001, 0.01) : random.Log(0.01, 100),
                Radius = random.Chance(0.3) ? random.Log(0.02, 0.05) : random.Log(0.05, 5),
                InertiaFactor = random.Log(0.1, 1),
            };
        }

        BallProperties preset = random.Any(
            BallProperties.Tunnel, BallProperties.YouthFootball, BallProperties.Futsal, BallProperties.BeachBall, BallProperties.MedicineBall);

        // Any ball between a beach ball and a medicine ball.
        return random.Chance(0.6) ? preset : new BallProperties { Mass = random.Log(0.1, 3), Radius = random.Uniform(0.1, 0.2), InertiaFactor = random.Uniform(0.4, 1) };
    }

    private static Air AnyAir(SeededRandom random, StressKind kind)
    {
        Vector3d wind = kind switch
        {
            StressKind.ComesToRest => Vector3d.Zero,
            StressKind.Hurricane => random.Uniform(20, 80) * (random.Chance(0.5) ? random.Heading() : random.Direction()),
            _ => random.Chance(0.7) ? Vector3d.Zero : random.Log(0.01, 30) * random.Direction(),
        };
        return kind == StressKind.Absurd
            ? new Air { Density = random.Any(0, 1e-6, 1.2, 10, 100), KinematicViscosity = random.Log(1e-7, 0.1), Wind = wind }
            : new Air { Density = random.Uniform(0.9, 1.3), KinematicViscosity = random.Uniform(1.3e-5, 1.9e-5), Wind = wind };
    }

    private static Ground AnyGround(SeededRandom random, StressKind kind)
    {
        bool rests = kind == StressKind.ComesToRest;
        double Friction() => rests ? random.Log(0.01, 2) : random.Chance(0.2) ? 0 : random.Log(1e-3, 2);
        double height = random.Chance(0.5) ? 0 : random.Uniform(-20, 20);
        SurfaceMaterial material = SurfaceMaterial.PublishedTurf with
        {
            NormalRestitution = rests ? random.Uniform(0, 0.95)
                : kind == StressKind.BounceTrain ? random.Any(1, 1, 0.99999, 0.999, 0.95)
                : random.Any(0, 1, random.Next()),
            TangentialRestitution = random.Any(-1, 0, 1, random.Uniform(-1, 1)),
        };
        return Ground.PublishedTurf with
        {
            Height = height,
            TangentialRestitutionZ = random.Any(-1, 0, 1, random.Uniform(-1, 1)),
            Material = material with
            {
                SpinRestitution = random.Any(0, 1, random.Next()),
                SlidingFriction = Friction(),
                RollingResistance = Friction(),
                SpinDamping = rests ? random.Log(1e-4, 0.1) : random.Chance(0.2) ? 0 : random.Log(1e-5, 1),
            },
            MinimumBounceSpeed = kind == StressKind.BounceTrain ? random.Log(1e-3, 1e-2) : random.Any(0.001, 0.2, random.Log(0.001, 1)),
            RestEnergy = rests ? random.Log(1e-6, 1e-2) : random.Log(1e-9, 1e-1),
            Aerodynamics = random.Any(GroundAerodynamics.Horizontal, GroundAerodynamics.None),
        };
    }

    private static ForceSet Forces(SeededRandom random, StressKind kind)
    {
        AerodynamicModel form = random.Chance(0.7) ? AerodynamicModel.Published : AerodynamicModel.Regularized;
        if (kind is StressKind.SlidingMode || random.Chance(0.6))
        {
            return ForceSet.Published with { Coefficients = form };
        }

        // Without drag a Magnus force may keep a ball in the air forever.
        ForceLaw drag = random.Any(ForceLaw.Empirical, ForceLaw.Constant, ForceLaw.None);
        bool floats = kind == StressKind.ComesToRest && drag == ForceLaw.None;
        return ForceSet.Published with
        {
            Buoyancy = random.Chance(0.7),
            Drag = drag,
            Magnus = floats ? ForceLaw.None : random.Any(ForceLaw.Empirical, ForceLaw.Constant, ForceLaw.None),
            SpinDecay = random.Any(ForceLaw.Empirical, ForceLaw.Constant, ForceLaw.None),
            Coefficients = form,
            DragCoefficient = kind == StressKind.ComesToRest ? random.Uniform(0.1, 1) : random.Any(0, 0.25, random.Uniform(0, 1)),
            MagnusCoefficient = random.Any(0.25, 0, random.Uniform(-0.5, 0.5)),
            SpinDecayCoefficient = random.Any(0, random.Log(1e-7, 1e-2)),
        };
    }

    /// <summary>Returns the forces with which a ball sinks, so that it comes to rest.</summary>
    private static ForceSet Sinking(ForceSet forces, BallProperties ball, Air air)
    {
        // The ball must be heavier than the air.
        forces = forces with { Buoyancy = forces.Buoyancy && Buoyancy.DisplacedMass(ball, air) < 0.5 * ball.Mass };

        // With a lift proportional to the speed and a drag proportional to its square, a ball can sink arbitrarily slowly. Methods of low order lengthen a velocity
        // that they turn, which keeps a ball bouncing.
        forces = forces.Magnus == ForceLaw.Constant ? forces with { Magnus = ForceLaw.Empirical } : forces;

        // Lift supports a ball that keeps its spin: it sinks as slowly as its drag allows, and without drag not at all.
        return forces.Magnus != ForceLaw.None ? forces with { SpinDecay = ForceLaw.Empirical } : forces;
    }

    private static double[] Frames(SeededRandom random, StressKind kind)
    {
        return kind switch
        {
            StressKind.ShortSteps => Even(random.Log(1e-6, 1e-3), 200),
            StressKind.LongSteps => Even(random.Uniform(0.1, 1), 40),
            StressKind.IrregularFrames => [.. Enumerable.Range(0, 60).Select(_ => random.Below(8) switch
            {
                0 => 0,
                1 => double.Epsilon * (1 + random.Below(1000)),
                2 => 5,
                3 => random.Log(1e-12, 1),
                _ => random.Uniform(0.002, 0.04),
            })],
            StressKind.ComesToRest => [random.Log(0.005, 0.5)],
            StressKind.BounceTrain or StressKind.Absurd => Even(random.Any(0.01, 1.0 / 60, random.Log(1e-4, 0.02)), 40),
            _ => Even(random.Any(0.01, 1.0 / 60, 0.04, random.Log(1e-3, 0.1)), 150),
        };

        static double[] Even(double length, int count) => [.. Enumerable.Repeat(length, count)];
    }

    private static (Vector3d Position, Vector3d Velocity, Vector3d Spin) Launch(SeededRandom random, StressKind kind, Scene scene)
    {
        double contact = scene.Ground.Height + scene.Ball.Radius;
        double up = random.Any(0, random.Log(1e-9, 1e-3), random.Uniform(0, 3), random.Uniform(0, 30));
        double speed = random.Any(random.Log(1e-3, 10), random.Uniform(0, 40), random.Uniform(0, 200));
        double spinRate = random.Any(0, random.Log(1e-3, 10), random.Uniform(0, 100), random.Uniform(0, 1000));
        Vector3d velocity = speed * random.Direction();
        Vector3d spin = spinRate * (random.Chance(0.2) ? random.Any(new Vector3d(1, 0, 0), Vector3d.Up, -1 * Vector3d.Up, new Vector3d(0, 0, 1)) : random.Direction());
        (velocity, spin, up) = kind switch
        {
            StressKind.LaunchOnGround => OnGround(random.Any(0, -random.Uniform(0, 5), random.Log(1e-16, 1e-6), 0), scene.Ground.MinimumBounceSpeed),
            StressKind.Grazing => Grazing(random.Log(1e-12, 1e-2)),
            StressKind.BounceTrain => (Rising(random.Any(0, random.Uniform(-3, 3), random.Log(1e-3, 1e-1))), spin, random.Any(0, random.Log(1e-6, 1))),
            StressKind.SpinWithoutTravel => (random.Chance(0.7) ? Vector3d.Zero : random.Log(1e-12, 1e-6) * random.Direction(), spin, random.Any(0, 0, up)),
            StressKind.GyroSpin => (velocity, velocity * (spinRate / Math.Max(1e-3, speed) * random.Any(1, -1)), up),
            StressKind.SlidingMode => AtJump(CriticalSpeed * random.Any(1, 1 + random.Log(1e-15, 1e-2), 1 + random.Uniform(0, 0.8))),
            _ => (velocity, spin, up),
        };
        var position = new Vector3d(random.Uniform(-60, 60), contact + up, random.Uniform(-60, 60));
        double most = velocity.Length;
        double mostSpin = spin.Length;
        return (position, most > 200 ? velocity * (200 / most) : velocity, mostSpin > 1000 ? spin * (1000 / mostSpin) : spin);

        Vector3d Rising(double rise) => new(velocity.X, rise, velocity.Z);

        (Vector3d Velocity, Vector3d Spin, double Up) OnGround(double above, double threshold)
        {
            Vector3d rises = Rising(random.Any(0, threshold, -threshold, 0.999 * threshold, -0.999 * threshold, velocity.Y));
            return (random.Any(rises, rises, Vector3d.Zero, rises.Horizontal), spin, above);
        }

        // The ball reaches the ground with almost no vertical speed, or just misses it.
        (Vector3d Velocity, Vector3d Spin, double Up) Grazing(double height)
        {
            double fall = Math.Sqrt(2 * scene.Gravity * height);
            return ((speed * random.Heading()) + new Vector3d(0, random.Any(0, -1e-9, -fall, fall, random.Uniform(-0.01, 0.01)), 0), spin, height);
        }

        (Vector3d Velocity, Vector3d Spin, double Up) AtJump(double fast)
        {
            double share = random.Any(1, 1 + random.Log(1e-15, 1e-2), 1 - random.Log(1e-15, 1e-2), random.Uniform(0.5, 2));
            return ((fast * Unit(velocity)) + scene.Air.Wind, CriticalSpin * fast / scene.Ball.Radius * share * random.Direction(), random.Uniform(0, 30));
        }
    }

    private static Vector3d Unit(Vector3d v) => v.Length > 0 ? v / v.Length : new Vector3d(1, 0, 0);
}

/// <summary>Scenes of the stress matrix with the measured laws: one of the balls, and ground with impact friction, drilling friction and the complete air force.</summary>
internal static class MeasuredStress
{
    /// <summary>The drag curves, by the names that scenarios use for their balls.</summary>
    public static IReadOnlyList<(string Type, DragCurve Curve)> Curves { get; } =
    [
        ("generic", DragCurve.Generic), ("tango12", DragCurve.Tango12), ("teamgeist", DragCurve.Teamgeist), ("jabulani", DragCurve.Jabulani),
        ("brazuca", DragCurve.Brazuca),
    ];

    /// <summary>Returns the same shot in a scene of the measured profile.</summary>
    public static StressScene Of(StressScene scene, long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, ~index));
        Ground ground = scene.Scene.Ground;
        if (scene.Kind != StressKind.ComesToRest)
        {
            // If rest is guaranteed, keep the numbers that the guarantee depends on.
            ground = ground with
            {
                Material = ground.Material with
                {
                    RestitutionSpeedScale = random.Any(30, double.PositiveInfinity, random.Log(0.1, 1000)),
                    ImpactFriction = random.Any(0, double.PositiveInfinity, random.Log(0.01, 3)),
                    RollingResistancePerSpeed = random.Any(0, random.Log(1e-4, 0.1)),
                    TorsionalPatchRadius = random.Any(0, random.Log(1e-4, 0.1)),
                },
                Aerodynamics = GroundAerodynamics.Full,
                TangentialRestitutionZ = null,
            };
        }

        return scene with
        {
            Scene = scene.Scene with
            {
                Ball = scene.Scene.Ball with { DragCurve = Curves[random.Below(Curves.Count)].Curve },
                Forces = scene.Scene.Forces with { Coefficients = AerodynamicModel.Measured },
                Ground = ground,
            },
        };
    }
}
