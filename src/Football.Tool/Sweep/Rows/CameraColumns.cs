using FootballPhysics.Tool.Cameras;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>The columns of cameras: their matrices, the pixels of the samples, and whether the pixels are inside the image.</summary>
internal static class CameraColumns
{
    private static readonly string[] s_rows = ["a", "b", "w"];
    private static readonly string[] s_columns = ["x", "y", "z", "1"];
    private static readonly string[] s_pixel = ["u", "v"];

    /// <summary>Creates the columns.</summary>
    /// <param name="count">The number of cameras.</param>
    /// <param name="times">The times of the samples, in s.</param>
    /// <param name="labels">The names of the samples.</param>
    /// <param name="cameras">Returns the cameras of the current row.</param>
    /// <param name="at">Returns the position at a time, in m; null after the end.</param>
    public static IEnumerable<ColumnSource> Of(int count, IReadOnlyList<double> times, string[] labels, Func<IReadOnlyList<CameraView>> cameras, Func<double, Vector3d?> at)
    {
        if (count == 0)
        {
            yield break;
        }

        string[] numbers = [.. Enumerable.Range(0, count).Select(camera => FormattableString.Invariant($"{camera}"))];
        yield return new ColumnSource(
            Column.Real("cameras.matrix", "", "camera matrices: (a, b, w) = matrix (x, y, z, 1), u = a/w, v = b/w, and w is the depth in m").Along(s_columns).Along(s_rows).Along(numbers),
            (to, row, _) =>
            {
                for (int camera = 0; camera < count; camera++)
                {
                    IReadOnlyList<double> matrix = cameras()[camera].Camera.Matrix;
                    for (int i = 0; i < matrix.Count; i++)
                    {
                        to.Reals[(matrix.Count * ((row * count) + camera)) + i] = matrix[i];
                    }
                }
            });
        yield return new ColumnSource(
            Column.Real("samples.pixel", "px", "pixels of the centre at these times, also outside the image; none behind the camera or after the end").Along(s_pixel).Along(labels).Along(numbers),
            (to, row, _) => Each(row, (view, position, place) =>
            {
                (double u, double v) = Pixel(view, position);
                (to.Reals[2 * place], to.Reals[(2 * place) + 1]) = (u, v);
            }));
        yield return new ColumnSource(
            Column.Word("samples.visible", "whether the centre is within the image; objects do not hide it", "no", "yes").Along(labels).Along(numbers),
            (to, row, _) => Each(row, (view, position, place) =>
            {
                (double u, double v) = Pixel(view, position);
                to.Words[place] = (byte)(view.Contains(u, v) ? 1 : 0);
            }));

        void Each(int row, Action<CameraView, Vector3d?, int> set)
        {
            for (int camera = 0; camera < count; camera++)
            {
                for (int k = 0; k < times.Count; k++)
                {
                    set(cameras()[camera], at(times[k]), (((row * count) + camera) * times.Count) + k);
                }
            }
        }
    }

    private static (double U, double V) Pixel(CameraView view, Vector3d? position)
    {
        if (position is not { } seen)
        {
            return (double.NaN, double.NaN);
        }

        view.Camera.TryProject(in seen, out double u, out double v);
        return (u, v);
    }
}
