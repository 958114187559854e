using FootballPhysics.Tests.Reference;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>Measured orders of the methods, up to and including the impact, the jump of the drag law, and the end of a slide.</summary>
public sealed class ConvergenceTests
{
    [Theory]
    [InlineData(Integrator.Euler, 0.01, 0.9, 1.15)]
    [InlineData(Integrator.SemiImplicitEuler, 0.01, 0.9, 1.15)]
    [InlineData(Integrator.Rk2, 0.02, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 0.16, 3.8, 4.5)]
    public void Reference_cases_that_end_with_an_impact_converge_at_the_order_of_the_method(Integrator integrator, double coarsest, double low, double high)
    {
        ReferenceCase[] cases = [.. ReferenceCase.All.Where(item =>
            item.StopAt == StopAt.Impact && item.Expected.Time > 0.5 && !item.Name.Contains("violent", StringComparison.Ordinal)
            && item.Scene.Forces.Drag != ForceLaw.None && item.Scene.Forces.Coefficients == AerodynamicModel.Published)];
        Assert.True(cases.Length > 25);
        Order.Hold(integrator.ToString(), [.. cases.Select(item => Order.Observed(coarsest, 3, step =>
            Vector3d.Distance(
                Flight.ToImpact(item.Scene, integrator, step, item.Position, item.Velocity, item.Spin).Position,
                item.Expected.Position)))], low, high);
    }

    [Theory]
    [InlineData(Integrator.Rk2, 0.04, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 0.16, 3.8, 4.5)]
    public void Shots_that_cross_the_critical_speed_keep_the_order(Integrator integrator, double coarsest, double low, double high)
    {
        var random = new Shots(1219);
        var orders = new List<double>();
        while (orders.Count < 20)
        {
            Vector3d velocity = random.Velocity(13.5, 18, 15, 35);
            Vector3d spin = random.Uniform(30, 60) * random.Direction();
            if (Crosses(velocity, spin, (speed, sp) => speed - FittedDrag.CriticalSpeed, sp => sp > 0.1))
            {
                orders.Add(OrderOf(Scene.Published, integrator, coarsest, velocity, spin));
            }
        }

        Order.Hold(integrator.ToString(), orders, low, high);
    }

    [Theory]
    [InlineData(Integrator.Rk2, 0.04, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 0.16, 3.8, 4.5)]
    public void Shots_that_cross_the_critical_spin_parameter_keep_the_order(Integrator integrator, double coarsest, double low, double high)
    {
        var random = new Shots(5);
        var orders = new List<double>();
        while (orders.Count < 20)
        {
            // Fast, with a spin parameter just below the critical one, which grows as the ball slows down.
            Vector3d velocity = random.Velocity(22, 34, 15, 30);
            Vector3d spin = random.Uniform(0.044, 0.049) * velocity.Length / Flight.Radius * random.Direction();
            if (Crosses(velocity, spin, (speed, sp) => FittedDrag.CriticalSpin - sp, _ => true))
            {
                orders.Add(OrderOf(Scene.Published, integrator, coarsest, velocity, spin));
            }
        }

        Order.Hold(integrator.ToString(), orders, low, high);
    }

    [Theory]
    [InlineData(Integrator.Euler, 0.02, 0.85, 1.2)]
    [InlineData(Integrator.SemiImplicitEuler, 0.02, 0.85, 1.2)]
    [InlineData(Integrator.Rk2, 0.04, 1.85, 2.2)]
    [InlineData(Integrator.Rk4, 0.08, 3.7, 4.5)]
    public void Flights_by_the_measured_laws_keep_the_order(Integrator integrator, double coarsest, double low, double high)
    {
        var random = new Shots(78);
        Order.Hold(integrator.ToString(), [.. Enumerable.Range(0, 16).Select(_ =>
            OrderOf(Scene.Measured, integrator, coarsest, random.Velocity(15, 30, 15, 35), random.Uniform(10, 60) * random.Direction()))], low, high);
    }

