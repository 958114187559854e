using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Stability;

/// <summary>Draws a hostile scene from its number: masses and sizes of six decades, restitutions and frictions at both ends, launches exactly on the law's surfaces, steps in hostile orders.</summary>
internal static class HostileGenerator
{
    private const double CriticalSpeed = 12.19;
    private const double CriticalSpin = 0.05;
    private const double Farthest = 1e6;

    /// <summary>Returns the scene with a number.</summary>
    public static StressScene Make(ulong number)
    {
        // One random sequence: the order of the draws determines the scene.
        var random = new HostileRandom(number);
        int kind = random.Below(16);
        BallProperties ball = Ball(random);
        double gravity = random.Any(9.81, 9.81, 0, 1e-6, 300, random.Log(1e-6, 300), 1.62);
        Air air = AnyAir(random);

        // The ball contains some of the air that it displaces.
        double volume = Buoyancy.DisplacedMass(ball, new Air { Density = 1 });
        ball = ball with { Mass = Math.Min(100, Math.Max(ball.Mass, 0.06 * volume * air.Density)) };
        air = air with { Density = Math.Min(air.Density, 10 * ball.Mass / volume) };
        Ground ground = AnyGround(random, ball);
        ForceSet forces = Forces(random, kind, ball, ground.Height);
        (Vector3d velocity, Vector3d spin, double up) = Kick(random, kind, ball, air, ground, gravity);
        Vector3d position = Place(random, kind, ground.Height + ball.Radius, ground.Height, up);
        SolverSettings settings = Settings(random);
        return new StressScene
        {
            Number = (long)number,
            Scene = Scene.Published with { Ball = ball, Gravity = gravity, Air = air, Ground = ground, Forces = forces },
            Settings = settings,
            Position = position,
            Velocity = velocity,
            Spin = spin,
            Frames = Frames(random, ground.Material.NormalRestitution > 0.9),
        };
    }

    private static BallProperties Ball(HostileRandom random)
    {
        if (!random.Chance(0.6))
        {
            return BallProperties.Tunnel;
        }

        double mass = random.Any(random.Log(1e-3, 100), random.Log(0.01, 10), 1e-3, 100);
        double radius = random.Any(random.Log(0.02, 5), random.Log(0.02, 1), 0.02, 5);
        return new BallProperties { Mass = mass, Radius = radius, InertiaFactor = random.Any(1.0, 0.4, 2.0 / 3, 0.1, random.Log(0.1, 1)) };
    }

    private static Air AnyAir(HostileRandom random)
    {
        double density = random.Any(1.2, 1.2, 0.0, random.Log(1e-3, 30), 0.9);
        double viscosity = random.Any(1.5e-5, 1.5e-5, random.Log(1e-7, 0.1));
        Vector3d wind = Vector3d.Zero;
        if (random.Chance(0.35))
        {
            wind = random.Any(1000.0, random.Uniform(0, 30), random.Log(1e-6, 1000), CriticalSpeed) * random.Direction();
            wind = random.Chance(0.3) ? new Vector3d(0, wind.Y, 0) : wind;
        }

        return new Air { Density = density, KinematicViscosity = viscosity, Wind = wind };
    }

    private static Ground AnyGround(HostileRandom random, BallProperties ball)
    {
        double height = random.Any(0, 0, Farthest, -Farthest, random.Uniform(-Farthest, Farthest), random.Uniform(-5, 5));
        SurfaceMaterial material = SurfaceMaterial.PublishedTurf with
        {
            NormalRestitution = random.Any(0.0, 1.0, 0.6, random.Next(), 1 - 1e-9, 1e-12),
            TangentialRestitution = random.Any(0.0, 1.0, -1.0, 0.5, random.Uniform(-1, 1)),
        };
        return Ground.PublishedTurf with
        {
            Height = height,
            TangentialRestitutionZ = random.Any(0.0, 1.0, -1.0, 0.5, random.Uniform(-1, 1)),
            Material = material with
            {
                SpinRestitution = random.Any(0.0, 1.0, 0.8),
                SlidingFriction = random.Any(0.0, 10.0, 0.5, random.Log(1e-6, 10)),
                RollingResistance = random.Any(0.0, 10.0, 0.05, random.Log(1e-6, 10)),
                SpinDamping = Math.Min(ball.MostDamping, random.Any(0.0, 0.002, 1.0, random.Log(1e-9, 1))),
            },
            MinimumBounceSpeed = random.Any(0.001, 0.2, 10.0, random.Log(0.001, 10)),
            RestEnergy = random.Any(1e-4, 1e-12, 100, random.Log(1e-12, 100)),
            Aerodynamics = random.Any(GroundAerodynamics.Horizontal, GroundAerodynamics.None),
        };
    }

