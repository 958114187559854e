namespace Football.Physics;

/// <summary>Finds kicks that reach a target after bounces, and off named things: one bounce and in, off the wall, in off the post.</summary>
/// <remarks>
/// Kicks over the directions that can meet the first thing are flown in long steps, few at first, more where those lead to no hit; from the closest of those that meet
/// all of them, Newton's method goes on through the impacts with the derivatives by the launch. Made once for a scene and used again. Not for several threads at once.
/// </remarks>
public sealed class BankShotAimer
{
    /// <summary>Steps of the first look and of the search itself, s.</summary>
    private const double CoarseStep = 0.04;
    private const double FineStep = 0.01;

    /// <summary>A kick is given up after this, s.</summary>
    private const double LongestFlight = 8;

    /// <summary>The looks, from the widest to the closest: so many directions and elevations, each look twice as close as the one before.</summary>
    private const int Looks = 4;
    private const int Directions = 5;
    private const int Elevations = 8;
    private const int Starts = 8;
    private const int MostHalvings = 8;

    /// <summary>The most that a direction is turned at once, rad.</summary>
    private const double LargestTurn = 0.1;

    private readonly Simulator _simulator;
    private readonly LaunchDerivatives _derivatives;
    private readonly StepLog _log = new();
    private readonly BankShotPath _path;
    private readonly World? _world;
    private readonly BankShotStart[] _starts = new BankShotStart[Starts];
    private int _count;
    private int _simulations;
    private int _iterations;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BankShotAimer(Scene? scene = null)
    {
        _simulator = new Simulator(scene);
        _derivatives = new LaunchDerivatives(_simulator);
        _world = World.Of(_simulator.Scene);
        _path = new BankShotPath(_log);
        _log.Observer = _path;
    }

    /// <summary>Finds a kick.</summary>
    /// <param name="request">What the kick is to do: from, target, speed, spin, elevations, tolerance. Without a point on the way.</param>
    /// <param name="after">The names of what it is to meet before, in order: "ground", an obstacle's, "left post", "crossbar" …; at least one.</param>
    /// <returns>The best kick found. A hit passes the target within the tolerance after having met just these; all else is not converged: no other kick is ruled out.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, nothing is to be met, or the scene has nothing of a name; the message says what it has.</exception>
    public AimResult Find(AimRequest request, params string[] after)
    {
        Check.Given(nameof(request), request);
        Check.Given("aim.after", after);
        request.Validate();
        if (request.Through is { } point)
        {
            throw Check.Refusal("aim.through", point.ToString(), "none, where something is to be met before");
        }

        int[] things = Things(after);
        _simulations = 0;
        _iterations = 0;
        var frame = new TargetFrame(Raised(request.From), Raised(request.Target));
        BankShotStart best = Nothing(request, in frame);
        for (int look = 0; look < Looks && !IsHit(request, in best); look++)
        {
            BankShotStart closest = Look(request, in frame, things, 1 << look);
            best = !best.IsFine && closest.Miss < best.Miss ? closest : best;
            for (int i = 0; i < _count && !IsHit(request, in best); i++)
            {
                BankShotStart found = Improve(request, in frame, things, in _starts[i]);
                best = found.IsFine && (!best.IsFine || found.Miss < best.Miss) ? found : best;
            }
        }

        best.Kick.Vectors(request.Speed, frame.Forward, out Vector3d velocity, out Vector3d spin);
        bool hits = IsHit(request, in best);
        var measured = new MeasuredMiss(best.Miss, null, best.Time, best.Position);
        return new AimResult(hits ? AimStatus.Hit : AimStatus.NotConverged, in velocity, in spin, in measured, AimArc.Low, rolls: false, _iterations, _simulations, blockedBy: null);
    }

    private int[] Things(string[] names)
    {
        if (names.Length == 0)
        {
            throw Check.Refusal("aim.after", "[]", "the names of one thing or more");
        }

        int first = _world?.FirstCollider ?? 0;
        int count = _world is null ? 1 : _world.Colliders.Length;
        var things = new int[names.Length];
        for (int i = 0; i < names.Length; i++)
        {
            int found = first;
            while (found < first + count && _simulator.NameOf(found) != names[i])
            {
                found++;
            }

            if (found == first + count)
            {
                string known = string.Join(" | ", Enumerable.Range(first, count).Select(_simulator.NameOf));
                throw Check.Refusal(FormattableString.Invariant($"aim.after[{i}]"), names[i], known);
            }

            things[i] = found;
        }

        return things;
    }