    [Theory]
    [InlineData(Integrator.Euler, 0.02, 0.85, 1.2)]
    [InlineData(Integrator.SemiImplicitEuler, 0.02, 0.85, 1.2)]
    [InlineData(Integrator.Rk2, 0.04, 1.85, 2.3)]
    [InlineData(Integrator.Rk4, 0.08, 3.7, 4.5)]
    public void Flights_in_gusts_of_a_ball_that_wobbles_keep_the_order(Integrator integrator, double coarsest, double low, double high)
    {
        // Well above 2 m, where the upward gusts are full, and with a spin that the knuckle force does not end at.
        Scene scene = Scene.Measured with
        {
            Air = new Air { WindField = new WindByHeight(8, 1, 1, gusts: new Gusts { Seed = 5 }) },
            Forces = ForceSet.Measured with { KnuckleSeed = 17 },
            Ground = FootballPhysics.Ground.PublishedTurf with { Height = -20 },
        };
        var random = new Shots(79);
        Order.Hold(integrator.ToString(), [.. Enumerable.Range(0, 12).Select(_ =>
        {
            Vector3d velocity = random.Velocity(20, 30, 5, 25);
            return Order.Observed(coarsest, 3, step => Vector3d.Distance(High(scene, integrator, step, velocity), High(scene, Integrator.Rk4, 0.0025, velocity)));
        })], low, high);

        static Vector3d High(Scene scene, Integrator integrator, double step, Vector3d velocity) =>
            Flight.Play(scene, Flight.With(integrator), step, 0.64, StopAt.Time, new Vector3d(0, 3, 0), velocity, new Vector3d(0, 2, 1), out _).Position;
    }

    /// <summary>The orientation is known within a step, so that the force of the seams keeps the order while the ball turns.</summary>
    [Theory]
    [InlineData(Integrator.Rk2, 0.04, 1.8, 2.3)]
    [InlineData(Integrator.Rk4, 0.04, 3.7, 4.6)]
    public void Flights_of_a_knuckle_ball_that_turns_keep_the_order(Integrator integrator, double coarsest, double low, double high)
    {
        var random = new Shots(80);
        Order.Hold(integrator.ToString(), [.. Enumerable.Range(0, 12).Select(i => OrderOf(
            Scene.Measured with { Forces = ForceSet.Measured with { KnuckleSeed = i } }, integrator, coarsest, random.Velocity(20, 30, 15, 25), random.Uniform(3, 20) * random.Direction()))], low, high);
    }

    [Theory]
    [InlineData(Integrator.Euler, 0.02, 0.85, 1.2)]
    [InlineData(Integrator.SemiImplicitEuler, 0.02, 0.85, 1.2)]
    [InlineData(Integrator.Rk2, 0.04, 1.9, 2.2)]
    [InlineData(Integrator.Rk4, 0.16, 3.8, 4.5)]
    public void Flights_with_a_force_of_the_game_keep_the_order(Integrator integrator, double coarsest, double low, double high)
    {
        // An updraught that fades with height, and a gust in time.
        var gust = IForce.From(ball =>
            new Vector3d(0.4 * Math.Sin(3 * ball.Time), 0.3 * Math.Exp(-0.2 * ball.Position.Y), 0.01 * ball.AirVelocity.X));
        Scene scene = Scene.Published with { Forces = ForceSet.Published with { Coefficients = AerodynamicModel.Regularized, Drag = ForceLaw.Constant, Magnus = ForceLaw.Constant, CustomForces = [gust] } };
        var random = new Shots(77);
        Order.Hold(integrator.ToString(), [.. Enumerable.Range(0, 12).Select(_ =>
            OrderOf(scene, integrator, coarsest, random.Velocity(15, 30, 15, 35), random.Uniform(10, 60) * random.Direction()))], low, high);
    }

    [Theory]
    [InlineData(Integrator.Euler, 0.02, 0.85, 1.25)]
    [InlineData(Integrator.SemiImplicitEuler, 0.02, 0.85, 1.25)]
    [InlineData(Integrator.Rk2, 0.05, 1.8, 2.3)]
    [InlineData(Integrator.Rk4, 0.2, 3.8, 4.5)]
    public void A_roll_converges_at_the_order_of_the_method(Integrator integrator, double coarsest, double low, double high)
    {
        // Sidespin bends the roll, wind from the side pushes it.
        Scene scene = Ground(new Vector3d(2, 0, -1));
        var random = new Shots(221);
        Order.Hold(integrator.ToString(), [.. Enumerable.Range(0, 12).Select(_ =>
        {
            Vector3d velocity = random.Velocity(16, 22, 0, 0);
            var spin = new Vector3d(velocity.Z / Flight.Radius, random.Uniform(20, 60), -velocity.X / Flight.Radius);
            return OrderOnGround(scene, integrator, coarsest, 0.8, velocity, spin, MotionState.Rolling);
        })], low, high);
    }