    private static ForceSet Forces(HostileRandom random, int kind, BallProperties ball, double groundHeight)
    {
        var forces = ForceSet.Published with
        {
            Buoyancy = random.Chance(0.7),
            Coefficients = random.Chance(0.7) ? AerodynamicModel.Published : AerodynamicModel.Regularized,
        };
        if (random.Below(10) >= 5)
        {
            forces = forces with
            {
                Drag = (ForceLaw)random.Below(3),
                Magnus = (ForceLaw)random.Below(3),
                SpinDecay = (ForceLaw)random.Below(3),
                DragCoefficient = random.Any(0.0, 0.25, random.Log(1e-6, 10), 10),
                MagnusCoefficient = random.Any(0.25, -0.25, 0.0, random.Uniform(-5, 5), random.Log(1, 10), -10),
                SpinDecayCoefficient = Math.Min(ball.MostDamping, random.Any(0.0, 1e-4, random.Log(1e-9, 1))),
            };
        }

        bool own = (kind == 15 && random.Chance(0.3)) || random.Chance(0.01);
        return own ? forces with { CustomForces = [HostileForces.Draw(random, groundHeight)] } : forces;
    }

    private static (Vector3d Velocity, Vector3d Spin, double Up) Kick(HostileRandom random, int kind, BallProperties ball, Air air, Ground ground, double gravity)
    {
        double speed = random.Any(random.Uniform(0, 40), random.Log(1e-9, 1000), 1000.0, 0.0, CriticalSpeed, 1e-3, random.Uniform(10, 14));
        double spinRate = random.Any(0.0, random.Uniform(0, 100), 10000.0, random.Log(1e-9, 10000), 1e-100);
        var along = new Vector3d(1, 0, 0);
        var down = new Vector3d(0, -1, 0);
        Vector3d direction = random.Chance(0.15) ? random.Any(along, Vector3d.Up, down, new Vector3d(0, 0, 1)) : random.Direction();
        Vector3d velocity = speed * direction;
        Vector3d spin = spinRate * (random.Chance(0.2) ? random.Any(along, Vector3d.Up, down) : random.Direction());
        double up = random.Any(0.0, random.Log(1e-15, 1e-3), random.Uniform(0, 3), random.Uniform(0, 500), random.Log(1, 1e5));
        double threshold = ground.MinimumBounceSpeed;
        (velocity, spin, up) = kind switch
        {
            // Exactly at the critical speed.
            0 => (
                (CriticalSpeed * random.Direction()) + air.Wind,
                CriticalSpin * CriticalSpeed / ball.Radius * random.Any(1, 1 + 1e-15, 1 - 1e-15, 2, 0.5, random.Log(0.01, 100)) * random.Direction(),
                random.Uniform(0, 30)),
            1 => AtCriticalSpin(random.Uniform(12, 40)),

            // Level flight at the critical speed.
            2 => ((CriticalSpeed * random.Any(1, 1 + 1e-12, 1 - 1e-9, 1 + 1e-6) * random.Heading()) + air.Wind, spin, random.Uniform(0, 20)),

            // On the ground, at and around the minimum bounce speed.
            3 => (Rising(random.Any(threshold, -threshold, 0, 1e-100, -1e-100, threshold * (1 - 1e-16), -threshold * (1 - 1e-15))), spin, 0),
            4 => Grazing(random.Log(1e-12, 1)),
            5 => (Vector3d.Zero, spin, random.Any(0.0, 500.0, 1.0)),

            // Spins along its flight.
            6 => (velocity, spinRate / Math.Max(1e-6, velocity.Length) * velocity, up),

            // Rolls without slip.
            7 => (Rising(0), new Vector3d(velocity.Z / ball.Radius, spin.Y, -velocity.X / ball.Radius), 0),
            8 => (air.Wind, spin, up),
            9 => (Rising(-Math.Abs(velocity.Y) - 1), spin, 0),
            _ => (velocity, spin, up),
        };
        return (velocity.Length > 1000 ? velocity * (999.999 / velocity.Length) : velocity, spin.Length > 10000 ? spin * (9999.99 / spin.Length) : spin, up);

        Vector3d Rising(double rise) => new(velocity.X, rise, velocity.Z);

        // Exactly at the critical spin.
        (Vector3d Velocity, Vector3d Spin, double Up) AtCriticalSpin(double fast) => (
            (fast * random.Direction()) + air.Wind, CriticalSpin * fast / ball.Radius * random.Any(1, 1 + 2e-16, 1 - 2e-16) * random.Direction(), random.Uniform(0, 30));

        // Grazes the ground.
        (Vector3d Velocity, Vector3d Spin, double Up) Grazing(double height)
        {
            double fall = Math.Sqrt(2 * gravity * height);
            return (Rising(random.Any(-fall, fall, -fall * (1 + 1e-12), 0.0)), spin, height);
        }
    }

