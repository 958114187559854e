using FootballPhysics.Contacts;

namespace FootballPhysics.Batch;

/// <summary>Updates the derivatives by the launch over a step, by central differences of the step itself.</summary>
/// <remarks>
/// This covers everything in a step: slides and their ends, rolls, nets, other contacts, and the lengths of segments.
/// <para>The trick: the columns of J = ∂y/∂y₀ are motions that the ball can make (a rolling ball keeps rolling). So y is varied along an orthonormal basis of
/// them, J = B R, instead of along the axes. This needs fewer steps, and none starts in the ground.</para>
/// </remarks>
internal sealed class StepDifferences
{
    /// <summary>The widest variation, as a speed in m/s, and the time in s that converts a position to a speed.</summary>
    private const double Widest = 4e-4;
    private const double Way = 0.05;

    /// <summary>The turn, in rad, that counts as much as 1 m/s: the force of the seams changes over some tenths of a radian.</summary>
    private const double Turn = 1.0;

    /// <summary>The largest variations relative to a slip, and to the speed of a roll or the flow; then the narrowest variation, in m/s.</summary>
    private const double SlipShare = 0.01;
    private const double RollShare = 0.001;
    private const double Narrowest = 1e-7;

    /// <summary>The number of times, and the factor, by which a variation is narrowed until both sides have the same events and agree.</summary>
    private const int MostTries = 6;
    private const double Narrower = 0.25;

    /// <summary>The relative difference up to which results of full and half width agree.</summary>
    private const double Agreed = 3e-8;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly bool _isEven;
    private readonly bool _hasLawsAlone;

    /// <summary>True if the motion depends on the orientation.</summary>
    private readonly bool _hasSeams;
    private readonly TangentBasis _basis;
    private readonly Motion[] _changes = new Motion[TangentBasis.Most];
    private readonly double[] _times = new double[TangentBasis.Most];
    private BallState _end;
    private Quaterniond _endOrientation;
    private long _pieces;
    private double _timeStep;
    private StopAt _stopAt;

    public StepDifferences(Simulator simulator)
    {
        _simulator = simulator;
        Scene scene = simulator.Scene;
        _isEven = scene.Ground.Heights is null && scene.Ground.Pattern is null;
        _hasLawsAlone = SceneAir.HasLawsAlone(scene);
        _hasSeams = KnuckleForce.Of(scene) is not null;
        _basis = new TangentBasis(Way, 1.0 / scene.Ball.Radius, Turn);
    }

    /// <summary>Updates the tangent over a step.</summary>
    /// <param name="tangent">J at the start; on return, at the end, or at the event that ended the step.</param>
    /// <param name="start">The ball at the start.</param>
    /// <param name="end">The ball at the end.</param>
    /// <param name="dt">The length, in s.</param>
    /// <param name="stopAt">The event that ends the step.</param>
    /// <param name="events">The events in the step.</param>
    /// <param name="pieces">The number of segments in the step.</param>
    /// <param name="eventTimes">Receives δt of each column: the change of the end time by the launch.</param>
    public void Take(Tangent tangent, in BallState start, in BallState end, double dt, StopAt stopAt, ReadOnlySpan<BallEvent> events, long pieces, double[] eventTimes)
    {
        _timeStep = dt;
        _stopAt = stopAt;
        _end = end;
        _endOrientation = _hasSeams ? end.Orientation : Quaterniond.Identity;
        _pieces = pieces;
        bool dependsOnPlace = DependsOnPlace(in start, events);
        _basis.Span(tangent, dependsOnPlace);
        double widest = WidthAt(in start);

        // Variable wind and custom forces are smooth, and such steps are frequent: use a single width.
        bool isSmooth = !_hasLawsAlone && events.Length == 0 && start.Nets == 0 && start.Branch == end.Branch && start.Motion == MotionState.Airborne;
        for (int i = 0; i < _basis.Count; i++)
        {
            Motion direction = _basis[i];
            Change(in start, in direction, widest, events, isSmooth, out _changes[i], out _times[i]);
        }

        for (int c = 0; c < Tangent.Columns; c++)
        {
            // Subtract displacements instead of positions, to lose less to rounding.
            var sum = new Motion(tangent.Of(c).Position, Vector3d.Zero, Vector3d.Zero);
            double time = 0;
            for (int i = 0; i < _basis.Count; i++)
            {
                double share = _basis.Share(i, c);
                sum = MotionVector.Sum(1.0, in sum, share, in _changes[i]);
                time += share * _times[i];
            }

            tangent.Set(c, in sum);
            eventTimes[c] = time;
        }
    }

