using System.Numerics;
using System.Runtime.CompilerServices;

namespace FootballPhysics.Yardsticks;

/// <summary>The thesis' four integrators (3.3.3, 3.3.4): tuples, a heap object per stage, orientation by adding and normalising.</summary>
public sealed class ThesisIntegrators(ThesisForces forces)
{
    public (Vector3 P, Quaternion Q, Vector3 V, Vector3 W) Integrate(
        Integrator method, float deltaTime, Vector3 p, Quaternion q, Vector3 v, Vector3 w, ThesisState state) => method switch
        {
            Integrator.Euler => ExplicitEuler(deltaTime, p, q, v, w, state),
            Integrator.SemiImplicitEuler => SemiImplicitEuler(deltaTime, p, q, v, w, state),
            Integrator.Rk2 => RungeKutta2(deltaTime, p, q, v, w, state),
            _ => RungeKutta4(deltaTime, p, q, v, w, state),
        };

    private (Vector3 P, Quaternion Q, Vector3 V, Vector3 W) ExplicitEuler(
        float deltaTime, Vector3 p, Quaternion q, Vector3 v, Vector3 w, ThesisState state)
    {
        (Vector3 a, Vector3 alpha) = forces.CalculateAccelerationAndAngularAcceleration(v, w, state);
        Vector3 vNext = v + (deltaTime * a);
        Vector3 wNext = w + (deltaTime * alpha);
        Vector3 pNext = p + (deltaTime * v);
        var qNext = Quaternion.Normalize(Quaternion.Add(q, Quaternion.Multiply(QuaternionDerivative(q, w), deltaTime)));
        return (pNext, qNext, vNext, wNext);
    }

    private (Vector3 P, Quaternion Q, Vector3 V, Vector3 W) SemiImplicitEuler(
        float deltaTime, Vector3 p, Quaternion q, Vector3 v, Vector3 w, ThesisState state)
    {
        (Vector3 a, Vector3 alpha) = forces.CalculateAccelerationAndAngularAcceleration(v, w, state);
        Vector3 vNext = v + (deltaTime * a);
        Vector3 wNext = w + (deltaTime * alpha);
        Vector3 pNext = p + (deltaTime * vNext);
        var qNext = Quaternion.Normalize(Quaternion.Add(q, Quaternion.Multiply(QuaternionDerivative(q, wNext), deltaTime)));
        return (pNext, qNext, vNext, wNext);
    }

    private (Vector3 P, Quaternion Q, Vector3 V, Vector3 W) RungeKutta2(
        float deltaTime, Vector3 p, Quaternion q, Vector3 v, Vector3 w, ThesisState state)
    {
        ThesisK k1 = ComputeK(v, w, q, state);
        ThesisK k2 = ComputeK(
            v + (deltaTime * k1.V / 2f),
            w + (deltaTime * k1.W / 2f),
            Quaternion.Add(q, Quaternion.Multiply(k1.Q, deltaTime / 2f)),
            state);
        Vector3 pNext = p + (deltaTime * k2.P);
        Vector3 vNext = v + (deltaTime * k2.V);
        Vector3 wNext = w + (deltaTime * k2.W);
        var qNext = Quaternion.Normalize(Quaternion.Add(q, Quaternion.Multiply(k2.Q, deltaTime)));
        return (pNext, qNext, vNext, wNext);
    }

    private (Vector3 P, Quaternion Q, Vector3 V, Vector3 W) RungeKutta4(
        float deltaTime, Vector3 p, Quaternion q, Vector3 v, Vector3 w, ThesisState state)
    {
        ThesisK k1 = ComputeK(v, w, q, state);
        ThesisK k2 = ComputeK(
            v + (deltaTime * k1.V / 2f),
            w + (deltaTime * k1.W / 2f),
            Quaternion.Add(q, Quaternion.Multiply(k1.Q, deltaTime / 2f)),
            state);
        ThesisK k3 = ComputeK(
            v + (deltaTime * k2.V / 2f),
            w + (deltaTime * k2.W / 2f),
            Quaternion.Add(q, Quaternion.Multiply(k2.Q, deltaTime / 2f)),
            state);
        ThesisK k4 = ComputeK(
            v + (deltaTime * k3.V),
            w + (deltaTime * k3.W),
            Quaternion.Add(q, Quaternion.Multiply(k3.Q, deltaTime)),
            state);
        Vector3 vNext = v + (deltaTime * (k1.V + (2 * k2.V) + (2 * k3.V) + k4.V) / 6);
        Vector3 pNext = p + (deltaTime * (k1.P + (2 * k2.P) + (2 * k3.P) + k4.P) / 6);
        Vector3 wNext = w + (deltaTime * (k1.W + (2 * k2.W) + (2 * k3.W) + k4.W) / 6);
        var weightedSum = Quaternion.Add(k1.Q, Quaternion.Multiply(k2.Q, 2f));
        weightedSum = Quaternion.Add(weightedSum, Quaternion.Multiply(k3.Q, 2f));
        weightedSum = Quaternion.Add(weightedSum, k4.Q);
        var qNext = Quaternion.Normalize(Quaternion.Add(q, Quaternion.Multiply(weightedSum, deltaTime / 6f)));
        return (pNext, qNext, vNext, wNext);
    }

    // Not inlined, so that the object is on the heap, as in Unity: .NET 10 would keep it on the stack.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private ThesisK ComputeK(Vector3 velocity, Vector3 angularVelocity, Quaternion orientation, ThesisState state)
    {
        var k = new ThesisK();
        (k.V, k.W) = forces.CalculateAccelerationAndAngularAcceleration(velocity, angularVelocity, state);
        k.P = velocity;
        k.Q = QuaternionDerivative(orientation, angularVelocity);
        return k;
    }

    // q̇ = ½ (ω, 0) ⊗ q
    private static Quaternion QuaternionDerivative(Quaternion q, Vector3 w) =>
        Quaternion.Multiply(Quaternion.Multiply(new Quaternion(w.X, w.Y, w.Z, 0f), q), 0.5f);
}
