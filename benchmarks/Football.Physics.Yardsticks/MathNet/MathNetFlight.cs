using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.OdeSolvers;

namespace FootballPhysics.Yardsticks;

/// <summary>A general ODE library on the same right-hand side: MathNet.Numerics' Runge–Kutta solvers (its SecondOrder is Heun's method).</summary>
public sealed class MathNetFlight
{
    private readonly PlainFitted _law;
    private readonly PlainVector _wind;
    private readonly bool _fourthOrder;
    private readonly Func<double, Vector<double>, Vector<double>> _rates;

    public MathNetFlight(Integrator integrator, Scene? scene = null)
    {
        scene ??= Scene.Published;
        _law = new PlainFitted(scene, scene.Forces.Coefficients == AerodynamicModel.Regularized);
        _wind = scene.Air.Wind;
        _fourthOrder = integrator switch
        {
            Integrator.Rk2 => false,
            Integrator.Rk4 => true,
            _ => throw new ArgumentOutOfRangeException(nameof(integrator), integrator, "MathNet.Numerics has no Euler method; allowed: Rk2 | Rk4."),
        };
        _rates = Rates;
    }

    /// <summary>Returns the state that the solver advances.</summary>
    public static Vector<double> StateOf(Shot shot) => Vector<double>.Build.DenseOfArray(
    [
        shot.Position.X, shot.Position.Y, shot.Position.Z,
        shot.Velocity.X, shot.Velocity.Y, shot.Velocity.Z,
        shot.Spin.X, shot.Spin.Y, shot.Spin.Z,
    ]);

    /// <summary>Advances a flight by equal steps.</summary>
    public Vector<double> Fly(Vector<double> state, double h, int steps = 1) => _fourthOrder
        ? RungeKutta.FourthOrder(state, 0, steps * h, steps + 1, _rates)[steps]
        : RungeKutta.SecondOrder(state, 0, steps * h, steps + 1, _rates)[steps];

    private Vector<double> Rates(double time, Vector<double> y)
    {
        var v = new PlainVector(y[3], y[4], y[5]);
        _law.Rates(v - _wind, new PlainVector(y[6], y[7], y[8]), out PlainVector a, out PlainVector b);
        return Vector<double>.Build.DenseOfArray([v.X, v.Y, v.Z, a.X, a.Y, a.Z, b.X, b.Y, b.Z]);
    }
}
