using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Stability;

/// <summary>The invariants of the events of every frame.</summary>
internal static class EventCheck
{
    public static void Events(StressFrame frame)
    {
        double lastTime = frame.Before.Time;
        double end = frame.Before.Time + frame.Length;
        foreach (ref readonly BallEvent item in frame.Log.Events)
        {
            bool finite = item.Position.IsFinite && item.Velocity.IsFinite && item.Spin.IsFinite
                && item.VelocityBefore.IsFinite && item.SpinBefore.IsFinite && double.IsFinite(item.Time);
            if (!finite)
            {
                frame.FindMild($"event not finite, {frame.Scene.Settings.Integrator}{(frame.Scene.HasOwnForces ? ", own force" : "")}", 1, $"{item.Kind}");
                continue;
            }

            frame.FindIf(
                !(item.Time >= lastTime && item.Time <= end), "time of an event", Math.Max(lastTime - item.Time, item.Time - end),
                $"{item.Kind} at {item.Time:R} after {lastTime:R} in a frame to {end:R}");
            double off = Math.Abs(item.Position.Y - frame.Contact);
            frame.FindIf(off > frame.Touching, "event off contact", off, $"{item.Kind}");

            if (item.Kind == BallEventKind.Impact)
            {
                Impact(frame, in item);
            }

            double radius = frame.Scene.Scene.Ball.Radius;
            var slip = new Vector3d(item.Velocity.X + (radius * item.Spin.Z), 0, item.Velocity.Z - (radius * item.Spin.X));
            frame.FindIf(item.Kind == BallEventKind.Roll && slip.Length > 1e-12 * (1 + item.Velocity.Length), "slip after a roll", slip.Length, $"{slip}");

            frame.FindIf(item.Kind == BallEventKind.Rest && frame.After.Motion != MotionState.Rest, "rest but not stopped", 1, $"{frame.After.Motion}");

            lastTime = item.Time;
        }
    }

    /// <summary>Checks that the events of one instant are in the order: bounce, slide, roll, rest.</summary>
    public static void Kinds(StressFrame frame)
    {
        double lastTime = frame.Before.Time;
        BallEventKind? lastKind = null;
        foreach (ref readonly BallEvent item in frame.Log.Events)
        {
            // After the limit of impacts per step the ball stays on the object, and hits it there again.
            bool spent = frame.Log.Events.Count > StepRun.MostImpacts;
            if (item.Time == lastTime && item.Kind < lastKind && lastKind != BallEventKind.Rest && !spent)
            {
                string kind = item.Kind == BallEventKind.Impact ? $"impact after {lastKind} at the same instant" : "order of kinds";
                frame.Find(kind, 1, $"{item.Kind} after {lastKind}");
            }

            lastTime = item.Time;
            lastKind = item.Kind;
        }
    }

    /// <summary>Checks that no event is farther from the one before than a ball can move.</summary>
    public static void Ways(StressFrame frame)
    {
        StressScene scene = frame.Scene;

        // The speed of a ball is unbounded if a wind lifts it in proportion to its spin.
        if (scene.HasOwnForces || (scene.Windy && scene.Scene.Forces.Magnus == ForceLaw.Constant) || scene.Settings.RollingTransition != RollingTransition.Exact)
        {
            return;
        }

        double lastTime = frame.Before.Time;
        Vector3d lastPlace = frame.Before.Position;
        foreach (ref readonly BallEvent item in frame.Log.Events)
        {
            // The limit is three times the distance at the fastest speed of the frame, or at the surface speed of the spin, plus the share of gravity. A wind that
            // presses the ball down lifts it sideways, for a while far faster. The clock has the resolution of its last bit.
            double time = item.Time - lastTime + (2 * StressFrame.Ulp(item.Time));
            double way = (item.Position - lastPlace).Horizontal.Length;
            double surface = scene.Scene.Ball.Radius * Math.Max(frame.Before.Spin.Length, item.SpinBefore.Length);
            double speed = frame.Fastest + surface + scene.Scene.Air.Wind.Length + 1e-9;
            double most = ((scene.Windy ? 10 : 3) * speed * time) + 1e-9 + (4 * StressFrame.Ulp(1e6)) + (time * Math.Abs(scene.Upward) * frame.Length);
            frame.FindMildIf(way > most, "event too far on", way / most, $"{item.Kind} {way} m on after {time} s at up to {frame.Fastest} m/s");

            lastTime = item.Time;
            lastPlace = item.Position;
        }
    }

