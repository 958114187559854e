namespace FootballPhysics.Live;

/// <summary>A position on a path ahead, and its standard deviation per axis, in m.</summary>
internal readonly record struct Ahead(double Time, double X, double Y, double Z, double Deviation)
{
    public static Ahead At(double time, Vector3d position, double deviation) =>
        new(Rounded(time), Rounded(position.X), Rounded(position.Y), Rounded(position.Z), Rounded(deviation));

    private static double Rounded(double value) => Math.Round(value, 3);
}

/// <summary>The kick that the filter believes in: its time and the standard deviation of the time, in s.</summary>
internal sealed record FoundKick(double Time, double Deviation);

/// <summary>The picture that the page draws: one message of the stream.</summary>
/// <param name="Time">The time, in s.</param>
/// <param name="Truth">The true position.</param>
/// <param name="Seen">For each camera, true if it sees the ball.</param>
/// <param name="Motion">The motion that the filter estimates; null before the first point.</param>
/// <param name="Speed">The speed that the filter estimates, in m/s.</param>
/// <param name="Kick">The kick of the last 0.5 s; null without one.</param>
/// <param name="IsOutlier">True if the last pixel does not fit.</param>
/// <param name="Path">The path ahead that the filter predicts, from now on.</param>
/// <param name="Line">The path ahead of the filter with constant velocity.</param>
/// <param name="Error">The error of the position 0.5 s ahead so far, root mean square, in m: of the filter.</param>
/// <param name="LineError">That of the filter with constant velocity.</param>
/// <param name="Kicks">The number of kicks found so far.</param>
internal sealed record Frame(
    double Time, Ahead Truth, bool[] Seen, string? Motion, double Speed, FoundKick? Kick, bool IsOutlier, Ahead[] Path, Ahead[] Line, double Error, double LineError, int Kicks);
