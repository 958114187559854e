using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Eliminates the launches from the normal equations of flights (Schur complement).</summary>
/// <remarks>
/// The equations of a flight have the blocks A of its launch, C of the shared parameters, and B of both, and the gradients a and c. Without the launches:
/// S = Σ (C − Bᵀ A⁻¹ B), s = Σ (c − Bᵀ A⁻¹ a).
/// </remarks>
/// <param name="shared">The number of shared parameters.</param>
internal sealed class LaunchElimination(int shared)
{
    private const int Launch = FlightPath.Launch;

    private readonly int _size = Launch + shared;

    /// <summary>Computes A⁻¹.</summary>
    public void Invert(double[] normal, double[] inverse)
    {
        double[] a = new double[Launch * Launch];
        for (int i = 0; i < a.Length; i++)
        {
            a[i] = normal[(i / Launch * _size) + (i % Launch)];
        }

        Linear.Invert(a, inverse, Launch);
    }

    /// <summary>Returns A⁻¹B.</summary>
    public double[] Couple(double[] normal, double[] inverse)
    {
        double[] coupling = new double[Launch * shared];
        for (int i = 0; i < Launch; i++)
        {
            for (int j = 0; j < shared; j++)
            {
                double sum = 0;
                for (int k = 0; k < Launch; k++)
                {
                    sum += inverse[(i * Launch) + k] * normal[(k * _size) + Launch + j];
                }

                coupling[(i * shared) + j] = sum;
            }
        }

        return coupling;
    }

    /// <summary>Adds S += w (C − Bᵀ A⁻¹B), s += w (c − (A⁻¹B)ᵀ a).</summary>
    public void Eliminate(double[] normal, double[] gradient, double[] coupling, double weight, double[] s, double[] right)
    {
        for (int i = 0; i < shared; i++)
        {
            double left = gradient[Launch + i];
            for (int k = 0; k < Launch; k++)
            {
                left -= coupling[(k * shared) + i] * gradient[k];
            }

            right[i] += weight * left;
            for (int j = 0; j < shared; j++)
            {
                double sum = normal[((Launch + i) * _size) + Launch + j];
                for (int k = 0; k < Launch; k++)
                {
                    sum -= normal[(k * _size) + Launch + i] * coupling[(k * shared) + j];
                }

                s[(i * shared) + j] += weight * sum;
            }
        }
    }
}
