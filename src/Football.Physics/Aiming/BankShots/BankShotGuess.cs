namespace Football.Physics;

/// <summary>
/// Guesses where a kick touches what it is to touch: the ground in hops that get shorter, all else where the way from what is before to what comes after is shortest,
/// which is where a mirror would show the one in the other (Fermat's principle). From there <see cref="BankShotChain"/> finds it.
/// </summary>
internal sealed class BankShotGuess
{
    /// <summary>What a hop over the ground is of the one before, and a speed of that before an impact: as a rule.</summary>
    private const double NextHop = 0.6;
    private const double Kept = 0.65;

    /// <summary>Speed of a way through the air, of that at its start.</summary>
    private const double Slowed = 0.9;

    private const int Sweeps = 4;
    private const int MirrorSteps = 10;

    /// <summary>The most that the normal of a contact turns at once, rad.</summary>
    private const double LargestBend = 0.7;

    /// <summary>The share of the last hop that there is when the target is reached: the guesses, one by one.</summary>
    private static readonly double[] Shares = [0.5, 0.12, 0.85];

    private readonly BallProperties _ball;
    private readonly double _upward;

    public BankShotGuess(Scene scene)
    {
        _ball = scene.Ball;
        _upward = Weight.UpwardAcceleration(scene);
    }

    /// <summary>How many guesses there are for what lies on the ground in between, or not.</summary>
    /// <param name="hops">Whether the ground is among what is to be touched.</param>
    public static int CountOf(bool hops) => hops ? Shares.Length : 1;

    /// <summary>Puts the contacts of a chain, of which each has its thing, and its kick where they may be.</summary>
    /// <param name="chain">The chain.</param>
    /// <param name="ground">What is the ground of its things.</param>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="frame">Ball and target.</param>
    /// <param name="index">Which guess.</param>
    public void Make(BankShotChain chain, Collider? ground, AimRequest request, in TargetFrame frame, int index)
    {
        int count = chain.Count;
        BankShotContact[] contacts = chain.Contacts;
        Vector3d before = frame.From;
        for (int i = 0; i < count; i++)
        {
            contacts[i].GoTo(in before, _ball.Radius);
            before = contacts[i].Thing == ground ? before : contacts[i].Place;
        }

        for (int sweep = 0; sweep < Sweeps; sweep++)
        {
            for (int i = 0; i < count; i++)
            {
                if (contacts[i].Thing == ground)
                {
                    i = Hop(chain, ground, in frame, i, Shares[index]);
                }
                else
                {
                    Mirror(chain, request, in frame, i);
                }
            }
        }

        Vector3d first = contacts[0].Place;
        chain.Kick = Thrown(request, in frame, first - frame.From);
    }

    /// <summary>Puts a row of contacts with the ground between what is before and after it.</summary>
    /// <returns>The last of them.</returns>
    private int Hop(BankShotChain chain, Collider ground, in TargetFrame frame, int first, double share)
    {
        BankShotContact[] contacts = chain.Contacts;
        int next = first;
        double whole = 0;
        double hop = 1;
        for (; next < chain.Count && contacts[next].Thing == ground; next++)
        {
            whole += hop;
            hop *= NextHop;
        }

        whole += share * hop;
        Vector3d from = first == 0 ? frame.From : contacts[first - 1].Place;
        Vector3d to = next == chain.Count ? frame.Target : contacts[next].Place;
        double gone = 0;
        hop = 1;
        for (int i = first; i < next; i++)
        {
            gone += hop;
            hop *= NextHop;
            contacts[i].GoTo(Vector3d.Lerp(in from, in to, gone / whole), _ball.Radius);
        }

        return next - 1;
    }

    /// <summary>Puts a contact to where the way over it is shortest, both ends raised by what the ball falls on its way: least |A − c| + |c − B|.</summary>
    private void Mirror(BankShotChain chain, AimRequest request, in TargetFrame frame, int index)
    {
        ref BankShotContact c = ref chain.Contacts[index];
        Vector3d before = index == 0 ? frame.From : chain.Contacts[index - 1].Place;
        Vector3d after = index == chain.Count - 1 ? frame.Target : chain.Contacts[index + 1].Place;
        double speed = Slowed * request.Speed;
        for (int i = 0; i < index; i++)
        {
            speed *= Kept;
        }

        for (int i = 0; i < MirrorSteps; i++)
        {
            Vector3d a = Raised(c.Place - before, speed);
            Vector3d b = Raised(c.Place - after, Kept * speed);
            double la = a.Length;
            double lb = b.Length;
            if (!(la > 0 && lb > 0))
            {
                return;
            }

            a /= la;
            b /= lb;
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

            Vector3d move = (((xy * gy) - (yy * gx)) / determinant * c.Level) + (((xy * gx) - (xx * gy)) / determinant * c.Steep);
            double bend = (c.Curvature * move).Length;
            c.GoTo(c.Place + (Math.Min(1.0, LargestBend / Math.Max(bend, 1e-9)) * move), _ball.Radius);
        }
    }

    /// <summary>A way from a point that is raised by what a ball falls on the way, ½ g t².</summary>
    private Vector3d Raised(in Vector3d way, double speed)
    {
        double time = way.Length / speed;
        return way + new Vector3d(0, 0.5 * _upward * time * time, 0);
    }

    /// <summary>The kick that is thrown over a way, the low one: tan ε = (v² − √(v⁴ − g (g x² + 2 y v²)))/(g x).</summary>
    private Kick Thrown(AimRequest request, in TargetFrame frame, in Vector3d way)
    {
        double x = way.Horizontal.Length;
        double g = -_upward;
        double v = Slowed * request.Speed;
        double root = (v * v * v * v) - (g * ((g * x * x) + (2.0 * way.Y * v * v)));
        double elevation = g * x > 1e-9 ? Elementary.Atan2((v * v) - Math.Sqrt(Math.Max(0, root)), g * x) : Elementary.Atan2(way.Y, x);
        double azimuth = Elementary.Atan2(Vector3d.Dot(in way, frame.Left), Vector3d.Dot(in way, frame.Forward));
        return Kick.Of(request, ElevationBounds.Of(request).Clamp(elevation), azimuth);
    }
}
