using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Finds a player's touches of the ball: dribbling touch, trap, first-time shot and shielding.</summary>
/// <remarks>
/// Each result contains the motion of the foot, the simulated motion of the ball, the deviation from the request, and the chance of success. The touch never
/// gives the ball more speed or spin than the <see cref="Foot"/> can produce. The game's bodies and an engine's colliders are ignored, because they include the
/// player's own legs. Not thread-safe: create one per thread.
/// </remarks>
public sealed class Touches
{
    /// <summary>The speed error above which a topspin is tried, in m/s.</summary>
    private const double Pace = 0.05;

    private const int MostSpeeds = 8;
    private const long Seed = 20261124;

    /// <summary>The starting elevations of the search, in degrees relative to the aimed one.</summary>
    private static readonly double[] s_elevations = [0, 4, 8, 14, -4];

    private readonly Simulator _simulator;
    private readonly DribbleProblem _dribble;
    private readonly TrapProblem _trap;
    private readonly FirstTimeProblem _shot;
    private readonly Aimer _aimer;
    private readonly double[] _x = new double[3];
    private readonly double[] _residuals = new double[3];

    /// <summary>Creates a solver for touches in a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="foot">The foot; default: a <see cref="Foot"/> with a maximum speed of 25 m/s.</param>
    /// <param name="spread">The errors of the foot; default: the values of <see cref="TouchSpread"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public Touches(Scene? scene = null, Foot? foot = null, TouchSpread? spread = null)
    {
        // Remove bodies and engine colliders: one of them is the kicking foot, which would block the ball.
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

    /// <summary>The errors of the foot.</summary>
    public TouchSpread Spread { get; }

    /// <summary>Finds the touch that brings the ball to a running player at a given time and speed.</summary>
    /// <remarks>The ball may arrive with any motion. The touch matches the wanted speed as closely as friction allows.</remarks>
    /// <param name="ball">The ball at the touch.</param>
    /// <param name="request">The player, his run, and the position at which he wants the ball.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public Touch Dribble(in BallState ball, DribbleRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        BallState.Launched(in ball);

        // 1. Solve for the horizontal velocity that reaches the position on time. 2. If the resulting speed is wrong, try topspin.
        _dribble.Set(in ball, request);

        // The first guess is the mean velocity over the ground.
        Vector3d mean = (request.BallTarget - ball.Position).Horizontal / request.Duration;
        _x[0] = mean.X;
        _x[1] = mean.Z;
        _x[2] = 0;
        _dribble.Solve(_x);
        double pace = Math.Abs(_dribble.Residuals[2]);
        if (pace > Pace)
        {
            (double x, double z) = (_x[0], _x[1]);

            // Solve for three unknowns, from position and speed. Keep the result if it hits, or if it is within tolerance at a better speed.
            _dribble.Free(spin: true);
            bool helps = _dribble.Solve(_x) || (Off(_dribble.Residuals) < request.Tolerance && Math.Abs(_dribble.Residuals[2]) < pace);
            _dribble.Free(spin: false);
            if (!helps)
            {
                // Use the touch without topspin after all.
                (_x[0], _x[1], _x[2]) = (x, z, 0);
                _dribble.Solve(_x);
            }
        }

        // Simulate the chosen touch, because the result contains its position, speed and strike.
        _dribble.Evaluate(_x, _residuals);
        double miss = Off(_residuals);
        double paceMiss = Math.Abs(_residuals[2]);
        TouchStatus status = miss <= request.Tolerance ? TouchStatus.Done : !_dribble.Strike.FastEnough ? TouchStatus.FootTooSlow : TouchStatus.OutOfReach;
        FootStrike strike = _dribble.Strike;
        BallState end = _dribble.End;
        double chance = Chance(_dribble, in strike, r => Off(r) <= request.SuccessRadius);
        return new Touch(status, in strike, end.Position, end.Velocity, request.Duration, miss, paceMiss, chance);
    }

    /// <summary>Finds the strike that stops the ball, or leaves it rolling with the player.</summary>
    /// <param name="ball">The ball at the touch.</param>
    /// <param name="request">The player's velocity, and the tolerance.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
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

        // As a first guess, the ball takes on the player's velocity at once.
        _trap.Solve(_x);
        _trap.Evaluate(_x, _residuals);
        double off = Off(_residuals);
        FootStrike strike = _trap.Strike;
        BallState end = _trap.End;

