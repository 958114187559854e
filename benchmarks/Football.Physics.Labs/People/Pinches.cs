namespace FootballPhysics.Labs.People;

/// <summary>Two players run at a ball that lies or falls between them, each at his own speed and a little aside.</summary>
internal sealed class Pinches() : PeopleCases("between two players")
{
    private const int Frames = 150;

    /// <summary>A player touches the ball if he is closer than this at an end of a frame, m, or came closer within it.</summary>
    private const double Close = 1e-3;

    /// <summary>The rounding error of the paths, as a share of a speed.</summary>
    private const double Rounding = 1e-6;

    public readonly PeopleClaim TooFast = new("pinched: faster than it may be, share", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);
    public readonly PeopleClaim Beyond20 = new("pinched: faster than 20 m/s, m/s", ClaimParts.Count | ClaimParts.Worst);
    public readonly PeopleClaim Squeezed = new("pinched: squeezed", ClaimParts.Count);

    /// <summary>Squeezes that had not ended after the players had passed each other.</summary>
    public readonly PeopleClaim Unending = new("pinched: squeezed when the players have passed");
    public readonly PeopleClaim InGround = new("pinched: in the ground, m", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);

    public override PeopleClaim[] Claims => [TooFast, Beyond20, Squeezed, Unending, InGround];

    /// <summary>Simulates one pinch.</summary>
    public override void Play(long seed, int index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        var bodies = new KinematicBodies();
        WalkingPlayer[] players = [new(bodies, "one"), new(bodies, "other")];
        var scene = new Scene { Bodies = bodies };
        var ball = new Ball(scene);
        double frame = random.Chance(0.6) ? 1.0 / 60 : random.Uniform(0.005, 0.04);
        ball.Place(new Vector3d(0, random.Chance(0.5) ? Radius : random.Uniform(Radius, 1.2), 0));
        double first = random.Uniform(0.2, 8);
        double second = random.Chance(0.3) ? 0 : random.Uniform(0.2, 8);
        players[0].Place = new Vector3d(-random.Uniform(0.4, 1.5), 0, random.Chance(0.3) ? 0 : random.Uniform(-0.15, 0.15));
        players[1].Place = new Vector3d(random.Uniform(0.4, 1.5), 0, random.Chance(0.3) ? 0 : random.Uniform(-0.15, 0.15));
        players[0].Velocity = new Vector3d(first, 0, 0);
        players[1].Velocity = new Vector3d(-second, 0, 0);
        var bound = new SpeedBound(scene.Gravity);
        double fastest = 0;
        double deepest = 0;
        double arrival = 0;
        bool tooFast = false;
        bool squeezed = false;
        for (int i = 0; i < Frames; i++)
        {
            BallState before = ball.State;
            foreach (WalkingPlayer player in players)
            {
                player.Put(ball.Time);
            }

            Meter.Step(ball, frame, $"pinch {index}, frame {i}");
            BallState after = ball.State;
            double most = bound.Follow(in before, in after, Touch(players, ball, frame, in before, in after), SurfaceMaterial.Boot);
            double speed = after.Velocity.Length;
            fastest = Math.Max(fastest, speed);

            // Only a squeeze limits the speed: two players who approach each other may make a ball between them faster with each impact.
            bool wasSqueezed = before.Motion == MotionState.Pinned;
            arrival = wasSqueezed ? arrival : 0;
            bool released = wasSqueezed;
            foreach (ref readonly BallEvent item in ball.Events)
            {
                bool begins = item.Kind == BallEventKind.Pinned;
                released |= begins;
                arrival = begins ? Math.Max(arrival, item.VelocityBefore.Length) : arrival;
            }

            most = Math.Max(most, arrival);
            tooFast |= released && speed > most * (1 + Rounding);
            if (released && speed > 0.1)
            {
                TooFast.See(speed / most, $"pinch {index}, frame {i}: {speed:0.00} m/s from players of {first:0.00} and {second:0.00} m/s");
            }

            squeezed |= after.Motion == MotionState.Pinned;
            deepest = Math.Max(deepest, Radius - after.Position.Y);
            foreach (WalkingPlayer player in players)
            {
                player.Walk(frame);
            }
        }

        Cases++;
        Beyond20.Judge(fastest, 20);
        TooFast.Case(tooFast);
        Squeezed.Case(squeezed);
        Unending.Case(ball.Motion == MotionState.Pinned && players[0].Place.X - players[1].Place.X > 1, $"pinch {index}");
        InGround.Judge(deepest, Entered);
    }

