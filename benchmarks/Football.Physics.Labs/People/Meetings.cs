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
        InGround.See(deepest);
        InGround.Case(deepest > Entered);
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
