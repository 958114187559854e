using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Predictors;

/// <summary>The circle that a player can reach, against the player's motion in small steps.</summary>
public sealed class RunnerMotionTests
{
    private const double Step = 1e-4;

    [Fact]
    public void His_circle_is_where_he_would_be_and_as_far_as_he_can_run()
    {
        var random = new Shots(81);
        for (int k = 0; k < 20; k++)
        {
            Player runner = Random(random);
            double now = random.Uniform(0, 5);
            var motion = new RunnerMotion(in runner, now);
            Vector3d centre = runner.Position.Horizontal;
            double run = 0;
            double speed = 0;
            Assert.Equal(now + runner.Reaction, motion.Start);
            for (int i = 0; i * Step < 3; i++)
            {
                double time = now + (i * Step);
                bool reacts = time >= motion.Start;
                if (i % 1000 == 0)
                {
                    motion.MiddleAt(time, out double x, out double z);
                    Assert.InRange(Vector3d.Distance(centre, new Vector3d(x, 0, z)), 0, 5e-3);
                    Assert.Equal(runner.Reach + run, motion.RadiusAt(time), 5e-3);
                    Assert.Equal(speed, motion.GrowthAt(time), 5e-3);
                }

                // Until the reaction he keeps his velocity; then he accelerates from rest up to his top speed.
                centre += reacts ? Vector3d.Zero : Step * runner.Velocity.Horizontal;
                double faster = reacts ? Math.Min(runner.Speed, speed + (Step * runner.Acceleration)) : 0;
                run += 0.5 * Step * (speed + faster);
                speed = faster;
            }
        }
    }

    [Fact]
    public void The_arrival_is_the_inverse_of_the_radius()
    {
        var random = new Shots(82);
        for (int k = 0; k < 200; k++)
        {
            Player runner = Random(random);
            var motion = new RunnerMotion(in runner, random.Uniform(0, 5));
            double time = motion.Start + random.Uniform(1e-3, 4);
            Assert.Equal(time, motion.ArrivalAt(motion.RadiusAt(time)), 1e-9);
            Assert.Equal(motion.Start, motion.ArrivalAt(0.5 * runner.Reach));
        }
    }

    /// <summary>The rates and bounds against differences of centre and radius.</summary>
    [Fact]
    public void The_rates_are_those_of_the_circle()
    {
        var random = new Shots(83);
        for (int k = 0; k < 200; k++)
        {
            Player runner = Random(random);
            var motion = new RunnerMotion(in runner, random.Uniform(0, 5));
            double time = motion.Start + random.Uniform(-1, 3);
            motion.MiddleAt(time - Step, out double x0, out double z0);
            motion.MiddleAt(time + Step, out double x1, out double z1);
            motion.MiddleVelocity(time > motion.Start, out double vx, out double vz);
            var velocity = new Vector3d((x1 - x0) / (2 * Step), 0, (z1 - z0) / (2 * Step));
            double growth = (motion.RadiusAt(time + Step) - motion.RadiusAt(time - Step)) / (2 * Step);
            double bend = (motion.GrowthAt(time + Step) - motion.GrowthAt(time)) / Step;
            if (Math.Abs(time - motion.Start) < 2 * Step)
            {
                continue;
            }

            Assert.InRange(Vector3d.Distance(velocity, new Vector3d(vx, 0, vz)), 0, 1e-8);
            Assert.Equal(velocity.Length, motion.CarriedAt(time), 1e-8);
            Assert.Equal(growth, motion.GrowthAt(time), 1e-2);
            Assert.InRange(growth + velocity.Length, 0, motion.Fastest + 1e-8);
            Assert.InRange(bend, 0, motion.GrowthRateFrom(time) + 1e-6);
        }
    }

    private static Player Random(Shots random) => new()
    {
        Position = random.Uniform(0, 20) * random.Direction(),
        Velocity = random.Uniform(1, 8) * random.Direction(),
        Reaction = random.Uniform(0, 0.5),
        Acceleration = random.Uniform(3, 9),
        Speed = random.Uniform(4, 9),
        Reach = random.Uniform(0.3, 2),
    };
}
