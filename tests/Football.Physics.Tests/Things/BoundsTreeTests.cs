using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Things;

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
            int[] expected = [.. Enumerable.Range(0, count).Where(k => boxes[k].Intersects(in asked))];
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

    /// <summary>Whichever way a row goes, a branch is a stretch of it: one of its boxes is found by some dozen of the tree's.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void Along_a_row_a_box_is_found_by_few_others(int axis)
    {
        var random = new Random(2);
        const int Count = 128;
        int[] places = [.. Enumerable.Range(0, Count)];
        random.Shuffle(places);
        Bounds3d[] boxes =
        [
            .. places.Select(place =>
            {
                // A little apart on the other axes too, and nowhere at the origin.
                var center = new Vector3d(7 + (0.5 * random.NextDouble()), 9 + (0.5 * random.NextDouble()), 11 + (0.5 * random.NextDouble()));
                center += (5 + (2.0 * place)) * new Vector3d(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
                return Bounds3d.Around(in center, 0.6, 0.6, 0.6);
            }),
        ];
        var tree = new BoundsTree(boxes);
        var nodes = (Bounds3d[])typeof(BoundsTree).GetField("_bounds", System.Reflection.BindingFlags.NonPublic | System.Reflection.BindingFlags.Instance)!.GetValue(tree)!;
        Assert.Equal((2 * Count) - 1, nodes.Length);
        double touched = boxes.Average(box => nodes.Count(node => node.Intersects(in box)));
        Assert.InRange(touched, 8, 9);
    }

    private static Bounds3d Box(Random random, double most)
    {
        double Size() => most * random.NextDouble();
        return Bounds3d.Around(new Vector3d(random.Next(-20, 20), random.Next(-3, 5), random.Next(-20, 20)), Size(), Size(), Size());
    }
}
