namespace FootballPhysics.Labs.Stability;

/// <summary>The invariants of the state after every frame.</summary>
internal static class StateCheck
{
    /// <summary>The energy, J, below which a ball counts as at rest: neither its size nor its time is checked.</summary>
    private const double Nothing = 1e-40;

    /// <summary>The limit of evaluations per frame: some milliseconds.</summary>
    private const long MostEvaluations = 100_000;

    /// <summary>Checks that the state is finite, its orientation a rotation, its position on or above the ground, and its time right.</summary>
    /// <returns>False if the state is not finite: no other check is possible.</returns>
    public static bool Holds(StressFrame frame)
    {
        ref readonly BallState before = ref frame.Before;
        ref readonly BallState after = ref frame.After;
        string method = $"{frame.Scene.Settings.Integrator}{(frame.Scene.HasOwnForces ? ", own force" : "")}";
        if (!(after.Position.IsFinite && after.Velocity.IsFinite && after.Spin.IsFinite && after.Orientation.IsFinite && double.IsFinite(after.Time)))
        {
            frame.FindMild($"not finite, {method}", 1, $"{before.Motion} at {before.Velocity}, {before.Spin} to {after.Velocity}, {after.Spin}");
            return false;
        }

        double size = Math.Abs(after.Orientation.LengthSquared - 1);
        frame.FindIf(size > 1e-9, "orientation", size, $"size² {after.Orientation.LengthSquared}");

        double depth = frame.Contact - after.Position.Y;
        frame.FindMildIf(depth > frame.Touching, $"penetration, {method}", depth, $"{before.Motion} to {after.Motion}");

        frame.FindIf(
            after.Motion != MotionState.Airborne && (depth != 0 || after.Velocity.Y != 0), "on the ground but not at it", 1,
            $"{after.Motion}, {-depth} m above, {after.Velocity.Y} m/s");

        double late = Math.Abs(after.Time - (before.Time + frame.Length));
        frame.FindIf(late > 4 * StressFrame.Ulp(after.Time), "clock", late, $"{before.Time} to {after.Time}");

        return true;
    }

    /// <summary>Checks that braking never reverses a motion, and that a decaying quantity never grows.</summary>
    public static void Reversal(StressFrame frame)
    {
        StressScene scene = frame.Scene;
        if (frame.Log.Events.Count > 0 || scene.HasOwnForces)
        {
            return;
        }

        ref readonly BallState before = ref frame.Before;
        ref readonly BallState after = ref frame.After;
        ForceSet forces = scene.Scene.Forces;
        bool flies = before.Motion == MotionState.Airborne && after.Motion == MotionState.Airborne;
        frame.FindIf(flies && Vector3d.Dot(before.Spin, after.Spin) < 0, "spin reversed in flight", 1, $"{before.Spin} to {after.Spin}");

        // The remainder of a spin that has ended is rounding.
        frame.FindIf(
            before.Spin.Y * after.Spin.Y < -1e-15 * before.Spin.Y * before.Spin.Y, "spin about the vertical reversed", 1,
            $"{before.Motion} to {after.Motion}, {before.Spin.Y} to {after.Spin.Y}");

        if (scene.Windy)
        {
            return;
        }

        frame.FindIf(
            flies && scene.Upward == 0 && forces.Magnus == ForceLaw.None && Vector3d.Dot(before.Velocity, after.Velocity) < 0, "velocity reversed by drag", 1,
            $"{before.Velocity} to {after.Velocity}, {scene.Settings.Integrator}");

        bool straight = forces.Magnus == ForceLaw.None || scene.Scene.Ground.Aerodynamics == GroundAerodynamics.None;
        frame.FindIf(
            straight && before.Motion == MotionState.Rolling && after.Motion == MotionState.Rolling && Vector3d.Dot(before.Velocity, after.Velocity) < -1e-20, "roll reversed", 1,
            $"{before.Velocity} to {after.Velocity}");

        double growth = (after.Spin.Length / before.Spin.Length) - 1;
        frame.FindIf(
            before.Motion == MotionState.Airborne && forces.SpinDecay != ForceLaw.None && growth > 1e-14, "spin grew in flight", growth,
            $"{before.Spin} to {after.Spin}");
    }

    /// <summary>Checks the work of a frame, in evaluations: a clock also counts other programs.</summary>
    public static void Work(StressFrame frame)
    {
        frame.FindMildIf(
            frame.Log.Evaluations > MostEvaluations, $"long frame of {(frame.Length >= 1 ? "a second or more" : "less than a second")}", frame.Log.Evaluations,
            $"{frame.Log.Steps} pieces, {frame.Log.Events.Count} events");
    }

    /// <summary>Checks that a frame creates no more energy than the method's own error. Skips the measured laws: their error is unbounded.</summary>
    public static void Energy(StressFrame frame)
    {
        if (!frame.Scene.Measured)
        {
            Gain(frame);
        }
    }

    /// <summary>Checks the energy only without wind and without custom forces.</summary>
    public static void EnergyInStillAir(StressFrame frame)
    {
        if (!frame.Scene.Windy && !frame.Scene.HasOwnForces)
        {
            Gain(frame);
        }
    }

    private static void Gain(StressFrame frame)
    {
        if (frame.Energy() is not { } energy || energy.Holds || energy.Gained < Nothing)
        {
            return;
        }

        StressScene scene = frame.Scene;
        ref readonly BallState before = ref frame.Before;
        ref readonly BallState after = ref frame.After;
        BallProperties ball = scene.Scene.Ball;
        double scale = (0.5 * ball.Mass * Math.Max(before.Velocity.LengthSquared, after.Velocity.LengthSquared))
            + (0.5 * ball.MomentOfInertia * Math.Max(before.Spin.LengthSquared, after.Spin.LengthSquared))
            + (ball.Mass * Math.Abs(scene.Upward) * (Math.Max(before.Position.Y, after.Position.Y) - frame.Contact));
        double share = (energy.Gained - energy.Allowed) / (scale + 1e-290);
        string size = share > 0.01 ? "more than 1 %" : share > 1e-4 ? "more than 0.01 %" : "little";
        ForceSet forces = scene.Scene.Forces;
        frame.FindMild(
            $"energy made, {size}, {scene.Settings.Integrator}, {before.Motion} to {after.Motion}, {(frame.Log.Events.Count > 0 ? "events, " : "")}"
            + $"{(frame.Log.StalledSteps > 0 ? "stalled, " : "")}drag {forces.Drag}, Magnus {forces.Magnus}",
            share,
            $"{energy.Gained} J, of which the method may make {energy.ByMethod} J, contact {energy.ByContact} J, rounding {energy.ByRounding} J");
    }
}
