using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Cameras;

/// <summary>A camera of the input, and the size of its image, in pixels.</summary>
internal sealed record CameraView(TrackCamera Camera, double Width, double Height)
{
    private const string SizeForm = "[width, height]";

    private static readonly double[] s_size = [1920, 1080];

    /// <summary>Reads the list "cameras". Call <see cref="InputFields.Check"/> afterwards.</summary>
    public static CameraView[] Take(InputObject root) => [.. root.Objects("cameras").Select(Of).OfType<CameraView>()];

    /// <summary>True if a pixel is inside the image.</summary>
    public bool Contains(double u, double v) => u >= 0 && u <= Width && v >= 0 && v <= Height;

    /// <summary>Creates a camera from its matrix, or from its position, target and focal length; returns null if the library rejects it.</summary>
    private static CameraView? Of(InputObject from)
    {
        double[] size = from.Numbers("size", SizeForm, s_size);
        TrackCamera? camera;
        if (from.Has("matrix"))
        {
            from.Exclude("position", "matrix");
            from.Exclude("target", "matrix");
            from.Exclude("focalLength", "matrix");
            camera = from.Table("matrix") is { } matrix ? from.Make(() => new TrackCamera([.. matrix.Cast<double>()])) : null;
        }
        else
        {
            Vector3d position = from.Vector("position");
            Vector3d target = from.Vector("target");
            double focalLength = from.Number("focalLength");
            camera = from.Make(() => TrackCamera.LookingAt(position, target, focalLength, size[0], size[1]));
        }

        return camera is null ? null : new CameraView(camera, size[0], size[1]);
    }
}
