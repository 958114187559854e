namespace FootballPhysics.Labs.People;

/// <summary>One moving object and a ball on open ground: a player whose foot is on the ground, a leg, a boot, a head that comes down.</summary>
internal sealed class Meetings() : PeopleCases("one thing and a ball")
{
    private const int Frames = 150;
    private static readonly IShape[] s_shapes =
    [
        new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25),
        new CapsuleShape(new Vector3d(0, -1, 0), new Vector3d(0, 1.55, 0), 0.25),
        new BoxShape(new Vector3d(0, 0.06, 0), new Vector3d(0.05, 0.06, 0.14)),
        new SphereShape(new Vector3d(0, 0.3, 0), 0.12),
    ];

    public readonly PeopleClaim TooFast = new("met by one: faster than a rigid hit explains");
    public readonly PeopleClaim InGround = new("met by one: in the ground, m", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);
    public readonly PeopleClaim Overlap = new("met by one: in what moves, m", ClaimParts.Worst);

    public override PeopleClaim[] Claims => [TooFast, InGround, Overlap];

    /// <summary>Simulates one meeting.</summary>
    public override void Play(long seed, int index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        int which = index % s_shapes.Length;
        var bodies = new KinematicBodies();
        KinematicBody body = bodies.Add("mover", s_shapes[which], SurfaceMaterial.Boot);
        var ball = new Ball(new Scene { Bodies = bodies });
        double frame = random.Chance(0.7) ? 1.0 / 60 : random.Uniform(0.005, 0.04);
        ball.Place(new Vector3d(0, random.Chance(0.7) ? Radius : random.Uniform(Radius, 1), 0));
        Vector3d heading = random.Heading();
        Vector3d place = (-random.Uniform(0.4, 1.2) * heading) + new Vector3d(random.Uniform(-0.12, 0.12), 0, random.Uniform(-0.12, 0.12));
        double speed = random.Uniform(0.2, 8);
        double faster = random.Uniform(-2, 2);
        if (random.Chance(0.5))
        {
            ball.Kick(new Vector3d(random.Uniform(-5, 5), random.Uniform(0, 3), random.Uniform(-5, 5)), random.Uniform(0, 45) * random.Direction());
        }

        double kicked = ball.State.Velocity.Length;
        double most = speed;
        double deepest = 0;
        for (int i = 0; i < Frames; i++)
        {
            body.MoveTo(place, speed * heading, ball.Time);
            Meter.Step(ball, frame, $"meeting {index}, frame {i}");
            place += frame * speed * heading;
            speed = Math.Clamp(speed + (frame * faster), -8.5, 8.5);
            most = Math.Max(most, Math.Abs(speed));
            Vector3d at = ball.State.Position;
            TooFast.Case(ball.State.Velocity.Length > 1.05 * ((1.5 * most) + Math.Max(kicked, 1) + 3));
            deepest = Math.Max(deepest, Radius - at.Y);
            Overlap.See(Radius - Distance(which, at - place), $"meeting {index}, frame {i}: {ball.Motion}");
        }

        Cases++;
        InGround.Judge(deepest, Entered);
        Overlap.Case(false);
    }

    private static double Distance(int which, Vector3d place) => which switch
    {
        0 => Solid.Capsule(place, new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25),
        1 => Solid.Capsule(place, new Vector3d(0, -1, 0), new Vector3d(0, 1.55, 0), 0.25),
        2 => Solid.Box(place, new Vector3d(0, 0.06, 0), new Vector3d(0.05, 0.06, 0.14)),
        _ => (place - new Vector3d(0, 0.3, 0)).Length - 0.12,
    };
}

/// <summary>A ball goes into the edge of board and ground at a flat angle, as along a touchline. Compares its time of rest with the same kick on open ground.</summary>
internal sealed class FlatHits() : PeopleCases("flat into an edge")
{
    private const double Frame = 1.0 / 60;

    /// <summary>The longest time to wait for rest, s.</summary>
    private const double Longest = 90;

    /// <summary>The longest slide in the edge that is allowed, s.</summary>
    private const double LongSlide = 2;

    private readonly (Simulator Simulator, double Board)[] _pitches =
    [
        On(Pitch.Cage),
        On(Pitch.Stadium),
        (new Simulator(new Scene { Obstacles = [new Obstacle { Name = "right board", Shape = new BoxShape(new Vector3d(5.05, 0.5, 0), new Vector3d(0.05, 0.5, 400)), Surface = SurfaceMaterial.Board }] }), 5),
    ];

    private readonly Simulator _open = new(new Scene());

    public readonly PeopleClaim SlidLong = new("flat into an edge: slides in it for more than 2 s");
    public readonly PeopleClaim Restless = new("flat into an edge: not at rest after 90 s; the longest, s", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);

    /// <summary>
    /// Counts balls at rest later than on open ground, from the last hit or support by a board. A ball counts only if it is later than both with the same
    /// motion and with all its energy as rolling, because spin at a board may drive the ball on with that energy.
    /// </summary>
    public readonly PeopleClaim Later =
        new("flat into an edge: at rest later than with its energy on open ground, s", ClaimParts.Count | ClaimParts.Worst | ClaimParts.Verdict);

