using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>The path that observers get of a ball on curved surfaces: around them, without gaps, at one speed.</summary>
public sealed class ShownPathTests
{
    private const double Radius = 0.11;
    private const double Dome = 1.0;

    /// <summary>From one side of a dome to the other, the path goes around it. It is as symmetric as its ends.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.1)]
    [InlineData(-0.2)]
    public void A_path_over_a_dome_goes_around_it(double aside)
    {
        World world = new Simulator(new Scene
        {
            Ball = new BallProperties { Radius = Radius },
            Ground = Ground.None,
            Obstacles = [new Obstacle { Name = "dome", Shape = new SphereShape(Vector3d.Zero, Dome) }],
        }).World!;
        const double Angle = 0.6;
        const double Duration = 0.1;
        double speed = 2 * Angle * (Dome + Radius) / Duration;
        BallState before = At(-Angle, 1);
        BallState after = At(Angle, -1);
        after.Time += Duration;
        Span<Contact> set = ContactSet.Near(world, in before, 1e-9, new Contact[ContactSet.Room], world.Room);
        Assert.Equal(1, set.Length);
        var seen = new Pieces();
        var log = new StepLog { Observer = seen };
        var run = new StepRun(Duration, after.Time, log);
        new ShownPath(world).Show(in before, in after, before.Velocity, after.Velocity, set, ref run);
        List<PathSegment> all = seen.All;
        Assert.True(all.Count > 1);
        Assert.Equal(before.Position, all[0].PositionAt(all[0].Time));
        Assert.InRange((after.Position - all[^1].PositionAt(all[^1].EndTime)).Length, 0, 1e-14);
        for (int i = 0; i < all.Count; i++)
        {
            for (int k = 0; k <= 20; k++)
            {
                double time = all[i].Time + ((all[i].EndTime - all[i].Time) * k / 20);
                Vector3d place = all[i].PositionAt(time);
                Assert.True(place.Length >= Dome + Radius - 2e-7, $"{i} {k}: {place.Length - Dome - Radius}");

                // The mirrored path, backwards.
                double its = before.Time + after.Time - time;
                PathSegment mirrored = all.First(at => its <= at.EndTime + 1e-12);
                Vector3d image = mirrored.PositionAt(its);
                Assert.InRange((new Vector3d(-image.X, image.Y, image.Z) - place).Length, 0, 1e-6);
            }

            if (i > 0)
            {
                Assert.InRange((all[i].PositionAt(all[i].Time) - all[i - 1].PositionAt(all[i - 1].EndTime)).Length, 0, 1e-12);
                Vector3d velocity = all[i].VelocityAt(all[i].Time);
                Assert.InRange((velocity - all[i - 1].VelocityAt(all[i - 1].EndTime)).Length, 0, 1e-9);
                Assert.InRange(velocity.Length, 0.65 * speed, 1.3 * speed * Math.Sqrt(1 + (aside * aside)));
            }
        }

        BallState At(double angle, double side) => new()
        {
            Time = 4,
            Position = (Dome + Radius) * new Vector3d(Math.Sin(angle), Math.Cos(angle), 0),
            Velocity = speed * new Vector3d(0.7 * Math.Cos(angle), -0.7 * Math.Sin(angle), side * aside),
        };
    }

    private sealed class Pieces : PieceObserver
    {
        public List<PathSegment> All { get; } = [];

        public override bool Add(in PathSegment piece)
        {
            All.Add(piece);
            return false;
        }
    }
}
