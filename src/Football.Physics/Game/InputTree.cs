namespace FootballPhysics.Game;

/// <summary>Inputs sorted by tick, player and ball, in a balanced tree; search, insertion and removal take logarithmic time.</summary>
/// <remarks>An AVL tree in arrays; each node stores the size of its subtree. It allocates only to grow.</remarks>
/// <typeparam name="T">The type of the inputs.</typeparam>
internal sealed class InputTree<T>(int capacity)
    where T : struct, IMatchInput<T>
{
    private const int None = -1;

    private T[] _inputs = new T[capacity];
    private Node[] _nodes = new Node[capacity];
    private int _root = None;
    private int _free = None;
    private int _made;

    /// <summary>The number of inputs.</summary>
    public int Count => CountOf(_root);

    /// <summary>Returns the input at an index in sorted order.</summary>
    public ref readonly T At(int index)
    {
        int node = _root;
        while (true)
        {
            int before = CountOf(_nodes[node].Left);
            if (index == before)
            {
                return ref _inputs[node];
            }

            node = index < before ? _nodes[node].Left : _nodes[node].Right;
            index -= index < before ? 0 : before + 1;
        }
    }

    /// <summary>Returns the number of inputs before (tick, player, ball).</summary>
    public int CountBefore(long tick, int player, int ball)
    {
        int count = 0;
        for (int node = _root; node != None;)
        {
            bool isBefore = Order(in _inputs[node], tick, player, ball) < 0;
            count += isBefore ? CountOf(_nodes[node].Left) + 1 : 0;
            node = isBefore ? _nodes[node].Right : _nodes[node].Left;
        }

        return count;
    }

    /// <summary>Compares an input with a key by tick, then player, then ball.</summary>
    public static int Order(in T input, long tick, int player, int ball)
    {
        int byTick = input.Tick.CompareTo(tick);
        int byPlayer = input.Player.CompareTo(player);
        return byTick != 0 ? byTick : byPlayer != 0 ? byPlayer : input.Ball.CompareTo(ball);
    }

    /// <summary>True if the tree has this input, with the same bits.</summary>
    public bool Has(in T input)
    {
        int index = CountBefore(input.Tick, input.Player, input.Ball);
        return index < Count && Order(in At(index), input.Tick, input.Player, input.Ball) == 0 && input.IsSame(in At(index));
    }

    /// <summary>Adds an input, or replaces the one with the same tick, player and ball.</summary>
    public void Put(in T input) => _root = Put(_root, in input);

    /// <summary>Removes an input.</summary>
    /// <returns>True if there was such an input.</returns>
    public bool Remove(long tick, int player, int ball)
    {
        int before = Count;
        _root = Remove(_root, tick, player, ball);
        return Count < before;
    }

    /// <summary>Removes the first <c>count</c> inputs.</summary>
    public void RemoveFirst(int count)
    {
        for (int i = 0; i < count; i++)
        {
            _root = TakeFirst(_root, out int first);
            Free(first);
        }
    }

    /// <summary>Removes all inputs, but keeps the capacity.</summary>
    public void Clear()
    {
        _root = None;
        _free = None;
        _made = 0;
    }

    private int CountOf(int node) => node == None ? 0 : _nodes[node].Count;

    private int HeightOf(int node) => node == None ? 0 : _nodes[node].Height;

    /// <summary>Adds or replaces an input in a subtree, and returns its new root.</summary>
    private int Put(int node, in T input)
    {
        if (node == None)
        {
            return Make(in input);
        }

        int order = Order(in _inputs[node], input.Tick, input.Player, input.Ball);
        if (order == 0)
        {
            _inputs[node] = input;
            return node;
        }

        // The call may reallocate the arrays: keep no reference across it.
        if (order > 0)
        {
            int left = Put(_nodes[node].Left, in input);
            _nodes[node].Left = left;
        }
        else
        {
            int right = Put(_nodes[node].Right, in input);
            _nodes[node].Right = right;
        }

        return Balance(node);
    }

    /// <summary>Removes an input from a subtree, and returns its new root.</summary>
    private int Remove(int node, long tick, int player, int ball)
    {
        if (node == None)
        {
            return None;
        }

        int order = Order(in _inputs[node], tick, player, ball);
        if (order > 0)
        {
            _nodes[node].Left = Remove(_nodes[node].Left, tick, player, ball);
        }
        else if (order < 0)
        {
            _nodes[node].Right = Remove(_nodes[node].Right, tick, player, ball);
        }
        else
        {
            int left = _nodes[node].Left;
            int right = _nodes[node].Right;
            Free(node);
            if (right == None)
            {
                return left;
            }

            // The next input in the sort order replaces this node.
            right = TakeFirst(right, out int next);
            _nodes[next].Left = left;
            _nodes[next].Right = right;
            return Balance(next);
        }

        return Balance(node);
    }

    private int TakeFirst(int node, out int first)
    {
        if (_nodes[node].Left == None)
        {
            first = node;
            return _nodes[node].Right;
        }

        _nodes[node].Left = TakeFirst(_nodes[node].Left, out first);
        return Balance(node);
    }

    private int Make(in T input)
    {
        int node = _free;
        if (node != None)
        {
            _free = _nodes[node].Left;
        }
        else
        {
            if (_made == _nodes.Length)
            {
                Array.Resize(ref _inputs, 2 * _made);
                Array.Resize(ref _nodes, 2 * _made);
            }

            node = _made++;
        }

        _inputs[node] = input;
        _nodes[node] = new Node { Left = None, Right = None, Count = 1, Height = 1 };
        return node;
    }

    private void Free(int node)
    {
        _nodes[node].Left = _free;
        _free = node;
    }

    /// <summary>Rotates a node whose subtree heights differ by two, and returns the new root.</summary>
    private int Balance(int node)
    {
        int left = _nodes[node].Left;
        int right = _nodes[node].Right;
        int lean = HeightOf(left) - HeightOf(right);
        if (lean > 1)
        {
            if (HeightOf(_nodes[left].Left) < HeightOf(_nodes[left].Right))
            {
                _nodes[node].Left = TurnLeft(left);
            }

            return TurnRight(node);
        }

        if (lean < -1)
        {
            if (HeightOf(_nodes[right].Right) < HeightOf(_nodes[right].Left))
            {
                _nodes[node].Right = TurnRight(right);
            }

            return TurnLeft(node);
        }

        Measure(node);
        return node;
    }

    private int TurnRight(int node)
    {
        int top = _nodes[node].Left;
        _nodes[node].Left = _nodes[top].Right;
        _nodes[top].Right = node;
        Measure(node);
        Measure(top);
        return top;
    }

    private int TurnLeft(int node)
    {
        int top = _nodes[node].Right;
        _nodes[node].Right = _nodes[top].Left;
        _nodes[top].Left = node;
        Measure(node);
        Measure(top);
        return top;
    }

    private void Measure(int node)
    {
        ref Node at = ref _nodes[node];
        at.Count = 1 + CountOf(at.Left) + CountOf(at.Right);
        at.Height = 1 + Math.Max(HeightOf(at.Left), HeightOf(at.Right));
    }

    private struct Node
    {
        public int Left;
        public int Right;
        public int Count;
        public int Height;
    }
}
