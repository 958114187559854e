namespace FootballPhysics.Labs.Scenes;

/// <summary>Compares a ball in the path of shapes that a game turns about a pivot with an exact rotation. It follows the gap without the library's contacts.</summary>
internal sealed class Turns : SceneKind
{
    private const double Limit = 1e-3;
    private const double Radius = 0.11;

    /// <summary>A pass or touch by less than this, m, is undecided.</summary>
    private const double Grazes = 1e-5;

    /// <summary>A touch that closes slower than this, m/s, may be a pass.</summary>
    private const double Slow = 0.01;

    private static readonly SurfaceMaterial s_rubber = SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = 0.5,
        RestitutionSpeedScale = double.PositiveInfinity,
        ImpactFriction = 0,
        SlidingFriction = 0,
    };

    public override string Name => "turns";

    public override string Claim => "A shape that turns about its pivot first touches the ball where an exact rotation does, and throws it as its surface moves there: 1e-3 m, and 1e-3 of the speed.";

    protected override SceneOutcome Play(SeededRandom random)
    {
        PieceKind kind = random.Any(PieceKind.Bodies, PieceKind.Colliders);
        while (true)
        {
            TurningModel model = Draw(random, out IShape shape, out string name);
            double gravity = random.Chance(0.5) ? 9.81 : 0;
            double duration = random.Uniform(0.2, 1);
            (Vector3d from, Vector3d velocity) = Aim(random, model, gravity, duration);
            Vector3d At(double t) => from + (t * velocity) - (0.5 * gravity * t * t * Vector3d.Up);
            if (model.Distance(At(0), 0, out _) < Radius + 0.02)
            {
                continue;
            }

            double touch = model.FirstTouch(At, velocity.Length + (gravity * duration), Radius, duration, out double least);
            bool undecided = double.IsNaN(touch) ? least < Grazes : duration - touch < Grazes || Closing(model, At, velocity, gravity, touch) < Slow;
            if (undecided)
            {
                continue;
            }

            double frame = random.Chance(0.5) ? random.Any(1 / 240.0, 1 / 60.0, 1 / 30.0) : random.Log(0.004, 0.1);
            return Compare(kind, name, shape, model, gravity, from, velocity, At, touch, duration, frame);
        }
    }

    private static TurningModel Draw(SeededRandom random, out IShape shape, out string name)
    {
        int which = random.Below(3);
        Vector3d start = random.Uniform(0, 1) * random.Direction();
        Vector3d moves = random.Chance(0.5) ? default : random.Uniform(0, 8) * random.Direction();
        Vector3d axis = random.Any(new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), new Vector3d(0, 0, 1), random.Direction(), random.Direction());
        double angle = random.Uniform(-3, 3);
        double rate = random.Log(0.5, 40) * random.Any(-1.0, 1.0);
        Vector3d a = random.Uniform(0, 0.8) * random.Direction();
        switch (which)
        {
            case 0:
                name = "sphere";
                double radius = random.Uniform(0.03, 0.3);
                shape = new SphereShape(a, radius);
                return new TurningModel(a, a, radius, false, start, moves, axis, angle, rate);
            case 1:
                name = "capsule";
                Vector3d b = a + (random.Uniform(0.1, 1.2) * random.Direction());
                double thickness = random.Uniform(0.02, 0.15);
                shape = new CapsuleShape(a, b, thickness);
                return new TurningModel(a, b, thickness, false, start, moves, axis, angle, rate);
            default:
                name = "box";
                var half = new Vector3d(random.Log(0.02, 0.8), random.Log(0.02, 0.8), random.Log(0.02, 0.8));
                shape = new BoxShape(a, half);
                return new TurningModel(a, half, 0, true, start, moves, axis, angle, rate);
        }
    }

    /// <summary>Returns the speed at which the gap closes when the ball touches, m/s.</summary>
    private static double Closing(TurningModel model, Func<double, Vector3d> at, in Vector3d velocity, double gravity, double touch)
    {
        Vector3d place = at(touch);
        model.Distance(place, touch, out Vector3d normal);
        return -Vector3d.Dot(velocity - (gravity * touch * Vector3d.Up) - model.SurfaceVelocity(place - (Radius * normal), touch), normal);
    }

    /// <summary>Draws a ball that would be near a random point of the shape at a random time, if the shape did not block it.</summary>
    private static (Vector3d From, Vector3d Velocity) Aim(SeededRandom random, TurningModel model, double gravity, double duration)
    {
        double time = random.Uniform(0.05, 0.9) * duration;
        double share = random.Next();
        Vector3d own = model.IsBox ? model.A + (random.Uniform(0, 1) * new Vector3d(random.Any(-1, 1) * model.B.X, random.Any(-1, 1) * model.B.Y, random.Any(-1, 1) * model.B.Z))
            : model.A + (share * (model.B - model.A));
        Vector3d near = model.WorldOf(own, time) + (random.Uniform(0, 0.25) * random.Direction());
        Vector3d velocity = random.Chance(0.3) ? default : random.Log(0.1, 30) * random.Direction();
        return (near - (time * velocity) + (0.5 * gravity * time * time * Vector3d.Up), velocity);
    }

    private static SceneOutcome Compare(
        PieceKind kind, string name, IShape shape, TurningModel model, double gravity, in Vector3d from, in Vector3d velocity, Func<double, Vector3d> at, double touch, double duration, double frame)
    {
        var pieces = new ScenePieces(kind);
        pieces.Add(shape, s_rubber);
        var simulator = new Simulator(pieces.In(new Scene { Ball = BallProperties.Tunnel, Gravity = gravity, Ground = Ground.None, Forces = ForceSet.None }));

        // Move the shape before the ball is launched: a launch moves the ball out of every shape that it overlaps.
        pieces.MoveTo(model.PivotAt(0), Quaterniond.FromAxisAngle(model.Axis, model.Angle), model.Velocity, model.Rate * model.Axis, 0);
        BallState state = simulator.Launch(from, velocity, default);
        BallEvent? impact = null;
        while (state.Time < duration && impact is null)
        {
            double angle = model.Angle + (model.Rate * state.Time);
            pieces.Step(
                simulator, ref state, Math.Min(frame, duration - state.Time), model.PivotAt(state.Time), Quaterniond.FromAxisAngle(model.Axis, angle), model.Velocity, model.Rate * model.Axis);
            foreach (ref readonly BallEvent item in pieces.Log.Events)
            {
                impact ??= item.Kind == BallEventKind.Impact ? item : null;
            }
        }

        string group = FormattableString.Invariant($"{name} of {kind}");
        string scene = FormattableString.Invariant($"{model.Rate:0.0} rad/s, frames of {1000 * frame:0.0} ms, ball {velocity.Length:0.00} m/s");
        bool hits = !double.IsNaN(touch);
        if (hits != impact is not null)
        {
            return new SceneOutcome(group, false, 0, Limit, FormattableString.Invariant($"{scene}: {(hits ? $"hit at {touch:0.0000} s missed" : $"hit at {impact!.Value.Time:0.0000} s that is none")}"));
        }

        if (impact is not { } found)
        {
            return new SceneOutcome(group, true, 0, Limit, scene);
        }

        // v' = v + (1 + e) u n, with the velocity of the surface at the contact point.
        Vector3d place = at(touch);
        model.Distance(place, touch, out Vector3d normal);
        Vector3d before = velocity - (gravity * touch * Vector3d.Up);
        Vector3d surface = model.SurfaceVelocity(place - (Radius * normal), touch);
        Vector3d after = before - ((1 + s_rubber.NormalRestitution) * Vector3d.Dot(before - surface, normal) * normal);
        double error = Math.Max(
            Vector3d.Distance(found.Position, place) + (Math.Abs(found.Time - touch) * Math.Max(1, before.Length)),
            Vector3d.Distance(found.Velocity, after) / Math.Max(1, surface.Length + before.Length));
        return new SceneOutcome(
            group, true, double.IsNaN(error) ? double.PositiveInfinity : error, Limit,
            FormattableString.Invariant($"{scene}: hit at {found.Time:0.00000} s for {touch:0.00000} s, {error:e1} off"));
    }
}

