namespace FootballPhysics.Labs.Scenes;

/// <summary>Compares a ball on carriers that turn, accelerate in steps, are tilted or round, with a textbook integration of slip and roll.</summary>
internal sealed class Carriers : SceneKind
{
    private const double Limit = 1e-6;

    /// <summary>
    /// The comparison ends at a load below this share of the weight, or at a slower roll, m/s, that friction brakes: there the ball leaves, or comes to rest.
    /// It also ends when friction cannot hold a roll: the model finds that instant only to within its step.
    /// </summary>
    private const double LeastLoad = 0.05;
    private const double SlowestRoll = 0.2;

    private enum Form
    {
        Turntable,
        Platform,
        TiltedDisc,
        Drum,
    }

    public override string Name => "carriers";

    public override string Claim => "On a carrier the ball goes where the equations of slip and roll take it, in steps of 0.05 ms: 1e-6 m. Frames of 4 to 33 ms, divided where the error of the steps is more than a fifth of that. A comparison ends where a roll loses its grip.";

    protected override SceneOutcome Play(SeededRandom random)
    {
        while (true)
        {
            Form form = random.Any(Form.Turntable, Form.Platform, Form.TiltedDisc, Form.Drum);
            PieceKind kind = form == Form.Platform ? random.Any(PieceKind.Bodies, PieceKind.Colliders) : random.Any(PieceKind.Obstacles, PieceKind.Bodies, PieceKind.Colliders);
            if (Compare(random, form, kind) is { } outcome)
            {
                return outcome;
            }
        }
    }

    private static SceneOutcome? Compare(SeededRandom random, Form form, PieceKind kind)
    {
        double radius = random.Chance(0.6) ? 0.11 : random.Uniform(0.06, 0.2);
        double inertia = random.Any(2.0 / 3, 0.4);
        double curve = form == Form.Drum ? random.Uniform(0.5, 3) : 0;
        Vector3d normal = form == Form.TiltedDisc ? Tilted(random) : form == Form.Drum ? Leaning(random.Uniform(-0.3, 0.3)) : Vector3d.Up;
        Vector3d axis = form == Form.Drum ? new Vector3d(0, 0, 1) : normal;
        Vector3d spin = form == Form.Platform ? default : random.Log(0.3, 6) * random.Any(-1.0, 1.0) * axis;
        Vector3d velocity = random.Chance(0.5) || form == Form.Drum ? default : LabMath.Along(random.Uniform(0, 2) * random.Direction(), normal);
        bool jumps = kind != PieceKind.Obstacles && form != Form.Drum && (form == Form.Platform || random.Chance(0.5));
        double push = random.Uniform(0.2, 5);
        double frame = Math.Min(random.Log(0.004, 1 / 30.0), 0.1 / Math.Max(1e-9, spin.Length));
        double duration = form == Form.Drum ? random.Uniform(0.2, 1) : random.Uniform(0.7, 2.5);

        double damping = random.Chance(0.5) ? 0 : random.Uniform(0.1, 5);
        double rolling = random.Chance(0.6) ? 0 : random.Log(0.005, 0.1);
        BallProperties ball = BallProperties.Tunnel with { Radius = radius, InertiaFactor = inertia };
        SurfaceMaterial surface = SurfaceMaterial.GoalFrame with
        {
            NormalRestitution = 0.5,
            SlidingFriction = random.Chance(0.3) ? 5 : random.Uniform(0.15, 1),
            RollingResistance = rolling,
            RollingResistancePerSpeed = rolling > 0 && random.Chance(0.5) ? 0.006 : 0,
            SpinDamping = damping * ball.MomentOfInertia,
        };
        Vector3d place = form == Form.Drum ? ((curve + radius) * normal) + (random.Uniform(-1, 1) * axis) : (radius * normal) + LabMath.Along(random.Uniform(0, 2) * random.Direction(), normal);
        Vector3d beneath = velocity + Vector3d.Cross(spin, place - (radius * normal));
        Vector3d moves = beneath + LabMath.Along(random.Log(0.3, form == Form.Drum ? 1 : 4) * random.Direction(), normal);
        Vector3d turns = random.Chance(0.5) ? (Vector3d.Cross(normal, moves - beneath) / radius) + (random.Uniform(-10, 10) * normal) : random.Log(0.5, 40) * random.Direction();

        var model = new CarrierModel(
            radius, inertia, new Vector3d(0, -9.81, 0), surface.SlidingFriction, rolling, surface.RollingResistancePerSpeed, damping, kind != PieceKind.Obstacles, curve, axis, normal)
        {
            Place = place,
            Moves = moves,
            Turns = turns,
        };

        // The motions of the carrier, frame by frame, until the comparison ends.
        List<(Vector3d Pivot, double Angle, Vector3d Velocity, Vector3d Spin)> frames = [];
        Vector3d pivot = default;
        double angle = 0;
        Vector3d before = model.Place;
        for (double time = 0; time + frame <= duration; time += frame)
        {
            before = model.Place;
            (model.Pivot, model.Velocity, model.Spin) = (pivot, velocity, spin);
            model.Advance(frame);
            if (model.LostGrip || !(model.LeastLoad > LeastLoad) || (rolling > 0 && model.SlowestRoll < SlowestRoll))
            {
                model.Place = before;
                break;
            }

            frames.Add((pivot, angle, velocity, spin));
            pivot += frame * velocity;
            angle += frame * Vector3d.Dot(spin, axis);
            velocity += jumps ? LabMath.Along(push * frame * random.Direction(), normal) : default;
            spin += jumps && form != Form.Platform ? random.Uniform(-4, 4) * frame * axis : default;
        }

        if (frames.Count * frame < 0.1)
        {
            return null;
        }

        IShape shape = form == Form.Drum ? new CapsuleShape(-30 * axis, 30 * axis, curve) : new BoxShape(-0.5 * normal, new Vector3d(60, 0.5, 60), LabMath.Upright(normal));
        BallState Run(int share) => Library(kind, shape, surface, ball, place, moves, turns, axis, frames, frame, share);
        int parts = Divide(Limit, share => Vector3d.Distance(Run(share).Position, Run(4 * share).Position));
        BallState found = Run(parts);
        double error = Vector3d.Distance(found.Position, model.Place);
        return new SceneOutcome(
            FormattableString.Invariant($"{form} of {kind}"), true, double.IsNaN(error) ? double.PositiveInfinity : error, Limit,
            FormattableString.Invariant($"{frames[0].Spin.Length:0.00} rad/s, {frames.Count} frames of {1000 * frame:0.0} ms / {parts}, μ {surface.SlidingFriction:0.00}, c₀ {rolling:0.000}, jumps {jumps}: {error:e1} m off, {found.Motion}"));
    }