    /// <summary>Computes the result of a variation along a direction.</summary>
    /// <remarks>
    /// It narrows the variation until both sides have the same events, and half the width agrees. Some forces have kinks (spin along the path, a net), which a
    /// wide variation would smear.
    /// </remarks>
    private void Change(
        in BallState start, in Motion direction, double width, ReadOnlySpan<BallEvent> events, bool isSmooth, out Motion change, out double time)
    {
        bool same = Quotient(in start, in direction, width, events, out change, out time);
        if (isSmooth && same)
        {
            return;
        }

        Motion near = change;
        double nearTime = time;
        double least = double.PositiveInfinity;
        for (int tries = 1; ; tries++)
        {
            if (Quotient(in start, in direction, 0.5 * width, events, out Motion nearer, out double nearerTime))
            {
                double apart = same ? Apart(in near, in nearer) : double.MaxValue;
                if (apart < least)
                {
                    // Richardson extrapolation to fourth order, (4 q(h/2) − q(h))/3.
                    least = apart;
                    change = same ? MotionVector.Sum(4.0 / 3.0, in nearer, -1.0 / 3.0, in near) : nearer;
                    time = same ? nearerTime + ((nearerTime - nearTime) / 3.0) : nearerTime;
                }
            }

            if (least <= Agreed || tries == MostTries)
            {
                return;
            }

            width *= Narrower;
            same = Quotient(in start, in direction, width, events, out near, out nearTime);
            if (double.IsPositiveInfinity(least))
            {
                // Close to a different course of events, the narrowest variation is the best.
                change = near;
                time = nearTime;
            }
        }
    }

    /// <summary>Returns the difference between two changes, as a velocity of the centre or of the surface.</summary>
    private double Apart(in Motion one, in Motion other) =>
        Math.Max((one.Velocity - other.Velocity).Length, _simulator.Scene.Ball.Radius * (one.Spin - other.Spin).Length);

    /// <summary>Returns true if the step depends on the position.</summary>
    /// <remarks>
    /// In flight, and on level uniform ground, in uniform air, it does not: the position is then carried along unchanged. So a ball that has just left the ground is
    /// never moved into it.
    /// </remarks>
    private bool DependsOnPlace(in BallState start, ReadOnlySpan<BallEvent> events)
    {
        bool flies = start.Motion == MotionState.Airborne && _end.Motion == MotionState.Airborne && events.Length == 0;
        bool isCarried = start.Motion is MotionState.Sliding or MotionState.Rolling && start.Carrier == 0 && _isEven;
        if (!(flies || isCarried) || !_hasLawsAlone || start.Nets != 0 || _end.Nets != 0)
        {
            return true;
        }

        foreach (ref readonly BallEvent e in events)
        {
            if (e.Kind is not (BallEventKind.Slide or BallEventKind.Roll or BallEventKind.Rest))
            {
                return true;
            }
        }

        World world = _simulator.World;
        return ContactSet.TouchesMore(world, in start, flies ? -1 : (int)start.Carrier - world.FirstCollider);
    }

    /// <summary>Computes (y(h) − y(−h))/2h at the end of the step, with the displacement instead of the position.</summary>
    /// <returns>True if both sides have the same events.</returns>
    private bool Quotient(in BallState start, in Motion direction, double width, ReadOnlySpan<BallEvent> events, out Motion change, out double time)
    {
        bool same = End(in start, in direction, width, events, out Motion high, out double later);
        same &= End(in start, in direction, -width, events, out Motion low, out double sooner);
        double perWidth = 0.5 / width;
        change = MotionVector.Sum(perWidth, in high, -perWidth, in low);
        time = perWidth * (later - sooner);
        return same;
    }

