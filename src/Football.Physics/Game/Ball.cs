using System.ComponentModel;
using System.Numerics;
using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>A ball that your game places, kicks and steps; it reports its position, motion and events.</summary>
/// <remarks>The axes are right-handed, with y up and −z forward; units are SI. A ball is not thread-safe, but its <see cref="Simulator"/> is.</remarks>
public sealed class Ball
{
    private readonly StepLog _log = new();
    private Simulator _simulator;
    private BallState _state;

    /// <summary>Creates a ball at rest on the ground at the origin.</summary>
    /// <remarks>Without ground, the ball starts in the air, with its centre at the origin.</remarks>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">The solver settings; default <see cref="SolverSettings.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public Ball(Scene? scene = null, SolverSettings? settings = null)
        : this(new Simulator(scene, settings))
    {
    }

    /// <summary>Creates a ball at rest on the ground at the origin, in a scene shared with other balls.</summary>
    /// <remarks>Without ground, the ball starts in the air, with its centre at the origin.</remarks>
    /// <param name="simulator">The compiled scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public Ball(Simulator simulator)
    {
        _simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        Place(simulator.OnGround(0, 0));
    }

    /// <summary>Gets or sets the compiled scene; setting it continues the motion in the new scene.</summary>
    /// <remarks>
    /// Set it between steps, for instance when rain begins or a wall is added. The ball keeps its position and motion. A ball at rest stays at rest
    /// if rolling friction holds it in the new scene too. A ball below the new ground is raised onto it. Obstacles that exist in both scenes
    /// stay where they were pushed to; <see cref="Simulator.ResetObstacles"/> moves them back.
    /// </remarks>
    /// <exception cref="ArgumentNullException">The value is null; nothing has changed.</exception>
    public Simulator Simulator
    {
        get => _simulator;
        set
        {
            if (ReferenceEquals(value ?? throw new ArgumentNullException(nameof(value)), _simulator))
            {
                return;
            }

            // Obstacles that the ball has pushed stay at their new positions.
            value.World.Obstacles.Follow(_simulator.World.Obstacles);
            _state = value.Continue(_simulator, in _state);
            _simulator = value;
        }
    }

    /// <summary>Gets or sets the complete state, in double precision; setting it restores a snapshot.</summary>
    /// <exception cref="ArgumentException">The value was never launched: all its bytes are zero.</exception>
    /// <exception cref="ArgumentOutOfRangeException">No ball of this scene can have this state (<see cref="Simulator.Validate"/>); for example, it
    /// rests on an obstacle that does not exist. Nothing has changed.</exception>
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

    /// <summary>The time since the ball was placed, in s.</summary>
    public double Time => _state.Time;

    /// <summary>The position of the centre, in m; <see cref="Vector3d.ToVector3"/> converts it to single precision.</summary>
    public Vector3d Position => _state.Position;

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity => _state.Velocity;

    /// <summary>The angular velocity in the world frame, in rad/s.</summary>
    public Vector3d Spin => _state.Spin;

    /// <summary>The orientation.</summary>
    public Quaterniond Orientation => _state.Orientation;

    /// <summary>The motion state: airborne, sliding, rolling or at rest.</summary>
    public MotionState Motion => _state.Motion;

    /// <summary>Places the ball with zero velocity and spin, and resets its clock to 0.</summary>
    /// <remarks>A ball placed above the ground falls. Bodies keep their current positions and continue to move from there.</remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is out of range; nothing has changed.</exception>
    public void Place(Vector3d position) => Place(position, Simulator.LaunchOrientation);

    /// <summary>Places the ball with an orientation and with zero velocity and spin, and resets its clock to 0.</summary>
    /// <remarks>A kick keeps the orientation. With a knuckle force, a ball that hardly spins flies along another path in each orientation.</remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="orientation">The orientation; it is normalised. Default <see cref="Simulator.LaunchOrientation"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is out of range; nothing has changed.</exception>
    public void Place(Vector3d position, Quaterniond orientation)
    {
        Check.Place("launch.position", position);
        Check.Rotation("launch.orientation", orientation);
        Simulator.World.Bodies?.MoveClock(_state.Time, 0, isNew: true);
        _state = AtRest(Simulator, in position, in orientation, 0);
        _log.Clear();
    }

    /// <summary>Places the ball with a velocity and a spin, and resets its clock to 0.</summary>
    /// <remarks>Bodies keep their current positions and continue to move from there.</remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="velocity">The velocity, in m/s; speed at most 1000.</param>
    /// <param name="spin">The spin in the world frame, in rad/s; at most 10 000.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void Launch(Vector3d position, Vector3d velocity, Vector3d spin) => Launch(position, velocity, spin, Simulator.LaunchOrientation);

    /// <summary>Places the ball with an orientation, a velocity and a spin, and resets its clock to 0.</summary>
    /// <remarks>Bodies keep their current positions and continue to move from there.</remarks>
    /// <param name="position">The position of the centre, in m; components within ±1e6. A ball that overlaps the ground is raised onto it.</param>
    /// <param name="velocity">The velocity, in m/s; speed at most 1000.</param>
    /// <param name="spin">The spin in the world frame, in rad/s; at most 10 000.</param>
    /// <param name="orientation">The orientation; it is normalised. Default <see cref="Simulator.LaunchOrientation"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void Launch(Vector3d position, Vector3d velocity, Vector3d spin, Quaterniond orientation)
    {
        BallState launched = Simulator.Launch(position, velocity, spin, orientation);
        Simulator.World.Bodies?.MoveClock(_state.Time, 0, isNew: true);
        _state = launched;
        _log.Clear();
    }

