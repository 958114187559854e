using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A request to shield the ball: the player keeps his body between the ball and his opponents.</summary>
public sealed record ShieldRequest
{
    /// <summary>The player in possession of the ball.</summary>
    public Player Player { get; init; } = new Player();

    /// <summary>The opponents; at most 64. Default: none.</summary>
    public IReadOnlyList<Player> Opponents { get; init; } = [];

    /// <summary>The maximum distance of the ball from the player, in m. Above 0, at most 10; default 0.6.</summary>
    /// <remarks>The default is the player's reach without a step.</remarks>
    public double MaximumDistance { get; init; } = 0.6;

    /// <summary>The radius of the player's body, which opponents run around, in m. 0 … 1; default 0.3.</summary>
    public double BodyRadius { get; init; } = 0.3;

    /// <summary>The time from which the opponents' reaction times are measured, in s. Default 0.</summary>
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

/// <summary>The result of a shielding search: the best position of the ball, and the safety margins.</summary>
public sealed class ShieldResult
{
    /// <summary>The number of directions and of distances that are sampled.</summary>
    private const int Directions = 72;
    private const int Rings = 4;

    /// <summary>The margin if no opponent reaches the ball, in s.</summary>
    private const double Forever = 3600;

    private readonly ShieldRequest _request;
    private readonly double[] _margins = new double[Directions];

    internal ShieldResult(ShieldRequest request)
    {
        _request = request;
        Margin = double.NegativeInfinity;
        int safe = 0;

        // Sample all directions and distances, to find the best position and the share of safe ones. Start with the outermost ring, whose margins are stored.
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

    /// <summary>The position with the largest margin within the player's reach, on the ground, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The largest margin over the first opponent, in s; negative if an opponent is first.</summary>
    /// <remarks>The margin is 3600 if no opponent comes.</remarks>
    public double Margin { get; }

    /// <summary>True if the player reaches some position before all opponents.</summary>
    public bool IsShielded => Margin > 0;

    /// <summary>The share of the sampled positions that the player reaches before all opponents, 0 … 1.</summary>
    public double SafeShare { get; }

    /// <summary>The margins at the positions on the outermost ring, in s.</summary>
    /// <remarks>The directions are equally spaced. They start at −z and run counter-clockwise, seen from above.</remarks>
    public IReadOnlyList<double> Margins => _margins;

    /// <summary>Returns the time by which the player reaches a position before the first opponent, in s.</summary>
    /// <remarks>The result is negative if an opponent is first, and 3600 if no opponent comes.</remarks>
    /// <param name="place">The position, in m; its height is ignored.</param>
    public double MarginAt(Vector3d place)
    {
        Check.Place(nameof(place), place);

        // The player has the ball, so he does not need to react.
        Vector3d own = (place - _request.Player.Position).Horizontal;
        double he = new RunnerMotion(_request.Player.Reacting(0), _request.Time).ArrivalAt(own.Length);
        double first = he + Forever;
        foreach (Player opponent in _request.Opponents)
        {
            // Until he reacts, the opponent keeps his motion; then he runs around the player's body.
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

    /// <summary>Returns the shortest distance between two positions around the player's body, in m.</summary>
    /// <remarks>If the body blocks the line, the path consists of two tangents and the arc between them.</remarks>
    private double WayAround(Vector3d from, Vector3d to)
    {
        double radius = _request.BodyRadius;
        Vector3d middle = _request.Player.Position.Horizontal;
        Vector3d a = from - middle;
        Vector3d b = to - middle;
        double straight = (b - a).Length;
        double first = a.Length;
        double second = b.Length;

        // An opponent who touches the body need not run around it.
        if (!(straight > 0) || !(first > radius) || !(second > radius))
        {
            return straight;
        }

        // Compute how far the straight line passes from the body.
        double along = -Vector3d.Dot(in a, b - a) / (straight * straight);
        double passes = (a + (Math.Min(1, Math.Max(0, along)) * (b - a))).Length;
        if (passes >= radius)
        {
            return straight;
        }

        // τ is the angle at the centre between a position, at the distance d, and its tangent point; r is the radius.
        // The arc is the angle between both positions minus the tangent angles: cos τ = r/d.
        double firstTangent = Math.Sqrt((first * first) - (radius * radius));
        double secondTangent = Math.Sqrt((second * second) - (radius * radius));
        double between = Elementary.Atan2(Math.Abs((a.X * b.Z) - (a.Z * b.X)), Vector3d.Dot(in a, in b));
        double arc = between - Elementary.Atan2(firstTangent, radius) - Elementary.Atan2(secondTangent, radius);
        return firstTangent + secondTangent + (radius * Math.Max(0, arc));
    }
}
