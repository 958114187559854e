using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>A slide that crosses the jump of the published drag law crosses it at the same instant for steps of any length, also in its first piece and in its last.</summary>
public sealed class SlideAcrossJumpTests
{
    /// <summary>The speed at which the published drag law jumps, m/s.</summary>
    private const double Critical = 12.19;

    /// <summary>Friction turns the axis of a spin that is so small on its way too fast for RK4 in 10 ms, rad/s: some 1e-6 m, and 1e-4 of that in 1 ms, jump or no jump.</summary>
    private const double NearlyNoSpin = 1;

    /// <summary>Steps of 10 ms and of 0.1 ms of slides that missed the jump: they ended up to 15 mm apart.</summary>
    [Theory]
    [InlineData(0.7679331458936046, 12.19209997778575, -5.419594489448613, 27.425827981287966, -4.1341341166519925)]
    [InlineData(0.7703548552117658, 12.223363750706433, 7.367281548835365, -13.225613117664736, -0.023385673523762307)]
    [InlineData(0.5544813684489854, 12.21872407571664, 5.9530634270206235, 20.72204705062721, -7.8176548369085594)]
    [InlineData(0.5121240790754559, 12.220153726255447, 8.812092250199761, -13.40707667148859, 13.391052264913633)]
    [InlineData(0.38753920267696335, 12.21225032961858, -19.7949484284636, 19.693196565107264, -3.9683362790823224)]
    [InlineData(0.5665133832802824, 12.203308957808405, -9.942909619404084, -30.668003841190547, -15.054303751933755)]
    public void Slides_that_missed_it_in_their_first_step(double friction, double speed, double wx, double wy, double wz)
    {
        Simulator simulator = OnGround(friction);
        BallState start = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, speed), new Vector3d(wx, wy, wz));
        Assert.InRange(Apart(simulator, in start, 60), 0, 1e-7);
    }

    [Theory]
    [InlineData("launched", 400)]
    [InlineData("after an impact", 200)]
    [InlineData("on a board", 200)]
    public void Random_slides(string kind, int count)
    {
        var random = new Shots(317);
        int crossed = 0;
        for (int i = 0; i < count; i++)
        {
            double friction = random.Uniform(0.4, 0.8);
            Simulator simulator = kind == "on a board" ? OnBoard(friction) : OnGround(friction);

            // Half of them come to the jump in their first step.
            double speed = Critical + (random.Next() * (i % 2 == 0 ? 0.41 : 0.1));
            Vector3d spin = random.Uniform(0, 30) * random.Direction();
            bool strikes = kind == "after an impact";
            BallState start = simulator.Launch(
                new Vector3d(0, strikes ? 0.12 : 0.11, 0), new Vector3d(0, strikes ? -0.1 : 0, speed), spin);
            crossed += speed > Critical && spin.Length * 0.11 > 0.05 * speed ? 1 : 0;

            // ω turns towards that of a roll along z, which is about x.
            bool almostStops = spin.X < NearlyNoSpin && Math.Sqrt((spin.Y * spin.Y) + (spin.Z * spin.Z)) < NearlyNoSpin;
            double apart = Apart(simulator, in start, 2);
            Assert.True(apart < (almostStops ? 1e-5 : 1e-6), $"{apart} m: friction {friction}, {speed} m/s, spin {spin}");
        }

        Assert.InRange(crossed, count / 2, count);
    }

    /// <summary>The spin of a roll is reached within a step of the jump, on either side of it: both ends are found.</summary>
    [Fact]
    public void Slides_that_end_at_the_jump()
    {
        var random = new Shots(82);
        int close = 0;
        for (int i = 0; i < 200; i++)
        {
            Simulator simulator = OnGround(random.Uniform(0.4, 0.8));
            double speed = random.Uniform(12.3, 13.8);
            double about = random.Uniform(-10, 10);
            double wanted = Critical + random.Uniform(-0.005, 0.005);

            // The spin with which the slide ends at that speed, by bisection; in still air v (1 + k) = v₀ + k r ω₀.
            double low = ((11.9 * 5 / 3) - speed) / (2.0 / 3 * 0.11);
            double high = ((13.0 * 5 / 3) - speed) / (2.0 / 3 * 0.11);
            BallState start = default;
            for (int k = 0; k < 30; k++)
            {
                double middle = 0.5 * (low + high);
                start = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 0, speed), new Vector3d(middle, about, 0));
                BallState ball = start;
                var log = new StepLog();
                while (ball.Motion == MotionState.Sliding)
                {
                    simulator.Step(ref ball, 0.001, log);
                }

                close += k == 29 && Math.Abs(ball.Velocity.Length - wanted) < 0.02 ? 1 : 0;
                (low, high) = ball.Velocity.Length > wanted ? (low, middle) : (middle, high);
            }

            Assert.InRange(Apart(simulator, in start, 2), 0, 1e-6);
        }

        Assert.InRange(close, 150, 200);
    }

    private static double Apart(Simulator simulator, in BallState start, double time)
    {
        BallState coarse = start;
        BallState fine = start;
        var log = new StepLog();
        simulator.Run(ref coarse, 0.01, time, StopAt.Rest, log);
        simulator.Run(ref fine, 0.0001, time, StopAt.Rest, log);
        return (coarse.Position - fine.Position).Length;
    }

    private static Simulator OnGround(double friction) => new(Scene.Published with { Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { SlidingFriction = friction, RollingResistance = 0.08 } } });

    private static Simulator OnBoard(double friction) => new(Scene.Published with
    {
        Ground = Ground.None,
        Obstacles = [new Obstacle { Shape = new PlaneShape(Vector3d.Zero, Vector3d.Up), Surface = SurfaceMaterial.GoalFrame with { SlidingFriction = friction, RollingResistance = 0.08, RollingResistancePerSpeed = 0, TorsionalPatchRadius = 0, SpinDamping = 0.002 } }],
    });
}
