using FootballPhysics.Tool.Fit;

namespace FootballPhysics.Labs.Following;

/// <summary>Predicts positions of real tracks: the filter, next to a constant velocity and a parabola.</summary>
internal static class FollowReal
{
    private static readonly double[] Aheads = [0.5, 1];

    /// <summary>The number of points that the simple filters fit, and that each flight has before it is judged.</summary>
    private const int Points = 10;

    /// <summary>The greatest difference between the time of a point and the time ahead, s: half an interval at 25 Hz.</summary>
    private const double Near = 0.0201;

    /// <summary>Adds the rows of a track.</summary>
    public static void Add(string file, double noise, LabTable table, LabRun run)
    {
        using FileStream stream = File.OpenRead(file);
        TrackPoint[] track = TrackReader.Read(stream, run.Terminal.Person.WriteLine);
        var scene = new Scene { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) };
        MatchPiece[] flights = [.. new MatchFit(scene).Find(track).Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight)];
        var filter = new BallFilter(scene, new BallFilterSettings { Noise = noise });
        var path = new Trajectory();
        var squares = new double[Aheads.Length, 3];
        var counts = new int[Aheads.Length];
        for (int i = 0; i < track.Length; i++)
        {
            filter.Update(track[i].Time, track[i].Position);
            MatchPiece? flight = Array.Find(flights, piece => piece.StartTime <= track[i].Time && piece.EndTime >= track[i].Time);
            if (flight is null || i < Points || track[i - Points + 1].Time < flight.StartTime)
            {
                continue;
            }

            filter.LookAhead(Aheads[^1] + Near, path);
            for (int k = 0; k < Aheads.Length; k++)
            {
                double time = track[i].Time + Aheads[k];
                int at = Array.FindIndex(track, i, point => Math.Abs(point.Time - time) <= Near);
                if (time > flight.EndTime || at < 0)
                {
                    continue;
                }

                time = Math.Min(track[at].Time, path.EndTime);
                counts[k]++;
                squares[k, 0] += (path.PositionAt(time) - track[at].Position).LengthSquared;
                squares[k, 1] += (Line(track, i, time, 0) - track[at].Position).LengthSquared;
                squares[k, 2] += (Line(track, i, time, scene.Gravity) - track[at].Position).LengthSquared;
            }
        }

        for (int k = 0; k < Aheads.Length; k++)
        {
            double Rms(int of) => Math.Sqrt(squares[k, of] / counts[k]);
            table.Add(Path.GetFileName(file), Aheads[k], flights.Length, counts[k], Rms(0), Rms(1), Rms(2));
        }
    }

    /// <summary>Extends a least-squares line, or a parabola of a known gravity, through the last points.</summary>
    private static Vector3d Line(TrackPoint[] track, int last, double time, double gravity)
    {
        Vector3d mean = Vector3d.Zero;
        double middle = 0;
        for (int i = last - Points + 1; i <= last; i++)
        {
            mean += Straight(i) / Points;
            middle += track[i].Time / Points;
        }

        Vector3d slope = Vector3d.Zero;
        double spread = 0;
        for (int i = last - Points + 1; i <= last; i++)
        {
            double off = track[i].Time - middle;
            slope += off * (Straight(i) - mean);
            spread += off * off;
        }

        double fall = time - track[last].Time;
        return mean + ((time - middle) / spread * slope) - (0.5 * gravity * fall * fall * Vector3d.Up);

        Vector3d Straight(int i)
        {
            double before = track[i].Time - track[last].Time;
            return track[i].Position + (0.5 * gravity * before * before * Vector3d.Up);
        }
    }
}
