using System.Globalization;
using FootballPhysics.Labs.Stability;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>The stress matrix's bound for the energy of a frame: it finds what it must, and honest frames come close to it.</summary>
public sealed class EnergyCheckTests
{
    private static readonly Dictionary<string, (Scene Scene, Vector3d Position, Vector3d Velocity, Vector3d Spin)> s_balls = new()
    {
        ["at rest in the air"] = (Scene.Published, new(0, 20, 0), Vector3d.Zero, Vector3d.Zero),
        ["at rest in the wind"] = (Scene.Published with { Air = new Air { Wind = new Vector3d(3, 1, 12) } }, new(0, 20, 0), Vector3d.Zero, Vector3d.Zero),
        ["at rest in vacuum"] = (Scene.Vacuum, new(0, 500, 0), Vector3d.Zero, Vector3d.Zero),
        ["a shot in the default scene"] = (new Scene(), new(0, 20, 0), new(22, 9, 3), new(5, 60, -20)),
        ["a bounce in the default scene"] = (new Scene(), new(0, 0.111, 0), new(12, -3, 0), new(5, 60, -20)),
        ["a slide in the default scene"] = (new Scene(), new(0, 0.11, 0), new(12, 0, 0), Vector3d.Zero),
        ["a roll in the default scene"] = (new Scene(), new(0, 0.11, 0), new(4, 0, 0), new(0, 0, -4 / 0.11)),
        ["a shot"] = (Scene.Published, new(0, 20, 0), new(22, 9, 3), new(5, 60, -20)),
        ["a shot without drag"] = (Scene.Published with { Forces = ForceSet.Published with { Drag = ForceLaw.None } }, new(0, 20, 0), new(22, 9, 3), new(5, 60, -20)),
        ["a shot with a constant Magnus force alone"] = (
            Scene.Published with { Gravity = 0, Forces = ForceSet.None with { Magnus = ForceLaw.Constant } }, new(0, 20, 0), new(22, 9, 3), new(5, 60, -20)),
        ["a beach ball"] = (Scene.Published with { Ball = BallProperties.BeachBall }, new(0, 20, 0), new(12, 3, 0), new(5, 60, -20)),
        ["a bounce"] = (Scene.Published, new(0, 0.111, 0), new(12, -3, 0), new(5, 60, -20)),
        ["a slide"] = (Scene.Published, new(0, 0.11, 0), new(12, 0, 0), Vector3d.Zero),
        ["a roll"] = (Scene.Published, new(0, 0.11, 0), new(4, 0, 0), new(0, 0, -4 / 0.11)),
        ["at rest on the ground"] = (Scene.Published, new(0, 0.11, 0), Vector3d.Zero, Vector3d.Zero),
    };

    private static readonly double[] s_frames = [0.001, 0.01, 0.04, 1];

    public static TheoryData<string, Integrator> Balls() => new(s_balls.Keys.SelectMany(_ => Flight.Integrators, (ball, method) => (ball, method)));

    [Theory]
    [MemberData(nameof(Balls))]
    public void A_ball_that_is_thrown_to_200_m_s_in_a_frame_is_found(string ball, Integrator method)
    {
        foreach (double dt in s_frames)
        {
            Frame frame = Frame.Play(ball, method, dt);
            Assert.True(frame.Judge(frame.After).Holds, $"{dt} s: {frame.Judge(frame.After)}");
            BallState thrown = frame.After;
            thrown.Velocity = new Vector3d(0, 200, 0);
            thrown.Motion = MotionState.Airborne;
            FrameEnergy judged = frame.Judge(thrown);
            Assert.False(judged.Holds);

            // Not by a little: no frame of a second, and no method, could do a tenth of that.
            Assert.True(judged.Gained > 10 * judged.Allowed, $"{dt} s: gained {judged.Gained} J, allowed {judged.Allowed} J");
        }
    }

