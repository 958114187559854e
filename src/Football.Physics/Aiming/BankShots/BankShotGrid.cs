namespace Football.Physics;

/// <summary>
/// The last resort: kicks over all directions that can meet the first thing are flown in long steps, few at first, more where those lead to no hit; from the closest of
/// those that meet all of them, Newton's method goes on through the impacts.
/// </summary>
internal sealed class BankShotGrid
{
    /// <summary>The looks, from the widest to the closest: so many directions and elevations, each look twice as close as the one before.</summary>
    private const int Looks = 4;
    private const int Directions = 5;
    private const int Elevations = 8;
    private const int Starts = 8;

    private readonly BankShotFlight _flight;
    private readonly World _world;
    private readonly double _radius;
    private readonly BankShotStart[] _starts = new BankShotStart[Starts];
    private int _count;

    public BankShotGrid(BankShotFlight flight, World world, double radius)
    {
        _flight = flight;
        _world = world;
        _radius = radius;
    }

    /// <summary>Finds a kick that is closer than the best so far.</summary>
    public BankShotStart Find(AimRequest request, in TargetFrame frame, int[] things, BankShotStart best)
    {
        for (int look = 0; look < Looks && !best.IsHit(request); look++)
        {
            BankShotStart closest = Look(request, in frame, things, 1 << look);
            best = !best.IsFine && closest.Miss < best.Miss ? closest : best;
            for (int i = 0; i < _count && !best.IsHit(request); i++)
            {
                BankShotStart found = _flight.Improve(request, in frame, things, in _starts[i]);
                best = found.IsFine && (!best.IsFine || found.Miss < best.Miss) ? found : best;
            }
        }

        return best;
    }

    /// <summary>Flies kicks over all directions of use, and keeps the closest of those that meet everything.</summary>
    /// <returns>The closest of all.</returns>
    private BankShotStart Look(AimRequest request, in TargetFrame frame, int[] things, int closeness)
    {
        // A grid that a closer look halves; the best of those that meet everything are the starts of Newton's method.
        _count = 0;
        var bounds = ElevationBounds.Of(request);
        BankShotStart best = default;
        best.Miss = double.MaxValue;
        Azimuths(in frame, things, out double from, out double to);
        int directions = Directions * closeness;
        int elevations = Elevations * closeness;
        for (int i = 0; i <= directions; i++)
        {
            for (int j = 0; j <= elevations; j++)
            {
                // What a wider look has flown need not be flown again.
                if (closeness > 1 && (i & 1) == 0 && (j & 1) == 0)
                {
                    continue;
                }

                Kick kick = Kick.Of(request, bounds.Lowest + ((bounds.Highest - bounds.Lowest) * j / elevations), from + ((to - from) * i / directions));
                BankShotStart shot = _flight.Fly(request, in frame, things, in kick, BankShotFlight.CoarseStep);
                if (shot.Meets)
                {
                    Keep(in shot);
                    best = shot.Miss < best.Miss ? shot : best;
                }
            }
        }

        return best;
    }

    /// <summary>The directions in which the first thing but the ground is met: those of its box as seen from the ball, or all where it has none.</summary>
    private void Azimuths(in TargetFrame frame, int[] things, out double from, out double to)
    {
        int thing = Array.Find(things, item => item != 0);
        if (thing == 0)
        {
            // Over the ground alone: to the target, and beside it for a ball that bends.
            from = -0.5;
            to = 0.5;
            return;
        }

        Bounds3d box = _world.Colliders[thing - _world.FirstCollider].Bounds;
        Vector3d size = box.Max - box.Min;
        if (!size.IsFinite)
        {
            from = -Math.PI;
            to = Math.PI;
            return;
        }

        Vector3d middle = (0.5 * (box.Min + box.Max)) - frame.From;
        double around = Elementary.Atan2(Vector3d.Dot(in middle, frame.Left), Vector3d.Dot(in middle, frame.Forward));
        double half = (0.5 * size.Horizontal.Length) + _radius;
        double distance = middle.Horizontal.Length;

        // Twice as wide as it looks: the ball may bend.
        double angle = distance > half ? Elementary.Atan2(half, Math.Sqrt((distance * distance) - (half * half))) : 0.5 * Math.PI;
        double spread = Math.Min(Math.PI, (2.0 * angle) + 0.02);
        from = around - spread;
        to = around + spread;
    }

    /// <summary>Keeps a start if it is among the closest.</summary>
    private void Keep(in BankShotStart shot)
    {
        int place = _count < Starts ? _count++ : Starts;
        while (place > 0 && shot.Miss < _starts[place - 1].Miss)
        {
            if (place < Starts)
            {
                _starts[place] = _starts[place - 1];
            }

            place--;
        }

        if (place < Starts)
        {
            _starts[place] = shot;
        }
    }
}
