using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics;

/// <summary>Computes the force and torque of the air on a ball that is moved by a physics engine or your own integrator.</summary>
/// <remarks>
/// The result includes drag, Magnus force, spin decay, wind, knuckle force and custom forces, by the same laws as a flight in <see cref="Simulator"/>. Gravity
/// is not included, because engines apply their own. Buoyancy is not included either: add <see cref="Buoyancy"/> if you want it. Ground, obstacles and nets are
/// ignored. The object is immutable and does not allocate. It is thread-safe if the wind and the custom forces of the scene are thread-safe.
/// </remarks>
public sealed class Aerodynamics
{
    /// <summary>The maximum distance that a ball can have flown, in m.</summary>
    private const double FarthestFlown = 1e45;

    private readonly double _mass;
    private readonly double _inertia;
    private readonly double _radiusSquared;
    private readonly Vector3d _wind;
    private readonly bool _jumps;
    private readonly bool _varies;

    // Not readonly, because a call through a readonly field would first copy the struct.
    private SceneAir _air;

    /// <summary>Compiles the air of a scene.</summary>
    /// <param name="scene">The scene; only its ball, air, gravity and forces are used. Default <see cref="FootballPhysics.Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Aerodynamics(Scene? scene = null)
    {
        Scene = scene ?? Scene.Default;
        Scene.Validate();
        _air = SceneAir.Of(Scene);
        _mass = Scene.Ball.Mass;
        _inertia = Scene.Ball.MomentOfInertia;
        _radiusSquared = Scene.Ball.Radius * Scene.Ball.Radius;
        _wind = Scene.Air.Wind;
        _jumps = _air.Jumps;
        _varies = _air.Varies;
        Buoyancy = Scenes.Buoyancy.Force(Scene);
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>The constant buoyancy of the ball, in N: 0.066 upwards for a football, zero if the scene has none. <see cref="Evaluate(Vector3d, Vector3d, Vector3d, double, double, Quaterniond?)"/> does not include it.</summary>
    public Vector3d Buoyancy { get; }

    /// <summary>Computes the force and the torque on a ball at one instant.</summary>
    /// <param name="position">The position of the centre, in m; components within ±1e6. Only custom forces and a wind that varies by position depend on
    /// it.</param>
    /// <param name="velocity">The velocity, in m/s; speed at most 1000.</param>
    /// <param name="spin">The spin, in rad/s; at most 10 000.</param>
    /// <param name="time">The time, in s; 0 … 1e12. Only custom forces and a wind that varies over time depend on it.</param>
    /// <param name="airDistance">The distance that the ball has flown through the air since the kick, in m; 0 … 1e45. Only the knuckle force depends on
    /// it.</param>
    /// <param name="orientation">The orientation of the ball. Only the knuckle force depends on it. Default: the identity.</param>
    /// <returns>The force, in N, and the torque, in N m, for the mass and the moment of inertia of the scene's ball.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public ForceAndTorque Evaluate(Vector3d position, Vector3d velocity, Vector3d spin, double time = 0, double airDistance = 0, Quaterniond? orientation = null)
    {
        Validate(in position, in velocity, in spin);
        Check.Within("time", time, 0, Limits.Time);
        Check.Within("airDistance", airDistance, 0, FarthestFlown);
        return At(in position, in velocity, in spin, time, airDistance, Unit(orientation));
    }

    /// <summary>Computes the force and the torque on many balls at one instant. The balls do not affect each other.</summary>
    /// <param name="positions">The positions of the centres, in m.</param>
    /// <param name="velocities">The velocities, in m/s; one per ball.</param>
    /// <param name="spins">The spins, in rad/s; one per ball.</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="loads">Receives the force and the torque of each ball.</param>
    /// <param name="airDistances">The distances flown through the air, in m; one per ball. Empty means 0 for all balls.</param>
    /// <param name="orientations">The orientations; one per ball. Empty means the identity for all balls.</param>
    /// <exception cref="ArgumentException">The spans do not have the same length.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it. Nothing has been written.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite. The loads of earlier balls have been written.</exception>
    public void Evaluate(
        ReadOnlySpan<Vector3d> positions,
        ReadOnlySpan<Vector3d> velocities,
        ReadOnlySpan<Vector3d> spins,
        double time,
        Span<ForceAndTorque> loads,
        ReadOnlySpan<double> airDistances = default,
        ReadOnlySpan<Quaterniond> orientations = default)
    {
        SameLength("velocities", velocities.Length, positions.Length);
        SameLength("spins", spins.Length, positions.Length);
        SameLength("loads", loads.Length, positions.Length);
        if (!airDistances.IsEmpty)
        {
            SameLength("airDistances", airDistances.Length, positions.Length);
        }

        if (!orientations.IsEmpty)
        {
            SameLength("orientations", orientations.Length, positions.Length);
        }

        // Validate all input before writing any output.
        Check.Within("time", time, 0, Limits.Time);
        for (int i = 0; i < positions.Length; i++)
        {
            Validate(in positions[i], in velocities[i], in spins[i]);
        }

        for (int i = 0; i < airDistances.Length; i++)
        {
            Check.Within("airDistance", airDistances[i], 0, FarthestFlown);
        }

        foreach (ref readonly Quaterniond orientation in orientations)
        {
            Check.Rotation("orientation", orientation);
        }

        for (int i = 0; i < positions.Length; i++)
        {
            loads[i] = At(in positions[i], in velocities[i], in spins[i], time, airDistances.IsEmpty ? 0 : airDistances[i], orientations.IsEmpty ? Quaterniond.Identity : orientations[i].Normalized());
        }
    }

    /// <summary>Returns the velocity to set at a kick in an engine that uses semi-implicit Euler: the velocity half a step earlier.</summary>
    /// <remarks>
    /// Such an engine adds a whole step of acceleration before it moves the body, which is half a step too much. Without this correction, a ball in vacuum lands short by the
    /// distance that it covers in one step. Call it once per kick.
    /// </remarks>
    /// <param name="position">The position of the centre, in m.</param>
    /// <param name="velocity">The velocity that the kick gives the ball, in m/s.</param>
    /// <param name="spin">The spin that the kick gives the ball, in rad/s.</param>
    /// <param name="step">The length of the engine's step, in s; 0 … 1.</param>
    /// <param name="gravity">The engine's gravitational acceleration, in m/s².</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="orientation">The orientation of the ball. Only the knuckle force depends on it. Default: the identity.</param>
    /// <returns>v − ½ Δt (g + F/m), with the force F of the air at the kick.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public Vector3d KickVelocity(Vector3d position, Vector3d velocity, Vector3d spin, double step, Vector3d gravity, double time = 0, Quaterniond? orientation = null)
    {
        Check.Within("step", step, 0, 1);
        Check.Size("gravity", gravity, Limits.Speed, "m/s²");
        return velocity - (0.5 * step * (gravity + (Evaluate(position, velocity, spin, time, orientation: orientation).Force / _mass)));
    }

    /// <summary>Computes the force and the torque for the next step of an engine that uses semi-implicit Euler, after a kick with
    /// <see cref="KickVelocity"/>.</summary>
    /// <remarks>
    /// In such an engine, the velocity is half a step behind the position. This method therefore evaluates the air forces at a velocity advanced by half a
    /// step. The two corrections together make the engine's steps second-order accurate. At 240 steps per second, the path differs from the library's flight by
    /// millimetres at 30 m. A call costs two evaluations.
    /// </remarks>
    /// <param name="position">The position of the centre, in m.</param>
    /// <param name="velocity">The engine's velocity of the body, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="step">The length of the engine's step, in s; 0 … 1.</param>
    /// <param name="gravity">The engine's gravitational acceleration, in m/s².</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="airDistance">The distance that the ball has flown through the air since the kick, in m.</param>
    /// <param name="orientation">The orientation of the body. Only the knuckle force depends on it. Default: the identity.</param>
    /// <returns>The force, in N, and the torque, in N m.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public ForceAndTorque EvaluateForStep(
        Vector3d position, Vector3d velocity, Vector3d spin, double step, Vector3d gravity, double time = 0, double airDistance = 0, Quaterniond? orientation = null)
    {
        Check.Within("step", step, 0, 1);
        Check.Size("gravity", gravity, Limits.Speed, "m/s²");
        Vector3d acceleration = gravity + (Evaluate(position, velocity, spin, time, airDistance, orientation).Force / _mass);
        return At(in position, velocity + (0.5 * step * acceleration), in spin, time, airDistance, Unit(orientation));
    }

