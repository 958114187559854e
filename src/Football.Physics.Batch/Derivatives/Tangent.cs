using FootballPhysics.Contacts;

namespace FootballPhysics.Batch;

/// <summary>The derivative of the motion at one time by the launch, J = ∂y/∂y₀.</summary>
/// <remarks>It has the rows of <see cref="MotionVector"/>, and nine columns for the position, velocity and spin of the launch.</remarks>
internal sealed class Tangent
{
    /// <summary>The number of columns: the components of the launch.</summary>
    public const int Columns = 9;

    private const int Rows = MotionVector.Size;
    private const int Mapped = Rows * Columns;
    private const int Length = MotionVector.Whole * Columns;

    private readonly double[] _j = new double[Length];
    private readonly double[] _next = new double[Length];
    private readonly double[] _kept = new double[Length];

    /// <summary>Resets to the launch itself, J = 1.</summary>
    public void Reset()
    {
        Array.Clear(_j, 0, Length);
        for (int i = 0; i < Columns; i++)
        {
            _j[(i * Columns) + i] = 1;
        }
    }

    /// <summary>Saves the current values.</summary>
    public void Keep() => Array.Copy(_j, _kept, Length);

    /// <summary>Restores the saved values.</summary>
    public void Restore() => Array.Copy(_kept, _j, Length);

    /// <summary>Gets one entry.</summary>
    public double this[int row, int column] => _j[(row * Columns) + column];

    /// <summary>Returns a block of three rows and three columns.</summary>
    public Matrix3d Block(int row, int column) => new(Row(row, column), Row(row + 1, column), Row(row + 2, column));

    /// <summary>Returns one column: the derivative of the motion by one component of the launch.</summary>
    public Motion Of(int column) => new(
        Column(0, column), Column(MotionVector.Velocity, column), Column(MotionVector.Spin, column), _j[(MotionVector.AirDistance * Columns) + column], Column(MotionVector.Turn, column));

    /// <summary>Sets a column.</summary>
    public void Set(int column, in Motion value)
    {
        Set(0, column, in value.Position);
        Set(MotionVector.Velocity, column, in value.Velocity);
        Set(MotionVector.Spin, column, in value.Spin);
        _j[(MotionVector.AirDistance * Columns) + column] = value.AirDistance;
        Set(MotionVector.Turn, column, in value.Turn);
    }

    /// <summary>J ← A J, A of ten rows and columns. The turn stays: no event turns the ball.</summary>
    public void Map(double[] a)
    {
        Multiply(a, _j, _next);
        Array.Copy(_next, _j, Mapped);
    }

    /// <summary>J ← J + f ⊗ δt: converts from a fixed time to the time of an event, or back.</summary>
    /// <param name="velocity">v.</param>
    /// <param name="rates">v̇, ω̇.</param>
    /// <param name="times">δt of each column.</param>
    /// <param name="sign">1 or −1.</param>
    public void Shift(in Vector3d velocity, in MotionRates rates, double[] times, double sign)
    {
        for (int c = 0; c < Columns; c++)
        {
            double by = sign * times[c];
            Add(0, c, by * velocity);
            Add(MotionVector.Velocity, c, by * rates.Acceleration);
            Add(MotionVector.Spin, c, by * rates.SpinAcceleration);
            _j[(MotionVector.AirDistance * Columns) + c] += by * rates.AirSpeed;
            Add(MotionVector.Turn, c, by * rates.Turning);
        }
    }

    /// <summary>J ← J + r ⊗ δt, where r is the rate of the motion by time.</summary>
    public void Add(in Motion rate, double[] times)
    {
        for (int c = 0; c < Columns; c++)
        {
            Add(0, c, times[c] * rate.Position);
            Add(MotionVector.Velocity, c, times[c] * rate.Velocity);
            Add(MotionVector.Spin, c, times[c] * rate.Spin);
        }
    }

    /// <summary>Updates J from the start to the end of a plain flight.</summary>
    /// <param name="x">The derivatives of x, apart from δx itself.</param>
    /// <param name="y">The derivatives of y.</param>
    /// <param name="z">The derivatives of z.</param>
    /// <param name="motion">The derivatives of velocity and spin magnitude.</param>
    /// <param name="axis">The axis of the spin.</param>
    /// <param name="first">A unit vector across the axis.</param>
    /// <param name="second">The other unit vector across the axis.</param>
    /// <param name="startSpin">|ω| at the start, rad/s.</param>
    /// <param name="endSpin">|ω| at the end, rad/s.</param>
    public void Fly(
        in FlightRow x,
        in FlightRow y,
        in FlightRow z,
        in FlightColumns motion,
        in Vector3d axis,
        in Vector3d first,
        in Vector3d second,
        double startSpin,
        double endSpin)
    {
        for (int c = 0; c < Columns; c++)
        {
            // δω = δ|ω| n + |ω| δn
            Vector3d velocity = Column(MotionVector.Velocity, c);
            Vector3d spin = Column(MotionVector.Spin, c);
            double byFirst = Vector3d.Dot(in first, in spin) / startSpin;
            double bySecond = Vector3d.Dot(in second, in spin) / startSpin;
            var turned = new Vector3d(Vector3d.Dot(in axis, in spin), byFirst, bySecond);
            Add(0, c, new Vector3d(Of(in x, in velocity, in turned), Of(in y, in velocity, in turned), Of(in z, in velocity, in turned)));
            Set(MotionVector.Velocity, c, new Vector3d(Of(in motion.X, in velocity, in turned), Of(in motion.Y, in velocity, in turned), Of(in motion.Z, in velocity, in turned)));
            Set(MotionVector.Spin, c, (Of(in motion.Spin, in velocity, in turned) * axis) + (endSpin * ((byFirst * first) + (bySecond * second))));
        }
    }

