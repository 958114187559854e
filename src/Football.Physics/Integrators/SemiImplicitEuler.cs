using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Semi-implicit (symplectic) Euler: velocity first, then position with the new velocity (thesis 3.8, 3.9). Order 1.</summary>
internal readonly struct SemiImplicitEuler : IIntegrator
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
        step.AirVelocity = u + (h * a);
        step.SpinRate = w + (h * b);
        step.Path = h * step.AirVelocity;
        step.Turn = h * step.SpinRate;
    }

    public void Advance<TSystem>(ref TSystem system, double time, in Motion from, double h, out MotionStep step)
        where TSystem : struct, IMotionSystem
    {
        system.Rates(time, in from, out step.StartRates);
        Vector3d velocity = from.Velocity + (h * step.StartRates.Acceleration);
        step.End = from.After(h, in velocity, in step.StartRates);
        step.Rotation = h * step.End.Spin;
    }

    /// <remarks>The re-integrated height y + v τ + a τ² is quadratic in τ.</remarks>
    public double ContactTime(in HeightArc arc) => arc.QuadraticRoot(arc.StartAcceleration);
}
