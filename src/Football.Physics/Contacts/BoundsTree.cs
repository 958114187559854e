using FootballPhysics.Numerics;

namespace FootballPhysics.Contacts;

/// <summary>A tree of bounding boxes of stationary objects, built once.</summary>
/// <remarks>
/// It tests only boxes; the caller tests the objects inside. Nodes are in depth-first order; each stores the index of the node after its
/// branch,
/// so a walk needs no stack.
/// </remarks>
internal sealed class BoundsTree
{
    private const int NoItem = -1;

    private readonly Bounds3d[] _bounds;
    private readonly int[] _after;
    private readonly int[] _item;

    /// <summary>Builds a tree.</summary>
    /// <param name="boxes">The boxes.</param>
    public BoundsTree(Bounds3d[] boxes)
    {
        int count = boxes.Length == 0 ? 0 : (2 * boxes.Length) - 1;
        _bounds = new Bounds3d[count];
        _after = new int[count];
        _item = new int[count];
        int[] items = new int[boxes.Length];
        for (int i = 0; i < items.Length; i++)
        {
            items[i] = i;
        }

        if (count > 0)
        {
            Build(boxes, items, 0, items.Length, 0);
        }
    }

    /// <summary>Advances to the next box that intersects the given box.</summary>
    /// <param name="box">The given box.</param>
    /// <param name="node">Position of the walk; 0 at the start.</param>
    /// <param name="item">Index of the box found.</param>
    /// <returns>False at the end.</returns>
    public bool Next(in Bounds3d box, ref int node, out int item)
    {
        while (node < _bounds.Length)
        {
            int here = node;

            // A box that misses this node misses its entire branch.
            if (!_bounds[here].Intersects(in box))
            {
                node = _after[here];
                continue;
            }

            node++;
            item = _item[here];
            if (item != NoItem)
            {
                return true;
            }
        }

        item = NoItem;
        return false;
    }

    /// <summary>Returns the time at which a straight path reaches the first box, s; the given limit if it reaches none before.</summary>
    public double FirstMet(in StraightWay way, double until)
    {
        int node = 0;
        while (node < _bounds.Length)
        {
            double met = way.Meets(in _bounds[node]);

            // The path reaches this node, and thus its entire branch, too late or not at all.
            if (!(met < until))
            {
                node = _after[node];
                continue;
            }

            until = _item[node] != NoItem ? met : until;
            node++;
        }

        return until;
    }

    /// <summary>Builds the branch for a range of items, which it splits at the median along the axis with the widest spread of centres.</summary>
    /// <returns>The node after the branch.</returns>
    private int Build(Bounds3d[] boxes, int[] items, int from, int to, int node)
    {
        // The bounds of all items, and the bounds of their centres, which determine the split axis.
        Bounds3d all = boxes[items[from]];
        Bounds3d centers = boxes[items[from]].AtCenter;
        for (int i = from + 1; i < to; i++)
        {
            all = all.Union(in boxes[items[i]]);
            centers = centers.Union(boxes[items[i]].AtCenter);
        }

        _bounds[node] = all;
        _item[node] = to - from == 1 ? items[from] : NoItem;
        int next = node + 1;
        if (to - from > 1)
        {
            Vector3d spread = centers.Max - centers.Min;
            int axis = spread.X >= spread.Y && spread.X >= spread.Z ? 0 : spread.Y >= spread.Z ? 1 : 2;
            Array.Sort(items, from, to - from, Comparer<int>.Create((a, b) => Compare(boxes, axis, a, b)));
            int middle = (from + to) / 2;
            next = Build(boxes, items, from, middle, next);
            next = Build(boxes, items, middle, to, next);
        }

        _after[node] = next;
        return next;
    }

    private static int Compare(Bounds3d[] boxes, int axis, int a, int b)
    {
        Vector3d first = boxes[a].AtCenter.Min;
        Vector3d second = boxes[b].AtCenter.Min;
        int order = axis == 0 ? first.X.CompareTo(second.X) : axis == 1 ? first.Y.CompareTo(second.Y) : first.Z.CompareTo(second.Z);
        return order != 0 ? order : a.CompareTo(b);
    }
}
