using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.People;

/// <summary>Two players run at a ball that lies between them, or falls there, each at his own speed and a little aside.</summary>
internal sealed class Pinches
{
    private const double Radius = 0.11;
    private const int Frames = 150;

    /// <summary>What moves is close where it is closer than this at an end of a frame, m, or came closer in it.</summary>
    private const double Close = 1e-3;

    /// <summary>Rounding of the paths, as a share of a speed.</summary>
    private const double Rounding = 1e-6;

    public StepMeter Meter { get; } = new();

    public int Cases { get; private set; }

    /// <summary>With a frame after which the ball is faster than it may be.</summary>
    public int TooFast { get; private set; }

    /// <summary>The greatest share of what is allowed.</summary>
    public double MostShare { get; private set; }

    public string MostShareAt { get; private set; } = "";

    /// <summary>The fastest ball, m/s.</summary>
    public double Fastest { get; private set; }

    /// <summary>With a ball of more than 20 m/s.</summary>
    public int Beyond20 { get; private set; }

    /// <summary>Pinches in which the ball was squeezed.</summary>
    public int Squeezed { get; private set; }

    /// <summary>Squeezes that had not ended when the players had passed each other.</summary>
    public int Unending { get; private set; }

    public string UnendingAt { get; private set; } = "";

    /// <summary>How deep the ball was in the ground at most, m.</summary>
    public double Deepest { get; private set; }

    /// <summary>Plays one pinch.</summary>
    public void Play(long seed, int index)
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
            tooFast |= speed > most * (1 + Rounding);
            if (speed > MostShare * most && speed > 0.1)
            {
                MostShare = speed / most;
                MostShareAt = FormattableString.Invariant($"pinch {index}, frame {i}: {speed:0.00} m/s from players of {first:0.00} and {second:0.00} m/s");
            }

            squeezed |= after.Motion == MotionState.Pinned;
            Deepest = Math.Max(Deepest, Radius - after.Position.Y);
            foreach (WalkingPlayer player in players)
            {
                player.Walk(frame);
            }
        }

        Cases++;
        Fastest = Math.Max(Fastest, fastest);
        Beyond20 += fastest > 20 ? 1 : 0;
        TooFast += tooFast ? 1 : 0;
        Squeezed += squeezed ? 1 : 0;
        UnendingAt = ball.Motion == MotionState.Pinned ? FormattableString.Invariant($"pinch {index}") : UnendingAt;
        Unending += ball.Motion == MotionState.Pinned && players[0].Place.X - players[1].Place.X > 1 ? 1 : 0;
    }

    /// <summary>The fastest of the players who touched the ball in a frame, and when; how fast it came to the first of them.</summary>
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
