using System.Numerics;
using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>A ball for a game: build it, kick it, step it every frame, read where it is and what happened.</summary>
/// <remarks>Right-handed, y up, forward −z; SI units. Not for several threads at once; the <see cref="Simulator"/> behind it is.</remarks>
public sealed class Ball
{
    private readonly StepLog _log = new();
    private Simulator _simulator;
    private BallState _state;

    /// <summary>A ball at rest on the ground at the origin; at the origin itself, in the air, if there is no ground.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">How to integrate it; default <see cref="SolverSettings.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Ball(Scene? scene = null, SolverSettings? settings = null)
        : this(new Simulator(scene, settings))
    {
    }

    /// <summary>A ball at rest on the ground at the origin, in a scene shared with other balls; at the origin itself, in the air, if there is no ground.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public Ball(Simulator simulator)
    {
        _simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        Place(simulator.OnGround(0, 0));
    }

    /// <summary>The compiled scene. Setting it between steps goes on in another one (rain begins, a wall stands there), where the ball is and as it moves.</summary>
    /// <remarks>
    /// A ball at rest stays so where rolling friction holds it in the new scene too; one below the new ground is raised to it. Obstacles that both scenes have are where they were
    /// pushed to; <see cref="Simulator.ResetObstacles"/> puts them back.
    /// </remarks>
    /// <exception cref="ArgumentNullException">The simulator that is set is null; nothing has changed.</exception>
    public Simulator Simulator
    {
        get => _simulator;
        set
        {
            if (ReferenceEquals(value ?? throw new ArgumentNullException(nameof(value)), _simulator))
            {
                return;
            }

            // What the ball has pushed stays where it is.
            if (value.World.Obstacles.Count > 0)
            {
                value.World.Obstacles.Follow(_simulator.World.Obstacles);
            }

            _state = value.Continue(_simulator, in _state);
            _simulator = value;
        }
    }

    /// <summary>The whole state in double precision. Setting it restores a snapshot.</summary>
    /// <exception cref="ArgumentException">The state that is set was never launched: all its bytes are zero.</exception>
    /// <exception cref="ArgumentOutOfRangeException">No ball of this scene can have it (<see cref="Simulator.Validate"/>): it lies on a thing that is not there. Nothing has changed.</exception>
    public BallState State
    {
        get => _state;
        set
        {
            BallState.Launched(in value);
            Simulator.Validate(in value);
            Simulator.World.Bodies?.MoveClock(_state.Time, value.Time, isNew: false);
            _state = value;
        }
    }

    /// <summary>The events of the last step, in order of time.</summary>
    public EventBuffer Events => _log.Events;

    /// <summary>Right-hand sides that the last step evaluated.</summary>
    internal long Evaluations => _log.Evaluations;

    /// <summary>Time since the ball was placed, s.</summary>
    public double Time => _state.Time;

    /// <summary>Position of the centre, m; <see cref="Vector3d.ToVector3"/> rounds it for an engine.</summary>
    public Vector3d Position => _state.Position;

    /// <summary>Velocity, m/s.</summary>
    public Vector3d Velocity => _state.Velocity;

    /// <summary>Angular velocity, rad/s, world frame.</summary>
    public Vector3d Spin => _state.Spin;

    /// <summary>Orientation.</summary>
    public Quaterniond Orientation => _state.Orientation;

    /// <summary>The motion of the ball: in the air, sliding, rolling or at rest.</summary>
    public MotionState Motion => _state.Motion;

    /// <summary>Puts the ball down without motion, at time 0. Above the ground it will fall. Bodies stay where they are now, and go on from there.</summary>
    /// <param name="position">Position of the centre, m; components within ±1e6. A ball in the ground is raised straight up until it is not.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is out of range; nothing has changed.</exception>
    public void Place(Vector3d position)
    {
        Check.Place("launch.position", position);
        Simulator.World.Bodies?.MoveClock(_state.Time, 0, isNew: true);
        _state = AtRest(Simulator, position, 0);
        _log.Clear();
    }

    /// <summary>Puts the ball somewhere as it moves, at time 0. Bodies stay where they are now, and go on from there.</summary>
    /// <param name="position">Position of the centre, m; components within ±1e6. A ball in the ground is raised straight up until it is not.</param>
    /// <param name="velocity">Velocity, m/s; speed at most 1000.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void Launch(Vector3d position, Vector3d velocity, Vector3d spin)
    {
        BallState launched = Simulator.Launch(position, velocity, spin);
        Simulator.World.Bodies?.MoveClock(_state.Time, 0, isNew: true);
        _state = launched;
        _log.Clear();
    }

