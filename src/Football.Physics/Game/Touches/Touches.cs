namespace FootballPhysics.Aiming;

/// <summary>
/// The ball at a player's feet: the dribbling touch, the trap, the first-time shot of a moving ball, and where it is shielded. Each answer is the motion of the foot, what the ball
/// does then by the simulation itself, how far that is from what was wanted, and how surely it comes off.
/// </summary>
/// <remarks>
/// The foot is a <see cref="Foot"/>: what it cannot give, for want of speed or friction, the answer does not have. The game's bodies and an engine's colliders are left out: the player's
/// own legs are among them. Its memory is its own: one a thread.
/// </remarks>
public sealed class Touches
{
    /// <summary>A difference of the pace above this, m/s, is worth a topspin.</summary>
    private const double Pace = 0.05;

    private const int MostSpeeds = 8;
    private const long Seed = 20261124;

    /// <summary>Elevations that a shot is begun with, degrees beside that of its aim.</summary>
    private static readonly double[] s_elevations = [0, 4, 8, 14, -4];

    private readonly Simulator _simulator;
    private readonly DribbleProblem _dribble;
    private readonly TrapProblem _trap;
    private readonly FirstTimeProblem _shot;
    private readonly Aimer _aimer;
    private readonly double[] _x = new double[3];
    private readonly double[] _residuals = new double[3];

    /// <summary>Prepares for touches in a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="foot">The foot; default <see cref="Foot"/>'s numbers, with a fastest speed of 25 m/s.</param>
    /// <param name="spread">How much the foot errs; default <see cref="TouchSpread"/>'s numbers.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Touches(Scene? scene = null, Foot? foot = null, TouchSpread? spread = null)
    {
        // Without bodies and engine colliders: the foot that strikes is one of them, and would be in the way.
        Scene own = (scene ?? Scene.Default) with { Bodies = null, EngineColliders = null };
        Foot = foot ?? new Foot { MaximumSpeed = 25 };
        Spread = spread ?? new TouchSpread();
        Spread.Validate();
        _simulator = new Simulator(own);
        _dribble = new DribbleProblem(_simulator, Foot);
        _trap = new TrapProblem(_simulator, Foot);
        _shot = new FirstTimeProblem(_simulator, Foot);
        _aimer = new Aimer(own);
    }

    /// <summary>The foot.</summary>
    public Foot Foot { get; }

    /// <summary>How much it errs.</summary>
    public TouchSpread Spread { get; }

    /// <summary>
    /// Finds the touch after which the ball is where a running player wants it, at a time on his way, at his pace as near as its friction allows; whatever it did before.
    /// </summary>
    /// <param name="ball">The ball at the touch.</param>
    /// <param name="request">The player, his way, and where he wants the ball on it.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public Touch Dribble(in BallState ball, DribbleRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        BallState.Launched(in ball);

        // 1. The velocity over the ground that brings it there in time. 2. Where it is then too slow or too fast, a topspin, as far as it helps.
        _dribble.Set(in ball, request);

        // First guess: the mean velocity over the ground.
        Vector3d mean = (request.Wanted - ball.Position).Horizontal / request.Duration;
        _x[0] = mean.X;
        _x[1] = mean.Z;
        _x[2] = 0;
        _dribble.Solve(_x);
        double pace = Math.Abs(_dribble.Residuals[2]);
        if (pace > Pace)
        {
            (double x, double z) = (_x[0], _x[1]);

            // Three unknowns for place and pace; kept where it hits, or is still near enough and the pace is better.
            _dribble.Free(spin: true);
            bool helps = _dribble.Solve(_x) || (Off(_dribble.Residuals) < request.Tolerance && Math.Abs(_dribble.Residuals[2]) < pace);
            _dribble.Free(spin: false);
            if (!helps)
            {
                // Back to the touch without topspin.
                (_x[0], _x[1], _x[2]) = (x, z, 0);
                _dribble.Solve(_x);
            }
        }

