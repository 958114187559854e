using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The fallback for bank shots: a grid search over all directions that can hit the first object.</summary>
/// <remarks>
/// Kicks fly in coarse steps, and the grid is refined while it finds no hit. Newton's method continues from the closest kicks that hit all objects.
/// </remarks>
internal sealed class BankShotGrid(BankShotFlight flight, World world, double radius)
{
    /// <summary>The number of grids, of directions and elevations in the first grid, and of kicks kept as starts; each grid halves the
    /// spacing.</summary>
    private const int Looks = 4;
    private const int Directions = 5;
    private const int Elevations = 8;
    private const int Starts = 8;

    private readonly BankShotFlight _flight = flight;
    private readonly World _world = world;
    private readonly double _radius = radius;
    private readonly (double Elevation, double Azimuth, double Miss)[] _starts = new (double Elevation, double Azimuth, double Miss)[Starts];
    private int _count;

    /// <summary>Searches for a kick closer than the best so far.</summary>
    public void Find(AimRequest request, in TargetFrame frame, int[] things)
    {
        // Each grid halves the spacing. The corrections start from the best kicks that hit all objects.
        var bounds = ElevationBounds.Of(request);
        Azimuths(in frame, things, out double from, out double to);
        for (int closeness = 1; closeness < 1 << Looks && !_flight.Hits; closeness *= 2)
        {
            _count = 0;
            int directions = Directions * closeness;
            int elevations = Elevations * closeness;
            for (int i = 0; i < (directions + 1) * (elevations + 1); i++)
            {
                (int column, int row) = (i / (elevations + 1), i % (elevations + 1));

                // Skip the kicks that a coarser grid has already simulated.
                if (closeness == 1 || (column & 1) != 0 || (row & 1) != 0)
                {
                    Look(bounds.Lowest + ((bounds.Highest - bounds.Lowest) * row / elevations), from + ((to - from) * column / directions));
                }
            }

            for (int i = 0; i < _count && !_flight.Hits; i++)
            {
                _flight.Improve(_starts[i].Elevation, _starts[i].Azimuth);
            }
        }
    }

    /// <summary>Returns the range of directions to the first object except the ground, from its bounding box; all directions if it is
    /// unbounded.</summary>
    private void Azimuths(in TargetFrame frame, int[] things, out double from, out double to)
    {
        int thing = Array.Find(things, item => item != 0);
        if (thing == 0)
        {
            // Only the ground is required: search towards the target, with a margin because the path may bend.
            from = -0.5;
            to = 0.5;
            return;
        }

        Bounds3d box = _world.ByIndex[thing - _world.FirstCollider].Bounds;
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

        // Use twice the apparent width, because the path may bend.
        double angle = distance > half ? Elementary.Atan2(half, Math.Sqrt((distance * distance) - (half * half))) : 0.5 * Math.PI;
        double spread = Math.Min(Math.PI, (2.0 * angle) + 0.02);
        from = around - spread;
        to = around + spread;
    }

    /// <summary>Simulates a kick, and stores it as a start if it is one of the closest.</summary>
    private void Look(double elevation, double azimuth)
    {
        // Use insertion sort, because the list is short and most kicks hit nothing.
        double miss = _flight.Look(elevation, azimuth);
        int place = miss < double.PositiveInfinity ? Math.Min(_count, Starts - 1) : -1;
        if (place < 0 || (_count == Starts && miss >= _starts[place].Miss))
        {
            return;
        }

        _count = Math.Min(_count + 1, Starts);
        for (; place > 0 && miss < _starts[place - 1].Miss; place--)
        {
            _starts[place] = _starts[place - 1];
        }

        _starts[place] = (elevation, azimuth, miss);
    }
}
