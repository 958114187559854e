using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Explicit Euler, y' = y + h f(y) (thesis 3.7). Order 1.</summary>
internal readonly struct ExplicitEuler : IIntegrator
{
    public int Stages => 1;

    public int Order => 1;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Fly<TAir>(ref TAir air, in FlightPoint from, double h, out FlightStep step)
        where TAir : struct, IAerodynamics
    {
        Vector3d u = from.AirVelocity;
        double w = from.SpinRate;
        FlightRates.Of(ref air, in from, in u, w, out Vector3d a, out double b);
        step.StartAcceleration = a;
        step.StartSpinAcceleration = b;
        step.Path = h * u;
        step.AirVelocity = u + (h * a);
        step.SpinRate = w + (h * b);
        step.Turn = h * w;
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        system.Rates(time, in from, out step.StartRates);
        step.End = from.After(h, in from.Velocity, in step.StartRates);
        step.Rotation = h * from.Spin;
    }

    /// <remarks>The re-integrated height y + v τ is linear in τ.</remarks>
    public double ContactTime(in HeightArc arc) => arc.StartVelocity < 0 ? Math.Min(arc.Start / -arc.StartVelocity, arc.Length) : arc.Length;
}
