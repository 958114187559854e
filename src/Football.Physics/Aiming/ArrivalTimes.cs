namespace FootballPhysics.Aiming;

/// <summary>Searches over the time of a flight or a roll for the kick that arrives at a target at a given speed.</summary>
/// <remarks>
/// Each time has one kick, whose arrival speed changes smoothly with the time. The solution lies between a time whose kick arrives too
/// slowly and one whose kick arrives too fast. If all arrive too fast, or all too slowly, it may lie at the end of the feasible times, or near a
/// time whose kick is closer than those of both neighbours.
/// </remarks>
internal sealed class ArrivalTimes(Aimer aimer)
{
    /// <summary>The ratio of successive times, and the maximum number of times.</summary>
    private const double Ratio = 1.15;
    private const int Most = 64;

    /// <summary>The number of successive times without a flight, after some with one, that end the scan. Rolls end at the first time without one.</summary>
    private const int MostMissing = 4;

    /// <summary>The first time, as a share of the time that a straight path at maximum speed takes.</summary>
    private const double Earliest = 0.7;

    private const int Rounds = 40;
    private const int Halvings = 24;
    private const double Closeness = 1e-9;

    private readonly Aimer _aimer = aimer;
    private readonly Node[] _nodes = new Node[Most];
    private AimRequest _request = new();
    private double _speed;
    private bool _rolls;
    private int _count;
    private AimSolution _near;
    private Node _closest;

    /// <summary>The kick of the last search whose arrival speed is closest to the requested one; null if no kick hits.</summary>
    public AimSolution? Closest => _closest.Hits ? _closest.Kick : null;

    /// <summary>Scans the times, then searches for the speed between two times, at the end of the feasible times, and at an extremum.</summary>
    /// <param name="request">The request.</param>
    /// <param name="speed">The arrival speed, in m/s.</param>
    /// <param name="roll">The fastest kick along the ground, to search for a roll; null to search for a flight.</param>
    /// <param name="result">The kick.</param>
    /// <returns>True if a kick was found.</returns>
    public bool Find(AimRequest request, double speed, AimSolution? roll, out AimResult result)
    {
        _request = request;
        _speed = speed;
        _rolls = roll is not null;
        _near = roll.GetValueOrDefault();
        _closest = default;
        bool found = Scan(out Node root) || Search(out root);
        result = found ? _aimer.ReportArrival(request, in root.Kick, speed) : default;
        return found;
    }

    /// <summary>Scans the times, shortest first, and finds the first solution on the low arc, which has the shorter time.</summary>
    private bool Scan(out Node root)
    {
        TargetFrame frame = _aimer.Context.Frame(_request);
        double windward = _aimer.Context.Scene.Air.Wind.Length + _request.TargetVelocity.Length;
        double time = _rolls ? _near.Time : Earliest * Vector3d.Distance(frame.From, frame.Target) / (_request.Speed + windward);
        int missing = 0;
        bool any = false;
        root = default;
        for (_count = 0; _count < Most - 1 && time < AimContext.LongestFlight && missing < (_rolls ? 1 : MostMissing); time *= Ratio)
        {
            Node node = At(time);
            _nodes[_count++] = node;
            if (_request.Arc == AimArc.Low && _count > 1 && Between(in _nodes[_count - 2], in node, out root))
            {
                return true;
            }

            any |= node.Hits;
            missing = node.Hits || !any ? 0 : missing + 1;
        }

        if (!_rolls)
        {
            Insert(_aimer.SlowestTime(_request));
            return false;
        }

        // Wind or a slope may bring a slower ball to the target earlier.
        _near = _nodes[0].Kick;
        while (_count < Most && _nodes[0].Hits)
        {
            Insert(_nodes[0].Time / Ratio);
        }

        return false;
    }

    /// <summary>Searches between two times, then at the end of the feasible times, and then at an extremum, in the order of the arc.</summary>
    private bool Search(out Node root)
    {
        for (int pass = 0; pass < 3; pass++)
        {
            for (int k = 1; k < _count; k++)
            {
                int i = _request.Arc == AimArc.Low ? k : _count - k;
                bool found = pass == 0 ? Between(in _nodes[i - 1], in _nodes[i], out root)
                    : pass == 1 ? AtEnd(in _nodes[i - 1], in _nodes[i], out root)
                    : AtTurn(i, out root);
                if (found)
                {
                    return true;
                }
            }
        }

        root = default;
        return false;
    }