    /// <summary>Predicts the path of the ball from its current state, without changing that state.</summary>
    /// <remarks>Does not allocate once the trajectory is large enough.</remarks>
    /// <param name="request">The duration of the prediction and its stop conditions.</param>
    /// <param name="into">Receives the path and the events.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public void LookAhead(LookAheadRequest request, Trajectory into) => Simulator.LookAhead(in _state, request, into);

    /// <summary>Returns the name of the object that an event reports, such as "ground" or "left post".</summary>
    /// <param name="happened">One of <see cref="Events"/>.</param>
    /// <returns>The name; null if the event has no object.</returns>
    public string? NameOf(in BallEvent happened) => Simulator.NameOf(in happened);

    /// <summary>Kicks the ball with the result of an aiming search.</summary>
    /// <param name="kick">The kick.</param>
    public void Kick(in AimResult kick) => Kick(kick.Velocity, kick.Spin);

    /// <summary>Kicks the ball from its current position.</summary>
    /// <param name="velocity">The velocity, in m/s; speed at most 1000. A <see cref="Vector3"/> converts implicitly.</param>
    /// <param name="spin">The spin in the world frame, in rad/s; at most 10 000.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    [OverloadResolutionPriority(1)]
    public void Kick(Vector3d velocity, Vector3d spin) => Simulator.Kick(ref _state, velocity, spin);

    /// <summary>Kicks the ball with a given speed, elevation and azimuth, and with spin relative to the kick direction.</summary>
    /// <param name="speed">The speed, in m/s; 0 … 1000.</param>
    /// <param name="elevationDegrees">The angle above the horizontal, in degrees; −90 … 90.</param>
    /// <param name="azimuthDegrees">The angle from −z, counter-clockwise seen from above (to the left), in degrees; −360 … 360.</param>
    /// <param name="topSpin">The spin about the horizontal axis across the kick, in rad/s: topspin (positive) makes the ball dip, backspin makes it
    /// lift.</param>
    /// <param name="sideSpin">The spin about the vertical, in rad/s: positive is counter-clockwise seen from above, and bends the path to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void Kick(double speed, double elevationDegrees, double azimuthDegrees, double topSpin = 0, double sideSpin = 0)
    {
        KickVectors.FromAngles(speed, elevationDegrees, azimuthDegrees, topSpin, sideSpin, out Vector3d velocity, out Vector3d spin);
        Kick(velocity, spin);
    }

    /// <summary>Kicks the ball at a speed in a direction, with spin relative to that direction.</summary>
    /// <param name="speed">The speed, in m/s; 0 … 1000.</param>
    /// <param name="direction">The direction of the kick; any length except zero.</param>
    /// <param name="topSpin">The spin about the horizontal axis across the kick, in rad/s: topspin (positive) makes the ball dip, backspin makes it
    /// lift.</param>
    /// <param name="sideSpin">The spin about the vertical, in rad/s: positive is counter-clockwise seen from above, and bends the path to the left.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or <paramref name="topSpin"/> is nonzero for a vertical kick; nothing has
    /// changed.</exception>
    public void Kick(double speed, Vector3d direction, double topSpin = 0, double sideSpin = 0)
    {
        Check.Within(nameof(speed), speed, 0, Limits.Speed);
        Vector3d unit = KickVectors.Unit(direction);
        Simulator.Kick(ref _state, speed * unit, KickVectors.Spin(unit, topSpin, sideSpin));
    }

    /// <summary>Computes the forces with which the ball's next step begins, for arrows and overlays: see <see cref="Simulator.ForcesAt"/>.</summary>
    /// <param name="dt">The length of the next step, in s; above 0, at most 1e12. Default 1/60.</param>
    /// <returns>The forces; null if the step begins with impulses.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is out of range, or a body was moved for a time more than 0.25 s from the ball's time.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite; the message names it.</exception>
    public BallForces? GetForces(double dt = Simulator.UsualStep) => _simulator.ForcesAt(in _state, dt);

    /// <summary>Advances the ball by one frame; <see cref="Events"/> then holds the events of that frame.</summary>
    /// <param name="dt">The frame time, in s; 0 … 1e12.</param>
    /// <remarks>Does not allocate. An exception from a custom force propagates; the ball keeps its state from before the step, without
    /// events.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">
    /// <paramref name="dt"/> is out of range, or a body was moved since the last step to a time more than 0.25 s from the ball's time. The ball is
    /// unchanged.
    /// </exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite; the message names it, and nothing has changed.</exception>
    public void Step(double dt)
    {
        Check.Within(nameof(dt), dt, 0, Limits.Time);
        _log.Clear();
        Simulator.Step(ref _state, dt, _log);
    }

    /// <summary>Does not compile: a whole number of seconds is almost always an integer division such as <c>1 / 60</c>, which is 0.</summary>
    /// <param name="dt">The frame time, in s. Write <c>1.0 / 60</c> for a frame, and <c>1.0</c> for one second.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is out of range.</exception>
    [EditorBrowsable(EditorBrowsableState.Never)]
    [Obsolete("The frame time is a whole number. 1 / 60 is an integer division, which gives 0: write 1.0 / 60. For whole seconds, write 1.0; for milliseconds, divide by 1000.0.", error: true)]
    public void Step(int dt) => Step((double)dt);

    /// <summary>Returns the state of a ball without motion: at rest if a surface supports it.</summary>
    internal static BallState AtRest(Simulator simulator, in Vector3d position, double time = 0) => AtRest(simulator, in position, simulator.LaunchOrientation, time);

    private static BallState AtRest(Simulator simulator, in Vector3d position, in Quaterniond orientation, double time) =>
        simulator.Placed(in position, Vector3d.Zero, Vector3d.Zero, in orientation, time);
}
