namespace FootballPhysics.Batch;

/// <summary>A motion as a vector of numbers: position 0 … 2, velocity 3 … 5, spin 6 … 8, distance flown 9, turn of the orientation 10 … 12.</summary>
/// <remarks>The turn is a small rotation in the frame of the world. Only <see cref="StepDifferences"/> needs it: plain flight and impacts do not depend on it.</remarks>
internal static class MotionVector
{
    /// <summary>The number of components without the turn.</summary>
    public const int Size = 10;

    /// <summary>The number of all components.</summary>
    public const int Whole = 13;

    /// <summary>The index of the first component of the velocity.</summary>
    public const int Velocity = 3;

    /// <summary>The index of the first component of the spin.</summary>
    public const int Spin = 6;

    /// <summary>The index of the distance flown.</summary>
    public const int AirDistance = 9;

    /// <summary>The index of the first component of the turn.</summary>
    public const int Turn = 10;

    /// <summary>Returns the motion of a ball.</summary>
    public static Motion Of(in BallState s) => new(s.Position, s.Velocity, s.Spin, s.AirDistance);

    /// <summary>Returns a motion with one changed component.</summary>
    public static Motion Changed(in Motion at, int index, double by) => new(
        at.Position + Unit(index, by),
        at.Velocity + Unit(index - Velocity, by),
        at.Spin + Unit(index - Spin, by),
        at.AirDistance + (index == AirDistance ? by : 0));

    /// <summary>Returns a x + b y.</summary>
    public static Motion Sum(double a, in Motion x, double b, in Motion y) => new(
        (a * x.Position) + (b * y.Position), (a * x.Velocity) + (b * y.Velocity), (a * x.Spin) + (b * y.Spin), (a * x.AirDistance) + (b * y.AirDistance),
        (a * x.Turn) + (b * y.Turn));

    /// <summary>Returns a ball with another motion.</summary>
    public static BallState With(in BallState s, in Motion motion)
    {
        BallState changed = s;
        changed.Position = motion.Position;
        changed.Velocity = motion.Velocity;
        changed.AirDistance = motion.AirDistance;

        // The search for a free path does not hold for another motion.
        changed.ClearUntil = 0;
        if (s.Motion == MotionState.Airborne)
        {
            changed.SetFlightSpin(motion.Spin);
        }
        else
        {
            changed.SetGroundSpin(motion.Spin);
        }

        // The new spin has set the angle to 0.
        if (motion.Turn != Vector3d.Zero)
        {
            changed.BaseOrientation = changed.BaseOrientation.Turned(in motion.Turn);
        }

        return changed;
    }

    /// <summary>Writes a difference quotient of a motion into a column of a matrix.</summary>
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

    /// <summary>Returns the change of a component that makes a difference quotient accurate to about ten digits.</summary>
    public static double Width(in Motion at, int index) =>
        index < Velocity ? 5e-6 : index < Spin ? 1e-5 * (1.0 + at.Velocity.Length) : index < AirDistance ? 1e-5 * (1.0 + at.Spin.Length) : 1e-5;

    private static Vector3d Unit(int index, double by) => new(index == 0 ? by : 0, index == 1 ? by : 0, index == 2 ? by : 0);
}
