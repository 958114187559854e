namespace FootballPhysics.Batch;

/// <summary>A motion as numbers in a row: place 0 … 2, velocity 3 … 5, spin 6 … 8, distance flown 9.</summary>
internal static class MotionVector
{
    /// <summary>How many numbers a motion has.</summary>
    public const int Size = 10;

    /// <summary>Index of the first component of the velocity.</summary>
    public const int Velocity = 3;

    /// <summary>Index of the first component of the spin.</summary>
    public const int Spin = 6;

    /// <summary>Index of the distance flown.</summary>
    public const int AirDistance = 9;

    /// <summary>The motion of a ball.</summary>
    public static Motion Of(in BallState s) => new(s.Position, s.Velocity, s.Spin, s.AirDistance);

    /// <summary>A motion of which one number is changed.</summary>
    public static Motion Changed(in Motion at, int index, double by) => new(
        at.Position + Unit(index, by),
        at.Velocity + Unit(index - Velocity, by),
        at.Spin + Unit(index - Spin, by),
        at.AirDistance + (index == AirDistance ? by : 0));

    /// <summary>a x + b y.</summary>
    public static Motion Sum(double a, in Motion x, double b, in Motion y) => new(
        (a * x.Position) + (b * y.Position), (a * x.Velocity) + (b * y.Velocity), (a * x.Spin) + (b * y.Spin), (a * x.AirDistance) + (b * y.AirDistance));

    /// <summary>A ball with another motion.</summary>
    public static BallState With(in BallState s, in Motion motion)
    {
        BallState changed = s;
        changed.Position = motion.Position;
        changed.Velocity = motion.Velocity;
        changed.AirDistance = motion.AirDistance;

        // What was found to be far from its way need not be far from another.
        changed.ClearUntil = 0;
        if (s.Motion == MotionState.Airborne)
        {
            changed.SetFlightSpin(motion.Spin);
        }
        else
        {
            changed.SetGroundSpin(motion.Spin);
        }

        return changed;
    }

    /// <summary>Writes a motion's difference quotient into a column of a matrix.</summary>
    public static void Write(double[] matrix, int column, in Motion high, in Motion low, double width)
    {
        double perWidth = 1.0 / width;
        Write(matrix, 0, column, perWidth * (high.Position - low.Position));
        Write(matrix, Velocity, column, perWidth * (high.Velocity - low.Velocity));
        Write(matrix, Spin, column, perWidth * (high.Spin - low.Spin));
        matrix[(AirDistance * Size) + column] = perWidth * (high.AirDistance - low.AirDistance);
    }

    /// <summary>Writes three numbers into a column of a matrix.</summary>
    private static void Write(double[] matrix, int row, int column, in Vector3d value)
    {
        matrix[(row * Size) + column] = value.X;
        matrix[((row + 1) * Size) + column] = value.Y;
        matrix[((row + 2) * Size) + column] = value.Z;
    }

    /// <summary>How much to change a number for a difference quotient that is right to about ten digits.</summary>
    public static double Width(in Motion at, int index) =>
        index < Velocity ? 5e-6 : index < Spin ? 1e-5 * (1.0 + at.Velocity.Length) : index < AirDistance ? 1e-5 * (1.0 + at.Spin.Length) : 1e-5;

    private static Vector3d Unit(int index, double by) => new(index == 0 ? by : 0, index == 1 ? by : 0, index == 2 ? by : 0);
}