    private static bool IsHit(AimRequest request, in BankShotStart shot) => shot.IsFine && shot.Miss <= request.Tolerance;

    /// <summary>A kick that meets nothing, for want of a better one.</summary>
    private static BankShotStart Nothing(AimRequest request, in TargetFrame frame)
    {
        BankShotStart nothing = default;
        nothing.Kick = Kick(request, ElevationBounds.Of(request).Clamp(0.3), 0);
        nothing.Miss = Vector3d.Distance(frame.From, in frame.Target);
        nothing.Position = frame.From;
        return nothing;
    }

    /// <summary>Flies kicks over all directions of use, and keeps the closest of those that meet everything.</summary>
    /// <returns>The closest of all.</returns>
    private BankShotStart Look(AimRequest request, in TargetFrame frame, int[] things, int closeness)
    {
        _count = 0;
        var bounds = ElevationBounds.Of(request);
        BankShotStart best = default;
        best.Miss = double.MaxValue;
        Azimuths(in frame, things, out double from, out double to);
        int directions = Directions * closeness;
        int elevations = Elevations * closeness;
        for (int i = 0; i <= directions; i++)
        {
            for (int j = 0; j <= elevations; j++)
            {
                // What a wider look has flown need not be flown again.
                if (closeness > 1 && (i & 1) == 0 && (j & 1) == 0)
                {
                    continue;
                }

                Kick kick = Kick(request, bounds.Lowest + ((bounds.Highest - bounds.Lowest) * j / elevations), from + ((to - from) * i / directions));
                BankShotStart shot = Fly(request, in frame, things, in kick, CoarseStep);
                if (shot.Meets)
                {
                    Keep(in shot);
                    best = shot.Miss < best.Miss ? shot : best;
                }
            }
        }

        return best;
    }

    /// <summary>The directions in which the first thing but the ground is met: those of its box as seen from the ball, or all where it has none.</summary>
    private void Azimuths(in TargetFrame frame, int[] things, out double from, out double to)
    {
        int thing = Array.Find(things, item => item != 0);
        if (thing == 0 || _world is null)
        {
            // Over the ground alone: to the target, and beside it for a ball that bends.
            from = -0.5;
            to = 0.5;
            return;
        }

        Bounds3d box = _world.Colliders[thing - _world.FirstCollider].Bounds;
        Vector3d size = box.Max - box.Min;
        if (!size.IsFinite)
        {
            from = -Math.PI;
            to = Math.PI;
            return;
        }

        Vector3d middle = (0.5 * (box.Min + box.Max)) - frame.From;
        double around = Elementary.Atan2(Vector3d.Dot(in middle, frame.Left), Vector3d.Dot(in middle, frame.Forward));
        double half = (0.5 * size.Horizontal.Length) + _simulator.Scene.Ball.Radius;
        double distance = middle.Horizontal.Length;

        // Twice as wide as it looks: the ball may bend.
        double angle = distance > half ? Elementary.Atan2(half, Math.Sqrt((distance * distance) - (half * half))) : 0.5 * Math.PI;
        double spread = Math.Min(Math.PI, (2.0 * angle) + 0.02);
        from = around - spread;
        to = around + spread;
    }

    /// <summary>Keeps a start if it is among the closest.</summary>
    private void Keep(in BankShotStart shot)
    {
        int place = _count < Starts ? _count++ : Starts;
        while (place > 0 && shot.Miss < _starts[place - 1].Miss)
        {
            if (place < Starts)
            {
                _starts[place] = _starts[place - 1];
            }

            place--;
        }

        if (place < Starts)
        {
            _starts[place] = shot;
        }
    }

