namespace FootballPhysics.Labs.Stability;

/// <summary>Custom forces of any strength.</summary>
internal static class HostileForces
{
    /// <summary>Returns one of four forces; all are drawn, so that the random sequence does not depend on the choice.</summary>
    public static IForce Draw(HostileRandom random, double groundHeight) => random.Any<IForce>(
        new Spring(
            random.Log(1e-3, 1e3),
            random.Any(0.0, random.Log(1e-3, 10)),
            new Vector3d(random.Uniform(-5, 5), groundHeight + random.Uniform(-3, 5), random.Uniform(-5, 5))),
        new Twister(random.Log(1e-2, 1e3), random.Log(1e-2, 1e4)),
        new Thrust(random.Uniform(-20, 20)),
        new Damper(random.Log(1e-3, 1e2), random.Log(1e-9, 1e3)));

    private sealed record Spring(double Stiffness, double Damping, Vector3d Origin) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddForce((Stiffness * (Origin - ball.Position)) - (Damping * ball.Velocity));
    }

    private sealed record Twister(double Strength, double Rate) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(new Vector3d(Strength * Math.Sin(Rate * ball.Time), Strength * Math.Cos(Rate * ball.Time), 0));
            sum.AddTorque(new Vector3d(0, 0.001 * Strength, 0));
        }
    }

    private sealed record Thrust(double Strength) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddForce(new Vector3d(0, Strength, 0));
    }

    private sealed record Damper(double OfVelocity, double OfSpin) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            sum.AddForce(-OfVelocity * ball.Velocity);
            sum.AddTorque(-OfSpin * ball.Spin);
        }
    }
}