    /// <summary>Checks that a hop has a length, and that a ball slides, rolls and rests once.</summary>
    public static void Hops(StressFrame frame)
    {
        double notBefore = frame.Before.Time;
        double rise = 0;
        int others = 0;
        foreach (ref readonly BallEvent item in frame.Log.Events)
        {
            if (item.Kind != BallEventKind.Impact)
            {
                others++;
                continue;
            }

            frame.FindIf(
                !(item.Time >= notBefore), "hop", notBefore - item.Time,
                $"impact at {item.Time} after a rise at {rise} m/s, not possible before {notBefore}");

            notBefore = item.Time + ShortestHop(frame, in item);
            rise = item.Velocity.Y;
        }

        // A ball that is heavier than the air slides, rolls and rests once, if no lift takes it off the ground again. The air alone moves a weightless ball.
        bool leaves = frame.Scene.Scene.Ground.Aerodynamics == GroundAerodynamics.Full;
        frame.FindIf(others > 3 && frame.Scene.Upward < 0 && !leaves, "events", others, $"{others} of a ball on the ground");
    }

    /// <summary>Returns the shortest duration of a hop: 2 v/a with the largest downward acceleration. It is half as long for semi-implicit Euler, which falls before it rises.</summary>
    private static double ShortestHop(StressFrame frame, in BallEvent impact)
    {
        Scene scene = frame.Scene.Scene;
        SolverSettings settings = frame.Scene.Settings;

        // A ball that rises more slowly than the minimum bounce speed stays down, and lift may take it off the ground again at any time: that is not a hop.
        if (impact.Velocity.Y < scene.Ground.MinimumBounceSpeed)
        {
            return 0;
        }

        // The ball moves as fast as before, with explicit Euler a little faster.
        double speed = 1.5 * (impact.Velocity - scene.Air.Wind).Length;
        double down = Math.Max(0, -frame.Scene.Upward) + frame.Air.Size(speed, scene.Ball.Radius * impact.Spin.Length);
        double tolerance = settings.CollisionTiming == CollisionTiming.Bisection ? 2 * settings.CollisionTolerance : 1e-12;
        return ((1 - 1e-6) * impact.Velocity.Y / Math.Max(down, 1e-300)) - tolerance;
    }

    private static void Impact(StressFrame frame, in BallEvent item)
    {
        SolverSettings settings = frame.Scene.Settings;

        // Contact may be found late or early by this much, and the speeds are rounded.
        double late = settings.CollisionTiming == CollisionTiming.Bisection ? 2 * settings.CollisionTolerance : 1e-15 * frame.Length;
        double pull = Math.Max(Math.Abs(frame.Scene.Upward), frame.Scene.HasOwnForces ? 2 * frame.Fastest / frame.Length : 0);
        if (item.VelocityBefore.Y > (late * pull) + (1e-15 * frame.Fastest))
        {
            string coarse = settings.CollisionTolerance > 1e-4 ? ", coarse" : "";
            frame.FindMild(
                $"impact of a ball that rises{(frame.Scene.HasOwnForces ? ", own force" : "")}, {settings.CollisionTiming}{coarse}",
                item.VelocityBefore.Y,
                $"{item.VelocityBefore.Y} m/s, {settings.Integrator}");
        }

        BallProperties ball = frame.Scene.Scene.Ball;
        Law(frame.Scene.Scene, item.VelocityBefore, item.SpinBefore, out Vector3d velocity, out Vector3d spin);
        double scale = item.VelocityBefore.Length + (ball.Radius * item.SpinBefore.Length) + 1e-300;
        double off = ((velocity - item.Velocity).Length + (ball.Radius * (spin - item.Spin).Length)) / scale;
        frame.FindIf(off > 1e-13 && !frame.Scene.Measured, "law of impact", off, $"{item.VelocityBefore}, {item.SpinBefore} to {item.Velocity}, {item.Spin}");

        double before = (ball.Mass * item.VelocityBefore.LengthSquared) + (ball.MomentOfInertia * item.SpinBefore.LengthSquared);
        double after = (ball.Mass * item.Velocity.LengthSquared) + (ball.MomentOfInertia * item.Spin.LengthSquared);
        frame.FindIf(after > before * (1 + 1e-12) && after > 1e-300, "energy of an impact", (after / before) - 1, $"{0.5 * before} J to {0.5 * after} J");
    }

    /// <summary>Applies the law of impact again, from its equations. A ball that does not approach gets no impulse.</summary>
    private static void Law(Scene scene, Vector3d v, Vector3d w, out Vector3d velocity, out Vector3d spin)
    {
        if (!(v.Y < 0))
        {
            velocity = v;
            spin = w;
            return;
        }

        double a = scene.Ball.InertiaFactor;
        double r = scene.Ball.Radius;
        double ex = scene.Ground.Material.TangentialRestitution;
        double ez = scene.Ground.TangentialRestitutionZ ?? ex;
        velocity = new Vector3d(
            (((1 - (a * ex)) * v.X) - (a * (1 + ex) * r * w.Z)) / (1 + a),
            -scene.Ground.Material.NormalRestitution * v.Y,
            (((1 - (a * ez)) * v.Z) + (a * (1 + ez) * r * w.X)) / (1 + a));
        spin = new Vector3d(
            (((a - ez) * w.X) + ((1 + ez) * v.Z / r)) / (1 + a),
            scene.Ground.Material.SpinRestitution * w.Y,
            (((a - ex) * w.Z) - ((1 + ex) * v.X / r)) / (1 + a));
    }
}
