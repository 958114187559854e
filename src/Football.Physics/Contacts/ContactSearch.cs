using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>Finds the first contact along a path: the gaps of nearby objects, each by <see cref="TimeOfImpact"/>.</summary>
internal readonly struct ContactSearch
{
    private readonly World _world;
    private readonly PathCubic _path;
    private readonly Bounds3d _bounds;
    private readonly double _time;
    private readonly double _bend;

    /// <summary>Prepares a search along a path.</summary>
    /// <param name="world">The world.</param>
    /// <param name="path">The path.</param>
    /// <param name="time">Start time, s.</param>
    public ContactSearch(World world, in PathCubic path, double time)
    {
        _world = world;
        _path = path;
        _bounds = world.IsBare ? Bounds3d.Everywhere : path.Bounds;
        _time = time;
        _bend = path.GreatestAcceleration;
    }

    /// <summary>Finds the first contact or passage on the path.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    /// <param name="first">The contact or passage.</param>
    /// <param name="held">Contacts that the ball keeps; they are skipped.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double First(in BallState s, int carrier, out Separation first, Span<Contact> held = default)
    {
        double at = FirstContact(in s, carrier, held, out first);
        return _world.HasPassages ? FirstPassage(in s, at, ref first) : at;
    }

    /// <summary>Finds the first contact on the path, without nets and goals.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    /// <param name="held">Contacts that the ball keeps; they are skipped.</param>
    /// <param name="first">The contact.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double FirstContact(in BallState s, int carrier, Span<Contact> held, out Separation first)
    {
        first = default;
        double best = double.PositiveInfinity;

        // Broad phase: the engine's cast and the bounding box of the path. Narrow phase: conservative advancement along each collider's gap.
        _world.Engine?.LookAlong(in _path, _time);
        var near = new NearThings(_world, _bounds.Expanded(_world.Ball.Radius), _time, _path.Length);
        while (near.NextCollider(out int thing))
        {
            bool seam = false;
            double at = thing == carrier || ContactSet.Has(held, thing) ? double.PositiveInfinity : FirstContact(thing, carrier, held, Math.Min(best, _path.Length), out seam);

            // If contacts are simultaneous, use the first collider in scene order, regardless of the traversal order.
            if (at < best || (at == best && at <= _path.Length && ComesFirst(thing, first.Index, at)))
            {
                best = at;
                first = seam ? Separation.OfSeam(_world, thing) : Separation.OfContact(_world, thing);
            }
        }

        return best;
    }

    /// <summary>True if the first of two simultaneous contacts has priority.</summary>
    private bool ComesFirst(int first, int second, double at)
    {
        if (!_world.IsByside(first, second))
        {
            return first < second;
        }

        Vector3d position = _path.At(at);
        return _world.ComesFirst(first, _world.Colliders[first].At(in position, _time + at).Normal, second, _world.Colliders[second].At(in position, _time + at).Normal);
    }

    /// <summary>Finds the first net or goal that the ball enters or leaves on the path, without contacts.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="first">The passage.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double FirstPassage(in BallState s, out Separation first)
    {
        first = default;
        return _world.HasPassages ? FirstPassage(in s, double.PositiveInfinity, ref first) : double.PositiveInfinity;
    }

    private double FirstPassage(in BallState s, double best, ref Separation first)
    {
        int bestThing = first.What == SeparationKind.None ? -1 : first.Index;
        int nets = _world.FirstPassage;
        int goals = nets + _world.Nets.Length;

        // A net extends beyond its edges by the depth of the ball in another net: expand the search by this depth.
        int deepest = s.Nets == 0 ? -1 : _world.NetForces.Deepest(in s);
        double deepestSide = deepest < 0 ? 0 : NetSheet.SideOf(s.NetSides, deepest);
        double deep = deepest < 0 ? 0 : _world.Nets[deepest].Depth(s.Position, deepestSide) + (_path.Length * _path.FastestSpeed);
        var near = new NearThings(_world, _bounds.Expanded(_world.Ball.Radius + Math.Max(0, deep)), _time, _path.Length);
        while (near.NextPassage(out int thing))
        {
            double until = Math.Min(best, _path.Length);
            double at = double.PositiveInfinity;
            Separation gap = default;

            // Check nets that do not contain the ball, and mouths that the ball has not entered and whose line it has not passed.
            if (thing < goals)
            {
                int net = thing - nets;
                bool inside = (s.Nets >> net & 1) != 0;
                if (!inside)
                {
                    var sheet = new NetGap(_world, net, deepest, deepestSide, in _path, _bend, new SearchSpan(in _path, until));
                    at = TimeOfImpact.First(ref sheet);
                    gap = sheet.Last;
                }
            }
            else if (((s.GoalsEntered | s.GoalsPassed) >> (thing - goals) & 1) == 0)
            {
                gap = Separation.OfGoal(_world, SeparationKind.MouthEntered, thing - goals);
                var mouth = new MouthGap(in gap, in _world.Goals[thing - goals], in _path, _time, _bend, new SearchSpan(in _path, until));
                at = TimeOfImpact.First(ref mouth);
            }

            // If passages are simultaneous, use the first net or goal in scene order, regardless of the traversal order.
            if (at < best || (at == best && thing < bestThing))
            {
                best = at;
                bestThing = thing;
                first = gap;
            }
        }

        // A net that contains the ball stretches, so its bounds do not help: always test whether the ball leaves it.
        for (int net = 0; net < _world.Nets.Length && s.Nets >> net != 0; net++)
        {
            if ((s.Nets >> net & 1) != 0)
            {
                Vector3d place = _world.Nets[net].PlaceInFrame(_path.At(0));
                Leave(Separation.OfLeavingNet(_world, net, NetSheet.SideOf(s.NetSides, net)), ref best, ref first, ref bestThing);
                Leave(Separation.OfNetEdge(_world, net, 0, place.X, deepest, deepestSide), ref best, ref first, ref bestThing);
                Leave(Separation.OfNetEdge(_world, net, 1, place.Y, deepest, deepestSide), ref best, ref first, ref bestThing);
            }
        }

        // If the ball is in the mouth of a goal, always test whether it crosses the line or leaves through the mouth.
        for (int goal = 0; goal < _world.Goals.Length && s.GoalsEntered >> goal != 0; goal++)
        {
            if ((s.GoalsEntered >> goal & 1) != 0)
            {
                Take(Separation.OfGoal(_world, SeparationKind.GoalLine, goal), ref best, ref first);
                Take(Separation.OfGoal(_world, SeparationKind.MouthLeft, goal), ref best, ref first);
            }
        }

        return best;
    }

    /// <summary>Keeps the exit from a net if it is the earliest event so far.</summary>
    private void Leave(in Separation net, ref double best, ref Separation first, ref int bestThing)
    {
        int thing = _world.FirstPassage + net.Index;
        var gap = new FallingGap(in net, in _path, _time, _bend, new SearchSpan(in _path, Math.Min(best, _path.Length)));
        double at = TimeOfImpact.First(ref gap);
        if (at < best || (at == best && thing < bestThing))
        {
            best = at;
            bestThing = thing;
            first = net;
        }
    }

    /// <summary>Keeps an event at a plane of a goal if it is the earliest so far.</summary>
    private void Take(in Separation plane, ref double best, ref Separation first)
    {
        var gap = new GoalPlaneGap(in plane, in _path, _time, _bend, new SearchSpan(in _path, Math.Min(best, _path.Length)));
        double at = TimeOfImpact.First(ref gap);
        if (at < best)
        {
            best = at;
            first = plane;
        }
    }

    /// <summary>Returns the time of the first closing contact with a collider, or of a seam at which it becomes the carrier; infinite if
    /// there is none.</summary>
    private double FirstContact(int thing, int carrier, Span<Contact> held, double until, out bool seam)
    {
        seam = false;
        Collider collider = _world.Colliders[thing];
        double r = _world.Ball.Radius;
        var span = new SearchSpan(in _path, until);
        if (collider.StandingPlane is { } plane)
        {
            var distance = new PlaneGap(_path.DistanceTo(plane.Normal, plane.DistanceTo(_path.Start) - r), in span);
            return TimeOfImpact.First(ref distance);
        }

        if (collider.Rotates)
        {
            var rotating = new RotatingGap(collider.From(_time), collider.HollowCurvature, in _path, _bend, r, in span);
            return TimeOfImpact.First(ref rotating);
        }

        // Transform the path to the frame of a moving collider, in which the collider is stationary.
        PathCubic path = _path;
        Bounds3d bounds = _bounds;
        if (collider.Moves)
        {
            path = collider.Seen(in _path, _time);
            bounds = path.Bounds;
        }

        if (!bounds.Expanded(r).Intersects(in collider.Bounds))
        {
            return double.PositiveInfinity;
        }

        var gap = new ShapeGap(collider, in path, _bend, r, in span);
        double t = 0;
        while (TimeOfImpact.Finds(ref gap, ref t))
        {
            // A flush seam causes no contact: advance until the ball is above the face and the normals agree.
            double passage = Flush.Passage(_world, thing, _path.At(t), _path.VelocityAt(t), _time + t, carrier, held);
            if (!(passage > 0))
            {
                return t;
            }

            t += Math.Max(passage, span.Shortest);
            gap.Crosses = true;
            if (t > until)
            {
                break;
            }

            seam = carrier >= 0 && Flush.CarrierAt(_world, carrier, _path.At(t), _time + t) == thing;
            if (seam)
            {
                return t;
            }
        }

        return double.PositiveInfinity;
    }
}
