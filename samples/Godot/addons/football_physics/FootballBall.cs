#nullable enable
using System;
using System.Collections.Generic;
using FootballPhysics.Engines;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>A football that steps in _PhysicsProcess, in the time of the game, and draws in _Process. Its children move and rotate with it. Its scale and its initial orientation are kept.</summary>
/// <remarks>
/// The ball hits every goal, pitch, wall and keeper in the tree, and the bodies in the layers of its hit mask. Changes of the ball, its preset or these objects take effect in the
/// next step. A ball without a visible child draws itself, with a pattern that shows its spin.
/// </remarks>
[Tool, GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballBall : Node3D
{
    /// <summary>Node.PhysicsInterpolationModeEnum.Off, which Godot has from 4.3 on. The ball interpolates itself, so Godot must not interpolate it again.</summary>
    private const int InterpolationOff = 2;

    /// <summary>If the node is farther than this from its drawn position, m, other code moved it.</summary>
    private const float Moved = 1e-3f;

    private static readonly List<FootballBall> s_all = new();

    private readonly EngineClock _clock = new();

    private FootballScene? _scene;
    private FixedStepRunner? _runner;
    private Action<double>? _moveKeepers;
    private MeshInstance3D? _skin;
    private Basis _start = Basis.Identity;
    private Vector3 _drawnAt;
    private BallSquash? _squash;
    private double _drawnTime;
    private bool _isFlat;
    private int _stamp;
    private bool _warned;

    /// <summary>Ball, air, ground and integrator; empty: the measured profile (a match ball, still air). A change takes effect in the next step.</summary>
    [Export]
    public FootballPreset? Preset { get; set; }

    /// <summary>Layers of the bodies that the ball hits; 0: only football nodes and the ground. A change takes effect in the next step.</summary>
    [Export(PropertyHint.Layers3DPhysics)]
    public uint HitMask { get; set; }

    /// <summary>Maximum speed of bodies that can hit the ball, m/s.</summary>
    [Export]
    public float GreatestSpeed { get; set; } = 15;

    /// <summary>True if the drawn ball flattens at an impact. Only the sphere that the node draws itself does; the simulation does not depend on it.</summary>
    [Export]
    public bool Squash { get; set; } = true;

    /// <summary>The fixed-step runner behind the node: state, tick, kicks by tick, rollback.</summary>
    public FixedStepRunner Runner => _runner ?? throw new InvalidOperationException("The football is not ready. Add it to the scene tree first, and use it after _Ready.");

    /// <summary>Velocity, m/s.</summary>
    public Vector3 Velocity => GodotFrame.ToGodot(Runner.State.Velocity);

    /// <summary>Spin, rad/s.</summary>
    public Vector3 Spin => GodotFrame.SpinToGodot(Runner.State.Spin);

    /// <summary>The motion state of the ball.</summary>
    public MotionState Motion => Runner.State.Motion;

    /// <summary>Radius of the ball, m.</summary>
    public float Radius => (float)(Preset?.BallOf() ?? BallProperties.Modern).Radius;

    /// <summary>Raised at each impact, before the signal, with its outputs.</summary>
    internal event Action<Impact>? Struck;

    /// <summary>The first ball that entered the tree; null if there is none.</summary>
    internal static FootballBall? First => s_all.Count > 0 ? s_all[0] : null;

    /// <summary>Kicks the ball at the next physics frame: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
    public void Kick(float speed, Vector3 direction, float topSpin = 0, float sideSpin = 0) =>
        Runner.QueueKick(speed, GodotFrame.FromGodot(direction), topSpin, sideSpin);

    /// <summary>Kicks the ball at the next physics frame, with a spin about any axis.</summary>
    public void KickWith(Vector3 velocity, Vector3 spin) =>
        Runner.QueueKick(GodotFrame.FromGodot(velocity), GodotFrame.SpinFromGodot(spin));

    /// <summary>Kicks the ball as the editor shows it.</summary>
    public void KickAsPreviewed() => Kick(KickSpeed, KickDirection, KickTopSpin, KickSideSpin);

    /// <summary>Places the ball at rest. While a rollback is attached to the runner, this is a PlaceInput of the next step, and the clock continues.</summary>
    public void Place(Vector3 position)
    {
        if (Runner.Rollback is not null)
        {
            Runner.QueuePlace(GodotFrame.FromGodot(position));
            return;
        }

        Runner.Place(GodotFrame.FromGodot(position));
        _squash?.Clear();
        Draw(1.0);
    }

    /// <summary>Moves the keepers at the start of a step. Call it if you set MoveBodies of the runner yourself, for instance to move Godot's bodies in a rollback.</summary>
    public void MoveKeepers() => _scene!.Stage.BeforeStep(Runner);

    /// <summary>Applies changes to the ball, its preset or the tree at once. Otherwise they take effect before the next step.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message contains its name. The ball keeps its previous settings.</exception>
    public void Apply()
    {
        // Create all new objects before replacing the old ones, so that a rejected value changes nothing.
        _stamp = Stamp();
        FootballScene scene = NewScene();
        bool begins = _runner is null;
        if (_runner is null)
        {
            double timeStep = 1.0 / Engine.PhysicsTicksPerSecond;
            _runner = new FixedStepRunner(scene.Stage.Game, timeStep, Math.Max(timeStep, 0.25));
        }
        else
        {
            _runner.Simulator = scene.Stage.Game;
        }

        _scene = scene;
        _squash = null;
        if (begins)
        {
            Place(GlobalPosition);
        }

        DrawSkin();
    }

    /// <summary>Compiles a new simulator for the ball's scene: its preset, and the goals, pitches, walls and keepers in the tree, without bodies.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message contains its name.</exception>
    internal Simulator CompileScene() => new FootballScene(Preset, 0, 0, null).Stage.Game;

    /// <inheritdoc/>
    public override void _EnterTree() => s_all.Add(this);

    /// <inheritdoc/>
    public override void _ExitTree() => s_all.Remove(this);

    /// <inheritdoc/>
    public override void _Ready()
    {
        if (Engine.IsEditorHint())
        {
            DrawSkin();
            return;
        }

        FootballWarmUp.Begin();
        _start = GlobalTransform.Basis;
        Set("physics_interpolation_mode", InterpolationOff);
        Apply();
    }

    /// <inheritdoc/>
    public override void _PhysicsProcess(double delta)
    {
        if (Engine.IsEditorHint())
        {
            return;
        }

        ApplyChanges();
        if (_runner is not { } runner)
        {
            return;     // the first scene was invalid, which was reported; the next valid one starts the ball
        }

        // The positions of Godot's bodies hold at this time, on the clock of the ball.
        _scene!.CollidersAreAt(runner.State.Time + _clock.Left, GreatestSpeed);
        for (int due = _clock.StepsIn(delta, runner.TimeStep); due > 0; due--)
        {
            MoveKeepersInSteps(runner);
            if (runner.MoveBodies is null)
            {
                MoveKeepers();
            }

            runner.Step();
            _scene.Stage.AfterStep(runner.State);
            for (int i = 0; i < runner.Events.Count; i++)
            {
                _scene.Push(in runner.Events[i]);
                _squash?.Follow(in runner.Events[i]);
                Emit(in runner.Events[i]);
                _scene.GoalOf(in runner.Events[i])?.EmitFor(this, in runner.Events[i]);
            }
        }
    }

    /// <inheritdoc/>
    public override void _Process(double delta)
    {
        if (Engine.IsEditorHint())
        {
            DrawPreview();
            return;
        }

        if (_runner is null)
        {
            return;
        }

        if (!_warned && (GlobalPosition - _drawnAt).Length() > Moved)
        {
            _warned = true;
            GD.PushWarning($"The football \"{Name}\" was moved by its transform, which has no effect because the simulation sets its position. Call Place(position) or Kick instead.");
        }

        Draw(_clock.FractionAt(Engine.GetPhysicsInterpolationFraction() * _clock.Frame, _runner.TimeStep));
        Flatten();
        _scene!.Draw();
    }

    /// <summary>Moves the keepers in MoveBodies, so that a rollback moves them again in each step that it repeats.</summary>
    /// <remarks>With moving bodies of Godot, the node does not do so: only the game can move those back in time, and a rollback throws until it does.</remarks>
    private void MoveKeepersInSteps(FixedStepRunner runner)
    {
        if (runner.MoveBodies is null || ReferenceEquals(runner.MoveBodies, _moveKeepers))
        {
            _moveKeepers ??= _ => MoveKeepers();
            runner.MoveBodies = HitMask == 0 || !(GreatestSpeed > 0) ? _moveKeepers : null;
        }
    }

    private FootballScene NewScene() => new(Preset, HitMask, GreatestSpeed, HitMask == 0 ? null : GetWorld3D().DirectSpaceState);

    /// <summary>A hash that changes when any input of the scene changes.</summary>
    private int Stamp() => HashCode.Combine(Preset, Preset?.Stamp ?? 0, HitMask, FootballThing.StampOfAll);

    /// <summary>Applies changes. A value out of range is reported once, and the ball keeps its previous settings.</summary>
    private void ApplyChanges()
    {
        if (Stamp() == _stamp)
        {
            return;
        }

        try
        {
            Apply();
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            GD.PushError($"The football \"{Name}\" keeps its previous settings: {refusal.Message}");
        }
    }

    private void Draw(double fraction)
    {
        BallPose pose = Runner.PoseAt(fraction);
        GlobalTransform = new Transform3D(new Basis(GodotFrame.ToGodot(pose.Orientation)) * _start, GodotFrame.ToGodot(pose.Position));
        _drawnAt = GlobalPosition;
        _drawnTime = Runner.State.Time - ((1.0 - fraction) * Runner.TimeStep);
    }

    /// <summary>Scales the drawn sphere along the normal of an impact. The node keeps its own scale.</summary>
    private void Flatten()
    {
        if (_skin is null || !Squash)
        {
            return;
        }

        BallStretch stretch = (_squash ??= new BallSquash(Runner.Simulator)).At(_drawnTime);
        if (!stretch.IsRound)
        {
            Basis scale = new(
                GodotFrame.ToGodot(stretch.Apply(new Vector3d(1, 0, 0))), GodotFrame.ToGodot(stretch.Apply(new Vector3d(0, 1, 0))), GodotFrame.ToGodot(stretch.Apply(new Vector3d(0, 0, 1))));
            _skin.GlobalTransform = new Transform3D(scale * GlobalTransform.Basis, GlobalPosition);
        }
        else if (_isFlat)
        {
            _skin.Transform = Transform3D.Identity;
        }

        _isFlat = !stretch.IsRound;
    }

    /// <summary>Adds a sphere of the ball's radius, independent of the node's scale, if the node has no visible child.</summary>
    private void DrawSkin()
    {
        if (_skin is null)
        {
            foreach (Node child in GetChildren())
            {
                if (child is VisualInstance3D)
                {
                    return;
                }
            }

            _skin = new MeshInstance3D { MaterialOverride = FootballDrawing.Made(new Color(1, 1, 1), FootballDrawing.BallTexture) };
            AddChild(_skin, false, InternalMode.Back);
        }

        Vector3 scale = GlobalTransform.Basis.Scale;
        _skin.Mesh = FootballDrawing.Fill(Engines.ShapeMesh.OfBall(Radius / Math.Max(1e-6f, Math.Max(scale.X, Math.Max(scale.Y, scale.Z)))));
    }
}