    /// <summary>Computes the derivative of an event's time by the launch: δt = −∇g·δy/ġ.</summary>
    /// <param name="place">∂g/∂p.</param>
    /// <param name="velocity">∂g/∂v.</param>
    /// <param name="spin">∂g/∂ω.</param>
    /// <param name="rate">ġ along the motion.</param>
    /// <param name="times">δt of each column.</param>
    public void Times(in Vector3d place, in Vector3d velocity, in Vector3d spin, double rate, double[] times)
    {
        double scale = -1.0 / rate;
        for (int c = 0; c < Columns; c++)
        {
            times[c] = scale * (Dot(0, c, in place) + Dot(MotionVector.Velocity, c, in velocity) + Dot(MotionVector.Spin, c, in spin));
        }
    }

    /// <summary>Removes the component along a direction from three rows, as when a ball is placed on a surface.</summary>
    public void Project(int row, in Vector3d normal)
    {
        for (int c = 0; c < Columns; c++)
        {
            Add(row, c, -Dot(row, c, in normal) * normal);
        }
    }

    /// <summary>Applies the map of a vanishingly short slide after which the ball rolls.</summary>
    /// <remarks>δv' = δv − δs/(1 + 1/α), δω' = n × δv'/r + (n·δω) n.</remarks>
    /// <param name="normal">n.</param>
    /// <param name="radius">r, m.</param>
    /// <param name="inertiaFactor">α.</param>
    public void Roll(in Vector3d normal, double radius, double inertiaFactor)
    {
        for (int c = 0; c < Columns; c++)
        {
            Vector3d velocity = Column(MotionVector.Velocity, c);
            Vector3d spin = Column(MotionVector.Spin, c);
            velocity -= inertiaFactor / (1.0 + inertiaFactor) * Slip.Of(in velocity, in spin, in normal, radius);
            Set(MotionVector.Velocity, c, in velocity);
            Set(MotionVector.Spin, c, Slip.RollingSpin(in velocity, Vector3d.Dot(in spin, in normal), in normal, radius));
        }
    }

    private static void Multiply(double[] a, double[] b, double[] into)
    {
        Array.Clear(into, 0, Mapped);
        for (int row = 0; row < Rows; row++)
        {
            int at = row * Columns;
            for (int k = 0; k < Rows; k++)
            {
                double factor = a[(row * Rows) + k];
                if (factor == 0)
                {
                    continue;
                }

                int from = k * Columns;
                for (int c = 0; c < Columns; c++)
                {
                    into[at + c] += factor * b[from + c];
                }
            }
        }
    }

    private Vector3d Row(int row, int column)
    {
        int at = (row * Columns) + column;
        return new Vector3d(_j[at], _j[at + 1], _j[at + 2]);
    }

    private double Dot(int row, int column, in Vector3d v)
    {
        int at = (row * Columns) + column;
        return (_j[at] * v.X) + (_j[at + Columns] * v.Y) + (_j[at + (2 * Columns)] * v.Z);
    }

    private static double Of(in FlightRow row, in Vector3d velocity, in Vector3d spin) =>
        Vector3d.Dot(in row.ByVelocity, in velocity) + Vector3d.Dot(in row.BySpin, in spin);

    private Vector3d Column(int row, int column)
    {
        int at = (row * Columns) + column;
        return new Vector3d(_j[at], _j[at + Columns], _j[at + (2 * Columns)]);
    }

    private void Set(int row, int column, in Vector3d v)
    {
        int at = (row * Columns) + column;
        _j[at] = v.X;
        _j[at + Columns] = v.Y;
        _j[at + (2 * Columns)] = v.Z;
    }

    private void Add(int row, int column, in Vector3d v)
    {
        int at = (row * Columns) + column;
        _j[at] += v.X;
        _j[at + Columns] += v.Y;
        _j[at + (2 * Columns)] += v.Z;
    }
}
