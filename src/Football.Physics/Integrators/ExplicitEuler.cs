using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Explicit Euler, y' = y + h f(y) (thesis 3.7). Order 1.</summary>
internal readonly struct ExplicitEuler : IIntegrator
{
    public int Stages => 1;

    public int Order => 1;

    public double ShareInPath => 0;

    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    public void Fly<TAir>(
        ref TAir air, in Vector3d axis, DragBranch branch, double ux, double uy, double uz, double w, double g, double h, out FlightStep step)
        where TAir : struct, IAerodynamics
    {
        air.Begin(w, branch, out AirStep once);
        FlightRates.AtStart(ref air, ref once, axis.X, axis.Y, axis.Z, g, ux, uy, uz, w, out double ax, out double ay, out double az, out double b);
        double ex = ux + (h * ax);
        double ey = uy + (h * ay);
        double ez = uz + (h * az);
        double ew = w + (h * b);
        step.StartAcceleration = new Vector3d(ax, ay, az);
        step.StartSpinAcceleration = b;
        step.AirVelocity = new Vector3d(ex, ey, ez);
        step.SpinRate = ew;
        step.Path = new Vector3d(h * ux, h * uy, h * uz);
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
