using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The settings of a batch.</summary>
public sealed record BatchSettings
{
    /// <summary>The one-step method: <see cref="Integrator.Rk2"/> or <see cref="Integrator.Rk4"/>. Default <see cref="Integrator.Rk4"/>.</summary>
    public Integrator Integrator { get; init; } = Integrator.Rk4;

    /// <summary>The length of a step, in s; rounded to float. 1e-5 … 1; default 0.02.</summary>
    public double TimeStep { get; init; } = 0.02;

    /// <summary>The floating-point precision. Default <see cref="BatchPrecision.Single"/>.</summary>
    public BatchPrecision Precision { get; init; } = BatchPrecision.Single;

    /// <summary>The number of threads; the results do not depend on it. 1 … 1024; default 1.</summary>
    public int Threads { get; init; } = 1;

    /// <summary>True to compute the highest point of each flight. Default false.</summary>
    public bool FindApex { get; init; }

    /// <summary>The default: RK4 in single precision, steps of 20 ms, one thread.</summary>
    public static BatchSettings Default { get; } = new();

    /// <summary>Returns the fastest settings for an accuracy.</summary>
    /// <remarks>RK4 in single precision with steps of 40 ms or 20 ms; for 1 µm, in double precision with 5 ms.</remarks>
    /// <param name="accuracy">The required accuracy of a shot, from the kick to the impact.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="accuracy"/> is not a defined value.</exception>
    public static BatchSettings For(Accuracy accuracy)
    {
        Check.Defined(nameof(accuracy), accuracy, (int)accuracy, 3);
        return accuracy switch
        {
            Accuracy.Millimeter => new BatchSettings { TimeStep = 0.04 },
            Accuracy.TenthOfMillimeter => new BatchSettings { TimeStep = 0.02 },
            Accuracy.Micrometer => new BatchSettings { TimeStep = 0.005, Precision = BatchPrecision.Double },
            _ => throw Check.Unknown(nameof(accuracy), accuracy),
        };
    }

    /// <summary>Throws if a setting is out of range.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A setting is out of range; the message names field, value and range.</exception>
    internal void Validate()
    {
        if (Integrator is not (Integrator.Rk2 or Integrator.Rk4))
        {
            throw Check.Refusal("batch.integrator", Integrator.ToString(), "Rk2 | Rk4");
        }

        Check.Within("batch.timeStep", TimeStep, 1e-5, 1);
        Check.Defined("batch.precision", Precision, (int)Precision, 2);
        Check.Within("batch.threads", Threads, 1, 1024);
    }
}
