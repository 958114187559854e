namespace Football.Physics;

/// <summary>Turns a function into a force.</summary>
public static class Force
{
    /// <summary>A law that gives the force on the ball.</summary>
    /// <param name="ball">The ball at one instant.</param>
    /// <returns>Force, N.</returns>
    public delegate Vector3d Law(in ForceInput ball);

    /// <summary>A force from a function.</summary>
    /// <param name="law">Gives the force in newtons.</param>
    /// <exception cref="ArgumentNullException"><paramref name="law"/> is null.</exception>
    public static IForce From(Law law) => new LawForce(law ?? throw new ArgumentNullException(nameof(law)));

    private sealed class LawForce : IForce
    {
        private readonly Law _law;

        public LawForce(Law law) => _law = law;

        public void Apply(in ForceInput ball, ref ForceSum sum) => sum.AddForce(_law(ball));
    }
}
