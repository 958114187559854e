using FootballPhysics.Laws;

namespace FootballPhysics.Passes.Plays;

/// <summary>The laws of the air: published and constant coefficients, winds, gusts, knuckle balls, and forces of the game.</summary>
internal static class Airs
{
    public static void Play()
    {
        var draw = new Draw(2);
        var storm = new WindByHeight(9, 0.6, -0.8, gusts: new Gusts { Seed = 11, Intensity = 0.3, Length = 30 });
        Air[] airs = [new Air(), new Air { Density = 0 }, new Air { Wind = new Vector3d(6, 0, 2) }, new Air { WindField = storm }, new Air { WindField = new WindByHeight(5, 1, 0) }, new Weather { Temperature = 4, Humidity = 0.9 }.ToAir(), Weather.AtAltitude(1500).ToAir(), new Air { WindField = new Whirl() }];
        foreach (ForceSet forces in Sets())
        {
            foreach (Air air in airs)
            {
                var scene = new Scene { Air = air, Forces = forces };
                OneBall.Kicks(draw, new Simulator(scene), 1, 1.0 / 60);
                OneBall.Kicks(draw, new Simulator(scene with { Ground = scene.Ground with { Aerodynamics = draw.Any(Enum.GetValues<GroundAerodynamics>()) } }, new SolverSettings { Integrator = draw.Any(Enum.GetValues<Integrator>()) }), 1, 0.01);
            }
        }

        foreach (BallProperties ball in BallProperties.Presets.Values)
        {
            OneBall.Kicks(draw, new Simulator(new Scene { Ball = ball, Forces = ForceSet.Measured with { KnuckleSeed = draw.Below(99) } }), 2, 1.0 / 60);
        }

        // Without gravity or with gravity to the side, and among boards.
        Scene[] others =
        [
            Scene.Published, Scene.Vacuum, Scene.Published with { Gravity = 0 }, new Scene { GravityVector = new Vector3d(1, -9.6, 0.5) }, new Scene { Ground = Ground.None },
            Pitch.Cage.On(Scene.Published), Pitch.Stadium.On(new Scene { Air = new Air { WindField = storm }, Forces = ForceSet.Measured with { KnuckleSeed = 3 } }),
            Pitch.Cage.On(new Scene { Forces = ForceSet.Measured with { CustomForces = [IForce.From(Pull)] } }),
        ];
        foreach (Scene scene in others)
        {
            OneBall.Kicks(draw, new Simulator(scene), 12, 1.0 / 60);
            OneBall.Kicks(draw, new Simulator(scene, new SolverSettings { Integrator = Integrator.Rk2 }), 3, 0.01);
        }

        // Through the jump of the published drag law, in flight and along the ground.
        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = integrator });
            var log = new StepLog();
            for (double speed = 8; speed < 26; speed += 0.5)
            {
                foreach ((double up, double spin) in new[] { (0.0, 0.0), (4, 30), (1.5, -60) })
                {
                    BallState ball = simulator.Launch(new Vector3d(0, up == 0 ? 0.11 : 1, 0), new Vector3d(speed, up, 0), new Vector3d(0, spin, -spin));
                    simulator.Run(ref ball, 0.01, 6, StopAt.Rest, log);
                    log.Clear();
                }
            }
        }

        Evaluations(draw);
    }

    private static IEnumerable<ForceSet> Sets()
    {
        yield return ForceSet.Measured;
        yield return ForceSet.Published;
        yield return ForceSet.Regularized;
        yield return ForceSet.Constant;
        yield return ForceSet.Constant with { SpinDecayCoefficient = 0.02 };
        yield return ForceSet.None;
        yield return ForceSet.Measured with { KnuckleSeed = 7 };
        yield return ForceSet.Published with { KnuckleSeed = 7 };
        yield return ForceSet.Measured with { Drag = ForceLaw.None };
        yield return ForceSet.Measured with { Magnus = ForceLaw.Constant };
        yield return ForceSet.Published with { Drag = ForceLaw.Constant, Magnus = ForceLaw.None };
        yield return ForceSet.Regularized with { SpinDecay = ForceLaw.None, Buoyancy = false };
        yield return ForceSet.Measured with { CustomForces = [IForce.From(Pull)] };
        yield return ForceSet.Published with { CustomForces = [IForce.From(Pull), new ScaledAir(Scene.Published, 1.1, 0.9)] };
        yield return ForceSet.Measured with { CustomForces = [new Twist()] };
        yield return ForceSet.None with { CustomForces = [new ScaledAir(Scene.Default, 0.9, 1.2)] };
    }

    private static Vector3d Pull(ForceContext ball) => (-0.2 * ball.Position) + new Vector3d(0, 0.1 * Math.Sin(ball.Time), 0);

    private static void Evaluations(Draw draw)
    {
        foreach (Scene scene in new[] { Scene.Default, Scene.Published, new Scene { Air = new Air { WindField = new Whirl() }, Forces = ForceSet.Measured with { KnuckleSeed = 1 } } })
        {
            var air = new Aerodynamics(scene);
            Vector3d[] positions = [.. Enumerable.Range(0, 50).Select(_ => draw.Vector(10))];
            Vector3d[] velocities = [.. Enumerable.Range(0, 50).Select(_ => draw.Vector(30))];
            Vector3d[] spins = [.. Enumerable.Range(0, 50).Select(_ => draw.Vector(60))];
            var loads = new ForceAndTorque[50];
            air.Evaluate(positions, velocities, spins, 1, loads);
            for (int i = 0; i < 50; i++)
            {
                _ = air.Evaluate(positions[i], velocities[i], spins[i], 1, 2);
                _ = air.EvaluateForStep(positions[i], velocities[i], spins[i], 0.02, new Vector3d(0, -9.81, 0));
                _ = air.KickVelocity(positions[i], velocities[i], spins[i], 0.02, new Vector3d(0, -9.81, 0));
            }
        }
    }

    /// <summary>A force of the game with a torque.</summary>
    private sealed class Twist : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(-0.01 * ball.Velocity);
            sum.AddTorque(-1e-5 * ball.Spin);
        }
    }

    /// <summary>Air that turns about the vertical.</summary>
    private sealed class Whirl : IWind
    {
        public double MaximumSpeed => 8;

        public Vector3d At(double time, in Vector3d position) => 8 / (1 + position.Length) * new Vector3d(position.Z, Math.Sin(time), -position.X).Normalized();
    }
}