    private static void Validate(in Vector3d position, in Vector3d velocity, in Vector3d spin)
    {
        Check.Place("position", position);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Size("spin", spin, Limits.Spin, "rad/s");
    }

    private static void SameLength(string name, int length, int expected)
    {
        if (length != expected)
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} has {length} items; allowed: {expected}, the number of positions."), name);
        }
    }

    private static Quaterniond Unit(in Quaterniond? orientation)
    {
        if (orientation is not { } given)
        {
            return Quaterniond.Identity;
        }

        Check.Rotation("orientation", given);
        return given.Normalized();
    }

    private ForceAndTorque At(in Vector3d position, in Vector3d velocity, in Vector3d spin, double time, double airDistance, in Quaterniond orientation)
    {
        Vector3d u = velocity - _wind;
        DragBranch branch = DragJump.BranchAt(_jumps, u.LengthSquared, _radiusSquared * spin.LengthSquared);
        var ball = new ForceContext(time, in position, in velocity, in u, in spin, MotionState.Airborne, airDistance, in orientation);
        _air.Evaluate(in ball, branch, out AirFactors factors);
        MotionRates rates = factors.Rates(in spin, Vector3d.Zero, _varies);
        return new ForceAndTorque(_mass * rates.Acceleration, _inertia * rates.SpinAcceleration);
    }
}
