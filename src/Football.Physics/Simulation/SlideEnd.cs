using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>The end of a slide in closed form, which is valid however the slip turns.</summary>
/// <remarks>Near the end the push and the load are almost constant, so it uses their means.</remarks>
internal sealed class SlideEnd
{
    /// <summary>Upper bound of the tolerance of a closed-form end, as a share of the step.</summary>
    private const double LargestSlideEnd = 1e-3;

    /// <summary>The closed form requires the squared push to be below this share of the squared friction.</summary>
    /// <remarks>Otherwise the slip may never end.</remarks>
    private const double LargestPush = 0.9999;

    /// <summary>The share of the longest end in a net that a piece leaves to the closed form.</summary>
    private const double NearEnd = 0.8;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly DragJumpGuard _jump;
    private readonly double _alpha;
    private readonly int _order;

    public SlideEnd(Surroundings around, DragJumpGuard jump, int order)
    {
        _around = around;
        _world = around.World;
        _jump = jump;
        _alpha = _world.Ball.InertiaFactor;
        _order = order;
    }

    /// <summary>Finds the end of a slide.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="run">The step.</param>
    /// <param name="piece">The proposed piece, which the end must not exceed.</param>
    /// <param name="slip">The slip, m/s.</param>
    /// <param name="stop">The end.</param>
    /// <returns>False if the end is not near, or if another event comes first.</returns>
    public bool Find(in BallState s, ref StepRun run, in SurfacePiece piece, in Vector3d slip, out SlideStop stop)
    {
        stop = default;
        ref readonly SurfaceSystem system = ref piece.System;
        ref readonly SurfaceForces on = ref system.Forces;
        double longest = piece.Length;

        // First estimate: use the push and the friction at the start.
        Vector3d push = system.SlipPush(in on, in piece.From.Spin);
        double friction = system.SlipFriction(in on);

        // On a curved surface, the push changes with the position: allow only a very short end.
        double most = on.Turning == Vector3d.Zero ? longest : Math.Min(longest, ContactTolerances.CurvedSlideEnd);

        // |s| < k t: friction, which slows the slip s at the rate k, may end it within the piece t. |c|² < k²: friction outweighs the push c, so it does end.
        if (!(slip.Length < friction * most) || !(push.LengthSquared < LargestPush * friction * friction))
        {
            return false;
        }

        double about = Vector3d.Dot(piece.From.Spin, on.Normal);
        double turning = system.AboutRate(in on, in piece.From);
        stop.Start = on.Body + on.Air - (on.Centripetal * on.Normal);
        var decay = new SlipDecay(in slip, in push, friction);
        stop.End = MotionAt(in s, in piece, in decay, system.MostFriction(in on), in stop.Start, in stop.Start, about + (decay.Time * turning));

        // Second estimate: use the means of both ends, which leave only a higher-order error in the end time.
        system.ForcesOn(s.Time + decay.Time, in stop.End, out SurfaceForces there);
        run.Log.Evaluations++;
        Vector3d endPush = system.SlipPush(in there, in stop.End.Spin);
        double endFriction = system.SlipFriction(in there);
        double change = (endPush - push).Length * (endPush.Length + push.Length);
        double loadChange = endFriction - friction;

        // If the means neglect too much, take an ordinary piece first.
        var mean = new SlipDecay(in slip, 0.5 * (push + endPush), 0.5 * (friction + endFriction));
        if (s.Nets != 0 ? !IsCloseInNet(in slip, in mean, endPush - push, friction, out stop.Before)
            : !(decay.Time * (change + (loadChange * loadChange)) <= ToleranceIn(run.Coarse) * friction * friction))
        {
            return false;
        }

        decay = mean;
        double t = decay.Time;
        if (!(t > 0 && t <= longest))
        {
            return false;
        }

        Vector3d last = there.Body + there.Air - (there.Centripetal * there.Normal);
        double sliding = 0.5 * (system.MostFriction(in on) + system.MostFriction(in there));
        double lastTurning = system.AboutRate(in there, in stop.End);
        about += 0.5 * t * (turning + lastTurning);
        stop.End = MotionAt(in s, in piece, in decay, sliding, in stop.Start, in last, about);
        stop.Time = t;
        stop.Grips = system.Grips(in there);

        // The rotation ∫ω dt, plus the second term of the Magnus series for the turning axis of the spin, t²/12 ω(t) × ω(0).
        Vector3d torque = SurfaceSystem.Tangential(on.Torque, on.Normal) + (turning * on.Normal);
        Vector3d lastTorque = SurfaceSystem.Tangential(there.Torque, on.Normal) + (lastTurning * on.Normal);
        stop.Turn = (t * piece.From.Spin) + ((t * t / 6.0) * ((2.0 * torque) + lastTorque))
            + ((sliding / (_alpha * _around.Radius)) * Vector3d.Cross(on.Normal, decay.Twice))
            + ((t * t / 12.0) * Vector3d.Cross(stop.End.Spin, piece.From.Spin));
        return IsFirst(in s, in system, in stop, about, in on.Normal);
    }

