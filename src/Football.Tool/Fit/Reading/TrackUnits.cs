using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>The positions of a track in the library's coordinates, in m.</summary>
/// <param name="Places">The positions.</param>
/// <param name="IsGuessed">True if neither the file nor the user states that the unit is the metre.</param>
/// <param name="IsShare">True if all coordinates were within 0 … 100 as written.</param>
internal sealed record TrackReading(Vector3d[] Places, bool IsGuessed, bool IsShare)
{
    public TrackPoint[] Points { get; init; } = [];
}

/// <summary>Finds the unit and the axes of a track's coordinates: as given, as stated in the header, or from the ball's fall in flight.</summary>
internal sealed class TrackUnits
{
    /// <summary>The range of the fall in the correct unit, as shares of g. Drag and lift change the fall by less, a wrong unit by more.</summary>
    private const double LeastShare = 0.5;
    private const double MostShare = 1.55;

    /// <summary>The limits of a ball: a speed that it exceeds in less than a twentieth of its track, in m/s, and the size of a pitch, in m.</summary>
    private const double MostSpeed = 75;
    private const double MostExtent = 1000;

    private const string Insist = "or --unit m if these are metres";

    private static readonly string[] s_likely = ["m", "ft", "in", "cm", "mm", "km"];

    private readonly TrackFormat _format;
    private readonly string?[] _stated;
    private readonly double[] _times;
    private readonly double[][] _places;
    private readonly Action<string> _report;

    private TrackUnits(TrackFormat format, string?[] stated, double[] times, double[][] places, Action<string> report)
    {
        _format = format;
        _stated = stated;
        _times = times;
        _places = places;
        _report = report;
    }

    /// <summary>Converts positions to the library's coordinates, in m.</summary>
    /// <param name="format">The given properties.</param>
    /// <param name="stated">The units that the header states; null for unknown ones.</param>
    /// <param name="times">The times, in s.</param>
    /// <param name="places">The columns x, y and z as written.</param>
    /// <param name="gravity">The gravity g, in m/s².</param>
    /// <param name="report">Receives guesses.</param>
    /// <exception cref="RefusedException">The coordinates cannot be metres, and the unit is not certain.</exception>
    public static TrackReading Convert(TrackFormat format, string?[] stated, double[] times, double[][] places, double gravity, Action<string> report)
    {
        var units = new TrackUnits(format, stated, times, places, report);
        bool isYUp = units.IsYUp(out TrackFall fall);
        double[] scales = units.Scales(isYUp, fall, gravity);
        units.Check(scales, isYUp);
        bool isRight = format.IsYDown ?? isYUp;
        if (format.IsYDown is null)
        {
            string across = isYUp ? "z" : "y";
            report($"guessed: {across} points to the {(isRight ? "right" : "left")} of x. A track does not show that; --y {(isRight ? "left" : "right")} if not, else sidespins are mirrored.");
        }

        var converted = new Vector3d[times.Length];
        for (int i = 0; i < converted.Length; i++)
        {
            double up = isYUp ? scales[1] * places[1][i] : scales[2] * places[2][i];
            double across = isYUp ? scales[2] * places[2][i] : scales[1] * places[1][i];
            converted[i] = new Vector3d(scales[0] * places[0][i], up, isRight ? across : -across);
        }

        (double xLeast, double xMost) = Percentiles(places[0]);
        (double yLeast, double yMost) = Percentiles(places[isYUp ? 2 : 1]);
        bool isShare = Math.Min(xLeast, yLeast) >= -2 && Math.Max(xMost, yMost) <= 102;
        return new TrackReading(converted, format.Unit is null && Array.TrueForAll(stated, unit => unit is null) && scales[0] == 1, isShare);
    }

    /// <summary>True if the ball falls along y.</summary>
    private bool IsYUp(out TrackFall fall)
    {
        TrackFall z = TrackFall.Of(_times, _places[2]);
        if (!z.IsSure && _format.IsYUp != true)
        {
            // Heights may count downwards: the impacts are then at the top.
            TrackFall down = TrackFall.Of(_times, [.. _places[2].Select(value => -value)]);
            z = down is { IsSure: true, Fall: > 0 } ? down with { Fall = -down.Fall } : z;
        }

        TrackFall y = TrackFall.Of(_times, _places[1]);
        if (_format.IsYUp is { } given)
        {
            fall = given ? y : z;
            return given;
        }

        // Drag slows a coordinate along the pitch in either direction, so its parabolas do not agree.
        bool isYUp = !z.IsSure && y is { Fall: > 0, Windows: >= 10, Spread: < 0.5 };
        if (isYUp)
        {
            _report("guessed: y points up, because the ball falls along it; --up z if not.");
        }

        fall = isYUp ? y : z;
        return isYUp;
    }

    private double[] Scales(bool isYUp, TrackFall fall, double gravity)
    {
        int up = isYUp ? 1 : 2;
        int across = isYUp ? 2 : 1;
        if (_format.Unit is "pitch" or "percent")
        {
            (double length, double width) = _format.Pitch ?? (105, 68);
            double part = _format.Unit == "pitch" ? 1 : 0.01;
            double[] pitch = [length * part, 1, 1];
            pitch[across] = width * part;
            RefuseFall(fall, gravity);
            if (_format.Pitch is null)
            {
                _report("guessed: the pitch is 105 x 68 m; --pitch LENGTHxWIDTH if not.");
            }

            return pitch;
        }

        if (_format.Unit is null && _stated[0] is null && _stated[across] is null)
        {
            RefuseShares(across);
        }

        string? known = _format.Unit ?? _stated[up];
        if (known is not null)
        {
            double metres = TrackFormat.Metres(known)!.Value;
            RefuseFall(fall with { Fall = metres * fall.Fall }, gravity);
            if (_format.Unit is null && Array.Exists(_stated, unit => unit is null))
            {
                _report("guessed: positions whose unit the header does not state are metres; --unit gives one unit for all.");
            }

            return [.. _stated.Select(unit => TrackFormat.Metres(_format.Unit ?? unit ?? "m")!.Value)];
        }

        string unit = Found(fall, gravity);
        return [.. _stated.Select(stated => TrackFormat.Metres(stated ?? unit)!.Value)];
    }

