using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>A custom force or torque of your game.</summary>
/// <remarks>
/// The result must be finite and a smooth function of the input alone. The simulator calls it several times per step, at times between frames. If the result is
/// not finite, the step throws an exception that names the force's type, and leaves the ball unchanged.
/// <para>On the ground the vertical part of the force is dropped, as for drag and Magnus force. While the ball rolls, only the torque about the vertical acts.
/// A ball with custom forces is integrated with the full spin vector, which costs slightly more.</para>
/// </remarks>
public interface IForce
{
    /// <summary>Adds the force (N) and the torque (N m) on the ball.</summary>
    /// <param name="ball">The ball at one instant.</param>
    /// <param name="sum">The sum to add to.</param>
    void Apply(in ForceContext ball, ref ForceAndTorque sum);

    /// <summary>Creates a force from a function, for example <c>IForce.From(ball => new Vector3d(0.4, 0, 0))</c>.</summary>
    /// <param name="force">A function that returns the force on the ball at one instant, in N.</param>
    /// <exception cref="ArgumentNullException"><paramref name="force"/> is null.</exception>
    static IForce From(Func<ForceContext, Vector3d> force) => From(force, 0);

    /// <summary>Creates a force from a function, and states its stiffness, see <see cref="IStiffForce"/>.</summary>
    /// <param name="force">A function that returns the force on the ball at one instant, in N.</param>
    /// <param name="stiffness">The greatest rate at which the force changes the motion, in 1/s; 0 … 1e6. 0: not known.</param>
    /// <exception cref="ArgumentNullException"><paramref name="force"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="stiffness"/> is out of range.</exception>
    static IForce From(Func<ForceContext, Vector3d> force, double stiffness)
    {
        if (force is null)
        {
            throw new ArgumentNullException(nameof(force));
        }

        Check.Within(nameof(stiffness), stiffness, 0, Limits.Stiffness);
        return new FunctionForce(force, stiffness);
    }

    private sealed class FunctionForce(Func<ForceContext, Vector3d> force, double stiffness) : IStiffForce
    {
        public double Stiffness => stiffness;

        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddForce(force(ball));
    }
}