    /// <summary>Counts balls at rest later than on open ground from there with the same motion.</summary>
    public readonly PeopleClaim SpinLater = new("flat into an edge: at rest later than from its last hit on open ground, s", ClaimParts.Count | ClaimParts.Worst);

    /// <summary>Counts balls at rest later than the same kick on open ground: a board that returns a spinning ball turns its backspin into topspin.</summary>
    public readonly PeopleClaim Turned = new("flat into an edge: at rest later than from the kick on open ground, s", ClaimParts.Count | ClaimParts.Worst);

    public override PeopleClaim[] Claims => [SlidLong, Restless, Later, SpinLater, Turned];

    /// <summary>Simulates one kick; kicks that miss the board are not counted.</summary>
    public override void Play(long seed, int index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));
        (Simulator simulator, double board) = _pitches[index % _pitches.Length];
        double speed = random.Chance(0.5) ? random.Uniform(2, 20) : random.Uniform(0.5, 12);
        double aside = random.Uniform(0, 0.6) * random.Uniform(0, 1);
        double up = random.Chance(0.5) ? 0 : random.Uniform(0, 0.35);
        Vector3d velocity = speed * new Vector3d(Math.Cos(up) * Math.Sin(aside), Math.Sin(up), -Math.Cos(up) * Math.Cos(aside));
        Vector3d spin = random.Below(3) switch
        {
            0 => Vector3d.Zero,
            1 => new Vector3d(velocity.Z / Radius, random.Uniform(-40, 40), -velocity.X / Radius),
            _ => new Vector3d(random.Uniform(-60, 60), random.Uniform(-60, 60), random.Uniform(-60, 60)),
        };
        var from = new Vector3d(board - Radius - random.Uniform(0, 1.2 * random.Next()), Radius, random.Uniform(0, 8));
        var ball = new Ball(simulator) { State = simulator.Launch(from, velocity, spin) };
        bool hit = false;
        double slid = 0;
        BallState last = ball.State;
        while (ball.Motion != MotionState.Rest && ball.Time < Longest)
        {
            Meter.Step(ball, Frame, $"hit {index}, {ball.Time} s");
            foreach (ref readonly BallEvent item in ball.Events)
            {
                hit |= item.ColliderIndex > 0 && simulator.NameOf(item.ColliderIndex) == "right board";
                last = item.Kind == BallEventKind.Impact && item.ColliderIndex > 0 ? ball.State : last;
            }

            Vector3d place = ball.State.Position;
            bool touches = Math.Abs(board - Radius - place.X) < 1e-6;
            bool isDown = place.Y < Radius + 1e-4;
            last = touches && !isDown ? ball.State : last;
            slid += ball.Motion == MotionState.Sliding && isDown && touches ? Frame : 0;
        }

        if (!hit)
        {
            return;
        }

        Cases++;
        FormattableString at = $"hit {index}: rests after {ball.Time:0.00} s, velocity {velocity}, spin {spin}, from {from}";
        SlidLong.Case(slid > LongSlide, at);
        Restless.See(ball.Time);
        Restless.Case(ball.Motion != MotionState.Rest);
        double spinLater = ball.Time - OnOpenGround(last.Position, last.Velocity, last.Spin, last.Time);
        Note(SpinLater, spinLater, null);
        Vector3d rolling = Rolling(simulator.Scene.Ball, in last);
        Note(Later, Math.Min(spinLater, ball.Time - OnOpenGround(last.Position, rolling, new Vector3d(rolling.Z / Radius, 0, -rolling.X / Radius), last.Time)), at);
        Note(Turned, ball.Time - OnOpenGround(from, velocity, spin, 0), at);
    }

    private static void Note(PeopleClaim claim, double later, FormattableString? at) => claim.Judge(later, Frame, later > Frame ? at : null);

    /// <summary>Returns the rolling speed with all the ball's energy, m (1 + α) v²/2 = m v²/2 + I ω²/2.</summary>
    private static Vector3d Rolling(BallProperties ball, in BallState s)
    {
        double energy = s.Velocity.LengthSquared + (ball.InertiaFactor * ball.Radius * ball.Radius * s.Spin.LengthSquared);
        Vector3d along = s.Velocity.Horizontal;
        return along.Length > 0 ? Math.Sqrt(energy / (1 + ball.InertiaFactor)) / along.Length * along : Vector3d.Zero;
    }

    /// <summary>Returns the time at which a ball rests on open ground, s.</summary>
    private double OnOpenGround(Vector3d from, Vector3d velocity, Vector3d spin, double time) => time + _open.Fly(from, velocity, spin, Frame, Longest, StopAt.Rest).Time;

    private static (Simulator Simulator, double Board) On(Pitch pitch) => (new Simulator(pitch.On()), (0.5 * pitch.Width) + pitch.BoardDistance);
}
