#nullable enable
using System;
using Godot;

namespace Football.Physics.GodotAddon;

/// <summary>A football: stepped in _PhysicsProcess, drawn in _Process. Its children move and turn with it; its scale and the way it stands at the start are kept.</summary>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballBall : Node3D
{
    /// <summary>Node.PhysicsInterpolationModeEnum.Off, which Godot has from 4.3 on: the ball is interpolated here, and not twice.</summary>
    private const int InterpolationOff = 2;

    private readonly StepLog _log = new();
    private FootballColliders? _colliders;
    private FixedStepRunner? _runner;
    private Basis _start = Basis.Identity;

    /// <summary>The ball hit something: the ground, a post, a wall.</summary>
    [Signal]
    public delegate void ImpactEventHandler(Vector3 position, Vector3 velocityBefore, Vector3 velocity, Vector3 spin, double time);

    /// <summary>The ball stayed on what carries it, slipping.</summary>
    [Signal]
    public delegate void SlideEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball began to roll without slip.</summary>
    [Signal]
    public delegate void RollEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball came to rest.</summary>
    [Signal]
    public delegate void RestEventHandler(Vector3 position, double time);

    /// <summary>A ball that was carried left what carried it.</summary>
    [Signal]
    public delegate void LeaveEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The ball met a net.</summary>
    [Signal]
    public delegate void NetEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>The whole ball is over the line of a goal.</summary>
    [Signal]
    public delegate void GoalEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>Things that move leave the ball no room, or it has room again: the ball's motion says which.</summary>
    [Signal]
    public delegate void SqueezedEventHandler(Vector3 position, Vector3 velocity, double time);

    /// <summary>Ball, air, ground and method; none: the measured profile, a football over dry turf in still air, as a new preset has it. A new one counts from the next _Ready.</summary>
    [Export]
    public FootballPreset? Preset { get; set; }

    /// <summary>Layers whose bodies the ball hits; 0: only the ground of its preset. Counts from the next _Ready.</summary>
    [Export(PropertyHint.Layers3DPhysics)]
    public uint HitMask { get; set; }

    /// <summary>Not slower than the fastest body that may hit the ball, m/s.</summary>
    [Export]
    public float GreatestSpeed { get; set; } = 15;

    /// <summary>The fixed-step runner behind the node: state, tick, kicks by tick, rollback.</summary>
    public FixedStepRunner Runner => _runner ?? throw new InvalidOperationException("The football has no _Ready behind it yet: use it once it is in the scene tree.");

    /// <summary>Velocity, m/s.</summary>
    public Vector3 Velocity => GodotFrame.ToGodot(Runner.State.Velocity);

    /// <summary>Spin, rad/s.</summary>
    public Vector3 Spin => GodotFrame.SpinToGodot(Runner.State.Spin);

    /// <summary>What the ball is doing.</summary>
    public MotionState Motion => Runner.State.Motion;

    /// <summary>Kicks the ball at the next physics frame: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
    public void Kick(float speed, Vector3 direction, float topSpin = 0, float sideSpin = 0) =>
        Runner.QueueKick(speed, GodotFrame.FromGodot(direction), topSpin, sideSpin);

    /// <summary>Kicks the ball at the next physics frame, with a spin about any axis.</summary>
    public void KickWith(Vector3 velocity, Vector3 spin) =>
        Runner.QueueKick(GodotFrame.FromGodot(velocity), GodotFrame.SpinFromGodot(spin));

    /// <summary>Puts the ball somewhere, at rest.</summary>
    public void Place(Vector3 position)
    {
        Runner.Place(GodotFrame.FromGodot(position));
        Draw(1.0);
    }

    /// <summary>The path ahead, if nobody touches the ball: a point every physics frame, the present one first. Allocates nothing.</summary>
    /// <param name="points">Filled from the start.</param>
    /// <returns>How many points were filled in; fewer than there is room for when the ball comes to rest.</returns>
    public int PredictPath(Span<Vector3> points)
    {
        BallState state = Runner.State;
        int count = 0;
        while (count < points.Length)
        {
            points[count++] = GodotFrame.ToGodot(state.Position);
            if (state.Motion == MotionState.Stopped)
            {
                break;
            }

            _log.Clear();
            Runner.Simulator.Step(ref state, Runner.TimeStep, _log);
        }

        return count;
    }

    /// <summary>The same as an array, which GDScript can read.</summary>
    /// <param name="count">Points at most; above 0.</param>
    public Vector3[] PathAhead(int count)
    {
        var points = new Vector3[count];
        return points[..PredictPath(points)];
    }

    /// <inheritdoc/>
    public override void _Ready()
    {
        double timeStep = 1.0 / Engine.PhysicsTicksPerSecond;
        _runner = new FixedStepRunner(AmongBodies(Preset?.Compile() ?? new Simulator()), timeStep, Math.Max(timeStep, 0.25));
        _start = GlobalTransform.Basis;
        Set("physics_interpolation_mode", InterpolationOff);
        Place(GlobalPosition);
    }

    /// <inheritdoc/>
    public override void _PhysicsProcess(double delta)
    {
        if (_colliders is not null)
        {
            // Godot has its bodies where they are at this time, on the clock of the ball.
            _colliders.Time = Runner.State.Time;
        }

        Runner.Step();
        for (int i = 0; i < Runner.Events.Count; i++)
        {
            Emit(in Runner.Events[i]);
        }
    }

    /// <inheritdoc/>
    public override void _Process(double delta) => Draw(Engine.GetPhysicsInterpolationFraction());

    private Simulator AmongBodies(Simulator simulator)
    {
        if (HitMask == 0)
        {
            return simulator;
        }

        _colliders = new FootballColliders(GetWorld3D().DirectSpaceState, HitMask, GreatestSpeed);
        return new Simulator(simulator.Scene with { EngineColliders = _colliders }, simulator.Settings);
    }

    private void Draw(double fraction)
    {
        BallPose pose = Runner.PoseAt(fraction);
        GlobalTransform = new Transform3D(new Basis(GodotFrame.ToGodot(pose.Orientation)) * _start, GodotFrame.ToGodot(pose.Position));
    }

    private void Emit(in BallEvent happened)
    {
        Vector3 position = GodotFrame.ToGodot(happened.Position);
        Vector3 velocity = GodotFrame.ToGodot(happened.Velocity);
        switch (happened.Kind)
        {
            case BallEventKind.Impact:
                EmitSignal(SignalName.Impact, position, GodotFrame.ToGodot(happened.VelocityBefore), velocity, GodotFrame.SpinToGodot(happened.Spin), happened.Time);
                break;
            case BallEventKind.Slide:
                EmitSignal(SignalName.Slide, position, velocity, happened.Time);
                break;
            case BallEventKind.Roll:
                EmitSignal(SignalName.Roll, position, velocity, happened.Time);
                break;
            case BallEventKind.Rest:
                EmitSignal(SignalName.Rest, position, happened.Time);
                break;
            case BallEventKind.Leave:
                EmitSignal(SignalName.Leave, position, velocity, happened.Time);
                break;
            case BallEventKind.Squeezed:
                EmitSignal(SignalName.Squeezed, position, velocity, happened.Time);
                break;
            case BallEventKind.Net:
                EmitSignal(SignalName.Net, position, velocity, happened.Time);
                break;
            case BallEventKind.Goal:
                EmitSignal(SignalName.Goal, position, velocity, happened.Time);
                break;
        }
    }
}
