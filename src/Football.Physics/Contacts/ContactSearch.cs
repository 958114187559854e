using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>Finds the first contact along a path: the gaps of nearby objects, each by <see cref="TimeOfImpact"/>.</summary>
/// <param name="world">The world.</param>
/// <param name="path">The path.</param>
/// <param name="time">Start time, s.</param>
internal readonly struct ContactSearch(World world, in PathCubic path, double time)
{
    /// <summary>The number of flush seams on a path after which the search passes them in longer steps.</summary>
    /// <remarks>Above: a ball along two objects whose normals hardly differ finds a seam at each step. Below: a contact soon after a seam is found late.</remarks>
    private const int MostSeams = 64;

    private readonly World _world = world;
    private readonly PathCubic _path = path;
    private readonly Bounds3d _bounds = world.IsBare ? default : path.Bounds;
    private readonly double _time = time;
    private readonly double _bend = world.IsPlaneAlone ? 0 : path.GreatestAcceleration; // the gap to a plane bounds its own

    /// <summary>Finds the first contact or passage on the path.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    /// <param name="first">The contact or passage.</param>
    /// <param name="held">Contacts that the ball keeps; they are skipped.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double First(in BallState s, int carrier, out Separation first, Span<Contact> held = default)
    {
        double at = FirstContact(in s, carrier, held, out first, out NearPassages near);
        return _world.HasPassages ? FirstPassage(in s, in near, at, ref first) : at;
    }

    /// <summary>Finds the first contact on the path, and the nets and goals near it.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    /// <param name="held">Contacts that the ball keeps; they are skipped.</param>
    /// <param name="first">The contact.</param>
    /// <param name="passages">The nets and goals whose bounds the path reaches.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double FirstContact(in BallState s, int carrier, Span<Contact> held, out Separation first, out NearPassages passages)
    {
        first = default;
        passages = default;
        double best = double.PositiveInfinity;
        if (_world.IsBare)
        {
            // The ball can hit only the ground.
            best = _world.Ground is null || carrier == 0 || held.Length > 0 ? best : FirstContact(0, carrier, held, best, out _);
            first = best <= _path.Length ? new Separation(_world, SeparationKind.Contact, 0) : first;
            return best;
        }

        // Broad phase: the engine's cast and the bounding box of the path. Narrow phase: conservative advancement along each collider's gap.
        _world.Engine?.LookAlong(in _path, _time);
        NearThings near = Near(in s, out passages.Deepest);
        while (near.Next(out int thing))
        {
            if (_world.IsPassage(thing))
            {
                passages.Add(_world, thing);
                continue;
            }

            bool seam = false;
            double at = thing == carrier || ContactSet.Has(held, thing) ? double.PositiveInfinity : FirstContact(thing, carrier, held, best, out seam);

            // If contacts are simultaneous, use the first collider in scene order, regardless of the traversal order.
            if (at < best || (at == best && at <= _path.Length && ComesFirst(thing, first.Index, at)))
            {
                best = at;
                first = new Separation(_world, seam ? SeparationKind.Seam : SeparationKind.Contact, thing);
            }
        }

        return best;
    }

    /// <summary>Finds the first net or goal that the ball enters or leaves on the path, without contacts.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="first">The passage.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double FirstPassage(in BallState s, out Separation first)
    {
        first = default;
        NearPassages passages = default;
        NearThings near = Near(in s, out passages.Deepest);
        while (_world.HasPassages && near.Next(out int thing))
        {
            passages.Add(_world, thing);
        }

        return FirstPassage(in s, in passages, double.PositiveInfinity, ref first);
    }

    /// <summary>Enumerates the objects whose bounds the path reaches.</summary>
    private NearThings Near(in BallState s, out int deepest)
    {
        // A net extends beyond its edges by the depth of the ball in another net: expand the search by this depth.
        deepest = s.Nets == 0 ? -1 : _world.NetForces.Deepest(in s);
        double deep = deepest < 0 ? 0 : _world.Nets[deepest].Depth(s.Position, NetSheet.SideOf(s.NetSides, deepest)) + (_path.Length * _path.FastestSpeed);
        return new NearThings(_world, _bounds.Expanded(_world.Ball.Radius + Math.Max(0, deep)), _time, _path.Length, s.Nets, s.NetSides, withPassages: true);
    }

    /// <summary>True if the first of two simultaneous contacts has priority.</summary>
    private bool ComesFirst(int first, int second, double at)
    {
        if (!_world.IsByside(first, second))
        {
            return first < second;
        }

        Vector3d position = _path.At(at);
        return _world.ComesFirst(first, _world.ByIndex[first].At(in position, _time + at).Normal, second, _world.ByIndex[second].At(in position, _time + at).Normal);
    }

    /// <summary>Finds the first passage. Of simultaneous ones, it takes the first net or goal in scene order, but contacts come before them.</summary>
    private double FirstPassage(in BallState s, in NearPassages near, double best, ref Separation first)
    {
        int deepest = near.Deepest;
        double deepestSide = deepest < 0 ? 0 : NetSheet.SideOf(s.NetSides, deepest);
        double reach = s.Nets == 0 ? 0 : _path.Length * _path.FastestSpeed;
        for (int net = 0; net < _world.Nets.Length && (near.Nets | s.Nets) >> net != 0; net++)
        {
            if ((s.Nets >> net & 1) != 0)
            {
                // A net that contains the ball stretches, so its bounds do not help: always test whether the ball leaves it. It leaves over an edge at
                // its greatest depth in any net, so that it does not slip through where two nets are joined.
                Vector3d place = _world.Nets[net].PlaceInFrame(_path.Start);
                Leave(new Separation(_world, SeparationKind.NetLeft, net, 2, NetSheet.SideOf(s.NetSides, net)), reach, ref best, ref first);
                Leave(new Separation(_world, SeparationKind.NetLeft, net, 0, place.X, 0, deepest, deepestSide), reach, ref best, ref first);
                Leave(new Separation(_world, SeparationKind.NetLeft, net, 1, place.Y, 0, deepest, deepestSide), reach, ref best, ref first);
            }
            else if ((near.Nets >> net & 1) != 0 && !SceneCheck.TearsNets(in s, _world))
            {
                var sheet = new NetGap(_world, net, deepest, deepestSide, in _path, _bend);
                double at = TimeOfImpact.First(ref sheet, new SearchSpan(_path.Length, best), ref _world.SearchEvaluations);
                first = at < best ? sheet.Last : first;
                best = Math.Min(at, best);
            }
        }

        for (int goal = 0; goal < _world.Goals.Length && (near.Goals | s.GoalsEntered) >> goal != 0; goal++)
        {
            if ((s.GoalsEntered >> goal & 1) != 0)
            {
                // If the ball is in the mouth of a goal, always test whether it crosses the line or leaves through the mouth.
                Cross(new Separation(_world, SeparationKind.GoalLine, goal), ref best, ref first);
                Cross(new Separation(_world, SeparationKind.MouthLeft, goal), ref best, ref first);
            }
            else if (((near.Goals & ~s.GoalsPassed) >> goal & 1) != 0)
            {
                var entry = new Separation(_world, SeparationKind.MouthEntered, goal);
                var mouth = new MouthGap(in entry, in _world.Goals[goal], in _path, _time, _bend);
                Keep(ref mouth, in entry, ref best, ref first);
            }
        }

        return best;
    }

    /// <summary>Keeps the exit from a net if it is the earliest event so far.</summary>
    /// <param name="net">The exit.</param>
    /// <param name="reach">A bound on the distance that the ball covers on the path, m.</param>
    /// <param name="best">The time of the earliest event so far, s.</param>
    /// <param name="first">That event.</param>
    private void Leave(in Separation net, double reach, ref double best, ref Separation first)
    {
        // The gap changes by at most this multiple of the distance.
        net.Evaluate(in _path.Start, in _path.C1, _time, out double start, out _);
        if (start > (net.Bends * reach) + ContactTolerances.Touching)
        {
            return;
        }

        var gap = new FallingGap(in net, in _path, _time, _bend);
        Keep(ref gap, in net, ref best, ref first);
    }

    /// <summary>Keeps an event at a plane of a goal if it is the earliest so far.</summary>
    private void Cross(in Separation plane, ref double best, ref Separation first)
    {
        var gap = new GoalPlaneGap(in plane, in _path, _time, _bend);
        Keep(ref gap, in plane, ref best, ref first);
    }

    private void Keep<TGap>(ref TGap gap, in Separation happening, ref double best, ref Separation first)
        where TGap : struct, IGap
    {
        double at = TimeOfImpact.First(ref gap, new SearchSpan(_path.Length, best), ref _world.SearchEvaluations);
        first = at < best ? happening : first;
        best = Math.Min(at, best);
    }

    /// <summary>Returns the time of the first closing contact with a collider, or of a seam at which it becomes the carrier; infinite if
    /// there is none.</summary>
    private double FirstContact(int thing, int carrier, Span<Contact> held, double until, out bool seam)
    {
        seam = false;
        Collider collider = _world.ByIndex[thing];
        double r = _world.Ball.Radius;
        var span = new SearchSpan(_path.Length, until);
        if (collider.StandingPlane is { } plane)
        {
            var flat = new PlaneGap(in _path, plane.Normal, plane.DistanceTo(in _path.Start) - r);
            return FirstBesideSeams(ref flat, thing, carrier, held, in span, out seam);
        }

        if (collider.Rotates)
        {
            var rotating = new RotatingGap(collider.From(_time), collider.HollowCurvature, in _path, _bend, r);
            return TimeOfImpact.First(ref rotating, in span, ref _world.SearchEvaluations);
        }

        return FirstOnShape(thing, carrier, held, in span, out seam);
    }

    /// <summary>Returns the same time for a collider that does not rotate.</summary>
    private double FirstOnShape(int thing, int carrier, Span<Contact> held, in SearchSpan span, out bool seam)
    {
        seam = false;
        Collider collider = _world.ByIndex[thing];
        double r = _world.Ball.Radius;

        // Transform the path to the frame of a moving collider, in which the collider is stationary.
        PathCubic path = _path;
        Bounds3d bounds = _bounds;
        if (collider.Moves)
        {
            path = collider.Seen(in _path, _time);
            bounds = path.Bounds;
        }

        if (!_world.IsBare && !bounds.Expanded(r).Intersects(in collider.Bounds))
        {
            return double.PositiveInfinity;
        }

        var gap = new ShapeGap(collider, in path, _bend, r, in span);
        return FirstBesideSeams(ref gap, thing, carrier, held, in span, out seam);
    }

    /// <summary>Returns the time of the first closing contact that is not a flush seam, or of a seam at which the collider becomes the carrier.</summary>
    private double FirstBesideSeams<TGap>(ref TGap gap, int thing, int carrier, Span<Contact> held, in SearchSpan span, out bool seam)
        where TGap : struct, ICrossedGap
    {
        seam = false;
        double t = TimeOfImpact.First(ref gap, in span, ref _world.SearchEvaluations);
        double stretch = 1.0;
        for (int count = 1; t <= span.Until; count++)
        {
            t = gap.Earliest(t);

            // A flush seam causes no contact: advance until the ball is above the face and the normals agree.
            double passage = Flush.Passage(_world, thing, _path.At(t), _path.VelocityAt(t), _time + t, carrier, held);
            if (!(passage > 0))
            {
                return t;
            }

            stretch = TimeOfImpact.Stretch(stretch, count, MostSeams);
            t += Math.Max(stretch * passage, span.Shortest);
            gap.Crosses = true;
            seam = t <= span.Until && carrier >= 0 && Flush.CarrierAt(_world, carrier, _path.At(t), _path.VelocityAt(t), _time + t) == thing;
            if (seam)
            {
                return t;
            }

            t = t <= span.Until ? TimeOfImpact.First(ref gap, in span, ref _world.SearchEvaluations, t) : t;
        }

        return double.PositiveInfinity;
    }
}

/// <summary>Nets and goals near a path, a bit for each.</summary>
internal struct NearPassages
{
    public ulong Nets;
    public ulong Goals;

    /// <summary>The net in which the ball is deepest; −1 if it is in none.</summary>
    public int Deepest;

    /// <summary>Adds a net or a goal; ignores a collider.</summary>
    public void Add(World world, int thing)
    {
        int net = thing - world.FirstPassage;
        int goal = net - world.Nets.Length;
        Nets |= net >= 0 && goal < 0 ? 1UL << net : 0;
        Goals |= goal >= 0 && goal < world.Goals.Length ? 1UL << goal : 0;
    }
}
