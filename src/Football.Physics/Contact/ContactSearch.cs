namespace FootballPhysics;

/// <summary>Finds the first contact along a path.</summary>
/// <remarks>
/// It tracks each gap by conservative advancement: a gap f with rate f' and second derivative of at most M stays open until
/// f + f' s − ½ M s² is zero. Near a contact this is Newton's method, which never oversteps the contact.
/// </remarks>
internal readonly struct ContactSearch
{
    /// <summary>The second derivative of the gap to a concave surface is bounded only up to this gap, as a share of the radius.</summary>
    internal const double NearHollow = 0.1;

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
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double First(in BallState s, int carrier, out Separation first) => First(in s, carrier, default, out first);

    /// <summary>Finds the first contact or passage on the path.</summary>
    /// <param name="s">The ball at the start of the path.</param>
    /// <param name="carrier">The carrier; −1 if there is none.</param>
    /// <param name="held">Contacts that the ball keeps; they are skipped.</param>
    /// <param name="first">The contact or passage.</param>
    /// <returns>Time from the start of the path, s; infinite if there is none.</returns>
    public double First(in BallState s, int carrier, Span<Contact> held, out Separation first)
    {
        double at = FirstContact(in s, carrier, held, out first);
        return carrier >= 0 && _world.IsPlaneAlone ? at : FirstPassage(in s, at, ref first);
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
        if (carrier >= 0 && _world.IsPlaneAlone)
        {
            return best;
        }

        // Broad phase: the engine's cast and the bounding box of the path. Narrow phase: conservative advancement along the gap of each
        // collider.
        _world.Engine?.LookAlong(in _path, _time);
        var near = new NearThings(_world, _bounds.Expanded(_world.Ball.Radius), _time, _path.Length);
        while (near.NextCollider(out int thing))
        {
            bool seam = false;
            double at = thing == carrier || ContactSet.Has(held, thing) ? double.PositiveInfinity : FirstContact(thing, carrier, held, Math.Min(best, _path.Length), out seam);

            // For simultaneous contacts, take the first collider of the scene, regardless of the order of the walk.
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
        return FirstPassage(in s, double.PositiveInfinity, ref first);
    }

    private double FirstPassage(in BallState s, double best, ref Separation first)
    {
        if (_world.Nets.Length + _world.Goals.Length == 0)
        {
            return best;
        }

        int bestThing = first.What == SeparationKind.None ? -1 : first.Index;
        int nets = _world.FirstPassage;
        int goals = nets + _world.Nets.Length;

        // A net extends beyond its edges by the depth of the ball in another net, so expand the search by it.
        int deepest = s.Nets == 0 ? -1 : _world.DeepestNet(in s);
        double deepestSide = deepest < 0 ? 0 : World.SideOf(s.NetSides, deepest);
        double deep = deepest < 0 ? 0 : _world.Nets[deepest].Depth(s.Position, deepestSide) + (_path.Length * _path.FastestSpeed);
        var near = new NearThings(_world, _bounds.Expanded(_world.Ball.Radius + Math.Max(0, deep)), _time, _path.Length);
        while (near.NextPassage(out int thing))
        {
            double until = Math.Min(best, _path.Length);
            double at = double.PositiveInfinity;
            Separation gap = default;

            // Consider nets that the ball is not in, and mouths that it has not entered and whose line it has not passed.
            if (thing < goals)
            {
                int net = thing - nets;
                bool inside = (s.Nets >> net & 1) != 0;
                at = inside ? at : MeetsNet(net, deepest, deepestSide, until, out gap);
            }
            else if (((s.GoalsEntered | s.GoalsPassed) >> (thing - goals) & 1) == 0)
            {
                gap = Separation.OfGoal(_world, SeparationKind.MouthEntered, thing - goals);
                at = EntersMouth(in gap, until);
            }

            // For simultaneous passages, take the first net or goal of the scene, regardless of the order of the walk.
            if (at < best || (at == best && thing < bestThing))
            {
                best = at;
                bestThing = thing;
                first = gap;
            }
        }

        // A net stretches with the ball in it, so its bounds are of no use: always test whether the ball leaves it.
        for (int net = 0; net < _world.Nets.Length && s.Nets >> net != 0; net++)
        {
            if ((s.Nets >> net & 1) != 0)
            {
                Vector3d place = _world.Nets[net].PlaceInFrame(_path.At(0));
                Leave(Separation.OfLeavingNet(_world, net, World.SideOf(s.NetSides, net)), ref best, ref first, ref bestThing);
                Leave(Separation.OfNetEdge(_world, net, 0, place.X, deepest, deepestSide), ref best, ref first, ref bestThing);
                Leave(Separation.OfNetEdge(_world, net, 1, place.Y, deepest, deepestSide), ref best, ref first, ref bestThing);
            }
        }

        // For a ball in the mouth of a goal, always test whether it passes the line or leaves through the mouth.
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
        double at = Fall(in net, Math.Min(best, _path.Length));
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
        double at = PassesPlane(in plane, Math.Min(best, _path.Length));
        if (at < best)
        {
            best = at;
            first = plane;
        }
    }

    /// <summary>Returns the time at which the ball enters the mouth of a goal; infinite if it does not.</summary>
    private double EntersMouth(in Separation mouth, double until)
    {
        double shortest = ShortestOf(in _path);
        double t = 0;

        // At the start of the path the ball may be slightly behind the mouth, because it was projected onto its carrier after the last piece.
        bool isBefore = _world.Goals[mouth.Index].BeforeMouth(_path.At(0)) >= -ContactTolerances.Projected;
        while (t <= until)
        {
            Vector3d place = _path.At(t);
            mouth.Evaluate(in place, _path.VelocityAt(t), _time + t, out double gap, out double rate);
            if (isBefore && gap <= ContactTolerances.Touching && rate < -ContactTolerances.Approaching && _world.Goals[mouth.Index].IsOpen(in place))
            {
                return t;
            }

            // The ball may reach the plane next from either side.
            isBefore = gap > ContactTolerances.Touching || (isBefore && rate >= -ContactTolerances.Approaching);
            double step = gap > ContactTolerances.Touching ? Safe(gap, rate, _bend) : gap < -ContactTolerances.Touching ? Safe(-gap, -rate, _bend) : Along(Math.Abs(rate), _bend);
            t += Math.Max(step, shortest);
        }

        return double.PositiveInfinity;
    }

    /// <summary>Returns the time at which a ball in the mouth of a goal passes one of its planes; infinite if it does not.</summary>
    /// <remarks>A plane that the ball has already passed counts at once.</remarks>
    private double PassesPlane(in Separation plane, double until)
    {
        double shortest = ShortestOf(in _path);
        double t = 0;
        while (t <= until)
        {
            plane.Evaluate(_path.At(t), _path.VelocityAt(t), _time + t, out double gap, out double rate);

            // The ball is beyond the plane, or on it and moving through it.
            if (gap < -2.0 * ContactTolerances.Touching || (gap <= ContactTolerances.Touching && rate < -ContactTolerances.Approaching))
            {
                return t;
            }

            t += Math.Max(gap > ContactTolerances.Touching ? Safe(gap, rate, _bend) : Along(rate, _bend), shortest);
        }

        return double.PositiveInfinity;
    }

    /// <summary>Returns the time of the first closing contact with a collider, or of a seam at which it becomes the carrier; infinite if
    /// there is none.</summary>
    private double FirstContact(int thing, int carrier, Span<Contact> held, double until, out bool seam)
    {
        seam = false;
        Collider collider = _world.Colliders[thing];
        double r = _world.Ball.Radius;
        if (collider.StandingPlane is { } plane)
        {
            return FirstContact(_path.DistanceTo(plane, r), until);
        }

        if (collider.Rotates)
        {
            return RotatingSearch.FirstContact(collider.From(_time), collider.HollowCurvature, in _path, _bend, r, until);
        }

        // Transform the path to the frame of a moving collider, where the collider is stationary.
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

        // M bounds f'': the acceleration of the path, plus |v|² κ/(1 − κ d) for a concave surface. A convex surface bends away.
        double speed = path.FastestSpeed;
        double hollow = collider.HollowCurvature;
        double bend = _bend + (hollow > 0 ? speed * speed * hollow / (1.0 - ((1.0 + NearHollow) * r * hollow)) : 0);
        double shortest = ShortestOf(in path);
        double t = 0;
        bool crosses = false;
        while (true)
        {
            ShapePoint at = collider.At(path.At(t));
            double gap = at.Distance - r;
            double rate = Vector3d.Dot(path.VelocityAt(t), at.Normal);
            if (gap <= ContactTolerances.Touching && rate < -ContactTolerances.Approaching)
            {
                // A flush seam causes no contact: advance until the ball is over the face and the normals agree.
                double passage = Flush.Passage(_world, thing, _path.At(t), _path.VelocityAt(t), _time + t, carrier, held);
                if (!(passage > 0))
                {
                    return t;
                }

                t += Math.Max(passage, shortest);
                crosses = true;
                if (t > until)
                {
                    return double.PositiveInfinity;
                }

                seam = carrier >= 0 && Flush.CarrierAt(_world, carrier, _path.At(t), _time + t) == thing;
                if (seam)
                {
                    return t;
                }

                continue;
            }

            if (t == 0 && gap <= ContactTolerances.Touching && rate <= ContactTolerances.Leaving && _bend == 0)
            {
                // On a straight path, ignore a closing contact without load. If the ball ends up inside the surface, it is pushed out.
                return double.PositiveInfinity;
            }

            if ((t == 0 || crosses) && hollow == 0 && !(FirstContact(path.DistanceTo(at.Normal, gap - path.ClimbAlong(at.Normal, t)), until, t) <= until))
            {
                // A convex shape lies behind the tangent plane at its nearest point. If the path never reaches the plane, there is no
                // contact.
                return double.PositiveInfinity;
            }

            double step = gap > ContactTolerances.Touching ? Safe(gap, rate, bend) : Along(rate, bend);

            // Far from a concave surface M is not valid, so bound the closing by the speed. Near it, use M only until the ball may be far
            // again.
            if (hollow > 0)
            {
                double bySpeed = Math.Max(gap, 0) / speed;
                step = gap < NearHollow * r ? Math.Max(bySpeed, Math.Min(step, ((NearHollow * r) - gap) / speed)) : bySpeed;
            }

            if (!Advance(ref t, step, shortest, until))
            {
                return double.PositiveInfinity;
            }
        }
    }

    /// <summary>Returns the time of the first closing contact with a plane; infinite if there is none.</summary>
    private double FirstContact(in PathDistance distance, double until, double from = 0)
    {
        double bend = distance.GreatestFall;
        double shortest = ShortestOf(in _path);
        double t = from;
        while (true)
        {
            double gap = distance.At(t);
            double rate = distance.RateAt(t);
            if (gap <= ContactTolerances.Touching && rate < -ContactTolerances.Approaching)
            {
                return t;
            }

            double step = gap > ContactTolerances.Touching ? Safe(gap, rate, bend) : Along(rate, bend);
            if (!Advance(ref t, step, shortest, until))
            {
                return double.PositiveInfinity;
            }
        }
    }

    /// <summary>Advances along the path. A step that was lengthened to the minimum stops at the end of the path.</summary>
    /// <returns>False beyond the end.</returns>
    internal static bool Advance(ref double t, double step, double shortest, double until)
    {
        double next = t + Math.Max(step, shortest);

        // A lengthened step must not skip the end of the path, where the gap may have closed.
        next = next > until && t + step <= until && t < until ? until : next;
        t = next;
        return next <= until;
    }

    /// <summary>Returns the time at which a gap that is linear in the position falls to zero; infinite if it does not, or already
    /// has.</summary>
    private double Fall(in Separation sought, double until)
    {
        double shortest = ShortestOf(in _path);
        double t = 0;
        while (true)
        {
            sought.Evaluate(_path.At(t), _path.VelocityAt(t), _time + t, out double gap, out double rate);

            // A closed gap that still falls is the event. A closed gap at rest does not fall.
            if (gap <= ContactTolerances.Touching)
            {
                if (rate < -ContactTolerances.Approaching && (t > 0 || gap > 0 || sought.What == SeparationKind.NetLeft))
                {
                    return t;
                }

                if (rate <= ContactTolerances.Approaching)
                {
                    return double.PositiveInfinity;
                }
            }

            double bend = sought.Bends * _bend;
            double step = gap > ContactTolerances.Touching ? Safe(gap, rate, bend) : Along(rate, bend);
            if (!Advance(ref t, step, shortest, until))
            {
                return double.PositiveInfinity;
            }
        }
    }

    /// <summary>Returns the time at which the ball reaches a net: within its radius of the sheet, and inside the rectangle.</summary>
    private double MeetsNet(int index, int deepest, double deepestSide, double until, out Separation gap)
    {
        NetSheet net = _world.Nets[index];
        double shortest = ShortestOf(in _path);
        double t = 0;
        gap = default;
        double side = net.PlaceInFrame(_path.At(0)).Z < 0 ? -1.0 : 1.0;
        gap = Separation.OfMeetingNet(_world, index, 2, side, side, deepest, deepestSide);
        while (true)
        {
            Vector3d at = _path.At(t);
            Vector3d velocity = _path.VelocityAt(t);
            Vector3d place = net.PlaceInFrame(in at);

            // The side of entry is the ball's side of the sheet when it reaches the slab.
            side = place.Z < 0 ? -1.0 : 1.0;
            double step = 0;
            Consider(Separation.OfMeetingNet(_world, index, 2, place.Z, side, deepest, deepestSide), in at, in velocity, ref step, ref gap);
            Consider(Separation.OfMeetingNet(_world, index, 0, place.X, side, deepest, deepestSide), in at, in velocity, ref step, ref gap);
            Consider(Separation.OfMeetingNet(_world, index, 1, place.Y, side, deepest, deepestSide), in at, in velocity, ref step, ref gap);
            if (step == 0)
            {
                return t;
            }

            if (!Advance(ref t, step, shortest, until))
            {
                return double.PositiveInfinity;
            }
        }
    }

    /// <summary>Computes for how long one condition of a net remains unmet. The longest such time is safe for all conditions.</summary>
    private void Consider(in Separation condition, in Vector3d place, in Vector3d velocity, ref double step, ref Separation gap)
    {
        condition.Evaluate(in place, in velocity, 0, out double value, out double rate);
        double bend = condition.Bends * _bend;

        // If the gap is open, advance while it is sure to stay open. If it is zero but not decreasing, advance until it could decrease. Otherwise the step is zero.
        double safe = value > ContactTolerances.Touching ? Safe(value, rate, bend)
            : value > -ContactTolerances.Touching && rate >= 0 ? Along(rate, bend)
            : 0;
        if (value > -ContactTolerances.Touching && rate >= 0)
        {
            safe = Math.Max(safe, double.Epsilon);
        }

        if (safe > step)
        {
            step = safe;
            gap = condition;
        }
    }

    /// <summary>Returns the minimum step of a search along a path, s, so that every search ends.</summary>
    internal static double ShortestOf(in PathCubic path) => Math.Max(ContactTolerances.ShortestShare * path.Length, ContactTolerances.ShortestStep);

    /// <summary>Returns a safe step for a closed gap that does not shrink: until it may shrink, or by the contact tolerance, ½ M
    /// s².</summary>
    private static double Along(double rate, double bend) =>
        bend > 0 ? Math.Max(rate / bend, Math.Sqrt(2.0 * ContactTolerances.Touching / bend)) : double.PositiveInfinity;

    /// <summary>Returns the positive root of f + f' s − ½ M s², without cancellation.</summary>
    internal static double Safe(double gap, double rate, double bend)
    {
        // s = (f' + √(f'² + 2 M f))/M; for f' < 0 this is 2 f/(√(…) − f').
        double root = Math.Sqrt((rate * rate) + (2.0 * bend * gap));
        return rate < 0 ? 2.0 * gap / (root - rate) : bend > 0 ? (rate + root) / bend : double.PositiveInfinity;
    }
}