    /// <summary>Inserts one more time in order, because the scan may miss all feasible times if the bounds are narrow.</summary>
    private void Insert(double time)
    {
        int place = _count++;
        for (; place > 0 && _nodes[place - 1].Time > time; place--)
        {
            _nodes[place] = _nodes[place - 1];
        }

        _nodes[place] = At(time);
    }

    private Node At(double time, bool isBetween = false)
    {
        Node node = default;
        node.Time = time;
        node.Hits = _aimer.TryArrival(_request, time, _rolls, isBetween, in _near, out node.Kick, out double arrival);
        node.Off = arrival - _speed;
        _near = node.Hits ? node.Kick : _near;
        if (node.Hits && !(_closest.Hits && Math.Abs(_closest.Off) <= Math.Abs(node.Off)))
        {
            _closest = node;
        }

        return node;
    }

    /// <summary>Finds the time at which the arrival speed matches, between one with a slower and one with a faster arrival.</summary>
    private bool Between(in Node before, in Node after, out Node root)
    {
        root = Math.Abs(before.Off) < Math.Abs(after.Off) ? before : after;
        if (!before.Hits || !after.Hits || !(before.Off * after.Off <= 0))
        {
            return false;
        }

        Node low = before;
        Node high = after;
        for (int i = 0; i < Rounds && high.Time - low.Time > Closeness * high.Time && Math.Abs(root.Off) > Closeness; i++)
        {
            // Take a secant step, limited so that the bracket shrinks from both ends.
            double share = Math.Min(0.9, Math.Max(0.1, low.Off / (low.Off - high.Off)));
            Node middle = At(low.Time + (share * (high.Time - low.Time)), isBetween: true);
            if (!middle.Hits)
            {
                return false;
            }

            root = Math.Abs(middle.Off) < Math.Abs(root.Off) ? middle : root;
            if (middle.Off * low.Off > 0)
            {
                low = middle;
            }
            else
            {
                high = middle;
            }
        }

        return true;
    }

    /// <summary>Searches between a time with a kick and one without, up to the last time with a kick.</summary>
    private bool AtEnd(in Node before, in Node after, out Node root)
    {
        root = default;
        if (before.Hits == after.Hits)
        {
            return false;
        }

        Node hit = before.Hits ? before : after;
        double without = before.Hits ? after.Time : before.Time;
        for (int i = 0; i < Halvings; i++)
        {
            Node middle = At(0.5 * (hit.Time + without));
            if (!middle.Hits)
            {
                without = middle.Time;
                continue;
            }

            if (middle.Off * hit.Off <= 0)
            {
                return hit.Time < middle.Time ? Between(in hit, in middle, out root) : Between(in middle, in hit, out root);
            }

            hit = middle;
        }

        // Accept the kick at the very end if the error of its arrival speed is within tolerance.
        root = hit;
        return Math.Abs(hit.Off) <= Aimer.LargestArrivalError;
    }

    /// <summary>Searches between three times of which the middle one is closest: the minimum or maximum of the arrival speed.</summary>
    private bool AtTurn(int middle, out Node root)
    {
        Node a = _nodes[middle - 1];
        Node b = _nodes[middle];
        Node c = middle + 1 < _count ? _nodes[middle + 1] : default;
        root = b;
        if (!a.Hits || !b.Hits || !c.Hits || a.Off * b.Off <= 0 || b.Off * c.Off <= 0 || Math.Abs(b.Off) > Math.Abs(a.Off) || Math.Abs(b.Off) > Math.Abs(c.Off))
        {
            return false;
        }

        // Golden-section search in the wider part, until the sign changes.
        for (int i = 0; i < Halvings; i++)
        {
            bool left = b.Time - a.Time > c.Time - b.Time;
            Node next = At(left ? b.Time - (0.382 * (b.Time - a.Time)) : b.Time + (0.382 * (c.Time - b.Time)));
            if (!next.Hits)
            {
                return false;
            }

            if (next.Off * b.Off <= 0)
            {
                return left ? Between(in a, in next, out root) : Between(in next, in c, out root);
            }

            if (Math.Abs(next.Off) < Math.Abs(b.Off))
            {
                (a, c) = left ? (a, b) : (b, c);
                b = next;
            }
            else
            {
                (a, c) = left ? (next, c) : (a, next);
            }
        }

        root = b;
        return Math.Abs(b.Off) <= Aimer.LargestArrivalError;
    }

    /// <summary>A time of flight, and its kick.</summary>
    private struct Node
    {
        public double Time;

        /// <summary>The excess of the arrival speed over the requested one, in m/s.</summary>
        public double Off;

        /// <summary>True if there is a kick.</summary>
        public bool Hits;

        public AimSolution Kick;
    }
}
