namespace Football.Physics;

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
    void Apply(in ForceInput ball, ref ForceSum sum);
}
