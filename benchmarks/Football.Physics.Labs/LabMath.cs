namespace FootballPhysics.Labs;

/// <summary>Small computations that the laboratories share. Those that a reference uses do not call the library's contacts.</summary>
internal static class LabMath
{
    /// <summary>Returns a number between two bounds.</summary>
    public static double Between(this Random random, double low, double high) => low + ((high - low) * random.NextDouble());

    /// <summary>Returns a number of a normal distribution.</summary>
    public static double Normal(this SeededRandom random, double mean = 0, double deviation = 1) =>
        mean + (deviation * Math.Sqrt(-2 * Math.Log(1 - random.Next())) * Math.Cos(2 * Math.PI * random.Next()));

    /// <summary>Returns a vector without its part along a normal.</summary>
    public static Vector3d Along(in Vector3d v, in Vector3d normal) => v - (Vector3d.Dot(v, normal) * normal);

    /// <summary>Returns the rotation that turns the vertical into a normal.</summary>
    public static Quaterniond Upright(in Vector3d normal)
    {
        Vector3d axis = Vector3d.Cross(Vector3d.Up, normal);
        double sine = axis.Length;
        return sine < 1e-15 ? Quaterniond.Identity : Quaterniond.FromAxisAngle(axis / sine, Math.Atan2(sine, normal.Y));
    }

    /// <summary>Returns a square height field.</summary>
    /// <param name="x">The first x, m.</param>
    /// <param name="z">The first z, m.</param>
    /// <param name="spacing">The distance between two heights, m.</param>
    /// <param name="count">The number of heights along x and along z.</param>
    /// <param name="height">Returns a height by its indices along x and z, m.</param>
    public static HeightField Hills(double x, double z, double spacing, int count, Func<int, int, double> height)
    {
        var values = new double[count, count];
        for (int i = 0; i < count * count; i++)
        {
            values[i / count, i % count] = height(i / count, i % count);
        }

        return HeightField.FromControlValues(x, z, spacing, values);
    }

    /// <summary>Returns the number from which on a condition holds, by bisection.</summary>
    /// <param name="low">A number at which it does not hold.</param>
    /// <param name="high">A larger number at which it holds.</param>
    /// <param name="holds">The condition.</param>
    /// <param name="closeness">The largest error; default: that of 40 halvings.</param>
    public static double Bisect(double low, double high, Func<double, bool> holds, double closeness = 0)
    {
        for (int i = 0; closeness > 0 ? high - low > closeness : i < 40; i++)
        {
            double middle = 0.5 * (low + high);
            (low, high) = holds(middle) ? (low, middle) : (middle, high);
        }

        return high;
    }

    /// <summary>Returns the number of events of a kind.</summary>
    public static int Count(this EventBuffer events, BallEventKind kind) => events.Span.ToArray().Count(item => item.Kind == kind);

    /// <summary>Launches a ball and simulates it to an end.</summary>
    public static BallState Fly(
        this Simulator simulator, in Vector3d position, in Vector3d velocity, in Vector3d spin, double step, double duration, StopAt stopAt, StepLog? log = null)
    {
        BallState ball = simulator.Launch(position, velocity, spin);
        simulator.Run(ref ball, step, duration, stopAt, log ?? new StepLog());
        return ball;
    }

    /// <summary>Launches a ball and returns its first impact.</summary>
    public static BallEvent FirstImpact(this Simulator simulator, in Vector3d position, in Vector3d velocity, in Vector3d spin, double step, double duration)
    {
        var log = new StepLog();
        simulator.Fly(position, velocity, spin, step, duration, StopAt.Impact, log);
        return log.Events[0];
    }
}