    /// <summary>Newton's method on the part of the miss across the way, by elevation and azimuth.</summary>
    private BankShotStart Improve(AimRequest request, in TargetFrame frame, int[] things, in BankShotStart start)
    {
        BankShotStart at = Fly(request, in frame, things, start.Kick, FineStep);
        var bounds = ElevationBounds.Of(request);
        for (int i = 0; at.Meets && i < request.MaximumIterations && at.Miss > 1e-3 * request.Tolerance; i++)
        {
            _iterations++;
            if (!Step(request, in frame, in at, out double up, out double aside))
            {
                break;
            }

            double turn = Math.Sqrt((up * up) + (aside * aside));
            double share = turn > LargestTurn ? LargestTurn / turn : 1.0;
            BankShotStart next = at;
            bool better = false;
            for (int halving = 0; halving < MostHalvings && !better; halving++)
            {
                Kick kick = at.Kick;
                kick.Elevation = bounds.Clamp(kick.Elevation + (share * up));
                kick.Azimuth += share * aside;
                next = Fly(request, in frame, things, in kick, FineStep);
                better = next.Meets && next.Miss < at.Miss;
                share *= 0.5;
            }

            if (!better)
            {
                break;
            }

            at = next;
        }

        at.IsFine = at.Meets;
        return at;
    }

    /// <summary>The turn that takes away the miss across the way: least squares of e + (∂p/∂θ) Δθ over the directions across v.</summary>
    private bool Step(AimRequest request, in TargetFrame frame, in BankShotStart at, out double up, out double aside)
    {
        at.Kick.Vectors(request.Speed, frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.Launch(request.From, velocity, spin);
        _derivatives.Run(ref state, FineStep, at.Time, StopAt.Time);
        _simulations++;
        Vector3d d = at.Kick.Direction(frame.Forward);
        var left = new Vector3d(d.Z, 0, -d.X);
        Elementary.SinCos(at.Kick.Elevation, out double sin, out double cos);

        // v = V (cos ε d + sin ε ŷ), ω = top ŷ × d + side ŷ;  ∂d/∂φ = ŷ × d, ∂(ŷ × d)/∂φ = −d
        Vector3d byElevation = request.Speed * (_derivatives.PositionByVelocity * new Vector3d(-sin * d.X, cos, -sin * d.Z));
        Vector3d byAzimuth = (_derivatives.PositionByVelocity * (request.Speed * cos * left)) - (_derivatives.PositionBySpin * (at.Kick.Top * d));
        Vector3d way = at.Velocity.LengthSquared > 0 ? at.Velocity / at.Velocity.Length : Vector3d.Zero;
        Vector3d e = Across(at.Position - frame.Target, in way);
        byElevation = Across(in byElevation, in way);
        byAzimuth = Across(in byAzimuth, in way);
        double aa = byElevation.LengthSquared;
        double ab = Vector3d.Dot(in byElevation, in byAzimuth);
        double bb = byAzimuth.LengthSquared;
        double determinant = (aa * bb) - (ab * ab);
        double ea = Vector3d.Dot(in e, in byElevation);
        double eb = Vector3d.Dot(in e, in byAzimuth);
        up = ((ab * eb) - (bb * ea)) / determinant;
        aside = ((ab * ea) - (aa * eb)) / determinant;
        return determinant > 1e-12 * aa * bb && !double.IsNaN(up + aside);
    }

    private static Vector3d Across(in Vector3d v, in Vector3d way) => v - (Vector3d.Dot(in v, in way) * way);

    private BankShotStart Fly(AimRequest request, in TargetFrame frame, int[] things, in Kick kick, double step)
    {
        kick.Vectors(request.Speed, frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.Launch(request.From, velocity, spin);
        _log.Clear();
        _path.Begin(things, frame.Target);
        _simulator.Run(ref state, step, LongestFlight, StopAt.Rest, _log, null);
        _simulations++;
        BankShotStart shot;
        shot.Kick = kick;
        shot.Meets = _path.MeetsAll;
        shot.IsFine = false;
        shot.Miss = shot.Meets ? Math.Sqrt(_path.Best) : double.MaxValue;
        shot.Time = _path.Time;
        shot.Position = _path.Position;
        shot.Velocity = _path.Velocity;
        return shot;
    }

    private static Kick Kick(AimRequest request, double elevation, double azimuth) =>
        new() { Elevation = elevation, Azimuth = azimuth, Top = request.TopSpin, Side = request.SideSpin };

    private Vector3d Raised(in Vector3d point) => AimContext.Raised(_simulator, point);
}
