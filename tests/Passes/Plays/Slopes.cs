using FootballPhysics.Laws;
using FootballPhysics.Shapes;

namespace FootballPhysics.Passes.Plays;

/// <summary>Ground that is not level or not uniform: slopes, hills, bowls, patterns of surfaces, and boards on them.</summary>
internal static class Slopes
{
    public static void Play()
    {
        var draw = new Draw(13);
        Ground[] grounds =
        [
            Bowl(), Hills(draw), Bowl() with { Pattern = new Stripes() }, Hills(draw) with { Material = SurfaceMaterial.Concrete },
            new Ground { Normal = new Vector3d(0.05, 1, 0.02).Normalized() }, new Ground { Normal = new Vector3d(0.5, 1, 0).Normalized(), Material = SurfaceMaterial.Concrete },
            new Ground { Pattern = new Stripes() },
            new Ground { Pattern = new SurfaceRectangles((new Vector3d(-5, 0, -5), new Vector3d(5, 0, 5), SurfaceMaterial.WetTurf), (new Vector3d(5, 0, -5), new Vector3d(9, 0, 5), SurfaceMaterial.Snow)) },
            Ground.PublishedTurf with { Normal = new Vector3d(0.1, 1, 0).Normalized() }, Ground.PublishedTurf with { Heights = Bowl().Heights },
            new Dials { Wetness = 0.5 }.Apply(Scene.Default with { Ground = new Ground { Pattern = new Stripes() } }).Ground,
            new Ground { TangentialRestitutionZ = 0.1 }, new Ground { Height = 3, MinimumBounceSpeed = 1 },
        ];
        foreach (Ground ground in grounds)
        {
            foreach (Obstacle[] obstacles in new Obstacle[][] { [], [new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 3, -3), new Vector3d(6, 6, 0.2)), Surface = SurfaceMaterial.Board }, new Obstacle { Name = "post", Shape = new CapsuleShape(new Vector3d(1, -3, 0), new Vector3d(1, 8, 0), 0.1) }] })
            {
                foreach (Scene air in new[] { Scene.Default, Scene.Published, Scene.Windy(new Vector3d(4, 0, 0)) })
                {
                    Kicks(draw, new Simulator(air with { Ground = ground, Obstacles = obstacles }), 6);
                }
            }
        }
    }

    /// <summary>A round bowl, 2 m deep in 20 m.</summary>
    public static Ground Bowl() => new() { Heights = Field((x, z) => 0.005 * ((x * x) + (z * z))) };

    private static Ground Hills(Draw draw)
    {
        double phase = draw.Between(0, 3);
        return new Ground { Heights = Field((x, z) => 0.5 * (Math.Sin((0.4 * x) + phase) + Math.Cos(0.5 * z))) };
    }

    private static HeightField Field(Func<double, double, double> height)
    {
        var values = new double[41, 41];
        for (int i = 0; i < 41; i++)
        {
            for (int j = 0; j < 41; j++)
            {
                values[i, j] = height(i - 20, j - 20);
            }
        }

        return HeightField.FromControlValues(-20, -20, 1, values);
    }

    private static void Kicks(Draw draw, Simulator simulator, int count)
    {
        var log = new StepLog();
        for (int i = 0; i < count; i++)
        {
            Vector3d at = new(draw.Between(-10, 10), draw.Any(-9, 0.5, 4), draw.Between(-10, 10));
            at = new Vector3d(at.X, Math.Max(at.Y, simulator.Scene.Ground.Heights?.HeightAt(at.X, at.Z) ?? -9), at.Z);
            BallState ball = simulator.Launch(at, draw.Between(0, 12) * draw.Heading(), draw.Vector(draw.Any(0, 40)));
            simulator.Run(ref ball, 1.0 / 60, 8, StopAt.Rest, log);
            simulator.Kick(ref ball, draw.Between(0.2, 8) * draw.Heading(), default);
            simulator.Run(ref ball, 1.0 / 60, 8, StopAt.Rest, log);
            log.Clear();
        }
    }

    private sealed class Stripes : ISurfacePattern
    {
        public double MinimumWidth => 2;

        public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [SurfaceMaterial.DryTurf, SurfaceMaterial.WetTurf];

        public int At(double x, double z) => (int)Math.Floor(x / 2) & 1;
    }
}
