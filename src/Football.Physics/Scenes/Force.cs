namespace Football.Physics;

/// <summary>Turns a function into a force.</summary>
public static class Force
{
    /// <summary>A force from a function, for instance <c>Force.From(ball => new Vector3d(0.4, 0, 0))</c>.</summary>
    /// <param name="force">Gives the force on the ball at one instant, N.</param>
    /// <exception cref="ArgumentNullException"><paramref name="force"/> is null.</exception>
    public static IForce From(Func<ForceInput, Vector3d> force) => new FunctionForce(force ?? throw new ArgumentNullException(nameof(force)));

    private sealed class FunctionForce : IForce
    {
        private readonly Func<ForceInput, Vector3d> _force;

        public FunctionForce(Func<ForceInput, Vector3d> force) => _force = force;

        public void Apply(in ForceInput ball, ref ForceSum sum) => sum.AddForce(_force(ball));
    }
}
