namespace FootballPhysics.Tracks;

/// <summary>The starts of searches for a flight that is seen from one viewpoint.</summary>
/// <remarks>Few of the minima are near the truth. A ball at a wrong depth with a strong spin can fit the first points. A path with bounces at other times has its own minimum. From one viewpoint, a curl towards the camera can also fit as well as one away from it.</remarks>
internal static class OneViewStarts
{
    /// <summary>The number of starts with other spins, and half the edge of a cube of spins, in rad/s.</summary>
    private const int Tried = 8;
    private const double Corner = 20;

    /// <summary>The durations of the first points that are fitted one after the other, in s, and their minimum number.</summary>
    private static readonly double[] s_spans = [0.4, 0.8, 1.6, double.PositiveInfinity];
    private const int Fewest = 10;

    /// <summary>The standard deviation of the launch height above the ground in the search from the first points, in m.</summary>
    private const double Reach = 1;

    /// <summary>Returns the starts, given the result of the first search.</summary>
    public static IEnumerable<double[]?> Of(Sightings seen, TrackFitRequest launch, Scene scene, double[] values, FitWatch watch)
    {
        yield return Grown(seen, launch with { HeightDeviation = Reach }, scene, watch);
        if (!launch.FromGround)
        {
            yield return Grown(seen, launch with { FromGround = true }, scene, watch);
        }

        var found = new Vector3d(values[6], values[7], values[8]);
        List<Vector3d> spins = [.. TrackFit.OtherSpins(values, launch), found - (2 * found.Y * Vector3d.Up), -found];
        for (int i = 0; i < 8; i++)
        {
            spins.Add(launch.Spin + (Corner * new Vector3d((i & 1) == 0 ? -1 : 1, (i & 2) == 0 ? -1 : 1, (i & 4) == 0 ? -1 : 1)));
        }

        var starts = new double[]?[spins.Count];
        double[] costs = new double[spins.Count];
        for (int i = 0; i < starts.Length; i++)
        {
            Vector3d spin = spins[i];
            starts[i] = seen.Start(launch, in spin, scene, out costs[i]);
        }

        Array.Sort(costs, starts);
        for (int i = 0; i < Tried; i++)
        {
            yield return starts[i];
        }
    }

    /// <summary>Fits the first points with a launch near the ground, and then increasingly more points.</summary>
    private static double[]? Grown(Sightings seen, TrackFitRequest launch, Scene scene, FitWatch watch)
    {
        var model = new TrackModel(scene, launch);
        double[]? values = null;
        int before = 0;
        foreach (double span in s_spans)
        {
            int count = before;
            while (count < seen.Count && (count < Fewest || seen.Time(count) - seen.Time(0) <= span))
            {
                count++;
            }

            if (count == before)
            {
                continue;
            }

            before = count;
            Sightings first = seen.First(count);
            values ??= first.Start(launch, launch.Spin, scene, out _);
            if (values is null)
            {
                return null;
            }

            new TrackSearch(first, launch, model, watch).Descend(values);
        }

        return values;
    }
}