    private static Vector3d Place(HostileRandom random, int kind, double contact, double groundHeight, double up)
    {
        double x = random.Any(0.0, Farthest, -Farthest, random.Uniform(-100, 100));
        double y = contact + up;
        y = y > Farthest ? random.Any(Farthest, Math.Min(Farthest, contact)) : y;
        if (kind == 10)
        {
            // At, in and below the ground.
            y = random.Any(-Farthest, groundHeight, contact - 1e-12, Math.BitDecrement(contact), Math.BitIncrement(contact));
        }

        return new Vector3d(x, Math.Max(-Farthest, Math.Min(y, Farthest)), random.Uniform(-100, 100));
    }

    private static SolverSettings Settings(HostileRandom random) => new()
    {
        Integrator = random.Any(Integrator.Rk4, Integrator.Rk4, Integrator.Rk4, Integrator.Rk2, Integrator.Euler, Integrator.SemiImplicitEuler),
        CollisionTiming = random.Chance(0.8) ? CollisionTiming.Exact : CollisionTiming.Bisection,
        CollisionTolerance = random.Any(1e-6, 1e-12, 1e-3, 1.0, 1e-300),
        RollingTransition = random.Chance(0.8) ? RollingTransition.Exact : RollingTransition.Heuristic,
    };

    private static double[] Frames(HostileRandom random, bool elastic)
    {
        int kind = random.Below(8);
        var frames = new double[random.Any(10, 30, 60)];
        double even = random.Log(1e-4, 0.1);
        for (int i = 0; i < frames.Length; i++)
        {
            frames[i] = kind switch
            {
                0 => 0.01,
                1 => even,
                2 => random.Any(1e-9, 0.016, 1e-9, 0.3),
                3 => random.Log(1e-9, 1),
                4 => i % 2 == 0 ? 1e-9 : 1.0,
                5 => random.Any(0.0, double.Epsilon, 1e-12, 0.02),
                6 when i < 4 => elastic ? random.Any(0.1, 0.3, 1.0) : random.Any(1.0, 10.0, 100.0),
                6 => 0.01,
                _ => 1.0 / 60,
            };
        }

        return frames;
    }
}

/// <summary>Custom forces of any strength.</summary>
internal static class HostileForces
{
    /// <summary>Returns one of four forces; all are drawn, so that the random sequence does not depend on the choice.</summary>
    public static IForce Draw(HostileRandom random, double groundHeight) => random.Any<IForce>(
        new Spring(
            random.Log(1e-3, 1e3),
            random.Any(0.0, random.Log(1e-3, 10)),
            new Vector3d(random.Uniform(-5, 5), groundHeight + random.Uniform(-3, 5), random.Uniform(-5, 5))),
        new Twister(random.Log(1e-2, 1e3), random.Log(1e-2, 1e4)),
        new Thrust(random.Uniform(-20, 20)),
        new Damper(random.Log(1e-3, 1e2), random.Log(1e-9, 1e3)));

    private sealed record Spring(double Stiffness, double Damping, Vector3d Origin) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddForce((Stiffness * (Origin - ball.Position)) - (Damping * ball.Velocity));
    }

    private sealed record Twister(double Strength, double Rate) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(new Vector3d(Strength * Math.Sin(Rate * ball.Time), Strength * Math.Cos(Rate * ball.Time), 0));
            sum.AddTorque(new Vector3d(0, 0.001 * Strength, 0));
        }
    }

    private sealed record Thrust(double Strength) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddForce(new Vector3d(0, Strength, 0));
    }

    private sealed record Damper(double OfVelocity, double OfSpin) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(-OfVelocity * ball.Velocity);
            sum.AddTorque(-OfSpin * ball.Spin);
        }
    }
}

/// <summary>The random numbers of the hostile scenes. The scenes depend on their order and their bits, so neither may change.</summary>
internal sealed class HostileRandom(ulong seed) : SeededRandom(Start(seed))
{
    public override double Log(double low, double high) => Math.Exp(Uniform(Math.Log(low), Math.Log(high)));

    public override int Below(int count) => (int)(Bits() % (ulong)count);

    public override Vector3d Direction()
    {
        while (true)
        {
            var v = new Vector3d(Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1));
            double length = Math.Sqrt((v.X * v.X) + (v.Y * v.Y) + (v.Z * v.Z));
            if (length is > 1e-3 and <= 1)
            {
                return new Vector3d(v.X / length, v.Y / length, v.Z / length);
            }
        }
    }

    private static ulong Start(ulong seed)
    {
        unchecked
        {
            ulong z = seed + 0x632BE59BD9B4E019UL;
            z = (z ^ (z >> 33)) * 0xFF51AFD7ED558CCDUL;
            z = (z ^ (z >> 33)) * 0xC4CEB9FE1A85EC53UL;
            z ^= z >> 33;
            return (Mixed(z + Step) ^ (z << 1)) + Step;
        }
    }
}