    [Theory]
    [MemberData(nameof(Balls))]
    public void A_gain_just_above_the_bound_is_found_and_just_below_it_is_not(string ball, Integrator method)
    {
        foreach (double dt in s_frames)
        {
            Frame frame = Frame.Play(ball, method, dt);
            FrameEnergy bound = frame.Judge(frame.Forged(1e-9));

            // Where only rounding is left, forging rounds as well.
            double margin = bound.ByMethod > 1e3 * bound.ByRounding ? 1.02 : 2;
            Assert.False(frame.Judge(frame.Forged(bound.Allowed * margin)).Holds);
            Assert.True(frame.Judge(frame.Forged(bound.Allowed / margin)).Holds);
        }
    }

    /// <summary>What Euler makes of free fall is ½ m g² h² a step, semi-implicit Euler takes as much, and the others are exact.</summary>
    [Theory]
    [InlineData(Integrator.Euler, 0.5)]
    [InlineData(Integrator.SemiImplicitEuler, 0)]
    [InlineData(Integrator.Rk2, 0)]
    [InlineData(Integrator.Rk4, 0)]
    public void A_fall_in_vacuum_may_gain_what_the_method_makes_of_gravity_and_no_more(Integrator method, double share)
    {
        foreach (double dt in s_frames)
        {
            Frame frame = Frame.Play("at rest in vacuum", method, dt);
            Assert.Equal(share * 0.43 * 9.81 * 9.81 * dt * dt, frame.Judge(frame.Forged(1)).ByMethod, 1e-12);
        }
    }

    /// <summary>Else it would be a bound that nothing can break.</summary>
    [Theory]
    [InlineData(Integrator.Euler, 0.99)]
    [InlineData(Integrator.SemiImplicitEuler, 0.9)]
    [InlineData(Integrator.Rk2, 0.9)]
    [InlineData(Integrator.Rk4, 0.1)]
    public void Honest_frames_come_close_to_the_bound(Integrator method, double least)
    {
        const int Rounds = 60;
        double most = 0;
        foreach (StressKind kind in (StressKind[])[StressKind.AnyShot, StressKind.LongSteps, StressKind.GyroSpin])
        {
            double share = Enumerable.Range(0, Rounds).Max(round => StressRun.Play(StressGenerator.Make(1, StressGenerator.Index(kind, method, round))).Tally.EnergyShare);
            TestContext.Current.TestOutputHelper?.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{method}, {kind}: {share:0.000} of the bound"));
            most = Math.Max(most, share);
        }

        Assert.InRange(most, least, 1);
    }

    /// <summary>A frame that was played, and what the check says of another end of it.</summary>
    private sealed record Frame(EnergyCheck Check, double Mass, double Length, BallState Before, BallState After, BallEvent[] Events)
    {
        public static Frame Play(string name, Integrator method, double dt)
        {
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = s_balls[name];
            var played = new StressScene
            {
                Kind = StressKind.AnyShot,
                Scene = scene,
                Settings = Flight.With(method),
                Position = position,
                Velocity = velocity,
                Spin = spin,
                Frames = [dt],
            };
            var simulator = new Simulator(scene, played.Settings);
            BallState before = simulator.Launch(position, velocity, spin);
            BallState after = before;
            var log = new StepLog();
            simulator.Step(ref after, dt, log);
            return new Frame(new EnergyCheck(played, simulator), scene.Ball.Mass, dt, before, after, log.Events.Span.ToArray());
        }

        public FrameEnergy Judge(BallState after) => Assert.NotNull(Check.Of(Before, Length, in after, Events));

        /// <summary>The end of the frame with so much more energy, J, than its start.</summary>
        public BallState Forged(double gain)
        {
            double more = gain - Check.Of(Before, Length, After, Events)!.Value.Gained;
            BallState forged = After;
            forged.Motion = After.Motion == MotionState.Rest ? MotionState.Rolling : After.Motion;

            // Wind sees the square of u = v − W: along the part of v that is left when W is taken away.
            Vector3d u = After.Velocity - Check.Wind;
            Vector3d along = u.Length > 0 ? u / u.Length : Vector3d.Up;
            forged.Velocity = Check.Wind + (Math.Sqrt(Math.Max(0, u.LengthSquared + (2 * more / Mass))) * along);
            return forged;
        }
    }
}
