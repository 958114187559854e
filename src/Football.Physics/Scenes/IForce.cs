namespace FootballPhysics.Laws;

/// <summary>A force or torque of the game's own.</summary>
/// <remarks>
/// It must be a smooth function of its input alone, and finite: it is asked several times a step, at points between frames. On
/// the ground the vertical part of the force is dropped, as that of drag and Magnus force is; while the ball rolls only the torque
/// about the vertical counts. One that is not finite is refused by its type's name, and the ball stays where it was. A ball with forces of its own is integrated with the full spin vector, which costs a little more.
/// </remarks>
public interface IForce
{
    /// <summary>Adds the force (N) and the torque (N m) that act on the ball.</summary>
    /// <param name="ball">The ball at one instant.</param>
    /// <param name="sum">Where to add.</param>
    void Apply(in ForceContext ball, ref ForceAccumulator sum);

    /// <summary>A force from a function, for instance <c>IForce.From(ball => new Vector3d(0.4, 0, 0))</c>.</summary>
    /// <param name="force">Gives the force on the ball at one instant, N.</param>
    /// <exception cref="ArgumentNullException"><paramref name="force"/> is null.</exception>
    static IForce From(Func<ForceContext, Vector3d> force) => new FunctionForce(force ?? throw new ArgumentNullException(nameof(force)));

    private sealed class FunctionForce : IForce
    {
        private readonly Func<ForceContext, Vector3d> _force;

        public FunctionForce(Func<ForceContext, Vector3d> force) => _force = force;

        public void Apply(in ForceContext ball, ref ForceAccumulator sum) => sum.AddForce(_force(ball));
    }
}

/// <summary>The running sum of forces and torques.</summary>
public struct ForceAccumulator
{
    /// <summary>Sum of the forces, N.</summary>
    public Vector3d Force { get; private set; }

    /// <summary>Sum of the torques, N m.</summary>
    public Vector3d Torque { get; private set; }

    /// <summary>Adds a force.</summary>
    /// <param name="force">Force, N.</param>
    public void AddForce(in Vector3d force) => Force += force;

    /// <summary>Adds a torque.</summary>
    /// <param name="torque">Torque, N m.</param>
    public void AddTorque(in Vector3d torque) => Torque += torque;
}