    /// <summary>True if the means describe the end of a slip in a net, where the push changes steadily.</summary>
    /// <remarks>
    /// If the push changes by d, and the direction of the slip turns by θ, the time of the end is off by t d (d + k θ)/12 per k² − c².
    /// </remarks>
    /// <param name="slip">The slip, m/s.</param>
    /// <param name="mean">Its decay under the means.</param>
    /// <param name="change">d, m/s².</param>
    /// <param name="friction">k, m/s².</param>
    /// <param name="before">The length of a piece after which the end is close enough, s; 0 if it is now, or if the slip does not end.</param>
    private static bool IsCloseInNet(in Vector3d slip, in SlipDecay mean, in Vector3d change, double friction, out double before)
    {
        double d = change.Length;
        double turn = 2.0 * ((slip / slip.Length) - (mean.Direction / mean.Time)).Length;
        double error = mean.Time * d * (d + (friction * turn)) / 12.0;
        double most = ContactTolerances.NetSlideEnd * mean.Left;
        before = error > most && most > 0 ? (1.0 - (NearEnd * Math.Sqrt(most / error))) * mean.Time : 0;
        return error <= most;
    }

    /// <summary>True if no other event comes before the end of the slip.</summary>
    private bool IsFirst(in BallState s, in SurfaceSystem system, in SlideStop stop, double about, in Vector3d normal)
    {
        // The spin about the normal ends, or the ball reaches another surface.
        if (system.SpinSign * (about - Vector3d.Dot(system.Carrier.Spin, in normal)) < 0 || system.Carrier.PatchAt(s.Position) != system.Carrier.PatchAt(in stop.End.Position)
            || (system.IsFace && system.Carrier.FaceMargin(in stop.End.Position, s.Time + stop.Time) < 0))
        {
            return false;
        }

        // A net goes slack or taut.
        if (s.Nets != 0 && _world.NetForces.SlackAt(s.Nets, s.NetSides, stop.End.Velocity, default) != system.NetsSlack)
        {
            return false;
        }

        // The drag law jumps: a piece must end at the jump.
        if (_jump.Acts && _around.BranchAt(in stop.End) != system.Branch)
        {
            return false;
        }

        // The ball hits another object on its path.
        var path = PathCubic.Line(s.Position, (stop.End.Position - s.Position) / stop.Time, stop.Time);
        return !(new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out _) <= stop.Time);
    }

    /// <summary>Returns the tolerance for the end of a slide in a step of a given length, s.</summary>
    private double ToleranceIn(double step)
    {
        double squared = TurnLimit.Coarseness(step) * TurnLimit.Coarseness(step);
        return Math.Min(LargestSlideEnd * step, _order >= 4 ? ContactTolerances.SlideEnd * squared * squared : ContactTolerances.CoarseSlideEnd * squared);
    }

    /// <summary>
    /// Returns the motion at the end of a slip: v = v₀ + ∫a − μ_s N/m ∫ŝ, p = p₀ + v₀ t + ∫∫a − μ_s N/m ∫∫ŝ, with a linear in time, and the
    /// spin of a roll.
    /// </summary>
    private Motion MotionAt(
        in BallState s, in SurfacePiece piece, in SlipDecay decay, double sliding, in Vector3d first, in Vector3d last, double about)
    {
        double t = decay.Time;
        Vector3d velocity = piece.From.Velocity + ((0.5 * t) * (first + last)) - (sliding * decay.Direction);
        Vector3d position = piece.From.Position + (t * piece.From.Velocity) + ((t * t / 6.0) * ((2.0 * first) + last)) - (sliding * decay.Twice);
        Vector3d surface = _world.SurfaceVelocity(piece.System.Carrier, in position, in piece.System.Forces.Normal, s.Time + t);
        Vector3d spin = Slip.RollingSpin(velocity - surface, about, in piece.System.Forces.Normal, _around.Radius);
        return new Motion(in position, in velocity, in spin);
    }
}

/// <summary>The end of a slide.</summary>
internal struct SlideStop
{
    /// <summary>The time until the end, s.</summary>
    public double Time;

    /// <summary>If the end was not found: the length of a piece after which it can be, s; 0 if unknown.</summary>
    public double Before;

    /// <summary>The motion at the end.</summary>
    public Motion End;

    /// <summary>The rotation until the end, rad.</summary>
    public Vector3d Turn;

    /// <summary>The acceleration at the start without friction, m/s².</summary>
    public Vector3d Start;

    /// <summary>True if friction holds the ball afterwards.</summary>
    public bool Grips;
}
