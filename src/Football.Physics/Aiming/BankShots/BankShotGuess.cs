using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Aiming;

/// <summary>Guesses the contacts of a bank shot; <see cref="BankShotProblem"/> refines them.</summary>
/// <remarks>
/// Each hop on the ground is a fixed share of the previous one. Other contacts minimise the path length between the points before and after, as in
/// a mirror (Fermat's principle).
/// </remarks>
internal sealed class BankShotGuess(Scene scene)
{
    /// <summary>Typical ratios of a hop to the previous one, and of the speed after an impact to the speed before it.</summary>
    private const double NextHop = 0.6;
    private const double Kept = 0.65;

    /// <summary>The mean speed of a path through the air, as a share of its initial speed.</summary>
    private const double Slowed = 0.9;

    private const int Sweeps = 4;
    private const int MirrorSteps = 10;

    /// <summary>The maximum rotation of a contact's normal in one step, in rad.</summary>
    private const double LargestBend = 0.7;

    /// <summary>The additional elevation of a kick that may land farther than planned, in rad.</summary>
    private const double Steeper = 0.15;

    /// <summary>The guesses: the share of the last hop, whether the last leg is a lob, and the additional elevation.</summary>
    private static readonly (double Share, bool IsLob, double Steeper)[] Ways =
    [
        (0.5, false, 0), (0.5, true, 0), (0.12, false, 0), (0.12, false, Steeper), (0.85, false, 0), (0.12, true, 0), (0.85, true, 0),
    ];

    private readonly BallProperties _ball = scene.Ball;
    private readonly double _upward = Weight.UpwardAcceleration(scene);
    private double _time;

    /// <summary>The number of guesses.</summary>
    public static int Count => Ways.Length;

    /// <summary>Places the contacts of the legs at a guess, and returns a matching kick.</summary>
    /// <param name="legs">The legs.</param>
    /// <param name="ground">The ground.</param>
    /// <param name="request">The request.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="index">The index of the guess.</param>
    /// <param name="kick">The kick.</param>
    /// <returns>False if the guess is the same as an earlier one.</returns>
    public bool Make(BankShotProblem legs, Collider? ground, AimRequest request, in TargetFrame frame, int index, out Kick kick)
    {
        // 1. Move each contact to the nearest point of its object. 2. One after another, move each to the mirror point between its neighbours. 3. Aim
        // the kick at the first contact.
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

    /// <summary>Returns the first or last bounce of a leg on the ground, or the leg's end or start if it has none.</summary>
    private Vector3d Hop(BankShotProblem legs, Collider? ground, in TargetFrame frame, int leg, double share, bool isLast)
    {
        Vector3d from = leg == 0 ? frame.From : legs.Contacts[leg - 1].Place;
        Vector3d to = leg == legs.Count ? frame.Target : legs.Contacts[leg].Place;
        int bounces = legs.Bounces[leg];
        if (bounces == 0 || ground is null)
        {
            return isLast ? from : to;
        }

        // The durations of the hops form a geometric series; the leg ends within the last hop.
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

    /// <summary>Moves a contact to minimise the path length |A − c| + |c − B|, with both ends raised by the fall of the ball on the path.</summary>
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

            // ∇f is the gradient of the sum of both lengths. Its tangential part is zero if the angles of incidence and reflection are equal.
            Vector3d slope = a + b;

            // The Hessian of the length f of the way over the surface, (1 − aaᵀ)/l_a + (1 − bbᵀ)/l_b − (∇f·n) H: directions a, b and lengths l of both parts,
            // normal n and curvature H. aaᵀ and bbᵀ are left out (Weiszfeld), so that steps are not too long.
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

            // Take a Newton step along the surface, limited by the rotation of the normal.
            Vector3d move = (((xy * gy) - (yy * gx)) / determinant * c.Level) + (((xy * gx) - (xx * gy)) / determinant * c.Steep);
            double bend = (c.Curvature * move).Length;
            c.GoTo(c.Place + (Math.Min(1.0, LargestBend / Math.Max(bend, 1e-9)) * move), _ball.Radius, _time);
        }
    }

    /// <summary>Raises a path by the fall of the ball, ½ g t², where t is the time of a throw, flat or as a lob.</summary>
    private Vector3d Raised(in Vector3d way, double speed, bool lob)
    {
        // A throw at the speed v over the way w, with the upward acceleration a, takes a time t with |w + ½ a t²| = v t, so
        // ¼ a² t⁴ − (v² − a w_y) t² + w² = 0.
        double a = _upward;
        double half = 0.5 * ((speed * speed) - (a * way.Y));
        double root = Math.Sqrt(Math.Max(0, (half * half) - (0.25 * a * a * way.LengthSquared)));
        double squared = lob ? (half + root) / (0.25 * a * a) : way.LengthSquared / Math.Max(half + root, 1e-9);
        squared = lob ? Math.Min(squared, 9.0) : squared;
        return way + new Vector3d(0, 0.5 * a * squared, 0);
    }

    /// <summary>Returns the low throw that covers a path: tan ε = (v² − √(v⁴ − g (g x² + 2 y v²)))/(g x).</summary>
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

/// <summary>A contact of the ball, on the surface one ball radius off an object; it moves along that surface by two numbers.</summary>
internal struct BankShotContact
{
    /// <summary>The maximum number of steps that project a point onto a curved surface.</summary>
    private const int MostRaises = 8;

    /// <summary>The object.</summary>
    public Collider Thing;

    /// <summary>The centre of the ball, in m.</summary>
    public Vector3d Place;

    /// <summary>The normal of the object at the contact.</summary>
    public Vector3d Normal;

    /// <summary>The rate at which the normal turns with the position, in 1/m.</summary>
    public SymmetricMatrix3d Curvature;

    /// <summary>The tangential directions: horizontal, and steepest.</summary>
    public Vector3d Level;
    public Vector3d Steep;

    /// <summary>Moves to the point on the surface nearest to a given point.</summary>
    public void GoTo(in Vector3d near, double radius, double time)
    {
        Place = near;
        ShapePoint at = Thing.At(in Place, time);
        for (int i = 0; i < MostRaises && Math.Abs(at.Distance - radius) > 1e-12; i++)
        {
            // Project along the normal repeatedly, until the ball just touches the object.
            Place += (radius - at.Distance) * at.Normal;
            at = Thing.At(in Place, time);
        }

        Normal = at.Normal;
        Curvature = at.Curvature;
        Axes(in Normal, out Level, out Steep);
    }

    /// <summary>Returns two directions perpendicular to a third; the first is horizontal.</summary>
    public static void Axes(in Vector3d direction, out Vector3d level, out Vector3d steep)
    {
        var flat = new Vector3d(direction.Z, 0, -direction.X);
        double size = flat.Length;
        level = size > 1e-9 ? flat / size : new Vector3d(1, 0, 0);
        steep = Vector3d.Cross(in direction, in level);
    }
}
