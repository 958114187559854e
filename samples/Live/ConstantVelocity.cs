using FootballPhysics.Tracks;

namespace FootballPhysics.Live;

/// <summary>The filter that most trackers have: an extended Kalman filter of position and velocity, to which bounces and kicks are noise.</summary>
internal sealed class ConstantVelocity
{
    private const int Size = 6;

    /// <summary>The spectral density of the acceleration, in m²/s³: of the values tried, that with the smallest error 0.5 s ahead.</summary>
    private const double Acceleration = 300;

    /// <summary>A pixel that is this many standard deviations off is ignored, unless as many pictures in a row are off.</summary>
    private const double Gate = 5;
    private const int Patience = 3;

    /// <summary>The standard deviation of the velocity at the start and after a lost ball, in m/s.</summary>
    private const double AnySpeed = 13;

    private readonly double[] _x = new double[Size];
    private readonly double[,] _p = new double[Size, Size];
    private readonly double[,] _next = new double[Size, Size];
    private readonly double[] _gain = new double[Size];
    private int _rejected;

    /// <summary>The time of the estimate, in s.</summary>
    public double Time { get; private set; }

    public bool HasEstimate { get; private set; }

    public Vector3d Velocity => new(_x[3], _x[4], _x[5]);

    public Vector3d PositionAt(double time) => new Vector3d(_x[0], _x[1], _x[2]) + ((time - Time) * Velocity);

    /// <summary>Includes the pixels of a picture.</summary>
    public void Update(Picture picture)
    {
        if (!HasEstimate)
        {
            Start(picture);
            return;
        }

        if (!Array.Exists(picture.Pixels, pixel => pixel is not null))
        {
            return;
        }

        Predict(picture.Time - Time);
        Time = picture.Time;
        bool rejects = false;
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            if (picture.Pixels[i] is { } pixel)
            {
                rejects |= !Include(Feed.Cameras[i], pixel);
            }
        }

        _rejected = rejects ? _rejected + 1 : 0;
        if (_rejected >= Patience)
        {
            // Lost: take the next pixels as they are.
            for (int i = 0; i < Size; i++)
            {
                _p[i, i] += i < 3 ? 1 : AnySpeed * AnySpeed;
            }

            _rejected = 0;
        }
    }

    /// <summary>Starts at the position that all cameras see: the least squares of their linear equations.</summary>
    private void Start(Picture picture)
    {
        if (Array.Exists(picture.Pixels, pixel => pixel is null))
        {
            return;
        }

        Vector3d x = Vector3d.Zero;
        Vector3d y = Vector3d.Zero;
        Vector3d z = Vector3d.Zero;
        Vector3d right = Vector3d.Zero;
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            IReadOnlyList<double> m = Feed.Cameras[i].Matrix;
            Pixel pixel = picture.Pixels[i]!.Value;
            for (int row = 0; row < 2; row++)
            {
                double seen = row == 0 ? pixel.U : pixel.V;
                var a = new Vector3d(m[4 * row] - (seen * m[8]), m[(4 * row) + 1] - (seen * m[9]), m[(4 * row) + 2] - (seen * m[10]));
                double b = (seen * m[11]) - m[(4 * row) + 3];
                (x, y, z, right) = (x + (a.X * a), y + (a.Y * a), z + (a.Z * a), right + (b * a));
            }
        }

        Vector3d normal = Vector3d.Cross(y, z);
        double determinant = Vector3d.Dot(x, normal);
        _x[0] = Vector3d.Dot(right, normal) / determinant;
        _x[1] = Vector3d.Dot(right, Vector3d.Cross(z, x)) / determinant;
        _x[2] = Vector3d.Dot(right, Vector3d.Cross(x, y)) / determinant;
        for (int i = 0; i < Size; i++)
        {
            _p[i, i] = i < 3 ? 0.01 : AnySpeed * AnySpeed;
        }

        (Time, HasEstimate) = (picture.Time, true);
    }

    private void Predict(double time)
    {
        for (int i = 0; i < 3; i++)
        {
            _x[i] += time * _x[i + 3];
        }

        // P = F P Fᵀ + Q, where F adds the velocity times the time to the position.
        for (int i = 0; i < Size; i++)
        {
            for (int j = 0; j < Size; j++)
            {
                double sum = _p[i, j];
                sum += i < 3 ? time * _p[i + 3, j] : 0;
                sum += j < 3 ? time * _p[i, j + 3] : 0;
                sum += i < 3 && j < 3 ? time * time * _p[i + 3, j + 3] : 0;
                bool isSameAxis = i % 3 == j % 3;
                double noise = (i < 3, j < 3) switch { (true, true) => time * time * time / 3, (false, false) => time, _ => time * time / 2 };
                _next[i, j] = sum + (isSameAxis ? Acceleration * noise : 0);
            }
        }

        Array.Copy(_next, _p, _p.Length);
    }

    /// <summary>Includes a pixel.</summary>
    /// <returns>False if it is too far off.</returns>
    private bool Include(TrackCamera camera, Pixel pixel)
    {
        IReadOnlyList<double> m = camera.Matrix;
        double depth = Along(8);
        (double u, double v) = (Along(0) / depth, Along(4) / depth);
        Span<double> across = stackalloc double[3];
        Span<double> down = stackalloc double[3];
        for (int k = 0; k < 3; k++)
        {
            across[k] = (m[k] - (u * m[8 + k])) / depth;
            down[k] = (m[4 + k] - (v * m[8 + k])) / depth;
        }

        double most = Gate * Gate;
        if (Square(pixel.U - u, across) > most || Square(pixel.V - v, down) > most)
        {
            return false;
        }

        double moved = Correct(pixel.U - u, across, down);
        Correct(pixel.V - v - moved, down, down);
        return true;

        double Along(int row) => (m[row] * _x[0]) + (m[row + 1] * _x[1]) + (m[row + 2] * _x[2]) + m[row + 3];
    }

    private double Square(double residual, ReadOnlySpan<double> row) => residual * residual / Variance(row);

    private double Variance(ReadOnlySpan<double> row)
    {
        double sum = Feed.Noise * Feed.Noise;
        for (int i = 0; i < 3; i++)
        {
            for (int j = 0; j < 3; j++)
            {
                sum += row[i] * _p[i, j] * row[j];
            }
        }

        return sum;
    }

    /// <summary>Includes a coordinate.</summary>
    /// <returns>The change of another coordinate, whose derivatives are <paramref name="other"/>.</returns>
    private double Correct(double residual, ReadOnlySpan<double> row, ReadOnlySpan<double> other)
    {
        double inverse = 1 / Variance(row);
        for (int i = 0; i < Size; i++)
        {
            _gain[i] = (_p[i, 0] * row[0]) + (_p[i, 1] * row[1]) + (_p[i, 2] * row[2]);
        }

        double moved = 0;
        for (int i = 0; i < Size; i++)
        {
            double change = inverse * _gain[i] * residual;
            _x[i] += change;
            moved += i < 3 ? other[i] * change : 0;
            for (int j = 0; j < Size; j++)
            {
                _p[i, j] -= inverse * _gain[i] * _gain[j];
            }
        }

        return moved;
    }
}