    /// <summary>Computes the motion at the end of a varied step, or just before the event that ends it, with the displacement instead of the position.</summary>
    private bool End(in BallState start, in Motion direction, double by, ReadOnlySpan<BallEvent> events, out Motion end, out double time)
    {
        BallState s = MotionVector.With(in start, MotionVector.Sum(1.0, MotionVector.Of(in start), by, in direction));
        Vector3d from = s.Position;
        _log.Clear();
        _log.StopAt = _stopAt;
        _simulator.Advance(ref s, _timeStep, _log);
        time = s.Time;
        Vector3d turn = TurnFromEnd(in s);
        end = new Motion(s.Position - from, s.Velocity, s.Spin, s.AirDistance, in turn);
        if (s.Motion == MotionState.Rolling)
        {
            Vector3d moving = OnSurface(in s, out Vector3d normal);
            if (moving.LengthSquared < ContactTolerances.Rolling * ContactTolerances.Rolling)
            {
                // The ball stands still: its remaining speed carries no information.
                end = new Motion(end.Position, s.Velocity - moving, Vector3d.Dot(s.Spin, in normal) * normal, s.AirDistance, in turn);
            }
        }

        bool same = s.Motion == _end.Motion && s.Branch == _end.Branch && s.Nets == _end.Nets && s.Carrier == _end.Carrier
            && _log.Steps == _pieces && _log.Events.Count == events.Length;
        for (int i = 0; same && i < events.Length; i++)
        {
            // An event at the very start happens at once on both sides, whatever the variation.
            ref readonly BallEvent e = ref _log.Events[i];
            same = e.Kind == events[i].Kind && e.ColliderIndex == events[i].ColliderIndex && e.Time == start.Time == (events[i].Time == start.Time);
        }

        if (_log.Halted)
        {
            // If the ball slides or rolls after the impact, the impact is not the last event.
            ref readonly BallEvent ending = ref Ending();
            end = new Motion(ending.Position - from, ending.VelocityBefore, ending.SpinBefore, s.AirDistance, in turn);
        }

        return same;
    }

    /// <summary>Returns the small rotation, in rad, from the end of the step to that of a varied step; zero if nothing depends on it.</summary>
    private Vector3d TurnFromEnd(in BallState s)
    {
        if (!_hasSeams)
        {
            return Vector3d.Zero;
        }

        // The vector part is sin(θ/2) n.
        Quaterniond turn = s.Orientation * new Quaterniond(-_endOrientation.X, -_endOrientation.Y, -_endOrientation.Z, _endOrientation.W);
        return (turn.W < 0 ? -2.0 : 2.0) * new Vector3d(turn.X, turn.Y, turn.Z);
    }

    /// <summary>Returns the event that ended the step: the first of its kind.</summary>
    private ref readonly BallEvent Ending()
    {
        BallEventKind kind = _stopAt == StopAt.Impact ? BallEventKind.Impact : BallEventKind.Rest;
        int i = 0;
        while (_log.Events[i].Kind != kind)
        {
            i++;
        }

        return ref _log.Events[i];
    }

    /// <summary>Returns the width of a variation: the slower a slip, roll or flow, the faster its force turns, and the narrower the variation.</summary>
    private double WidthAt(in BallState start)
    {
        if (start.Motion == MotionState.Airborne)
        {
            return Widest;
        }

        Vector3d moving = OnSurface(in start, out Vector3d normal);
        bool slides = start.Motion == MotionState.Sliding;
        double speed = (slides ? Slip.Of(in moving, start.Spin, in normal, _simulator.Scene.Ball.Radius) : moving).Length;
        double widest = Math.Min(Widest, RollShare * (start.Velocity - _simulator.Scene.Air.Wind).Length);
        widest = speed < ContactTolerances.Rolling ? widest : Math.Min(widest, (slides ? SlipShare : RollShare) * speed);
        return Math.Max(Narrowest, widest);
    }

    /// <summary>Returns the velocity relative to the supporting surface, and its normal.</summary>
    private Vector3d OnSurface(in BallState s, out Vector3d normal)
    {
        Collider carrier = _simulator.World.CarrierOf(in s);
        normal = carrier.At(s.Position, s.Time).Normal;
        return s.Velocity - carrier.Velocity;
    }
}
