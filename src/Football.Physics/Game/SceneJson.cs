using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>Writes scenes as JSON, for the command line, Python, C, JavaScript and bug reports.</summary>
/// <remarks>Each number is written so that it reads back as the same number. The scene that a reader builds therefore has the same <see cref="Simulator.SceneHash"/>.</remarks>
public static class SceneJson
{
    /// <summary>The step of a scenario without one, in s.</summary>
    private const double UsualStep = 0.01;

    /// <summary>Returns a scene as a JSON object, with the bodies at their last positions.</summary>
    /// <remarks>
    /// The object is a scenario without its launch: add <c>"launch": {"position": […], "velocity": […]}</c> for <c>football simulate</c> and <c>football replay</c>.
    /// The C interface, the Python package and the npm package read it as it is.
    /// </remarks>
    /// <param name="scene">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="scene"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number of the scene is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="InvalidOperationException">JSON cannot describe a part of the scene, because it is code: a custom force, a wind field or a ground pattern of your
    /// own, a shape of your own, or the colliders of an engine. The message names the part.</exception>
    public static string ToJson(this Scene scene)
    {
        Check.Given(nameof(scene), scene);
        scene.Validate();
        return new SceneText().Begin().Add(scene).Bodies(scene.Bodies, null).End().ToString();
    }

    /// <summary>Returns a scene with a ball as a JSON object: a scenario that <c>football replay</c> and <c>football simulate</c> play.</summary>
    /// <remarks>
    /// The ball is launched at time 0 with its present position, velocity, spin and orientation; add a <c>stop</c> to play it to its rest. A launch starts the
    /// knuckle force at its beginning. The bodies keep their present velocities.
    /// </remarks>
    /// <param name="simulator">The scene and its settings.</param>
    /// <param name="ball">The ball, usually just after a kick.</param>
    /// <param name="timeStep">The step of the scenario, in s; above 0, at most 1e12. Default 0.01.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="timeStep"/> is out of range.</exception>
    /// <exception cref="InvalidOperationException">JSON cannot describe a part of the scene, because it is code, or because it has changed since time 0: an obstacle
    /// that moves, or gusts. The message names the part.</exception>
    public static string ToJson(this Simulator simulator, in BallState ball, double timeStep = UsualStep)
    {
        Check.Given(nameof(simulator), simulator);
        BallState.Launched(in ball);
        Check.Within(nameof(timeStep), timeStep, 0, Limits.Time, exclusiveLow: true);
        if (ball.Time != 0 && ChangesInTime(simulator.Scene) is { } part)
        {
            throw new InvalidOperationException(FormattableString.Invariant(
                $"The ball's time is {ball.Time:R} s, and {part} has moved since time 0, where a scenario starts. Write the scene at time 0, before the first step."));
        }

        return new SceneText().Begin().Solver(simulator.Settings, timeStep).Add(simulator.Scene).Bodies(simulator.Scene.Bodies, ball.Time).Launch(in ball).End().ToString();
    }

    /// <summary>Returns the part of a scene that depends on the time; null if none does.</summary>
    private static string? ChangesInTime(Scene scene)
    {
        for (int i = 0; i < scene.Obstacles.Count; i++)
        {
            Obstacle item = scene.Obstacles[i];
            if (item.Velocity != Vector3d.Zero || !double.IsPositiveInfinity(item.Mass))
            {
                return $"{Check.Item("obstacles", i)} ({item.Name})";
            }
        }

        return scene.Air.WindField is WindByHeight { Gusts: not null } ? "air.wind.gusts" : null;
    }
}
