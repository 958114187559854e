namespace FootballPhysics.Tool.Replay;

/// <summary>The heights of the ground on a grid that extends a little beyond the visible objects.</summary>
/// <param name="X">The minimum x, in m.</param>
/// <param name="Z">The minimum z, in m.</param>
/// <param name="Cell">The side of a cell, in m.</param>
/// <param name="Columns">The number of points along x.</param>
/// <param name="Rows">The number of points along z.</param>
/// <param name="Heights">The heights, in m, row by row.</param>
internal sealed record GroundGrid(double X, double Z, double Cell, int Columns, int Rows, double[] Heights)
{
    private const double Around = 6;
    private const int MostCells = 44;

    /// <summary>Returns the ground under the given positions; null if there is no ground.</summary>
    public static GroundGrid? Of(Ground ground, IReadOnlyCollection<Vector3d> places)
    {
        if (ground.IsNone || places.Count == 0)
        {
            return null;
        }

        double width = places.Max(place => place.X) - places.Min(place => place.X) + (2 * Around);
        double depth = places.Max(place => place.Z) - places.Min(place => place.Z) + (2 * Around);
        double least = ground.Heights is { } heights ? Math.Max(0.5, 0.5 * heights.Spacing) : 2.5;
        double cell = least;
        while (Math.Max(width, depth) > MostCells * cell)
        {
            cell *= 2;
        }

        double x = cell * Math.Floor((places.Min(place => place.X) - Around) / cell);
        double z = cell * Math.Floor((places.Min(place => place.Z) - Around) / cell);
        int columns = (int)Math.Ceiling(width / cell) + 2;
        int rows = (int)Math.Ceiling(depth / cell) + 2;
        double[] values = [.. Enumerable.Range(0, columns * rows).Select(i => SceneShapes.GroundAt(ground, x + (cell * (i % columns)), z + (cell * (i / columns))))];
        return new GroundGrid(x, z, cell, columns, rows, values);
    }

    /// <summary>Returns the interpolated height of the ground under a position, in m.</summary>
    public double HeightAt(Vector3d place)
    {
        double u = Math.Clamp((place.X - X) / Cell, 0, Columns - 1.001);
        double w = Math.Clamp((place.Z - Z) / Cell, 0, Rows - 1.001);
        (int i, int j) = ((int)u, (int)w);
        (double s, double r) = (u - i, w - j);
        return ((1 - r) * (((1 - s) * At(i, j).Y) + (s * At(i + 1, j).Y))) + (r * (((1 - s) * At(i, j + 1).Y) + (s * At(i + 1, j + 1).Y)));
    }

    /// <summary>Returns a point of the grid, in m.</summary>
    public Vector3d At(int column, int row) => new(X + (Cell * column), Heights[(row * Columns) + column], Z + (Cell * row));
}
