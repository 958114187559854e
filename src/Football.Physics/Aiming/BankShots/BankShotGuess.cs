namespace FootballPhysics.Aiming;

/// <summary>
/// Guesses where a kick touches what it is to touch: the ground in hops that get shorter, all else where the way from what is before to what comes after is shortest,
/// which is where a mirror would show the one in the other (Fermat's principle). From there <see cref="BankShotProblem"/> finds it.
/// </summary>
internal sealed class BankShotGuess
{
    /// <summary>Usual ratios: a hop to the one before it, a speed after an impact to that before.</summary>
    private const double NextHop = 0.6;
    private const double Kept = 0.65;

    /// <summary>Speed of a way through the air, of that at its start.</summary>
    private const double Slowed = 0.9;

    private const int Sweeps = 4;
    private const int MirrorSteps = 10;

    /// <summary>The most that the normal of a contact turns at once, rad.</summary>
    private const double LargestBend = 0.7;

    /// <summary>How much steeper than thrown a kick is that may come to the ground behind a throw, rad.</summary>
    private const double Steeper = 0.15;

    /// <summary>The guesses: of the last hop as large a share, the last leg a flat one or a lob, the kick as much steeper.</summary>
    private static readonly (double Share, bool IsLob, double Steeper)[] Ways =
    [
        (0.5, false, 0), (0.5, true, 0), (0.12, false, 0), (0.12, false, Steeper), (0.85, false, 0), (0.12, true, 0), (0.85, true, 0),
    ];

    private readonly BallProperties _ball;
    private readonly double _upward;
    private double _time;

    public BankShotGuess(Scene scene)
    {
        _ball = scene.Ball;
        _upward = Weight.UpwardAcceleration(scene);
    }

    /// <summary>How many guesses there are.</summary>
    public static int Count => Ways.Length;

    /// <summary>Puts the contacts of some legs, of which each has its thing, where they may be, and makes a kick for them.</summary>
    /// <param name="legs">The legs.</param>
    /// <param name="ground">The ground.</param>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="index">Which guess.</param>
    /// <param name="kick">The kick.</param>
    /// <returns>False where it is no other than one before.</returns>
    public bool Make(BankShotProblem legs, Collider? ground, AimRequest request, in TargetFrame frame, int index, out Kick kick)
    {
        // 1. Every contact to where its thing is nearest. 2. By turns to where a mirror would show what comes after in what comes before. 3. The kick that is thrown
        // to the first of them.
        (double share, bool lob, double steeper) = Ways[index];
        bool hops = false;
        kick = default;
        Vector3d before = frame.From;
        _time = request.KickTime;
        for (int i = 0; i < legs.Count; i++)
        {
            legs.Contacts[i].GoTo(in before, _ball.Radius, _time);
            before = legs.Contacts[i].Place;
            hops |= legs.Bounces[i] > 0;
        }

        hops |= legs.Bounces[legs.Count] > 0;
        if ((lob && legs.Count == 0) || (share != Ways[0].Share && !hops))
        {
            return false;
        }

        for (int sweep = 0; sweep < Sweeps; sweep++)
        {
            for (int i = 0; i < legs.Count; i++)
            {
                Mirror(legs, ground, request, in frame, i, share, lob && i == legs.Count - 1);
            }
        }

        Vector3d first = Hop(legs, ground, in frame, 0, share, isLast: false);
        kick = Thrown(request, in frame, first - frame.From, steeper);
        return true;
    }

    /// <summary>The first or last place on the ground of a leg, or where it leads to or comes from where it has none.</summary>
    private Vector3d Hop(BankShotProblem legs, Collider? ground, in TargetFrame frame, int leg, double share, bool isLast)
    {
        Vector3d from = leg == 0 ? frame.From : legs.Contacts[leg - 1].Place;
        Vector3d to = leg == legs.Count ? frame.Target : legs.Contacts[leg].Place;
        int bounces = legs.Bounces[leg];
        if (bounces == 0 || ground is null)
        {
            return isLast ? from : to;
        }

        // Hops are a geometric series; the leg ends in the middle of one.
        double gone = 0;
        double hop = 1;
        for (int i = 0; i < bounces; i++)
        {
            gone += hop;
            hop *= NextHop;
        }

        double whole = gone + (share * hop);
        BankShotContact place = default;
        place.Thing = ground;
        place.GoTo(Vector3d.Lerp(in from, in to, (isLast ? gone : 1.0) / whole), _ball.Radius, _time);
        return place.Place;
    }