        // The distance of the ball from the touch in the player's frame: the ball's displacement minus the player's.
        double gone = (end.Position - ball.Position - (request.Duration * velocity)).Horizontal.Length;
        TouchStatus status = off <= request.Tolerance ? TouchStatus.Done : !strike.FastEnough ? TouchStatus.FootTooSlow : TouchStatus.OutOfReach;
        double chance = Chance(_trap, in strike, r => Off(r) <= request.SuccessSpeed);
        return new Touch(status, in strike, end.Position, end.Velocity, request.Duration, gone, off, chance);
    }

    /// <summary>Finds the strike that sends a moving ball to a target without a trap.</summary>
    /// <remarks>The shot is slower if the foot is not fast enough. A strike cannot remove incoming spin about the impulse direction; the search takes
    /// this spin into account.</remarks>
    /// <param name="ball">The ball at the touch.</param>
    /// <param name="request">The target, and the speed and spin of the shot.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
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

        // 1. Aim as if the ball were at rest. 2. Solve for the strike, with the share of the incoming spin that remains. 3. If the foot is too slow, retry with a slower kick.
        double speed = request.Speed;
        bool fast = false;
        for (int i = 0; i < MostSpeeds && !fast; i++)
        {
            // Skip the measurement, because the aim only starts the search.
            AimResult aim = _aimer.Find(AimFor(in ball, request, speed), measure: false);
            _shot.Set(in ball, request, speed);
            SolveShot(in aim, request.MaximumElevationDegrees);
            fast = _shot.Strike.FastEnough;

            // Retry 5 % slower, or just below the speed that the foot reached if this is even slower, so that a few tries are sufficient.
            speed = fast ? speed : Math.Max(0.5, Math.Min(0.95 * speed, 0.995 * _shot.Strike.Velocity.Length));
        }

        FootStrike strike = _shot.Strike;
        PathPoint closest = _shot.Closest;
        double miss = _shot.Miss;
        TouchStatus status = fast && miss <= request.Tolerance ? TouchStatus.Done : !fast ? TouchStatus.FootTooSlow : TouchStatus.OutOfReach;
        double chance = Chance(_shot, in strike, _ => _shot.Miss <= request.SuccessRadius);
        return new Touch(status, in strike, closest.Position, closest.Velocity, closest.Time - ball.Time, miss, 0, chance);
    }

    /// <summary>Finds the position at which a player shields the ball from his opponents.</summary>
    /// <remarks>Opponents must run around him, and he must be able to play the ball before any of them.</remarks>
    /// <param name="request">The player, the opponents, and the maximum distance of the ball from him.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public static ShieldResult Shield(ShieldRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        return new ShieldResult(request);
    }

    /// <summary>Solves the shot from the aimed elevation, and from steeper and flatter ones if that fails; keeps the best.</summary>
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
        _shot.Evaluate(_x, _residuals);
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

    /// <summary>Returns the share of touches with random errors that succeed; each is simulated like the intended touch.</summary>
    private double Chance(TouchProblem problem, in FootStrike meant, Func<double[], bool> comesOff)
    {
        if (Spread.Draws == 0)
        {
            return double.NaN;
        }

        int good = 0;
        for (int i = 0; i < Spread.Draws; i++)
        {
            // Draw five independent errors, with the same seeds for every touch, so that touches are comparable.
            NormalDistribution.Draw(SplitMix64.At(Seed, 6 * i), SplitMix64.At(Seed, (6 * i) + 1), out double a, out double b);
            NormalDistribution.Draw(SplitMix64.At(Seed, (6 * i) + 2), SplitMix64.At(Seed, (6 * i) + 3), out double c, out double d);
            NormalDistribution.Draw(SplitMix64.At(Seed, (6 * i) + 4), SplitMix64.At(Seed, (6 * i) + 5), out double e, out _);

            // An offset Δ of the contact point on the ball's surface turns the normal by Δ/r.
            double turn = Math.PI / 180.0 * Spread.DirectionDegrees;
            double tilt = Spread.Contact / _simulator.Scene.Ball.Radius;

            // Strike with these errors in speed, direction and contact point, and follow the ball.
            Vector3d foot = (1.0 + (0.01 * Spread.SpeedPercent * a)) * Turned(meant.FootVelocity, turn * b, turn * c);
            Vector3d normal = Turned(meant.Normal, tilt * d, tilt * e);
            FootStrike strike = Foot.Strike(
                _simulator.Scene.Ball, problem.Ball.Velocity, problem.Ball.Spin, KickVectors.Limited(in foot, Limits.Speed), normal);
            good += problem.Follow(strike.Velocity, strike.Spin, _residuals) && comesOff(_residuals) ? 1 : 0;
        }

        return (double)good / Spread.Draws;
    }

    /// <summary>Turns a vector by two small angles, in rad, about axes perpendicular to it; its length is unchanged.</summary>
    private static Vector3d Turned(in Vector3d vector, double first, double second)
    {
        double length = vector.Length;
        if (!(length > 0))
        {
            return vector;
        }

        Vector3d along = vector / length;

        // Construct two perpendicular axes from the y axis, or from the x axis if the vector is almost vertical.
        Vector3d across = Vector3d.Cross(Math.Abs(along.Y) < 0.9 ? Vector3d.Up : new Vector3d(1, 0, 0), in along);
        across /= across.Length;
        Vector3d turned = along + (first * across) + (second * Vector3d.Cross(in along, in across));
        return length / turned.Length * turned;
    }
}
