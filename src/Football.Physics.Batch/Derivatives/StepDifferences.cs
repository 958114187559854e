namespace FootballPhysics.Batch;

/// <summary>
/// What a step does to the derivatives by the launch, by central differences of the step itself: all that may happen in it, slides and their ends, rolls, nets,
/// what else the ball touches, and the lengths of the pieces that it is taken in, is differentiated as it is taken.
/// </summary>
/// <remarks>
/// The trick: the columns of J = ∂y/∂y₀ are motions that the ball can make (one that rolls goes on rolling), so that y is changed along an orthonormal basis of
/// them, J = B R, and not along the axes: fewer steps, and none from within the ground.
/// </remarks>
internal sealed class StepDifferences
{
    /// <summary>The widest change, m/s; of a spin that of the surface, of a place the way of so long, s.</summary>
    private const double Widest = 4e-4;
    private const double Way = 0.05;

    /// <summary>Share of a slip, and of the speed of a roll or of the flow, by which it is changed at most, and the narrowest change, m/s.</summary>
    private const double SlipShare = 0.01;
    private const double RollShare = 0.001;
    private const double Narrowest = 1e-7;

    /// <summary>Changed steps must go through the same events in as many pieces, and agree: else they are changed by less, so often and to this share.</summary>
    private const int MostTries = 6;
    private const double Narrower = 0.25;

    /// <summary>They agree with those of half the width where the two differ by no more than this share of the change.</summary>
    private const double Agreed = 3e-8;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly bool _isEven;
    private readonly bool _hasLawsAlone;
    private readonly TangentBasis _basis;
    private readonly Motion[] _changes = new Motion[TangentBasis.Most];
    private readonly double[] _times = new double[TangentBasis.Most];
    private BallState _end;
    private long _pieces;
    private double _timeStep;
    private StopAt _stopAt;

    public StepDifferences(Simulator simulator)
    {
        _simulator = simulator;
        Scene scene = simulator.Scene;
        _isEven = scene.Ground.Heights is null && scene.Ground.Pattern is null;
        _hasLawsAlone = SceneAir.HasLawsAlone(scene);
        _basis = new TangentBasis(Way, 1.0 / scene.Ball.Radius);
    }