    /// <summary>Returns the unit in which the ball falls with about g.</summary>
    private string Found(TrackFall fall, double gravity)
    {
        if (!fall.IsSure || !(gravity > 0))
        {
            _report("guessed: positions are metres; no flight is clear enough to check that, --unit gives another unit.");
            return "m";
        }

        RefuseDown(fall);
        double Ratio(string likely) => TrackFormat.Metres(likely)!.Value * fall.Fall / gravity;
        string unit = s_likely.MinBy(likely => Math.Abs(Math.Log(Ratio(likely))))!;
        if (Ratio(unit) is < LeastShare or > MostShare)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"The ball falls at {fall.Fall:0.###} units of length per unit of time squared in TRACK, which is no known unit. Give --unit, and --time-unit or --rate if times are not seconds."));
        }

        _report(unit == "m"
            ? FormattableString.Invariant($"guessed: positions are metres; the ball falls at {fall.Fall:0.0} m/s² in flight, air included. --unit gives another unit.")
            : FormattableString.Invariant($"guessed: positions are {unit}, because the ball falls at {fall.Fall:0.#} {unit}/s²; --unit gives another unit."));
        return unit;
    }

    private void RefuseDown(TrackFall fall)
    {
        if (fall.Fall < 0)
        {
            throw new RefusedException("The ball falls upwards in TRACK: its heights count downwards. Write them with the opposite sign.");
        }
    }

    /// <summary>Throws if the ball does not fall with about g in the given unit.</summary>
    private void RefuseFall(TrackFall metres, double gravity)
    {
        if (!metres.IsSure || !(gravity > 0))
        {
            return;
        }

        RefuseDown(metres);
        if (metres.Fall / gravity is < LeastShare or > MostShare)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"The ball falls at {metres.Fall:0.###} m/s² in TRACK with the units given or stated in its header; g is {gravity}. Check --unit, the header's units, and --time-unit or --rate."));
        }
    }

    /// <summary>Throws if the positions are shares of a pitch.</summary>
    private void RefuseShares(int across)
    {
        (double xLeast, double xMost) = Extent(_places[0]);
        (double yLeast, double yMost) = Extent(_places[across]);
        double least = Math.Min(xLeast, yLeast);
        double most = Math.Max(xMost, yMost);
        double span = Math.Max(xMost - xLeast, yMost - yLeast);
        if (least >= -0.1 && most <= 1.1 && span > 0.25)
        {
            throw new RefusedException($"All positions of TRACK are within 0 … 1: shares of a pitch. Give --unit pitch --pitch 105x68 with --y right (y counted from the top, as kloppy does) or --y left, {Insist}.");
        }

        if (least >= -1.1 && most <= 1.1 && span > 0.5)
        {
            throw new RefusedException($"All positions of TRACK are within -1 … 1: shares of half a pitch. Give --unit pitch with half the --pitch, such as 52.5x34, and --y right or --y left, {Insist}.");
        }
    }

    /// <summary>Throws if the ball moves impossibly fast or far.</summary>
    private void Check(double[] scales, bool isYUp)
    {
        int across = isYUp ? 2 : 1;
        List<double> speeds = [];
        for (int i = 1; i < _times.Length; i++)
        {
            double x = scales[0] * (_places[0][i] - _places[0][i - 1]);
            double y = scales[across] * (_places[across][i] - _places[across][i - 1]);
            if (_times[i] > _times[i - 1])
            {
                speeds.Add(Math.Sqrt((x * x) + (y * y)) / (_times[i] - _times[i - 1]));
            }
        }

        speeds.Sort();
        double fast = speeds.Count > 0 ? speeds[19 * (speeds.Count - 1) / 20] : 0;
        (double xLeast, double xMost) = Percentiles(_places[0]);
        (double yLeast, double yMost) = Percentiles(_places[across]);
        double extent = Math.Max(scales[0] * (xMost - xLeast), scales[across] * (yMost - yLeast));
        bool isGuessed = _format.Unit is null && Array.Exists(_stated, unit => unit is null);
        if (fast > MostSpeed || extent > MostExtent)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"The ball moves at {fast:0} m/s over {extent:0} m in TRACK: its positions or times have another unit. Give --unit m | cm | mm | ft | yd | in | pitch | percent, and --time-unit or --rate."));
        }

        int up = isYUp ? 1 : 2;
        (double low, double high) = Percentiles(_places[up]);
        double height = scales[up] * (high - low);
        if (isGuessed && scales[up] != 1 && extent < height)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"The ball moves over {extent:0.00} m and rises over {height:0.00} m in TRACK: heights and positions have different units. State each in the header, such as x_m and z_cm, or give --unit."));
        }
    }

    private static (double Least, double Most) Extent(double[] values) => values.Length > 0 ? (values.Min(), values.Max()) : (0, 0);

    /// <summary>Returns approximately the minimum and the maximum, without a few outliers.</summary>
    private static (double Least, double Most) Percentiles(double[] values)
    {
        double[] sorted = [.. values.Order()];
        return sorted.Length > 0 ? (sorted[(sorted.Length - 1) / 50], sorted[49 * (sorted.Length - 1) / 50]) : (0, 0);
    }
}
