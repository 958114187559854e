namespace FootballPhysics.Tracks;

/// <summary>A ball seen by a camera: the pixel of its centre.</summary>
public readonly struct PixelPoint
{
    /// <summary>Creates a point.</summary>
    /// <param name="time">The time, in s.</param>
    /// <param name="camera">The index of the camera, from 0.</param>
    /// <param name="u">The pixel to the right.</param>
    /// <param name="v">The pixel downwards.</param>
    /// <param name="noise">The standard deviation of u and of v, in pixels; default 1.</param>
    public PixelPoint(double time, int camera, double u, double v, double noise = 1)
    {
        Time = time;
        Camera = camera;
        U = u;
        V = v;
        Noise = noise;
    }

    /// <summary>The time, in s.</summary>
    public double Time { get; }

    /// <summary>The index of the camera, from 0.</summary>
    public int Camera { get; }

    /// <summary>The pixel to the right.</summary>
    public double U { get; }

    /// <summary>The pixel downwards.</summary>
    public double V { get; }

    /// <summary>The standard deviation of u and of v, in pixels.</summary>
    public double Noise { get; }
}
