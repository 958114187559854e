using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Laws;

/// <summary>The force and torque for a foreign rigid body, against the library's own flight and closed forms.</summary>
public sealed class AerodynamicsTests
{
    private const double Step = 0.001;

    public static TheoryData<string> Scenes => ["default", "published", "regularised", "constant", "vacuum", "wind", "wind by height", "knuckle", "custom", "tilted"];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void It_is_the_law_of_the_librarys_own_flight(string name)
    {
        Scene scene = Of(name) with { Ground = Ground.None };
        var air = new Aerodynamics(scene);
        var simulator = new Simulator(scene, new SolverSettings { Integrator = Integrator.Euler });
        var random = new SplitMix(7);
        for (int i = 0; i < 200; i++)
        {
            var position = new Vector3d(random.Next(-40, 40), random.Next(1, 20), random.Next(-40, 40));
            var velocity = new Vector3d(random.Next(-25, 25), random.Next(-15, 15), random.Next(-25, 25));
            var spin = new Vector3d(random.Next(-60, 60), random.Next(-60, 60), random.Next(-60, 60));
            spin = i % 10 == 0 ? Vector3d.Zero : i % 10 == 1 ? 0.03 * spin : spin;
            BallState ball = simulator.Launch(position, velocity, spin);
            ForceAndTorque load = air.Evaluate(position, velocity, spin, orientation: ball.Orientation);

            // One step of the explicit Euler method is the law itself, times the step.
            simulator.Step(ref ball, Step, new StepLog());
            Vector3d expected = velocity + (Step * (scene.GravityVector + ((load.Force + air.Buoyancy) / scene.Ball.Mass)));
            Vector3d expectedSpin = spin + (Step / scene.Ball.MomentOfInertia * load.Torque);
            Assert.Equal(0, (ball.Velocity - expected).Length, 1e-9);
            Assert.Equal(0, (ball.Spin - expectedSpin).Length, 1e-9);
        }
    }

    [Fact]
    public void Constant_laws_have_their_closed_forms()
    {
        Scene scene = new()
        {
            Air = new Air { Density = 1.2, Wind = new Vector3d(3, 0, -1) },
            Forces = ForceSet.Constant with { DragCoefficient = 0.3, MagnusCoefficient = 0.2, SpinDecayCoefficient = 1e-4 },
        };
        var velocity = new Vector3d(4, 6, -21);
        var spin = new Vector3d(10, 40, -5);
        ForceAndTorque load = new Aerodynamics(scene).Evaluate(Vector3d.Zero, velocity, spin);
        Vector3d u = velocity - scene.Air.Wind;
        double area = Math.PI * scene.Ball.Radius * scene.Ball.Radius;

        // F = C_M ρ π r³ (ω × u) − ½ ρ A C_D |u| u
        Vector3d drag = -0.5 * 1.2 * area * 0.3 * u.Length * u;
        Vector3d magnus = 0.2 * 1.2 * area * scene.Ball.Radius * Vector3d.Cross(spin, u);
        Assert.Equal(0, (load.Force - drag - magnus).Length, 1e-12);
        Assert.Equal(0, (load.Torque - (-1e-4 * spin)).Length, 1e-15);
    }

    [Fact]
    public void Buoyancy_is_the_weight_of_the_displaced_air_and_not_in_the_force()
    {
        var air = new Aerodynamics();
        double displaced = 4.0 / 3.0 * Math.PI * Math.Pow(air.Scene.Ball.Radius, 3) * air.Scene.Air.Density;
        Assert.Equal(displaced * 9.81, air.Buoyancy.Y, 1e-12);
        Assert.Equal(Vector3d.Zero, air.Evaluate(Vector3d.Zero, Vector3d.Zero, Vector3d.Zero).Force);
        Assert.Equal(Vector3d.Zero, new Aerodynamics(Scene.Vacuum).Buoyancy);
    }

    [Fact]
    public void Many_bodies_get_the_loads_of_single_ones_and_nothing_is_allocated()
    {
        var air = new Aerodynamics(Of("knuckle"));
        const int Count = 10_000;
        var positions = new Vector3d[Count];
        var velocities = new Vector3d[Count];
        var spins = new Vector3d[Count];
        var flown = new double[Count];
        var orientations = new Quaterniond[Count];
        var loads = new ForceAndTorque[Count];
        var random = new SplitMix(3);
        for (int i = 0; i < Count; i++)
        {
            velocities[i] = new Vector3d(random.Next(-25, 25), random.Next(-15, 15), random.Next(-25, 25));
            spins[i] = i % 2 == 0 ? Vector3d.Zero : new Vector3d(0, random.Next(-60, 60), 0);
            flown[i] = random.Next(0, 50);
            orientations[i] = new Quaterniond(random.Next(-1, 1), random.Next(-1, 1), random.Next(-1, 1), 2);
        }

        Assert.Equal(0, Allocation.Of(() => air.Evaluate(positions, velocities, spins, 2, loads, flown, orientations)));
        for (int i = 0; i < Count; i++)
        {
            Assert.Equal(air.Evaluate(positions[i], velocities[i], spins[i], 2, flown[i], orientations[i]), loads[i]);
        }

        // Without distances all are 0, without orientations the identity, and several threads get the same.
        Parallel.For(0, 8, _ =>
        {
            var mine = new ForceAndTorque[Count];
            air.Evaluate(positions, velocities, spins, 2, mine);
            Assert.Equal(air.Evaluate(positions[0], velocities[0], spins[0], 2), mine[0]);
            Assert.NotEqual(loads[0], mine[0]);
        });
    }

