using System;
using Godot;

namespace Football.Physics.GodotAddon;

/// <summary>A football: stepped in _PhysicsProcess, drawn in _Process. Its children move and turn with it.</summary>
[GlobalClass]
public partial class FootballBall : Node3D
{
    private FixedStepRunner? _runner;

    /// <summary>The ball hit the ground.</summary>
    [Signal]
    public delegate void ImpactEventHandler(Vector3 position, Vector3 velocityBefore, Vector3 velocity, Vector3 spin, double time);

    /// <summary>After an impact the ball stayed down, slipping.</summary>
    [Signal]
    public delegate void SlideEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball began to roll without slip.</summary>
    [Signal]
    public delegate void RollEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball came to rest.</summary>
    [Signal]
    public delegate void RestEventHandler(Vector3 position, double time);

    /// <summary>Ball, air, ground and method; none: a football over turf in still air. A new one counts from the next _Ready.</summary>
    [Export]
    public FootballPreset? Preset { get; set; }

    /// <summary>The fixed-step runner behind the node: state, tick, kicks by tick, rollback.</summary>
    public FixedStepRunner Runner => _runner ?? throw new InvalidOperationException("The ball is not in the scene tree yet.");

    /// <summary>Velocity, m/s.</summary>
    public Vector3 Velocity => GodotFrame.ToGodot(Runner.State.Velocity);

    /// <summary>Spin, rad/s.</summary>
    public Vector3 Spin => GodotFrame.SpinToGodot(Runner.State.Spin);

    /// <summary>What the ball is doing.</summary>
    public MotionState Motion => Runner.State.Motion;

    /// <summary>Kicks the ball at the next physics frame.</summary>
    public void Kick(Vector3 velocity, Vector3 spin) =>
        Runner.QueueKick(GodotFrame.FromGodot(velocity), GodotFrame.SpinFromGodot(spin));

    /// <summary>Kicks the ball: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
    public void Kick(float speed, Vector3 direction, float topSpin = 0, float sideSpin = 0) =>
        Runner.QueueKick(speed, GodotFrame.FromGodot(direction), topSpin, sideSpin);

    /// <summary>Puts the ball somewhere, at rest.</summary>
    public void Place(Vector3 position)
    {
        Runner.Place(GodotFrame.FromGodot(position));
        Draw(1.0);
    }

    /// <summary>The path ahead, if nobody touches the ball: a point every physics frame, the present one first.</summary>
    /// <param name="points">Filled from the start.</param>
    /// <returns>How many points were filled in; fewer than there is room for when the ball comes to rest.</returns>
    public int PredictPath(Span<Vector3> points)
    {
        BallState state = Runner.State;
        var log = new StepLog();
        int count = 0;
        while (count < points.Length)
        {
            points[count++] = GodotFrame.ToGodot(state.Position);
            if (state.Motion == MotionState.Stopped)
            {
                break;
            }

            log.Clear();
            Runner.Simulator.Step(ref state, Runner.TimeStep, log);
        }

        return count;
    }

    public override void _Ready()
    {
        double timeStep = 1.0 / Engine.PhysicsTicksPerSecond;
        _runner = new FixedStepRunner(Preset?.Compile() ?? new Simulator(), timeStep, Math.Max(timeStep, 0.25));
        Place(GlobalPosition);
    }

    public override void _PhysicsProcess(double delta)
    {
        Runner.Step();
        for (int i = 0; i < Runner.Events.Count; i++)
        {
            Emit(in Runner.Events[i]);
        }
    }

    public override void _Process(double delta) => Draw(Engine.GetPhysicsInterpolationFraction());

    private void Draw(double fraction)
    {
        BallPose pose = Runner.PoseAt(fraction);
        GlobalTransform = new Transform3D(new Basis(GodotFrame.ToGodot(pose.Orientation)), GodotFrame.ToGodot(pose.Position));
    }

    private void Emit(in BallEvent happened)
    {
        Vector3 position = GodotFrame.ToGodot(happened.Position);
        Vector3 velocity = GodotFrame.ToGodot(happened.Velocity);
        switch (happened.Kind)
        {
            case BallEventKind.Impact:
                EmitSignal("Impact", position, GodotFrame.ToGodot(happened.VelocityBefore), velocity, GodotFrame.SpinToGodot(happened.Spin), happened.Time);
                break;
            case BallEventKind.Slide:
                EmitSignal("Slide", position, velocity, happened.Time);
                break;
            case BallEventKind.Roll:
                EmitSignal("Roll", position, velocity, happened.Time);
                break;
            default:
                EmitSignal("Rest", position, happened.Time);
                break;
        }
    }
}