        // What is told is what this touch does: place, pace and strike.
        _dribble.Fly(_x, _residuals);
        double miss = Off(_residuals);
        double paceMiss = Math.Abs(_residuals[2]);
        TouchStatus status = miss <= request.Tolerance ? TouchStatus.Done : !_dribble.Strike.FastEnough ? TouchStatus.FootTooSlow : TouchStatus.OutOfReach;
        FootStrike strike = _dribble.Strike;
        BallState end = _dribble.End;
        double chance = Chance(_dribble, in strike, r => Off(r) <= request.SuccessRadius);
        return new Touch(status, in strike, end.Position, end.Velocity, request.Duration, miss, paceMiss, chance);
    }

    /// <summary>Finds the motion of the foot that takes the ball's speed, so that it lies dead, or rolls with the player, once it has settled.</summary>
    /// <param name="ball">The ball at the touch.</param>
    /// <param name="request">The player's velocity, and how dead is dead.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public Touch Trap(in BallState ball, TrapRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        BallState.Launched(in ball);
        _trap.Set(in ball, request);
        Vector3d velocity = request.Velocity.Horizontal;
        _x[0] = velocity.X;
        _x[1] = velocity.Z;

        // First guess: the ball goes as the player does at once.
        _trap.Solve(_x);
        _trap.Fly(_x, _residuals);
        double off = Off(_residuals);
        FootStrike strike = _trap.Strike;
        BallState end = _trap.End;

        // How far from where the player would have it: the ball's own way less his.
        double gone = (end.Position - ball.Position - (request.Duration * velocity)).Horizontal.Length;
        TouchStatus status = off <= request.Tolerance ? TouchStatus.Done : !strike.FastEnough ? TouchStatus.FootTooSlow : TouchStatus.OutOfReach;
        double chance = Chance(_trap, in strike, r => Off(r) <= request.SuccessSpeed);
        return new Touch(status, in strike, end.Position, end.Velocity, request.Duration, gone, off, chance);
    }

    /// <summary>Finds the strike that sends a moving ball to a target as it comes, within what the foot can do: slower where it is not fast enough.</summary>
    /// <remarks>The spin that the ball brings along the direction of the strike stays: no touch takes it. The shot is aimed with that.</remarks>
    /// <param name="ball">The ball at the touch.</param>
    /// <param name="request">The target, and how the ball is to go there.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public Touch FirstTimeShot(in BallState ball, FirstTimeRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        BallState.Launched(in ball);
        if (!((request.Target - ball.Position).Horizontal.Length > 0.01))
        {
            return new Touch(TouchStatus.Degenerate, default, ball.Position, ball.Velocity, 0, (request.Target - ball.Position).Length, 0, double.NaN);
        }

        // 1. A kick of a ball at rest to the target. 2. The strike for it, aimed again with the spin that stays. 3. Slower, where the foot is too slow for that.
        double speed = request.Speed;
        bool fast = false;
        for (int i = 0; i < MostSpeeds && !fast; i++)
        {
            // Unmeasured: it is only where the search for the strike begins.
            AimResult aim = _aimer.Find(AimFor(in ball, request, speed), measure: false);
            _shot.Set(in ball, request, speed);
            SolveShot(in aim, request.MaximumElevationDegrees);
            fast = _shot.Strike.FastEnough;

            // Below what the foot gave the ball, and by a twentieth at least: a few tries are enough.
            speed = fast ? speed : Math.Max(0.5, Math.Min(0.95 * speed, 0.995 * _shot.Strike.Velocity.Length));
        }

        FootStrike strike = _shot.Strike;
        PathPoint closest = _shot.Closest;
        double miss = _shot.Miss;
        TouchStatus status = fast && miss <= request.Tolerance ? TouchStatus.Done : !fast ? TouchStatus.FootTooSlow : TouchStatus.OutOfReach;
        double chance = Chance(_shot, in strike, _ => _shot.Miss <= request.SuccessRadius);
        return new Touch(status, in strike, closest.Position, closest.Velocity, closest.Time - ball.Time, miss, 0, chance);
    }

    /// <summary>Finds where the ball is shielded: where the player plays it before any opponent can, who must go around him.</summary>
    /// <param name="request">The player, the opponents, and how far the ball may be from him.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public static ShieldResult Shield(ShieldRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        return new ShieldResult(request);
    }

    /// <summary>From the aim of a ball without the spin that stays; and where that first meets the ground, from steeper and flatter ones. The best stays.</summary>
    private void SolveShot(in AimResult aim, double steepest)
    {
        double least = double.PositiveInfinity;
        (double elevation, double azimuth) = (aim.ElevationDegrees, aim.AzimuthDegrees);
        foreach (double steeper in s_elevations)
        {
            _x[0] = Math.Max(-5, Math.Min(aim.ElevationDegrees + steeper, steepest));
            _x[1] = aim.AzimuthDegrees;
            bool hits = _shot.Solve(_x);
            if (_shot.Miss < least)
            {
                least = _shot.Miss;
                (elevation, azimuth) = (_x[0], _x[1]);
            }

            if (hits)
            {
                return;
            }
        }

        (_x[0], _x[1]) = (elevation, azimuth);
        _shot.Fly(_x, _residuals);
    }

    private static AimRequest AimFor(in BallState ball, FirstTimeRequest request, double speed) => new()
    {
        From = ball.Position,
        Target = request.Target,
        Speed = speed,
        TopSpin = request.TopSpin,
        SideSpin = request.SideSpin,
        MaximumElevationDegrees = request.MaximumElevationDegrees,
        Arc = request.Arc,
    };

    private static double Off(double[] r) => Math.Sqrt((r[0] * r[0]) + (r[1] * r[1]));

    /// <summary>The share of touches with the foot's errors that come off: each is struck and followed as the meant one.</summary>
    private double Chance(TouchProblem problem, in FootStrike meant, Func<double[], bool> comesOff)
    {
        if (Spread.Draws == 0)
        {
            return double.NaN;
        }

        int good = 0;
        for (int i = 0; i < Spread.Draws; i++)
        {
            // Five independent errors a draw; the same ones for every touch, so that two can be compared.
            NormalDistribution.Draw(SplitMix64.At(Seed, 6 * i), SplitMix64.At(Seed, (6 * i) + 1), out double a, out double b);
            NormalDistribution.Draw(SplitMix64.At(Seed, (6 * i) + 2), SplitMix64.At(Seed, (6 * i) + 3), out double c, out double d);
            NormalDistribution.Draw(SplitMix64.At(Seed, (6 * i) + 4), SplitMix64.At(Seed, (6 * i) + 5), out double e, out _);

            // Where it touches by a metre on the ball's surface is an angle of the normal: Δ/r.
            double turn = Math.PI / 180.0 * Spread.DirectionDegrees;
            double tilt = Spread.Contact / _simulator.Scene.Ball.Radius;

            // A foot of another speed, direction and point of contact strikes, and the ball goes where it goes.
            Vector3d foot = (1.0 + (0.01 * Spread.SpeedPercent * a)) * Turned(meant.FootVelocity, turn * b, turn * c);
            Vector3d normal = Turned(meant.Normal, tilt * d, tilt * e);
            FootStrike strike = Foot.Strike(
                _simulator.Scene.Ball, problem.Ball.Velocity, problem.Ball.Spin, KickVectors.Limited(in foot, Limits.Speed), normal);
            good += problem.Follow(strike.Velocity, strike.Spin, _residuals) && comesOff(_residuals) ? 1 : 0;
        }

        return (double)good / Spread.Draws;
    }

    /// <summary>A vector turned by two small angles, rad, across itself; its length stays.</summary>
    private static Vector3d Turned(in Vector3d vector, double first, double second)
    {
        double length = vector.Length;
        if (!(length > 0))
        {
            return vector;
        }

        Vector3d along = vector / length;

        // Two axes across it; from up, or where it is nearly that, from x.
        Vector3d across = Vector3d.Cross(Math.Abs(along.Y) < 0.9 ? Vector3d.Up : new Vector3d(1, 0, 0), in along);
        across /= across.Length;
        Vector3d turned = along + (first * across) + (second * Vector3d.Cross(in along, in across));
        return length / turned.Length * turned;
    }
}