    /// <summary>Carries the tangent over a step.</summary>
    /// <param name="tangent">J at its start; then at its end, or at the event that ended it.</param>
    /// <param name="start">The ball at its start.</param>
    /// <param name="end">The ball at its end.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="stopAt">The event that ends it.</param>
    /// <param name="events">What happens in it.</param>
    /// <param name="pieces">In how many pieces it is taken.</param>
    /// <param name="eventTimes">When it ends by the launch, δt of each column.</param>
    public void Take(Tangent tangent, in BallState start, in BallState end, double dt, StopAt stopAt, ReadOnlySpan<BallEvent> events, long pieces, double[] eventTimes)
    {
        _timeStep = dt;
        _stopAt = stopAt;
        _end = end;
        _pieces = pieces;
        bool dependsOnPlace = DependsOnPlace(in start, events);
        _basis.Span(tangent, dependsOnPlace);
        double widest = WidthAt(in start);

        // Wind that varies and what a game adds are smooth, and such steps are many: one width does.
        bool isSmooth = !_hasLawsAlone && events.Length == 0 && start.Nets == 0 && start.Branch == end.Branch && start.Motion == MotionState.Airborne;
        for (int i = 0; i < _basis.Count; i++)
        {
            Motion direction = _basis[i];
            Change(in start, in direction, widest, events, isSmooth, out _changes[i], out _times[i]);
        }

        for (int c = 0; c < Tangent.Columns; c++)
        {
            // The way that it goes, not the place, is subtracted: less is lost to rounding.
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

    /// <summary>
    /// What a change along a direction becomes: narrower and narrower, until all go through the same and half of a width says the same as it does. A force
    /// has kinks (that of spin where the ball spins about its way, a net's), which a wide change smears.
    /// </summary>
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
                    // Of fourth order, (4 q(h/2) − q(h))/3
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
                // On the edge of another course the narrowest says most.
                change = near;
                time = nearTime;
            }
        }
    }

    /// <summary>By how much two changes of the velocity, or of the surface's, differ.</summary>
    private double Apart(in Motion one, in Motion other) =>
        Math.Max((one.Velocity - other.Velocity).Length, _simulator.Scene.Ball.Radius * (one.Spin - other.Spin).Length);

    /// <summary>
    /// True when what happens depends on the place. In flight, and along level ground of one kind, in air that is the same everywhere, the place goes on with the
    /// ball: one that has just left the ground is not changed to one within it.
    /// </summary>
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

    /// <summary>(y(h) − y(−h))/2h at the end of the step, of the way instead of the place.</summary>
    /// <returns>Whether both go through the same.</returns>
    private bool Quotient(in BallState start, in Motion direction, double width, ReadOnlySpan<BallEvent> events, out Motion change, out double time)
    {
        bool same = End(in start, in direction, width, events, out Motion high, out double later);
        same &= End(in start, in direction, -width, events, out Motion low, out double sooner);
        double perWidth = 0.5 / width;
        change = MotionVector.Sum(perWidth, in high, -perWidth, in low);
        time = perWidth * (later - sooner);
        return same;
    }

    /// <summary>The motion at the end of a changed step, its way instead of its place: at its time, or at the event that ends it, just before it.</summary>
    private bool End(in BallState start, in Motion direction, double by, ReadOnlySpan<BallEvent> events, out Motion end, out double time)
    {
        BallState s = MotionVector.With(in start, MotionVector.Sum(1.0, MotionVector.Of(in start), by, in direction));
        Vector3d from = s.Position;
        _log.Clear();
        _log.StopAt = _stopAt;
        _simulator.Advance(ref s, _timeStep, _log);
        time = s.Time;
        end = new Motion(s.Position - from, s.Velocity, s.Spin, s.AirDistance);
        if (s.Motion == MotionState.Rolling)
        {
            Vector3d moving = OnSurface(in s, out Vector3d normal);
            if (moving.LengthSquared < Slip.Rolling * Slip.Rolling)
            {
                // It stands on its spot: what is left of its speed says nothing.
                end = new Motion(end.Position, s.Velocity - moving, Vector3d.Dot(s.Spin, in normal) * normal, s.AirDistance);
            }
        }

        bool same = s.Motion == _end.Motion && s.Branch == _end.Branch && s.Nets == _end.Nets && s.Carrier == _end.Carrier
            && _log.Steps == _pieces && _log.Events.Count == events.Length;
        for (int i = 0; same && i < events.Length; i++)
        {
            // What is so from the start happens at once, whatever is changed.
            ref readonly BallEvent e = ref _log.Events[i];
            same = e.Kind == events[i].Kind && e.ColliderIndex == events[i].ColliderIndex && e.Time == start.Time == (events[i].Time == start.Time);
        }

        if (_log.Halted)
        {
            // An impact after which the ball slides or rolls is not the last event.
            ref readonly BallEvent ending = ref Ending();
            end = new Motion(ending.Position - from, ending.VelocityBefore, ending.SpinBefore, s.AirDistance);
        }

        return same;
    }

    /// <summary>The event that ended the step: the first of its kind.</summary>
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

    /// <summary>By how much to change the motion: the slower a slip, a roll or the flow, the faster its force turns.</summary>
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
        widest = speed < Slip.Rolling ? widest : Math.Min(widest, (slides ? SlipShare : RollShare) * speed);
        return Math.Max(Narrowest, widest);
    }

    /// <summary>The velocity over what carries the ball, and its normal.</summary>
    private Vector3d OnSurface(in BallState s, out Vector3d normal)
    {
        Collider carrier = _simulator.World.CarrierOf(in s);
        normal = carrier.At(s.Position, s.Time).Normal;
        return s.Velocity - carrier.Velocity;
    }
}
