namespace Football.Physics.Tests.Things;

/// <summary>The broad phase finds what looking at every box finds.</summary>
public sealed class BoundsTreeTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(200)]
    public void It_finds_what_looking_at_every_box_finds(int count)
    {
        var random = new Random(count);
        Bounds3d[] boxes = [.. Enumerable.Range(0, count).Select(_ => Box(random, 3))];
        var tree = new BoundsTree(boxes);
        int found = 0;
        int met = 0;
        for (int i = 0; i < 300; i++)
        {
            Bounds3d asked = Box(random, 2);
            int[] expected = [.. Enumerable.Range(0, count).Where(k => boxes[k].Touches(in asked))];
            var actual = new List<int>();
            int node = 0;
            while (tree.Next(in asked, ref node, out int item))
            {
                actual.Add(item);
            }

            found += actual.Count;
            Assert.Equal(expected, actual.Order());
            var way = new StraightWay(asked.Min, new Vector3d(random.Next(-30, 30), 0, random.Next(-30, 30)), 0, 2, 0.3);
            double first = boxes.Select(box => way.Meets(in box)).DefaultIfEmpty(2).Min();
            Assert.Equal(Math.Min(2, first), tree.FirstMet(in way, 2));
            met += first < 2 ? 1 : 0;
        }

        Assert.True(count < 3 || (found > 0 && met > 0));
    }

    [Fact]
    public void A_way_meets_a_box_when_it_is_as_near_as_asked()
    {
        var box = Bounds3d.Around(new Vector3d(10, 0, 0), 1, 2, 3);
        Assert.Equal((9 - 0.5) / 4, new StraightWay(Vector3d.Zero, new Vector3d(4, 0, 0), 0, 1, 0.5).Meets(in box), 1e-14);
        Assert.Equal(double.PositiveInfinity, new StraightWay(Vector3d.Zero, new Vector3d(-4, 0, 0), 0, 1, 0.5).Meets(in box));
        Assert.Equal(double.PositiveInfinity, new StraightWay(new Vector3d(0, 2.6, 0), new Vector3d(4, 0, 0), 0, 1, 0.5).Meets(in box));
        Assert.Equal(0, new StraightWay(new Vector3d(10, 1, 1), Vector3d.Zero, 0, 1, 0.5).Meets(in box));
    }

    /// <summary>A row of boxes is split along the row, wherever it lies: so the walk over all of them goes along it.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void It_is_split_along_the_axis_on_which_boxes_lie_apart(int axis)
    {
        foreach (double away in new[] { 0.0, 5000, -5000 })
        {
            int[] places = [5, 2, 7, 0, 6, 3, 1, 4];
            Vector3d Of(double along, double beside) => axis == 0 ? new Vector3d(along, away + beside, beside) : axis == 1 ? new Vector3d(beside, along, away + beside) : new Vector3d(away + beside, beside, along);
            Bounds3d[] boxes = [.. places.Select((place, i) => Bounds3d.Around(Of(10 * place, 0.01 * i), 1, 1, 1))];
            Assert.Equal(places.Order(), Walk(boxes).Select(i => places[i]));
        }
    }

    /// <summary>Of boxes at one place the first comes first.</summary>
    [Fact]
    public void Boxes_at_one_place_keep_their_order()
    {
        Bounds3d[] boxes = [.. Enumerable.Range(0, 20).Select(i => Bounds3d.Around(new Vector3d(1, 2, 3), 1 + i, 1, 1))];
        Assert.Equal(Enumerable.Range(0, 20), Walk(boxes));
    }

    private static List<int> Walk(Bounds3d[] boxes)
    {
        var tree = new BoundsTree(boxes);
        var found = new List<int>();
        int node = 0;
        while (tree.Next(Bounds3d.Everywhere, ref node, out int item))
        {
            found.Add(item);
        }

        return found;
    }

    private static Bounds3d Box(Random random, double most)
    {
        double Size() => most * random.NextDouble();
        return Bounds3d.Around(new Vector3d(random.Next(-20, 20), random.Next(-3, 5), random.Next(-20, 20)), Size(), Size(), Size());
    }
}