    /// <summary>Returns the speed of the fastest player who touched the ball in a frame, the times of the touches, and the ball's speed at the first of them.</summary>
    private static MoverTouch Touch(WalkingPlayer[] players, Ball ball, double frame, in BallState before, in BallState after)
    {
        double fastest = -1;
        double from = after.Time;
        double to = before.Time;
        double came = -1;
        double highest = 0;
        foreach (ref readonly BallEvent item in ball.Events)
        {
            highest = Math.Max(highest, item.Position.Y);
            string? name = item.ColliderIndex > 0 ? ball.Simulator.NameOf(item.ColliderIndex) : null;
            if (name is "one" or "other")
            {
                fastest = Math.Max(fastest, players[name == "one" ? 0 : 1].Velocity.Length);
                came = came < 0 ? item.VelocityBefore.Length : came;
                from = Math.Min(from, item.Time);
                to = Math.Max(to, item.Time);
            }
        }

        foreach (WalkingPlayer player in players)
        {
            bool atFirst = player.Distance(before.Position, 0) < Radius + Close;
            bool atLast = player.Distance(after.Position, frame) < Radius + Close;
            fastest = atFirst || atLast ? Math.Max(fastest, player.Velocity.Length) : fastest;
            from = atFirst ? before.Time : from;
            to = atLast ? after.Time : to;
        }

        return new MoverTouch(fastest, came, from, to, highest);
    }
}

/// <summary>
/// Bounds the speed that moving objects may give a ball: (1 + e) times the fastest object's speed, or the speed after the impact of the first object
/// alone, which adds (1 + e) u at most. After a time without a touch the bound starts from scratch. Speed gained by falling does not count.
/// </summary>
internal sealed class SpeedBound(double gravity)
{
    /// <summary>Touches that are farther apart than this, s, are independent.</summary>
    private const double Apart = 0.1;

    private double _most;
    private double _highest;
    private double _touched = double.NegativeInfinity;

    /// <summary>Returns the largest speed that a step allows, m/s.</summary>
    /// <param name="before">The ball before the step.</param>
    /// <param name="after">The ball after the step.</param>
    /// <param name="touch">The moving objects that touched the ball in the step.</param>
    /// <param name="material">Their material.</param>
    public double Follow(in BallState before, in BallState after, in MoverTouch touch, SurfaceMaterial material)
    {
        if (touch.Speed >= 0)
        {
            double e = Restitution(material);
            if (touch.Came >= 0 && touch.From - _touched > Apart)
            {
                _most = touch.Came + ((1 + e) * touch.Speed);
                _highest = before.Position.Y;
            }

            _most = Math.Max(_most, (1 + e) * touch.Speed);
            _touched = touch.To;
        }
        else
        {
            // Speed that the ball gains from its spin on the ground is allowed.
            _most = Math.Max(_most, after.Velocity.Length);
        }

        _highest = Math.Max(_highest, Math.Max(touch.Highest, Math.Max(before.Position.Y, after.Position.Y)));
        return double.IsInfinity(_touched)
            ? double.PositiveInfinity
            : Math.Sqrt((_most * _most) + (2 * gravity * (_highest - Math.Min(before.Position.Y, after.Position.Y))) + SpinEnergy(before.Spin));
    }

    /// <summary>Returns 2 E/m of the spin, m²/s²: a contact with friction may turn it into speed.</summary>
    private static double SpinEnergy(in Vector3d spin) => BallProperties.Modern.InertiaFactor * BallProperties.Modern.Radius * BallProperties.Modern.Radius * spin.LengthSquared;

    /// <summary>Returns e(v) = e₆ √(1 + (6/V_e)²)/√(1 + (v/V_e)²) of the slowest hits.</summary>
    private static double Restitution(SurfaceMaterial surface) => double.IsInfinity(surface.RestitutionSpeedScale)
        ? surface.NormalRestitution
        : Math.Min(1, surface.NormalRestitution * Math.Sqrt(1 + (36 / (surface.RestitutionSpeedScale * surface.RestitutionSpeedScale))));
}

/// <summary>The touches of moving objects with a ball in a step.</summary>
/// <param name="Speed">The speed of the fastest object, m/s; negative without a touch.</param>
/// <param name="Came">The speed of the ball before the first touch, m/s; negative if the object already touched the ball.</param>
/// <param name="From">The time of the first touch, s.</param>
/// <param name="To">The time of the last touch, s.</param>
/// <param name="Highest">The greatest height of the ball at an event of the step, m.</param>
internal readonly record struct MoverTouch(double Speed, double Came, double From, double To, double Highest);
