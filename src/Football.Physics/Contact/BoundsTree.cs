namespace Football.Physics;

/// <summary>The broad phase: a tree of boxes around what stands still, built once. It answers in boxes alone; what is inside them is asked after.</summary>
/// <remarks>Nodes lie in the order of a walk from the root, each with the node that follows its whole branch: a walk needs no stack.</remarks>
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

    /// <summary>Walks on to the next box that touches another.</summary>
    /// <param name="box">The other box.</param>
    /// <param name="node">Where the walk is: 0 to begin with.</param>
    /// <param name="item">Index of the box that was found.</param>
    /// <returns>False at the end.</returns>
    public bool Next(in Bounds3d box, ref int node, out int item)
    {
        while (node < _bounds.Length)
        {
            int here = node;

            // What does not touch this box touches nothing of its branch.
            if (!_bounds[here].Touches(in box))
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

    /// <summary>When a straight way comes near the first of the boxes, s; or this long, if it comes near none before.</summary>
    public double FirstMet(in StraightWay way, double until)
    {
        int node = 0;
        while (node < _bounds.Length)
        {
            double met = way.Meets(in _bounds[node]);

            // Met later than what was found, or not at all: so is all of its branch.
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

    /// <summary>Builds the branch of some items, split at the median along the axis on which their centres lie furthest apart.</summary>
    /// <returns>The node after it.</returns>
    private int Build(Bounds3d[] boxes, int[] items, int from, int to, int node)
    {
        // The box around all items, and that around their centres, which says along which axis to split.
        Bounds3d all = boxes[items[from]];
        Bounds3d centers = boxes[items[from]].AtCenter;
        for (int i = from + 1; i < to; i++)
        {
            all = all.With(in boxes[items[i]]);
            centers = centers.With(boxes[items[i]].AtCenter);
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
