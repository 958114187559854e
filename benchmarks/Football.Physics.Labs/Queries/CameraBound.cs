namespace FootballPhysics.Labs.Queries;

/// <summary>The least variance that pixels allow: the Cramér–Rao bound at the true launch, with the fit's prior (van Trees).</summary>
/// <remarks>
/// It uses neither the fit nor the library's cameras: differences of simulated paths, its own pinhole, its own inversion. It ignores that no launch is
/// below the ground, and the prior of the launch is unbiased. So a fit may be below the bound.
/// </remarks>
internal static class CameraBound
{
    private const int Launch = 9;
    private const int Height = 1;
    private const int FirstSpin = 6;

    /// <summary>Half the widths of the differences, m, m/s, rad/s; and the height by which the launch is raised for them, m.</summary>
    private static readonly double[] s_steps = [1e-3, 5e-4, 1e-3, 1e-3, 1e-3, 1e-3, 1e-2, 1e-2, 1e-2];
    private const double Raised = 1e-3;

    /// <summary>Returns the sum of the variances of all positions of a path, m².</summary>
    /// <param name="path">Returns the path of a launch with this position, velocity and spin.</param>
    /// <param name="truth">The true launch.</param>
    /// <param name="seen">The index of a position and the pinhole that sees it, once per pixel.</param>
    /// <param name="noise">The standard deviation of a pixel.</param>
    /// <param name="heightVariance">The prior variance of the height.</param>
    /// <param name="spinVariance">The prior variance of each component of the spin.</param>
    public static double Squares(
        Func<double[], Vector3d[]> path, double[] truth, IEnumerable<(int Place, Pinhole Camera)> seen, double noise, double heightVariance, double spinVariance)
    {
        double[] from = [.. truth];
        from[Height] += Raised;
        Vector3d[] places = path(from);
        Vector3d[][] by = [.. s_steps.Select((step, j) => path(Moved(from, j, step)).Zip(path(Moved(from, j, -step)), (high, low) => (high - low) / (2 * step)).ToArray())];

        // The information: Σ ∇u ∇uᵀ + ∇v ∇vᵀ over the pixels, plus the prior.
        double[,] information = new double[Launch, Launch];
        information[Height, Height] = 1 / heightVariance;
        for (int i = FirstSpin; i < Launch; i++)
        {
            information[i, i] = 1 / spinVariance;
        }

        foreach ((int place, Pinhole camera) in seen)
        {
            (double U, double V)[] g = [.. by.Select(direction => camera.Change(places[place], direction[place]))];
            for (int i = 0; i < Launch; i++)
            {
                for (int j = 0; j < Launch; j++)
                {
                    information[i, j] += ((g[i].U * g[j].U) + (g[i].V * g[j].V)) / (noise * noise);
                }
            }
        }

        double[,] covariance = Inverse(information);
        double sum = 0;
        for (int k = 0; k < places.Length; k++)
        {
            for (int i = 0; i < Launch; i++)
            {
                for (int j = 0; j < Launch; j++)
                {
                    sum += covariance[i, j] * Vector3d.Dot(by[i][k], by[j][k]);
                }
            }
        }

        return sum;
    }

    private static double[] Moved(double[] from, int number, double by)
    {
        double[] moved = [.. from];
        moved[number] += by;
        return moved;
    }

    /// <summary>Returns the inverse by Gauss–Jordan elimination of the matrix scaled to a diagonal of 1.</summary>
    private static double[,] Inverse(double[,] matrix)
    {
        int n = matrix.GetLength(0);
        double[] scale = [.. Enumerable.Range(0, n).Select(i => 1 / Math.Sqrt(matrix[i, i]))];
        double[,] a = new double[n, n];
        double[,] inverse = new double[n, n];
        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                a[i, j] = scale[i] * matrix[i, j] * scale[j];
                inverse[i, j] = i == j ? 1 : 0;
            }
        }

        // The matrix is symmetric and positive definite, so no pivots are needed.
        for (int i = 0; i < n; i++)
        {
            double pivot = a[i, i];
            for (int k = 0; k < n; k++)
            {
                a[i, k] /= pivot;
                inverse[i, k] /= pivot;
            }

            for (int row = 0; row < n; row++)
            {
                double factor = row == i ? 0 : a[row, i];
                for (int k = 0; k < n && factor != 0; k++)
                {
                    a[row, k] -= factor * a[i, k];
                    inverse[row, k] -= factor * inverse[i, k];
                }
            }
        }

        for (int i = 0; i < n; i++)
        {
            for (int j = 0; j < n; j++)
            {
                inverse[i, j] *= scale[i] * scale[j];
            }
        }

        return inverse;
    }
}

/// <summary>A pinhole camera that points at a target, with a level horizon.</summary>
internal sealed class Pinhole
{
    private readonly Vector3d _position;
    private readonly Vector3d _ahead;
    private readonly Vector3d _right;
    private readonly Vector3d _down;
    private readonly double _focalLength;

    public Pinhole(in Vector3d position, in Vector3d target, double focalLength)
    {
        _position = position;
        _ahead = (target - position) / (target - position).Length;
        Vector3d right = Vector3d.Cross(_ahead, Vector3d.Up);
        _right = right / right.Length;
        _down = Vector3d.Cross(_ahead, _right);
        _focalLength = focalLength;
    }

    /// <summary>Returns the number of pixels by which a point moves in the image, per metre along a direction.</summary>
    public (double U, double V) Change(in Vector3d place, in Vector3d direction)
    {
        Vector3d from = place - _position;
        double depth = Vector3d.Dot(in from, in _ahead);
        Vector3d across = direction - (Vector3d.Dot(in direction, in _ahead) / depth * from);
        return (_focalLength / depth * Vector3d.Dot(in across, in _right), _focalLength / depth * Vector3d.Dot(in across, in _down));
    }
}
