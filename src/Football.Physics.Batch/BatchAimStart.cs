namespace FootballPhysics.Batch;

/// <summary>Computes the frame of a target and a first kick in closed form.</summary>
/// <param name="context">The scene, compiled for aiming.</param>
/// <param name="timeStep">The step of the flights, in s.</param>
internal sealed class BatchAimStart(AimContext context, double timeStep)
{
    /// <summary>The range of horizontal distances to the target, in m.</summary>
    private const double Nearest = 0.1;
    private const double Farthest = 200;

    /// <summary>The smallest share of speed towards the target, and the longest time to it, in s. Beyond these, the target is near the end of the range.</summary>
    private const double LeastForward = 0.5;
    private const double LongestTime = 8;

    private readonly Simulator _simulator = context.Game;
    private readonly LaneDomain _domain = new(context.Scene, timeStep);
    private readonly Vector3d _wind = context.Scene.Air.Wind;
    private readonly double _upward = context.Upward;

    /// <summary>Prepares a request.</summary>
    /// <returns>False if the request is left to the single aimer.</returns>
    public bool Prepare(BatchAims aims, int index, ref BatchAimState s)
    {
        double contact = _simulator.ContactHeight;
        double fromY = aims.From.Y[index];
        s = default;
        s.OnGround = fromY <= contact;
        fromY = s.OnGround ? contact : fromY;
        double dx = aims.Target.X[index] - aims.From.X[index];
        double dz = aims.Target.Z[index] - aims.From.Z[index];
        double distance = Math.Sqrt((dx * dx) + (dz * dz));
        double top = aims.TopSpin[index];
        double side = aims.SideSpin[index];
        double speed = aims.Speed[index];
        s.Distance = distance;
        s.Rise = aims.Target.Y[index] - fromY;
        s.Speed = speed;
        s.Top = top;
        s.Side = side;
        s.SpinRate = Math.Sqrt((top * top) + (side * side));
        if (!(distance > Nearest && distance < Farthest) || aims.Target.Y[index] < contact)
        {
            return false;
        }

        s.ForwardX = dx / distance;
        s.ForwardZ = dz / distance;
        s.WindForward = (_wind.X * s.ForwardX) + (_wind.Z * s.ForwardZ);
        s.WindLeft = (_wind.X * s.ForwardZ) - (_wind.Z * s.ForwardX);
        double most = speed + _wind.Length;
        return _domain.Covers(most * most, s.SpinRate, 100, _wind.Y, 10) && Guess(ref s);
    }

    /// <summary>Computes the direction of a first kick by iteration on the slant, with the flight in closed form.</summary>
    /// <remarks>It is <see cref="FlatFire"/> with rational functions for the damping. The result compensates for fall, bend and wind.</remarks>
    private bool Guess(ref BatchAimState s)
    {
        double v = s.Speed;
        double slant = Math.Sqrt((s.Distance * s.Distance) + (s.Rise * s.Rise));
        double middle = v / (1.0 + (0.006 * slant));
        _simulator.AirFactors(middle, s.SpinRate, out double drag, out double lift);
        double k = drag / middle;
        double windUp = _wind.Y;
        double windSquared = _wind.LengthSquared;
        double df = s.Distance / slant;
        double du = s.Rise / slant;
        double dl = 0;
        double x = v;
        double af = df;
        double au = du;
        double al = dl;
        double t = 0;
        for (int i = 0; i < 4; i++)
        {
            // s = ln(1 + k x t)/k, so x t = s (1 + ks/2 + (ks)²/6 + …)
            double ks = k * slant;
            double tau = ks * (1.0 + (ks * (0.5 + (ks * ((1.0 / 6.0) + (ks * (1.0 / 24.0)))))));
            t = slant / x * (1.0 + (ks * (0.5 + (ks * ((1.0 / 6.0) + (ks * (1.0 / 24.0)))))));
            double fall = _upward * t * t * 0.5 / (1.0 + (tau * (1.0 / 3.0)));
            double bend = lift * x * t * t * 0.5 / (1.0 + (tau * (2.0 / 3.0)));

            // ω = top (ŷ × d) + side ŷ, and ŷ × forward = left; ω̂ × û in (forward, up, left).
            double flat = Math.Sqrt((df * df) + (dl * dl));
            double wf = 0;
            double wu = 0;
            double wl = 0;
            if (s.SpinRate > 0)
            {
                wf = -(s.Top * dl / flat) / s.SpinRate;
                wu = s.Side / s.SpinRate;
                wl = s.Top * df / flat / s.SpinRate;
            }

            double cf = (wu * al) - (wl * au);
            double cu = (wl * af) - (wf * al);
            double cl = (wf * au) - (wu * af);

            double f = s.Distance - (t * s.WindForward) - (bend * -cf);
            double u = s.Rise - (t * windUp) - fall - (bend * -cu);
            double l = -(t * s.WindLeft) - (bend * -cl);
            slant = Math.Sqrt((f * f) + (u * u) + (l * l));
            af = f / slant;
            au = u / slant;
            al = l / slant;
            x = FlatFire.AirSpeed(v, (af * s.WindForward) + (au * windUp) + (al * s.WindLeft), windSquared);
            if (!(x > 0.1 * v))
            {
                return false;
            }

            df = ((x * af) + s.WindForward) / v;
            du = ((x * au) + windUp) / v;
            dl = ((x * al) + s.WindLeft) / v;
        }

        s.DirectionForward = df;
        s.DirectionUp = du;
        s.DirectionLeft = dl;
        s.Time = t;
        return df > LeastForward && t > 0 && t < LongestTime;
    }
}
