#nullable enable
using System;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Adds the air of a football to the RigidBody3D above this node: drag, Magnus force, spin decay, wind and buoyancy.</summary>
/// <remarks>
/// Godot keeps moving the body, with its own bounces and its own gravity. The accelerations are those of the preset's ball, whatever the mass of the body. The node sets the damping and
/// the inertia of the body.
/// </remarks>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballAir : Node
{
    private Aerodynamics? _air;
    private double _time;
    private int _stamp;

    /// <summary>The ball and the air; empty: a match ball in still air at sea level. A change takes effect in the next physics frame. The preset's ground is ignored.</summary>
    [Export]
    public FootballPreset? Preset { get; set; }

    /// <summary>True to add the buoyancy of the ball, 0.066 N upwards.</summary>
    [Export]
    public bool Buoyancy { get; set; } = true;

    private RigidBody3D Body => GetParent() as RigidBody3D
        ?? throw new InvalidOperationException($"The parent of the FootballAir \"{Name}\" is not a RigidBody3D. Make it a child of the ball.");

    /// <summary>Kicks the body: top spin dips, negative top spin lifts, positive side spin bends to the left.</summary>
    public void Kick(float speed, Vector3 direction, float topSpin = 0, float sideSpin = 0)
    {
        Vector3d forward = GodotFrame.FromGodot(direction);
        KickWith(direction * (speed / direction.Length()), GodotFrame.SpinToGodot(KickVectors.Spin(forward, topSpin, sideSpin)));
    }

    /// <summary>Kicks the body: sets its velocity, m/s, and its spin, rad/s. It corrects the velocity for Godot's steps, so that the path matches the library's.</summary>
    public void KickWith(Vector3 velocity, Vector3 spin)
    {
        RigidBody3D body = Body;
        Aerodynamics air = Prepared(body);
        Vector3d kick = air.KickVelocity(Place(body), GodotFrame.FromGodot(velocity), GodotFrame.SpinFromGodot(spin), Step, Pull(body, air));
        body.LinearVelocity = GodotFrame.ToGodot(kick);
        body.AngularVelocity = spin;
    }

    /// <inheritdoc/>
    public override void _Ready() => Prepared(Body);

    /// <inheritdoc/>
    public override void _PhysicsProcess(double delta)
    {
        _time += delta;
        RigidBody3D body = Body;
        if (body.Freeze || body.Sleeping)
        {
            return;
        }

        Aerodynamics air = Prepared(body);
        ForceAndTorque load = air.EvaluateForStep(
            Place(body), GodotFrame.FromGodot(body.LinearVelocity), GodotFrame.SpinFromGodot(body.AngularVelocity), delta, Pull(body, air), _time);

        // The body may be heavier or lighter than the ball, but the accelerations are the ball's.
        double share = body.Mass / air.Scene.Ball.Mass;
        body.ApplyCentralForce(GodotFrame.ToGodot(share * (load.Force + (Buoyancy ? air.Buoyancy : Vector3d.Zero))));
        body.ApplyTorque(GodotFrame.SpinToGodot(share * load.Torque));
    }

    /// <summary>The length of a physics frame in the time of the game, s.</summary>
    private static double Step => Engine.TimeScale / Engine.PhysicsTicksPerSecond;

    private static Vector3d Place(RigidBody3D body) => GodotFrame.FromGodot(body.GlobalPosition);

    /// <summary>Returns the acceleration by gravity and buoyancy, m/s².</summary>
    private Vector3d Pull(RigidBody3D body, Aerodynamics air)
    {
        double gravity = ProjectSettings.GetSetting("physics/3d/default_gravity").AsDouble() * body.GravityScale;
        return new Vector3d(0, -gravity, 0) + (Buoyancy ? air.Buoyancy / air.Scene.Ball.Mass : Vector3d.Zero);
    }

    /// <summary>Applies a changed preset, sets the numbers of the body, and returns the air. If the preset is out of range, reports that once and keeps the previous one.</summary>
    private Aerodynamics Prepared(RigidBody3D body)
    {
        int stamp = HashCode.Combine(Preset, Preset?.Stamp ?? 0);
        if (_air is null || stamp != _stamp)
        {
            _stamp = stamp;
            try
            {
                _air = new Aerodynamics(Preset?.MakeScene());
            }
            catch (ArgumentOutOfRangeException rejected)
            {
                _air ??= new Aerodynamics();
                GD.PushError($"The air of \"{body.Name}\" stays as it was: {rejected.Message}");
            }

            body.LinearDampMode = RigidBody3D.DampMode.Replace;
            body.LinearDamp = 0;
            body.AngularDampMode = RigidBody3D.DampMode.Replace;
            body.AngularDamp = 0;
        }

        float inertia = (float)(_air.Scene.Ball.MomentOfInertia * body.Mass / _air.Scene.Ball.Mass);
        if (body.Inertia.X != inertia)
        {
            body.Inertia = new Vector3(inertia, inertia, inertia);
        }

        return _air;
    }
}