/// <summary>A shape that turns about its pivot and moves, exactly, and its distance from a point. It shares no code with the library's contacts.</summary>
/// <param name="A">One end of a capsule, the centre of a sphere or box, in the frame of the pivot, m.</param>
/// <param name="B">The other end of a capsule, or the half sizes of a box, m.</param>
/// <param name="Thickness">The radius of a capsule or sphere, m; 0 for a box.</param>
/// <param name="IsBox">True for a box.</param>
/// <param name="Start">The position of the pivot at time 0, m.</param>
/// <param name="Velocity">Velocity of the pivot, m/s.</param>
/// <param name="Axis">The axis, of length 1.</param>
/// <param name="Angle">The angle about the axis at time 0, rad.</param>
/// <param name="Rate">The rate about the axis, rad/s.</param>
internal sealed record TurningModel(Vector3d A, Vector3d B, double Thickness, bool IsBox, Vector3d Start, Vector3d Velocity, Vector3d Axis, double Angle, double Rate)
{
    /// <summary>A gap below this, m, is a hit.</summary>
    private const double Touches = 1e-10;

    /// <summary>The farthest point of the shape from the pivot, m.</summary>
    public double Reach => IsBox ? A.Length + B.Length : Math.Max(A.Length, B.Length) + Thickness;

