namespace Football.Physics;

/// <summary>What touching the ground does to the ball: an impact, and whether it then flies, slides or rolls; the end of a slip; leaving; rest.</summary>
internal sealed class ContactPhase<TAir>
    where TAir : struct, IAir
{
    private readonly BallProperties _ball;
    private readonly Ground _ground;
    private readonly Surroundings<TAir> _around;
    private readonly FlightSystem<TAir> _flight;

    public ContactPhase(Scene scene, Surroundings<TAir> around)
    {
        _ball = scene.Ball;
        _ground = scene.Ground;
        _around = around;
        _flight = new FlightSystem<TAir> { Around = around };
    }

    /// <summary>An impact where the ball is, and what becomes of the ball.</summary>
    public void Impact(ref BallState s, ref StepRun run)
    {
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        ImpactResponse.Apply(_ball, _ground, in v, in w, out Vector3d velocity, out Vector3d spin);
        run.Log.Events.Add(new BallEvent(BallEventKind.Impact, 0, Vector3d.Up, s.Time, s.Position, in v, in w, in velocity, in spin));
        run.Log.Halted |= run.Log.StopAt == StopAt.Impact;
        s.Branch = DragBranch.Unknown;
        if (run.Hit() && Leaves(in s, in velocity, in spin, ref run))
        {
            s.Velocity = velocity;
            s.SetFlightSpin(in spin);
            return;
        }

        s.Velocity = velocity.Horizontal;
        s.SetGroundSpin(in spin);
        if (Slip.Of(s.Velocity, in spin, _ball.Radius).Length < Slip.Rolling)
        {
            StartRolling(ref s, ref run);
        }
        else
        {
            s.Motion = MotionState.Sliding;
            run.Log.Events.Add(new BallEvent(BallEventKind.Slide, 0, Vector3d.Up, s.Time, s.Position, s.Velocity, in spin, s.Velocity, in spin));
        }
    }

    /// <summary>The slip is over: the spin becomes that of pure rolling.</summary>
    public void StartRolling(ref BallState s, ref StepRun run)
    {
        Vector3d before = s.Spin;
        Vector3d spin = Slip.RollingSpin(s.Velocity, before.Y, _ball.Radius);
        s.SetGroundSpin(in spin);
        s.Motion = MotionState.Rolling;
        run.Log.Events.Add(new BallEvent(BallEventKind.Roll, 0, Vector3d.Up, s.Time, s.Position, s.Velocity, in before, s.Velocity, in spin));
    }

    /// <summary>The ball comes to rest.</summary>
    public void Rest(ref BallState s, ref StepRun run)
    {
        run.Log.Events.Add(new BallEvent(BallEventKind.Rest, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
        run.Log.Halted |= run.Log.StopAt == StopAt.Rest;
        s.Velocity = Vector3d.Zero;
        s.SetGroundSpin(Vector3d.Zero);
        s.Motion = MotionState.Stopped;
    }

    /// <summary>A ball that is lighter than the air leaves the ground, unless the wind presses it down.</summary>
    /// <returns>True when it left.</returns>
    public bool LeavesGround(ref BallState s, ref StepRun run)
    {
        if (_around.Upward <= 0 || IsPressedDown(in s, s.Velocity, s.Spin, ref run))
        {
            return false;
        }

        s.SetFlightSpin(s.Spin);
        s.Motion = MotionState.Airborne;
        s.Branch = DragBranch.Unknown;
        return true;
    }

    /// <summary>Whether the ball flies on after an impulse: fast enough to count as a bounce, or lighter than the air and not pressed down.</summary>
    private bool Leaves(in BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run) =>
        velocity.Y >= _ground.MinimumBounceSpeed
            ? velocity.Y >= 0.5 * StabilityLimit.ShortestHop * -_around.Upward
            : _around.Upward > 0 && !IsPressedDown(in s, velocity.Horizontal, in spin, ref run);

    /// <summary>Whether the vertical force on a ball that is lighter than the air, at contact and without vertical velocity, points down.</summary>
    private bool IsPressedDown(in BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        var at = new Motion(s.Position, in velocity, in spin);
        FlightSystem<TAir> system = _flight;
        run.Log.Evaluations++;
        return system.On(system.JumpAt(in at).Branch, s.Time, in at).Acceleration.Y <= 0;
    }
}
