using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Hostile;

/// <summary>What must hold of the events of every frame.</summary>
internal static class HostileEventCheck
{
    public static void Events(HostileFrame frame)
    {
        double lastTime = frame.Before.Time;
        Vector3d lastPlace = frame.Before.Position;
        BallEventKind? lastKind = null;
        foreach (ref readonly BallEvent item in frame.Log.Events)
        {
            bool finite = item.Position.IsFinite && item.Velocity.IsFinite && item.Spin.IsFinite
                && item.VelocityBefore.IsFinite && item.SpinBefore.IsFinite && double.IsFinite(item.Time);
            if (!finite)
            {
                frame.FindMild($"event not finite, {frame.Scene.Settings.Integrator}{(frame.Scene.HasOwnForces ? ", own force" : "")}", 1, $"{item.Kind}");
                continue;
            }

            Order(frame, in item, lastTime, lastKind);
            Place(frame, in item, lastTime, in lastPlace);
            if (item.Kind == BallEventKind.Impact)
            {
                Impact(frame, in item);
            }

            double radius = frame.Scene.Scene.Ball.Radius;
            var slip = new Vector3d(item.Velocity.X + (radius * item.Spin.Z), 0, item.Velocity.Z - (radius * item.Spin.X));
            if (item.Kind == BallEventKind.Roll && slip.Length > 1e-12 * (1 + item.Velocity.Length))
            {
                frame.Find("slip after a roll", slip.Length, $"{slip}");
            }

            if (item.Kind == BallEventKind.Rest && frame.After.Motion != MotionState.Rest)
            {
                frame.Find("rest but not stopped", 1, $"{frame.After.Motion}");
            }

            lastTime = item.Time;
            lastPlace = item.Position;
            lastKind = item.Kind;
        }
    }

    private static void Order(HostileFrame frame, in BallEvent item, double lastTime, BallEventKind? lastKind)
    {
        double end = frame.Before.Time + frame.Length;
        if (!(item.Time >= lastTime && item.Time <= end))
        {
            frame.Find("time of an event", Math.Max(lastTime - item.Time, item.Time - end), $"{item.Kind} at {item.Time:R} after {lastTime:R} in a frame to {end:R}");
        }

        // After all impacts that a step may have the ball stays on what it hits, and is hit there again.
        bool spent = frame.Log.Events.Count > StepRun.MostImpacts;
        if (item.Time == lastTime && item.Kind < lastKind && lastKind != BallEventKind.Rest && !spent)
        {
            string kind = item.Kind == BallEventKind.Impact ? $"impact after {lastKind} at the same instant" : "order of kinds";
            frame.Find(kind, 1, $"{item.Kind} after {lastKind}");
        }
    }

    private static void Place(HostileFrame frame, in BallEvent item, double lastTime, in Vector3d lastPlace)
    {
        double off = Math.Abs(item.Position.Y - frame.Contact);
        if (off > frame.Touching)
        {
            frame.Find("event off contact", off, $"{item.Kind}");
        }

        // Three times as far as the fastest of the frame, or as a spin can make it, and what gravity adds; a wind that presses the ball down lifts it sideways, for a while far faster.
        // The clock is as coarse as its last bit.
        double time = item.Time - lastTime + (2 * HostileFrame.Ulp(item.Time));
        double way = (item.Position - lastPlace).Horizontal.Length;
        double surface = frame.Scene.Scene.Ball.Radius * Math.Max(frame.Before.Spin.Length, item.SpinBefore.Length);
        double speed = frame.Fastest + surface + frame.Scene.Scene.Air.Wind.Length + 1e-9;
        double most = ((frame.Scene.Windy ? 10 : 3) * speed * time) + 1e-9 + (4 * HostileFrame.Ulp(1e6)) + (time * Math.Abs(frame.Scene.Upward) * frame.Length);
        if (way > most && !frame.Scene.HasOwnForces && !frame.Scene.LiftsByWind && frame.Scene.Settings.RollingTransition == RollingTransition.Exact)
        {
            frame.FindMild("event too far on", way / most, $"{item.Kind} {way} m on after {time} s at up to {frame.Fastest} m/s");
        }
    }

    private static void Impact(HostileFrame frame, in BallEvent item)
    {
        SolverSettings settings = frame.Scene.Settings;

        // So late or early contact may be found, and the speeds are rounded.
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
        if (off > 1e-13)
        {
            frame.Find("law of impact", off, $"{item.VelocityBefore}, {item.SpinBefore} to {item.Velocity}, {item.Spin}");
        }

        double before = (ball.Mass * item.VelocityBefore.LengthSquared) + (ball.MomentOfInertia * item.SpinBefore.LengthSquared);
        double after = (ball.Mass * item.Velocity.LengthSquared) + (ball.MomentOfInertia * item.Spin.LengthSquared);
        if (after > before * (1 + 1e-12))
        {
            frame.Find("energy of an impact", (after / before) - 1, $"{0.5 * before} J to {0.5 * after} J");
        }
    }

    /// <summary>The law of impact once more, from its equations; what comes no closer gets no impulse.</summary>
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
