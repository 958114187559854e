using FootballPhysics.Numerics;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>The path on which crossings of zones are searched, and the search itself against dense samples.</summary>
public sealed class ZoneSearchTests
{
    private const double Duration = 0.25;
    private const int Samples = 4000;

    /// <summary>It has the positions, velocities and accelerations of both ends, as far as its degree allows.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void A_path_has_the_ends_of_its_piece(int degree)
    {
        var random = new Random(degree);
        for (int draw = 0; draw < 50; draw++)
        {
            PathPolynomial path = Draw(random, degree, 1, out BallState before, out BallState after, out Vector3d a, out Vector3d b);
            Near(before.Position, path.At(0));
            Near(after.Position, path.At(1));
            Near(Duration * before.Velocity, path.RateAt(0));
            if (degree > 2)
            {
                Near(Duration * after.Velocity, path.RateAt(1));
            }

            if (degree == 5)
            {
                Near(Duration * Duration * a, Second(path, 0), 1e-3);
                Near(Duration * Duration * b, Second(path, 1), 1e-3);
            }

            // The difference of the order after the degree is zero at any five or seven equal parts.
            Vector3d sum = default;
            double binomial = 1;
            for (int i = 0; i <= degree + 1; i++)
            {
                sum += binomial * path.At((double)i / (degree + 1));
                binomial *= -(degree + 1.0 - i) / (i + 1);
            }

            Near(default, sum, 1e-9);
            for (int i = 0; i <= 10; i++)
            {
                double s = 0.1 * i;
                Near((path.At(s + 1e-5) - path.At(s - 1e-5)) / 2e-5, path.RateAt(s), 1e-6);
            }
        }
    }

    /// <summary>The box contains the path, and the bounds its rates; both are those of the same path elsewhere.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void Bounds_contain_the_path_wherever_it_is(int degree)
    {
        var random = new Random(10 + degree);
        for (int draw = 0; draw < 50; draw++)
        {
            PathPolynomial path = Draw(random, degree, 1, out BallState before, out BallState after, out Vector3d a, out Vector3d b);
            double speed = 0;
            double bend = 0;
            for (int i = 0; i <= 200; i++)
            {
                double s = i / 200.0;
                Assert.True(path.Bounds.Expanded(1e-12).Intersects(new Bounds3d(path.At(s), path.At(s))));
                speed = Math.Max(speed, path.RateAt(s).Length);
                bend = Math.Max(bend, Second(path, s).Length);
            }

            Assert.InRange(path.FastestSpeed, speed * (1 - 1e-9), 8 * speed);
            Assert.InRange(path.GreatestAcceleration, bend * (1 - 1e-3), (8 * bend) + 1e-3);
            var off = new Vector3d(300, -200, 100);
            before.Position += off;
            after.Position += off;
            var moved = Between(in before, in after, in a, in b, degree);
            Assert.Equal(path.FastestSpeed, moved.FastestSpeed, 1e-9);
            Assert.Equal(path.GreatestAcceleration, moved.GreatestAcceleration, 1e-9);
            Near(path.Bounds.Min + off, moved.Bounds.Min);
            Near(path.Bounds.Max + off, moved.Bounds.Max);

            // No part of the box is farther from the path than the path is long.
            Assert.True((path.Bounds.Max - path.Bounds.Min).Length <= 4 * speed);
        }
    }

    /// <summary>Every crossing that dense samples see is found, in order, in and out by turns, also if the path first leads away.</summary>
    [Theory]
    [InlineData("sphere")]
    [InlineData("box")]
    [InlineData("plane")]
    public void Crossings_are_those_of_dense_samples(string kind)
    {
        var random = new Random(kind.Length);
        int crossings = 0;
        int turned = 0;
        for (int draw = 0; draw < 150; draw++)
        {
            IShape shape = kind switch
            {
                "sphere" => new SphereShape(new Vector3d(0.1, 0, 0), 0.5),
                "box" => new BoxShape(default, new Vector3d(0.4, 0.6, 0.3)),
                _ => new PlaneShape(new Vector3d(0, -0.2, 0), new Vector3d(0.3, 1, 0).Normalized()),
            };
            PathPolynomial path = Draw(random, 5, draw % 3 == 0 ? 6 : 1, out _, out _, out _, out _);
            const double Level = 0.05;
            var log = new StepLog();
            new ZoneSearch(log, in path, 0, shape, shape.MaximumConcaveCurvature, Level).Run();
            ZoneCrossing[] found = log.TakeCrossings().ToArray();
            var sampled = new List<double>();
            bool before = shape.At(path.At(0)).Distance <= Level;
            bool leadsAway = !before && Vector3d.Dot(shape.At(path.At(0)).Normal, path.RateAt(0)) > 0;
            bool isInside = before;
            double closest = double.PositiveInfinity;
            for (int i = 1; i <= Samples; i++)
            {
                double distance = shape.At(path.At((double)i / Samples)).Distance - Level;
                bool inside = distance <= 0;
                if (inside != isInside)
                {
                    sampled.Add((i - 0.5) / Samples);
                    isInside = inside;
                }

                closest = Math.Min(closest, Math.Abs(distance) < 1e-5 ? 0 : 1);
            }

            // A visit or an exit between two samples may be too short for them.
            if (found.Length != sampled.Count && closest == 0)
            {
                continue;
            }

            Assert.True(found.Length == sampled.Count, $"draw {draw}: {found.Length} of {sampled.Count}");
            for (int i = 0; i < found.Length; i++)
            {
                Assert.Equal(before == (i % 2 == 1), found[i].Enters);
                Assert.Equal(sampled[i], found[i].At, 0.6 / Samples);
                Assert.Equal(Level, shape.At(path.At(found[i].At)).Distance, 1e-8);
            }

            crossings += found.Length;
            turned += leadsAway && found.Length > 0 ? 1 : 0;
        }

        Assert.True(crossings > 60 && turned > 2, $"{crossings} crossings, {turned} after a turn");
    }

    private static PathPolynomial Draw(Random random, int degree, double bends, out BallState before, out BallState after, out Vector3d a, out Vector3d b)
    {
        Vector3d Vector(double size) => size * new Vector3d((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        before = new BallState { Time = 3, Position = Vector(1), Velocity = Vector(6 * bends) };
        after = new BallState { Time = 3 + Duration, Position = Vector(1), Velocity = Vector(6 * bends) };
        a = Vector(40 * bends);
        b = Vector(40 * bends);
        return Between(in before, in after, in a, in b, degree);
    }

    private static PathPolynomial Between(in BallState before, in BallState after, in Vector3d a, in Vector3d b, int degree) =>
        PathPolynomial.Between(before.Position, before.Velocity, in a, after.Position, after.Velocity, in b, Duration, degree);

    private static Vector3d Second(in PathPolynomial path, double s) => (path.RateAt(s + 1e-5) - path.RateAt(s - 1e-5)) / 2e-5;

    private static void Near(Vector3d expected, Vector3d actual, double within = 1e-11) => Assert.InRange((expected - actual).Length, 0, within * (1 + expected.Length));
}
