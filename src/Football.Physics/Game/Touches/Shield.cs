namespace FootballPhysics.Aiming;

/// <summary>A player who keeps the ball from his opponents by standing between.</summary>
public sealed record ShieldRequest
{
    /// <summary>The player who has the ball.</summary>
    public Player Player { get; init; } = new Player();

    /// <summary>His opponents; at most 64. Default none.</summary>
    public IReadOnlyList<Player> Opponents { get; init; } = [];

    /// <summary>How far from him the ball may be, m. Above 0, at most 10; default 0.6, what he can reach where he stands.</summary>
    public double MaximumDistance { get; init; } = 0.6;

    /// <summary>Radius of his body, which opponents go around, m. 0 … 1; default 0.3.</summary>
    public double BodyRadius { get; init; } = 0.3;

    /// <summary>When, s: the reaction times of the opponents count from here. Default 0.</summary>
    public double Time { get; init; }

    internal void Validate()
    {
        Player.Validate();
        Check.Member("shield.opponents", Opponents);
        Check.Within("shield.opponents", Opponents.Count, 0, 64);
        for (int i = 0; i < Opponents.Count; i++)
        {
            Opponents[i].Validate();
        }

        Check.Within("shield.maximumDistance", MaximumDistance, 0, 10, exclusiveLow: true);
        Check.Within("shield.bodyRadius", BodyRadius, 0, 1);
        Check.Within("shield.time", Time, -Limits.Time, Limits.Time);
    }
}

/// <summary>Where a ball is shielded: the best place, and how long before any opponent the player has it there and elsewhere.</summary>
public sealed class ShieldResult
{
    /// <summary>Directions and distances that are looked at.</summary>
    private const int Directions = 72;
    private const int Rings = 4;

    /// <summary>Where nobody else comes it is so long, s.</summary>
    private const double Forever = 3600;

    private readonly ShieldRequest _request;
    private readonly double[] _margins = new double[Directions];

    internal ShieldResult(ShieldRequest request)
    {
        _request = request;
        Margin = double.NegativeInfinity;
        int safe = 0;

        // All directions and distances: the best place, and the share of those that are safe. The farthest first, whose margins are kept.
        for (int ring = Rings; ring >= 1; ring--)
        {
            for (int i = 0; i < Directions; i++)
            {
                Vector3d place = At(i, request.MaximumDistance * ring / Rings);
                double margin = MarginAt(place);
                safe += margin > 0 ? 1 : 0;
                if (ring == Rings)
                {
                    _margins[i] = margin;
                }

                if (margin > Margin)
                {
                    Margin = margin;
                    Position = place;
                }
            }
        }

        SafeShare = (double)safe / (Rings * Directions);
    }

    /// <summary>The place within his reach where the player has the ball longest before any opponent, m over the ground.</summary>
    public Vector3d Position { get; }

    /// <summary>How long before the first opponent he has it there, s; below 0 where that one is first; 3 600 where nobody comes.</summary>
    public double Margin { get; }

    /// <summary>True when there is a place where he has it before all of them.</summary>
    public bool IsShielded => Margin > 0;

    /// <summary>The share of the places around him, of all directions and distances alike, where he has it before all of them, 0 … 1.</summary>
    public double SafeShare { get; }

    /// <summary>The margins at the farthest places, s: in equal angles from −z on, counter-clockwise seen from above.</summary>
    public IReadOnlyList<double> Margins => _margins;

    /// <summary>How long before the first opponent the player has a ball at a place, s; below 0 where that one is first; 3 600 where nobody comes.</summary>
    /// <param name="place">The place, m; its height does not count.</param>
    public double MarginAt(Vector3d place)
    {
        Check.Place(nameof(place), place);

        // When he himself is there: he needs no time to react, for he has the ball.
        Vector3d own = (place - _request.Player.Position).Horizontal;
        double he = new RunnerMotion(_request.Player.Reacting(0), _request.Time).ArrivalAt(own.Length);
        double first = he + Forever;
        foreach (Player opponent in _request.Opponents)
        {
            // Until he reacts he goes on as he does; from there around the player's body.
            var motion = new RunnerMotion(in opponent, _request.Time);
            motion.MiddleAt(motion.Start, out double x, out double z);
            first = Math.Min(first, motion.ArrivalAt(WayAround(new Vector3d(x, 0, z), place.Horizontal)));
        }

        return first - he;
    }

    private Vector3d At(int direction, double distance)
    {
        Vector3d place = _request.Player.Position.Horizontal;
        return place + (distance * KickVectors.Flat(2.0 * Math.PI * direction / Directions, new Vector3d(0, 0, -1)));
    }

    /// <summary>Length of the shortest way from one place to another around the player's body, m: two tangents and the arc between them, where he is in the way.</summary>
    private double WayAround(Vector3d from, Vector3d to)
    {
        double radius = _request.BodyRadius;
        Vector3d middle = _request.Player.Position.Horizontal;
        Vector3d a = from - middle;
        Vector3d b = to - middle;
        double straight = (b - a).Length;
        double first = a.Length;
        double second = b.Length;

        // Who stands at or within the body does not go around it.
        if (!(straight > 0) || !(first > radius) || !(second > radius))
        {
            return straight;
        }

        // Where the straight line comes closest to the body, and how close.
        double along = -Vector3d.Dot(in a, b - a) / (straight * straight);
        double passes = (a + (Math.Min(1, Math.Max(0, along)) * (b - a))).Length;
        if (passes >= radius)
        {
            return straight;
        }

        // The angle between the two, less those of the tangents: cos τ = r/d
        double firstTangent = Math.Sqrt((first * first) - (radius * radius));
        double secondTangent = Math.Sqrt((second * second) - (radius * radius));
        double between = Elementary.Atan2(Math.Abs((a.X * b.Z) - (a.Z * b.X)), Vector3d.Dot(in a, in b));
        double arc = between - Elementary.Atan2(firstTangent, radius) - Elementary.Atan2(secondTangent, radius);
        return firstTangent + secondTangent + (radius * Math.Max(0, arc));
    }
}