    [Fact]
    public void With_the_kicks_correction_an_engines_steps_in_vacuum_are_the_parabola()
    {
        var air = new Aerodynamics(Scene.Vacuum);
        var gravity = new Vector3d(0, -9.81, 0);
        var kick = new Vector3d(3, 8, -20);
        Vector3d velocity = air.KickVelocity(Vector3d.Zero, kick, Vector3d.Zero, 0.02, gravity);
        Vector3d position = Vector3d.Zero;
        for (int i = 1; i <= 80; i++)
        {
            velocity += 0.02 * gravity;
            position += 0.02 * velocity;
            double t = 0.02 * i;
            Assert.Equal(0, (position - ((t * kick) + (0.5 * t * t * gravity))).Length, 1e-12);
        }
    }

    [Fact]
    public void With_both_corrections_an_engines_steps_converge_at_second_order()
    {
        var scene = new Scene { Ground = Ground.None };
        var air = new Aerodynamics(scene);
        var simulator = new Simulator(scene, new SolverSettings { Integrator = Integrator.Rk4 });
        BallState ball = simulator.Launch(Vector3d.Zero, new Vector3d(2, 7, -24), new Vector3d(5, 45, 0));
        for (int i = 0; i < 1200; i++)
        {
            simulator.Step(ref ball, 0.001, new StepLog());
        }

        double Miss(int steps)
        {
            double step = 1.2 / steps;
            Vector3d pull = scene.GravityVector + (air.Buoyancy / scene.Ball.Mass);
            Vector3d position = Vector3d.Zero;
            var spin = new Vector3d(5, 45, 0);
            Vector3d velocity = air.KickVelocity(position, new Vector3d(2, 7, -24), spin, step, pull);
            for (int i = 0; i < steps; i++)
            {
                ForceAndTorque load = air.EvaluateForStep(position, velocity, spin, step, pull);
                velocity += step * (pull + (load.Force / scene.Ball.Mass));
                position += step * velocity;
                spin += step / scene.Ball.MomentOfInertia * load.Torque;
            }

            return (position - ball.Position).Length;
        }

        double coarse = Miss(60);
        Assert.InRange(coarse, 1e-6, 0.003);
        Assert.InRange(Miss(240) / coarse, 0, 0.1);
    }

    [Fact]
    public void What_is_out_of_range_is_rejected_by_name_and_nothing_is_written()
    {
        var air = new Aerodynamics();
        Vector3d zero = Vector3d.Zero;
        var bad = new Vector3d(double.NaN, 0, 0);
        Assert.StartsWith("position is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate(bad, zero, zero)).Message);
        Assert.StartsWith("velocity is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate(zero, new Vector3d(1001, 0, 0), zero)).Message);
        Assert.StartsWith("spin is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate(zero, zero, new Vector3d(0, 10_001, 0))).Message);
        Assert.StartsWith("time is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate(zero, zero, zero, -1)).Message);
        Assert.StartsWith("airDistance is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate(zero, zero, zero, 0, -1)).Message);
        Assert.StartsWith("step is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.KickVelocity(zero, zero, zero, 2, zero)).Message);
        var pull = new Vector3d(0, -1001, 0);
        Assert.StartsWith("gravity is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.KickVelocity(zero, zero, zero, 0.02, pull)).Message);
        Assert.StartsWith("step is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.EvaluateForStep(zero, zero, zero, 2, zero)).Message);
        Assert.StartsWith("gravity is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.EvaluateForStep(zero, zero, zero, 0.02, pull)).Message);
        Assert.Throws<ArgumentOutOfRangeException>(() => new Aerodynamics(new Scene { Air = new Air { Density = -1 } }));
        var loads = new ForceAndTorque[2];
        Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate([zero, zero], [new Vector3d(20, 0, 0), bad], [zero, zero], 0, loads));
        Assert.Equal(default, loads[0]);
        Assert.StartsWith("airDistance is ", Assert.Throws<ArgumentOutOfRangeException>(() => air.Evaluate([zero, zero], [new Vector3d(20, 0, 0), zero], [zero, zero], 0, loads, [1, -1])).Message);
        Assert.Equal(default, loads[0]);
        Assert.StartsWith("spins has 1 items; allowed: 2", Assert.Throws<ArgumentException>(() => air.Evaluate([zero, zero], [zero, zero], [zero], 0, loads)).Message);
        Assert.StartsWith("airDistances has 3", Assert.Throws<ArgumentException>(() => air.Evaluate([zero, zero], [zero, zero], [zero, zero], 0, loads, [1, 2, 3])).Message);
    }

    private static Scene Of(string name) => name switch
    {
        "published" => Scene.Published,
        "regularised" => new Scene { Forces = ForceSet.Regularized },
        "constant" => new Scene { Forces = ForceSet.Constant },
        "vacuum" => Scene.Vacuum,
        "wind" => Scene.Windy(new Vector3d(4, 1, -3)),
        "wind by height" => new Scene { Air = new Air { WindField = new WindByHeight(5, 1, -2) } },
        "knuckle" => new Scene { Ball = BallProperties.Jabulani, Forces = new ForceSet { KnuckleSeed = 5 } },
        "custom" => new Scene { Forces = new ForceSet { CustomForces = [IForce.From(ball => new Vector3d(0.4, 0.01 * ball.Position.X, 0.02 * ball.AirVelocity.Z))] } },
        "tilted" => new Scene { GravityVector = new Vector3d(1, -9, 2) },
        _ => new Scene(),
    };

    /// <summary>Numbers of a seed.</summary>
    private sealed class SplitMix(long seed)
    {
        private int _next;

        public double Next(double low, double high) => low + ((high - low) * SplitMix64.At(seed, _next++));
    }
}
