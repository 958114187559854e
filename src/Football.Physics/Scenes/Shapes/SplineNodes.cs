namespace FootballPhysics.Scenes;

/// <summary>Solves for the control values of a uniform cubic B-spline that passes through given heights.</summary>
/// <remarks>
/// The spline at node i is (c[i−1] + 4 c[i] + c[i+1])/6. A surface is a product of splines along x and z, so each line of the grid is solved by itself, first
/// along z, then along x. End condition: the second derivative is zero at the first and the last node (natural spline), so that a plane stays a plane.
/// </remarks>
internal static class SplineNodes
{
    /// <summary>Returns the control values, row by row: one more at each side than there are heights.</summary>
    /// <param name="heights">The heights at the nodes.</param>
    public static double[] ControlValues(double[,] heights)
    {
        int rows = heights.GetLength(0);
        int columns = heights.GetLength(1);
        int width = columns + 2;
        double[] values = new double[(rows + 2) * width];
        var line = new Line(Math.Max(rows, columns));
        for (int i = 0; i < rows; i++)
        {
            for (int j = 0; j < columns; j++)
            {
                line.Heights[j] = heights[i, j];
            }

            line.Solve(columns, values, (i + 1) * width, 1);
        }

        for (int j = 0; j < width; j++)
        {
            for (int i = 0; i < rows; i++)
            {
                line.Heights[i] = values[((i + 1) * width) + j];
            }

            line.Solve(rows, values, j, width);
        }

        return values;
    }

    /// <summary>One line of the grid, with memory for its solution.</summary>
    private sealed class Line(int most)
    {
        private readonly double[] _pivots = new double[most];
        private readonly double[] _left = new double[most];

        /// <summary>The heights at the nodes of the line.</summary>
        public double[] Heights { get; } = new double[most];

        /// <summary>Solves the tridiagonal system of the line by elimination.</summary>
        /// <param name="count">The number of nodes.</param>
        /// <param name="values">The control values.</param>
        /// <param name="first">The index of the first of count + 2 control values.</param>
        /// <param name="stride">The distance of two of them in the array.</param>
        public void Solve(int count, double[] values, int first, int stride)
        {
            // h are the heights, and c the control values.
            // At both ends the second derivative is zero, so c[0] = h[0]. In between: c[i−1] + 4 c[i] + c[i+1] = 6 h[i], with c[i−1] = left − pivot c[i].
            _left[0] = Heights[0];
            _pivots[0] = 0;
            for (int i = 1; i < count - 1; i++)
            {
                _pivots[i] = 1.0 / (4.0 - _pivots[i - 1]);
                _left[i] = ((6.0 * Heights[i]) - _left[i - 1]) * _pivots[i];
            }

            double next = Heights[count - 1];
            values[first + (count * stride)] = next;
            for (int i = count - 2; i >= 0; i--)
            {
                next = _left[i] - (_pivots[i] * next);
                values[first + ((i + 1) * stride)] = next;
            }

            // Beyond the ends, continue in a straight line.
            int end = first + ((count + 1) * stride);
            int inward = Math.Min(count - 1, 1) * stride;
            values[first] = (2.0 * values[first + stride]) - values[first + stride + inward];
            values[end] = (2.0 * values[end - stride]) - values[end - stride - inward];
        }
    }
}
