using FootballPhysics.Engines;
using Godot;
using GodotBall = FootballPhysics.GodotAddon.FootballBall;
using UnityBall = FootballPhysics.Unity.FootballBall;
using UnityTime = UnityEngine.Time;

namespace FootballPhysics.Package.Tests;

/// <summary>The ball follows the time of the engine: slow motion, pause, changed rates, speed-up, and a step in every frame for an hour.</summary>
[Collection(EngineTests.Statics)]
public sealed class EngineTimeTests : IDisposable
{
    public EngineTimeTests() => Dispose();

    public void Dispose()
    {
        UnityEngine.GameObject.DestroyAll();
        UnityEngine.Physics.All.Clear();
        UnityTime.fixedDeltaTime = 0.02f;
        Engine.PhysicsTicksPerSecond = 60;
        Engine.TimeScale = 1;
        GD.Pushed.Clear();
    }

    /// <summary>Godot calls a physics frame as often per real second at any time scale, with the length 1/ticks times the scale.</summary>
    [Theory]
    [InlineData(60, 60, 0.3, 60, 0.3)] // slow motion
    [InlineData(60, 480, 1.0, 480, 1.0)] // another rate in play
    [InlineData(480, 480, 8.0, 480, 8.0)] // the speed-up of reinforcement learning
    [InlineData(60, 60, 0.0, 60, 0.0)] // pause
    [InlineData(60, 144, 1.0, 144, 1.0)] // a rate that is no multiple
    public void A_ball_in_Godot_flies_for_the_time_of_the_game(int first, int ticks, double scale, int frames, double seconds)
    {
        Engine.PhysicsTicksPerSecond = first;
        var ball = new GodotBall { GlobalPosition = new Vector3(0, 30, 0) };
        Node.Root.AddChild(ball);
        double step = ball.Runner.TimeStep;
        Engine.PhysicsTicksPerSecond = ticks;
        Engine.TimeScale = scale;
        for (int i = 0; i < frames; i++)
        {
            ball._PhysicsProcess(scale / ticks);
        }

        // Less than a step is left.
        Assert.Equal(1.0 / first, step);
        Assert.InRange(seconds - ball.Runner.State.Time, -1e-3 * step, step);
        Assert.Equal(ball.Runner.Tick * step, ball.Runner.State.Time, 1e-9);

        // The path has points in steps of the ball.
        var path = new Vector3[3];
        ball.PredictPath(path);
        ball._PhysicsProcess(step);
        Assert.Equal(FootballPhysics.GodotAddon.GodotFrame.ToGodot(ball.Runner.State.Position), path[1]);
        Node.Root.RemoveChild(ball);
    }

    [Fact]
    public void In_slow_motion_Godots_ball_is_drawn_between_its_steps()
    {
        var ball = new GodotBall { GlobalPosition = new Vector3(0, 30, 0) };
        Node.Root.AddChild(ball);
        ball.KickWith(new Vector3(0, 0, -20), Vector3.Zero);
        Engine.TimeScale = 0.25;
        float last = 0;
        for (int i = 0; i < 40; i++)
        {
            ball._PhysicsProcess(0.25 / 60);
            Engine.InterpolationFraction = 0.5;
            ball._Process(0.25 / 60);
            float gone = last - ball.GlobalPosition.Z;
            last = ball.GlobalPosition.Z;
            Assert.InRange(gone, i < 4 ? -1e-5f : 0.06f, 0.09f); // 20 m/s for a quarter of a frame: 0.083 m
        }

        Engine.InterpolationFraction = 0;
        Node.Root.RemoveChild(ball);
    }

    /// <summary>Unity keeps the length of a fixed frame in single precision, and new projects store 2822399 ticks of 1/141120000 s for 0.02 s.</summary>
    [Theory]
    [InlineData(0.02f, 0.02)]
    [InlineData((float)(2822399.0 / 141120000.0), 0.02)]
    [InlineData(0.01f, 0.01)]
    [InlineData(1f / 60f, 1.0 / 60.0)]
    public void In_an_hour_of_Unity_every_fixed_frame_has_one_step(float frame, double step)
    {
        UnityTime.fixedDeltaTime = frame;
        UnityBall ball = new UnityEngine.GameObject("ball").Attach<UnityBall>();
        ball.Preset = new FootballPhysics.Unity.FootballPreset { timeStep = step };
        ball.gameObject.WakeUp();
        Action update = typeof(UnityBall).GetMethod("FixedUpdate", System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)!.CreateDelegate<Action>(ball);
        int frames = (int)Math.Round(3600 / step);
        int others = 0;
        for (int i = 1; i <= frames; i++)
        {
            update();
            others += ball.Runner.Tick == i ? 0 : 1;
        }

        Assert.Equal(0, others);
    }

    /// <summary>In an hour of frames that are no multiple of the step, the ball is never a step off.</summary>
    [Theory]
    [InlineData(0.02f, 0.01, 2)]
    [InlineData(0.02f, 0.04, 0)]
    [InlineData(1f / 144f, 1.0 / 60.0, 0)]
    [InlineData(0.0201f, 0.02, 0)]
    public void Frames_of_any_length_sum_up_to_the_time_of_the_game(float frame, double step, int each)
    {
        var clock = new EngineClock();
        double game = 0;
        long steps = 0;
        for (int i = 0; i < (int)(3600 / frame); i++)
        {
            int due = clock.StepsIn(frame, step);
            Assert.True(each == 0 || due == each);
            steps += due;
            game += clock.Frame;
            Assert.InRange(game - (steps * step), -2e-3 * step, step);
            Assert.InRange(clock.FractionAt(0.5 * frame, step), 0, 1);
        }

        Assert.InRange(game, 3599.9 * (1 - 1e-6), 3600.1);
        Assert.Equal(0, clock.StepsIn(double.NaN, step) + clock.StepsIn(-1, step) + clock.StepsIn(0, step));
    }
}