    [Theory]
    [InlineData(Integrator.Euler, 0.02, 0.85, 1.25)]
    [InlineData(Integrator.SemiImplicitEuler, 0.02, 0.85, 1.25)]
    [InlineData(Integrator.Rk2, 0.05, 1.8, 2.3)]
    [InlineData(Integrator.Rk4, 0.1, 3.8, 4.5)]
    public void A_slide_converges_at_the_order_of_the_method(Integrator integrator, double coarsest, double low, double high)
    {
        Scene scene = Ground(new Vector3d(2, 0, -1)) with { Ground = FootballPhysics.Ground.PublishedTurf with { Material = FootballPhysics.Ground.PublishedTurf.Material with { SlidingFriction = 0.15 } } };
        var random = new Shots(222);
        Order.Hold(integrator.ToString(), [.. Enumerable.Range(0, 12).Select(_ =>
            OrderOnGround(scene, integrator, coarsest, 0.4, random.Velocity(18, 22, 0, 0), random.Uniform(5, 15) * random.Direction(), MotionState.Sliding))], low, high);
    }

    /// <summary>Through the singular end of the slide: no order is lost beyond what the way towards it costs.</summary>
    [Fact]
    public void A_ball_that_slides_and_then_rolls_comes_to_rest_at_the_same_place_at_every_step()
    {
        var random = new Shots(223);
        var errors = new Errors("resting place");
        var scene = Scene.Published with { Air = new Air { Wind = new Vector3d(3, 0, 1) } };
        for (int i = 0; i < 12; i++)
        {
            Vector3d velocity = random.Velocity(5, 15, 0, 0);
            Vector3d spin = random.Uniform(0, 50) * random.Direction();
            Vector3d Place(double step)
            {
                Flight.Play(scene, SolverSettings.Default, step, 100, StopAt.Rest, new Vector3d(0, 0.11, 0), velocity, spin, out StepLog log);
                return Flight.First(log, BallEventKind.Rest).Position;
            }

            errors.Add($"{velocity}, {spin}", Vector3d.Distance(Place(0.02), Place(0.0025)));
        }

        errors.Hold(p95: 1e-7);
    }

    private static Scene Ground(Vector3d wind) => Scene.Published with { Air = new Air { Wind = wind }, Forces = ForceSet.Published with { Coefficients = AerodynamicModel.Regularized } };

    private static double OrderOf(Scene scene, Integrator integrator, double coarsest, Vector3d velocity, Vector3d spin)
    {
        var start = new Vector3d(0, 0.11, 0);
        Vector3d truth = Flight.ToImpact(scene, Integrator.Rk4, 0.0025, start, velocity, spin).Position;
        return Order.Observed(coarsest, 3, step => Vector3d.Distance(Flight.ToImpact(scene, integrator, step, start, velocity, spin).Position, truth));
    }

    private static double OrderOnGround(
        Scene scene, Integrator integrator, double coarsest, double duration, Vector3d velocity, Vector3d spin, MotionState motion)
    {
        BallState End(Integrator method, double step) => Flight.Play(
            scene, Flight.With(method), step, duration, StopAt.Time, new Vector3d(0, 0.11, 0), velocity, spin, out _);
        BallState truth = End(Integrator.Rk4, 0.001);
        Assert.Equal(motion, truth.Motion);
        return Order.Observed(coarsest, 3, step =>
        {
            BallState state = End(integrator, step);
            return Vector3d.Distance(state.Position, truth.Position)
                + (0.1 * Vector3d.Distance(state.Velocity, truth.Velocity))
                + (0.01 * Vector3d.Distance(state.Spin, truth.Spin));
        });
    }

    /// <summary>Whether a shot really crosses one surface of the jump, once, while the other condition holds throughout.</summary>
    private static bool Crosses(Vector3d velocity, Vector3d spin, Func<double, double, double> side, Func<double, bool> other)
    {
        var simulator = new Simulator(Scene.Published);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), velocity, spin);
        var log = new StepLog();
        int changes = 0;
        double? last = null;
        while (log.Events.Count == 0)
        {
            double speed = state.Velocity.Length;
            double sp = Flight.Radius * state.Spin.Length / speed;
            double now = side(speed, sp);
            changes += last * now < 0 ? 1 : 0;
            last = now;
            if (!other(sp))
            {
                return false;
            }

            simulator.Step(ref state, 0.01, log);
        }

        return changes == 1;
    }
}