    /// <summary>Computes where the ball goes from here; the ball stays as it is. Allocates nothing once the trajectory has room.</summary>
    /// <param name="request">How far to look, and what to stop at.</param>
    /// <param name="into">Where the path and the events go.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite, or too stiff for any step.</exception>
    public void LookAhead(LookAheadRequest request, Trajectory into) => Simulator.LookAhead(in _state, request, into);

    /// <summary>The name of what an event reports: "ground", "left post", an obstacle's; null for an event that has none.</summary>
    /// <param name="happened">One of <see cref="Events"/>.</param>
    public string? NameOf(in BallEvent happened) => Simulator.NameOf(happened.ColliderIndex);

    /// <summary>Kicks the ball where it is with a kick that was found for it.</summary>
    /// <param name="kick">The kick.</param>
    public void Kick(in AimResult kick) => Kick(kick.Velocity, kick.Spin);

    /// <summary>Kicks the ball where it is.</summary>
    /// <param name="velocity">Velocity, m/s; speed at most 1000. A <see cref="Vector3"/> will do.</param>
    /// <param name="spin">Spin, rad/s, world frame; at most 10 000.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    [OverloadResolutionPriority(1)]
    public void Kick(Vector3d velocity, Vector3d spin) => Simulator.Kick(ref _state, velocity, spin);

    /// <summary>Kicks the ball where it is: speed, angles, and spin relative to the direction.</summary>
    /// <param name="speed">Speed, m/s; 0 … 1000.</param>
    /// <param name="elevationDegrees">Angle above the horizontal, degrees; −90 … 90.</param>
    /// <param name="azimuthDegrees">Angle from −z, counter-clockwise seen from above (to the left), degrees; −360 … 360.</param>
    /// <param name="topSpin">Spin about the horizontal axis across the kick, rad/s: positive dips, negative (backspin) lifts.</param>
    /// <param name="sideSpin">Spin about the vertical, rad/s: positive is counter-clockwise seen from above, and bends to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void Kick(double speed, double elevationDegrees, double azimuthDegrees, double topSpin = 0, double sideSpin = 0)
    {
        KickVectors.FromAngles(speed, elevationDegrees, azimuthDegrees, topSpin, sideSpin, out Vector3d velocity, out Vector3d spin);
        Kick(velocity, spin);
    }

    /// <summary>Kicks the ball where it is: speed, direction, and spin relative to the direction.</summary>
    /// <param name="speed">Speed, m/s; 0 … 1000.</param>
    /// <param name="direction">Direction of the kick; any length but zero.</param>
    /// <param name="topSpin">Spin about the horizontal axis across the kick, rad/s: positive dips, negative (backspin) lifts.</param>
    /// <param name="sideSpin">Spin about the vertical, rad/s: positive is counter-clockwise seen from above, and bends to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or <paramref name="topSpin"/> is given to a vertical kick; nothing has changed.</exception>
    public void Kick(double speed, Vector3d direction, double topSpin = 0, double sideSpin = 0)
    {
        Check.Within(nameof(speed), speed, 0, Limits.Speed);
        Vector3d unit = KickVectors.Unit(direction);
        Simulator.Kick(ref _state, speed * unit, KickVectors.Spin(unit, topSpin, sideSpin));
    }

    /// <summary>Advances by a frame's time; <see cref="Events"/> then holds what happened in it. Allocates nothing.</summary>
    /// <param name="dt">Frame time, s: 0 … 1e12.</param>
    /// <remarks>What a force of the game's own throws comes through; the ball is then as it was before the step, without events.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">
    /// <paramref name="dt"/> is out of range, or a body was moved since the last step for a time more than 0.25 s from the ball's; the ball is as it was.
    /// </exception>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite; the message names it, and nothing has changed.</exception>
    public void Step(double dt)
    {
        Check.Within(nameof(dt), dt, 0, Limits.Time);
        _log.Clear();
        Simulator.Step(ref _state, dt, _log);
    }

    /// <summary>A ball without motion: at rest where it lies on something that holds it.</summary>
    internal static BallState AtRest(Simulator simulator, in Vector3d position, double time = 0)
    {
        BallState state = simulator.LaunchAt(in position, Vector3d.Zero, Vector3d.Zero, time);

        // On a slope, or in a wind, that rolling friction cannot hold it against, it begins to roll.
        if (state.Motion == MotionState.Rolling && simulator.RestsAt(in state))
        {
            state.Motion = MotionState.Rest;
        }

        return state;
    }
}