    public Vector3d PivotAt(double time) => Start + (time * Velocity);

    /// <summary>Returns the point of the shape at a position in its own frame, at a time.</summary>
    public Vector3d WorldOf(in Vector3d own, double time) => PivotAt(time) + Turn(own, Angle + (Rate * time));

    /// <summary>Returns the velocity of the shape's material at a point, m/s.</summary>
    public Vector3d SurfaceVelocity(in Vector3d at, double time) => Velocity + Vector3d.Cross(Rate * Axis, at - PivotAt(time));

    /// <summary>Returns the distance from the surface, m; negative inside a capsule, 0 inside a box.</summary>
    /// <param name="point">The point, m.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="normal">The direction away from the shape; zero inside a box.</param>
    public double Distance(in Vector3d point, double time, out Vector3d normal)
    {
        Vector3d own = Turn(point - PivotAt(time), -(Angle + (Rate * time)));
        Vector3d nearest;
        if (IsBox)
        {
            Vector3d from = own - A;
            nearest = A + new Vector3d(Math.Clamp(from.X, -B.X, B.X), Math.Clamp(from.Y, -B.Y, B.Y), Math.Clamp(from.Z, -B.Z, B.Z));
        }
        else
        {
            Vector3d line = B - A;
            double length = line.LengthSquared;
            double share = length > 0 ? Math.Clamp(Vector3d.Dot(own - A, line) / length, 0, 1) : 0;
            nearest = A + (share * line);
        }

        Vector3d away = own - nearest;
        double distance = away.Length;
        normal = distance > 0 ? Turn(away / distance, Angle + (Rate * time)) : default;
        return distance - Thickness;
    }

    /// <summary>Returns the time at which a ball on a parabola first touches the shape; NaN if it does not.</summary>
    /// <param name="place">Returns the position of the ball's centre at a time.</param>
    /// <param name="speed">A speed, m/s, that the ball does not exceed.</param>
    /// <param name="radius">Its radius, m.</param>
    /// <param name="duration">The duration of the search, s.</param>
    /// <param name="least">The smallest gap, m; 0 after a hit.</param>
    public double FirstTouch(Func<double, Vector3d> place, double speed, double radius, double duration, out double least)
    {
        // No gap closes faster than this, so no step can miss a touch.
        double fastest = speed + Velocity.Length + (Math.Abs(Rate) * (Reach + radius)) + 1e-9;
        least = double.PositiveInfinity;
        double time = 0;
        while (time < duration)
        {
            double gap = Distance(place(time), time, out _) - radius;
            if (gap < Touches)
            {
                least = 0;
                return time;
            }

            least = Math.Min(least, gap);
            time += gap / fastest;
        }

        return double.NaN;
    }

    /// <summary>Rotates a vector by Rodrigues' formula.</summary>
    private Vector3d Turn(in Vector3d v, double angle)
    {
        double cosine = Math.Cos(angle);
        return (cosine * v) + (Math.Sin(angle) * Vector3d.Cross(Axis, v)) + ((1 - cosine) * Vector3d.Dot(Axis, v) * Axis);
    }
}