    private static BallState Library(
        PieceKind kind, IShape shape, SurfaceMaterial surface, BallProperties ball, Vector3d place, Vector3d moves, Vector3d turns, Vector3d axis,
        List<(Vector3d Pivot, double Angle, Vector3d Velocity, Vector3d Spin)> frames, double frame, int parts)
    {
        var pieces = new ScenePieces(kind);
        pieces.Add(shape, surface);
        pieces.MoveTo(default, Quaterniond.Identity, frames[0].Velocity, frames[0].Spin, 0);
        var scene = new Scene { Ball = ball, Air = new Air { Density = 0 }, Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = -1000, RestEnergy = 1e-12 } };
        var simulator = new Simulator(pieces.In(scene, frames[0].Velocity, frames[0].Spin));
        BallState state = simulator.Launch(place, moves, turns);
        foreach ((Vector3d pivot, double angle, Vector3d velocity, Vector3d spin) in frames)
        {
            double start = state.Time;
            for (int i = 0; i < parts; i++)
            {
                double since = state.Time - start;
                double turned = angle + (since * Vector3d.Dot(spin, axis));
                pieces.Step(simulator, ref state, frame / parts, pivot + (since * velocity), Quaterniond.FromAxisAngle(axis, turned), velocity, spin);
            }
        }

        return state;
    }
    private static Vector3d Leaning(double angle) => new(Math.Sin(angle), Math.Cos(angle), 0);

    private static Vector3d Tilted(SeededRandom random)
    {
        double tilt = random.Uniform(0.02, 0.6);
        Vector3d towards = random.Heading();
        return (Math.Cos(tilt) * Vector3d.Up) + (Math.Sin(tilt) * towards);
    }
}
