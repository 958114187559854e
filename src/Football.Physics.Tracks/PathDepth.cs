namespace FootballPhysics.Tracks;

/// <summary>The standard error of a ball's distance from the first camera, along the fitted path.</summary>
/// <remarks>A launch whose depth is known may still have a curl towards the camera that pixels hardly reveal: the depth is then lost later.</remarks>
internal static class PathDepth
{
    /// <summary>Returns the largest standard error over the observations, in m.</summary>
    public static double Error(Sightings seen, TrackFitRequest request, TrackModel model, double[] values, double[] covariance)
    {
        // 1. C = L Lᵀ. 2. Simulate both ends of each column of L. 3. Add the squares of their distances in depth, at each observation.
        int n = values.Length;
        double[] columns = Cholesky(covariance, n);
        var depths = new DepthSightings(seen);
        var paths = new TrackPaths(depths, request, model);
        double[] middle = new double[depths.Rows];
        double[] high = new double[depths.Rows];
        double[] low = new double[depths.Rows];
        double[] squares = new double[depths.Rows];
        paths.Follow([.. values], middle);
        for (int j = 0; j < n; j++)
        {
            if (!Follow(paths, values, columns, j, 1, high) || !Follow(paths, values, columns, j, -1, low))
            {
                return double.PositiveInfinity;
            }

            for (int i = 0; i < squares.Length; i++)
            {
                // An end below the ground is raised to the ground, so use the farther of both ends.
                double off = Math.Max(Math.Abs(high[i] - middle[i]), Math.Abs(low[i] - middle[i]));
                squares[i] += off * off;
            }
        }

        return Math.Sqrt(squares.Max());
    }

    private static bool Follow(TrackPaths paths, double[] values, double[] columns, int column, double sign, double[] depths)
    {
        int n = values.Length;
        double[] moved = [.. values];
        for (int i = column; i < n; i++)
        {
            moved[i] += sign * columns[(i * n) + column];
        }

        if (!TrackModel.IsLaunch(moved))
        {
            return false;
        }

        paths.Follow(moved, depths);
        return true;
    }

    /// <summary>Returns L with C = L Lᵀ; a column without variance is 0.</summary>
    private static double[] Cholesky(double[] covariance, int n)
    {
        double[] l = new double[n * n];
        for (int j = 0; j < n; j++)
        {
            for (int i = j; i < n; i++)
            {
                double sum = covariance[(i * n) + j];
                for (int k = 0; k < j; k++)
                {
                    sum -= l[(i * n) + k] * l[(j * n) + k];
                }

                double pivot = i == j ? Math.Sqrt(Math.Max(0, sum)) : l[(j * n) + j];
                l[(i * n) + j] = i == j ? pivot : pivot > 0 ? sum / pivot : 0;
            }
        }

        return l;
    }

    /// <summary>Stores the depths of a path in place of its residuals.</summary>
    private sealed class DepthSightings(Sightings seen) : OtherResiduals(seen)
    {
        public override int Rows => Count;

        public override double Miss(int index, in Vector3d position, double[] misses)
        {
            misses[index] = FirstCamera!.Depth(in position);
            return 0;
        }
    }
}
