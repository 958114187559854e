using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>The push that smooth contacts leave, against the nearest push by descent; and contacts around a ball, against angles.</summary>
public sealed unsafe class PushProjectionTests
{
    /// <summary>Loads of smooth contacts make the rest of a push as short as possible.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(6)]
    public void Loads_leave_the_shortest_push(int count)
    {
        var random = new Random(60 + count);
        int loaded = 0;
        int taken = 0;
        for (int draw = 0; draw < 150; draw++)
        {
            Vector3d[] normals = [.. Enumerable.Range(0, count).Select(_ => (Vector(random) + new Vector3d(0, 0.8, 0)).Normalized())];
            Vector3d push = Vector(random) * 10;
            Vector3d left = push;
            double[] loads = new double[count];
            double moved = 1;
            for (int round = 0; round < 20000 && moved > 1e-13; round++)
            {
                moved = 0;
                for (int i = 0; i < count; i++)
                {
                    double load = Math.Max(0, loads[i] - Vector3d.Dot(left, normals[i]));
                    left += (load - loads[i]) * normals[i];
                    moved = Math.Max(moved, Math.Abs(load - loads[i]));
                    loads[i] = load;
                }
            }

            if (moved > 1e-13)
            {
                continue;
            }

            PushProjection found;
            fixed (Vector3d* all = normals)
            {
                found = PushProjection.Of(all, count, in push);
            }

            if (found.TakesAll)
            {
                Assert.InRange(left.Length, 0, 1e-7);
                Assert.All(Enumerable.Range(0, count), i => Assert.True(found.Bears(i)));
                taken++;
                continue;
            }

            Assert.InRange((left - found.Left).Length, 0, 1e-7);
            Vector3d sum = (found.First < 0 ? Vector3d.Zero : found.FirstLoad * normals[found.First]) + (found.Second < 0 ? Vector3d.Zero : found.SecondLoad * normals[found.Second]);
            Assert.InRange((push + sum - found.Left).Length, 0, 1e-9);
            Assert.True(found.FirstLoad >= 0 && found.SecondLoad >= 0);
            Assert.All(Enumerable.Range(0, count), i => Assert.Equal(i == found.First || i == found.Second, found.Bears(i)));
            loaded += found.First < 0 ? 0 : 1;
        }

        Assert.True(loaded > 40, $"{loaded} with load");
        Assert.True(taken > 5 || count < 3, $"{taken} taken");
    }

    [Fact]
    public void Two_opposite_contacts_among_any_clamp_a_ball()
    {
        var random = new Random(67);
        for (int draw = 0; draw < 300; draw++)
        {
            int count = 2 + (draw % 4);
            Vector3d[] normals = [.. Enumerable.Range(0, count).Select(_ => Vector(random).Normalized())];
            int one = random.Next(count);
            int other = (one + 1 + random.Next(count - 1)) % count;
            Assert.False(Clamps(normals));
            normals[other] = -normals[one];
            Assert.True(Clamps(normals));

            // The tolerance is about a tenth of a milliradian.
            Vector3d aside = Vector3d.Cross(normals[one], Vector(random).Normalized()).Normalized();
            normals[other] = ((-1.0 * normals[one]) + (5e-5 * aside)).Normalized();
            Assert.True(Clamps(normals));
            normals[other] = ((-1.0 * normals[one]) + (2e-4 * aside)).Normalized();
            Assert.False(Clamps(normals));
        }

        static bool Clamps(Vector3d[] normals)
        {
            fixed (Vector3d* all = normals)
            {
                return PushProjection.Clamp(all, normals.Length);
            }
        }
    }

    /// <summary>Three directions in one plane surround a point if no half plane holds them: all angles between neighbours are below 180°.</summary>
    [Fact]
    public void Three_contacts_in_a_plane_surround_a_ball_if_no_half_plane_holds_them()
    {
        var random = new Random(68);
        int surrounded = 0;
        for (int draw = 0; draw < 400; draw++)
        {
            Vector3d x = Vector(random).Normalized();
            Vector3d y = Vector3d.Cross(x, Vector(random)).Normalized();
            double[] angles = [.. Enumerable.Range(0, 3).Select(_ => random.NextDouble() * 2 * Math.PI)];
            double[] sorted = [.. angles.Order()];
            double widest = Math.Max(Math.Max(sorted[1] - sorted[0], sorted[2] - sorted[1]), sorted[0] + (2 * Math.PI) - sorted[2]);
            Vector3d[] normals = [.. angles.Select(at => (Math.Cos(at) * x) + (Math.Sin(at) * y))];
            bool surrounds = Surround(normals);
            Assert.Equal(widest < Math.PI, surrounds);
            surrounded += surrounds ? 1 : 0;

            // Out of the plane they do not.
            normals[2] = (normals[2] + (0.01 * Vector3d.Cross(x, y))).Normalized();
            double volume = Vector3d.Dot(normals[2], Vector3d.Cross(normals[0], normals[1]));
            Assert.True(Math.Abs(volume) <= ContactTolerances.Independent || !Surround(normals));
        }

        Assert.InRange(surrounded, 60, 200);

        static bool Surround(Vector3d[] normals)
        {
            fixed (Vector3d* all = normals)
            {
                return PushProjection.Surround(all);
            }
        }
    }

    private static Vector3d Vector(Random random) => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
}