    /// <summary>Puts a contact to where the way over it is shortest, both ends raised by what the ball falls on its way: least |A − c| + |c − B|.</summary>
    private void Mirror(BankShotProblem legs, Collider? ground, AimRequest request, in TargetFrame frame, int index, double share, bool lob)
    {
        ref BankShotContact c = ref legs.Contacts[index];
        Vector3d before = Hop(legs, ground, in frame, index, share, isLast: true);
        Vector3d after = Hop(legs, ground, in frame, index + 1, share, isLast: false);
        double speed = Slowed * request.Speed;
        for (int i = 0; i < index; i++)
        {
            speed *= Kept;
        }

        for (int i = 0; i < MirrorSteps; i++)
        {
            Vector3d a = Raised(c.Place - before, speed, lob: false);
            Vector3d b = Raised(c.Place - after, Kept * speed, lob);
            double la = a.Length;
            double lb = b.Length;
            if (!(la > 0 && lb > 0))
            {
                return;
            }

            a /= la;
            b /= lb;

            // ∇f of the two lengths; along the surface it is zero where angle in equals angle out.
            Vector3d slope = a + b;

            // Of ∇∇f = (1 − aaᵀ)/l_a + (1 − bbᵀ)/l_b − (∇f·n) H along the surface what makes no step too long: without aaᵀ and bbᵀ (Weiszfeld)
            double flat = (1.0 / la) + (1.0 / lb);
            double bent = Math.Max(0, -Vector3d.Dot(in slope, in c.Normal));
            double xx = flat + (bent * Math.Max(0, Vector3d.Dot(in c.Level, c.Curvature * c.Level)));
            double xy = bent * Vector3d.Dot(in c.Level, c.Curvature * c.Steep);
            double yy = flat + (bent * Math.Max(0, Vector3d.Dot(in c.Steep, c.Curvature * c.Steep)));
            double gx = Vector3d.Dot(in slope, in c.Level);
            double gy = Vector3d.Dot(in slope, in c.Steep);
            double determinant = (xx * yy) - (xy * xy);
            if (!(determinant > 0))
            {
                return;
            }

            // Newton along the surface, but turning the normal no farther than it can be trusted.
            Vector3d move = (((xy * gy) - (yy * gx)) / determinant * c.Level) + (((xy * gx) - (xx * gy)) / determinant * c.Steep);
            double bend = (c.Curvature * move).Length;
            c.GoTo(c.Place + (Math.Min(1.0, LargestBend / Math.Max(bend, 1e-9)) * move), _ball.Radius, _time);
        }
    }

    /// <summary>A way from a point that is raised by what a ball falls on the way, ½ g t²: its time is that of a throw at a speed, a flat one or a lob.</summary>
    private Vector3d Raised(in Vector3d way, double speed, bool lob)
    {
        // |w + ½ a t²| = v t:  ¼ a² t⁴ − (v² − a w_y) t² + w² = 0
        double a = _upward;
        double half = 0.5 * ((speed * speed) - (a * way.Y));
        double root = Math.Sqrt(Math.Max(0, (half * half) - (0.25 * a * a * way.LengthSquared)));
        double squared = lob ? (half + root) / (0.25 * a * a) : way.LengthSquared / Math.Max(half + root, 1e-9);
        squared = lob ? Math.Min(squared, 9.0) : squared;
        return way + new Vector3d(0, 0.5 * a * squared, 0);
    }

    /// <summary>The kick that is thrown over a way, the low one: tan ε = (v² − √(v⁴ − g (g x² + 2 y v²)))/(g x).</summary>
    private Kick Thrown(AimRequest request, in TargetFrame frame, in Vector3d way, double steeper)
    {
        double x = way.Horizontal.Length;
        double g = -_upward;
        double v = Slowed * request.Speed;
        double root = (v * v * v * v) - (g * ((g * x * x) + (2.0 * way.Y * v * v)));
        double elevation = g * x > 1e-9 ? Elementary.Atan2((v * v) - Math.Sqrt(Math.Max(0, root)), g * x) : Elementary.Atan2(way.Y, x);
        double azimuth = Elementary.Atan2(Vector3d.Dot(in way, frame.Left), Vector3d.Dot(in way, frame.Forward));
        return Kick.Of(request, ElevationBounds.Of(request).Clamp(elevation + steeper), azimuth);
    }
}

/// <summary>A place at which the ball is to touch something: of its centre, on the surface that lies a radius off the thing. It moves along that surface by two numbers.</summary>
internal struct BankShotContact
{
    /// <summary>A place is put back onto a surface that is curved in so many steps.</summary>
    private const int MostRaises = 8;

    /// <summary>The thing touched.</summary>
    public Collider Thing;

    /// <summary>Centre of the ball, m.</summary>
    public Vector3d Place;

    /// <summary>Normal of the thing there.</summary>
    public Vector3d Normal;

    /// <summary>How the normal turns with the place, 1/m.</summary>
    public SymmetricMatrix3d Curvature;

    /// <summary>The directions along the surface: level, and as steep as it gets.</summary>
    public Vector3d Level;
    public Vector3d Steep;

    /// <summary>Goes to the place on the surface nearest to one.</summary>
    public void GoTo(in Vector3d near, double radius, double time)
    {
        Place = near;
        ShapePoint at = Thing.At(in Place, time);
        for (int i = 0; i < MostRaises && Math.Abs(at.Distance - radius) > 1e-12; i++)
        {
            // Along the normal, again and again, until the ball just touches.
            Place += (radius - at.Distance) * at.Normal;
            at = Thing.At(in Place, time);
        }

        Normal = at.Normal;
        Curvature = at.Curvature;
        Axes(in Normal, out Level, out Steep);
    }

    /// <summary>Two directions across a third one, of which the first is level.</summary>
    public static void Axes(in Vector3d direction, out Vector3d level, out Vector3d steep)
    {
        var flat = new Vector3d(direction.Z, 0, -direction.X);
        double size = flat.Length;
        level = size > 1e-9 ? flat / size : new Vector3d(1, 0, 0);
        steep = Vector3d.Cross(in direction, in level);
    }
}
