using System.Reflection;

namespace FootballPhysics.Tests.Game;

/// <summary>A hash of a scene: the same for the same scene, another one for every number of it that is another one.</summary>
public sealed class SceneHashTests
{
    private static readonly Obstacle s_post = new() { Shape = new CapsuleShape(new Vector3d(-1, 0, -9), new Vector3d(-1, 2, -9), 0.06), Surface = SurfaceMaterial.GoalFrame };

    private static readonly Net s_net = new() { Center = new Vector3d(0, 1, -12), Normal = new Vector3d(0, 0.3, 1), Along = new Vector3d(1, 0, 0), HalfLength = 3.6, HalfWidth = 1.2 };

    private static readonly Scene s_scene = new() { Obstacles = [s_post], Nets = [s_net] };

    /// <summary>Every number of what a scene is made of, with a scene that has another one there.</summary>
    public static TheoryData<string> Numbers() => [.. Changed().Select(item => item.Name)];

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Another_number_is_another_hash(string name) =>
        Assert.NotEqual(new Simulator(s_scene).SceneHash, new Simulator(Changed().Single(item => item.Name == name).Scene).SceneHash);

    [Fact]
    public void The_same_numbers_are_the_same_hash()
    {
        var again = new Scene { Obstacles = [s_post with { Surface = SurfaceMaterial.GoalFrame }], Nets = [s_net with { Stiffness = 400 }] };
        Assert.Equal(new Simulator(s_scene).SceneHash, new Simulator(again).SceneHash);
        Assert.InRange(Changed().Count(), 45, 200);
    }

    /// <summary>The knuckle force of a ball has no effect without a seed, and its pressure only one on the outputs of impacts: recordings stay valid.</summary>
    [Fact]
    public void Numbers_without_an_effect_are_not_hashed()
    {
        static ulong Hash(BallProperties ball, long? seed) => new Simulator(s_scene with { Ball = ball, Forces = s_scene.Forces with { KnuckleSeed = seed } }).SceneHash;
        BallProperties ball = s_scene.Ball;
        Assert.Equal(Hash(ball, null), Hash(ball with { KnuckleForce = 0.5, SeamSeed = 77, Pressure = 1.1 }, null));
        Assert.Equal(4, new[] { Hash(ball, null), Hash(ball, 1), Hash(ball with { KnuckleForce = 0.5 }, 1), Hash(ball with { SeamSeed = 77 }, 1) }.Distinct().Count());
    }

    [Fact]
    public void Other_settings_are_another_hash()
    {
        SolverSettings[] settings =
        [
            new(),
            new() { Integrator = Integrator.Rk2 },
            new() { CollisionTiming = CollisionTiming.Bisection },
            new() { CollisionTiming = CollisionTiming.Bisection, CollisionTolerance = 1e-4 },
            new() { RollingTransition = RollingTransition.Heuristic },
            new() { LocateJump = false },
        ];
        Assert.Equal(settings.Length, settings.Select(one => new Simulator(s_scene, one).SceneHash).Distinct().Count());
    }

    /// <summary>The shapes have the same bounds, normals and surfaces.</summary>
    [Fact]
    public void A_shape_at_another_distance_is_another_hash()
    {
        static ulong Hash(double thickness) => new Simulator(new Scene { Obstacles = [new Obstacle { Shape = new Coated(thickness) }] }).SceneHash;
        Assert.NotEqual(Hash(0), Hash(0.25));
    }

    private static IEnumerable<(string Name, Scene Scene)> Changed() =>
    [
        .. Of(s_scene.Ball).Where(of => of.Name is not (nameof(BallProperties.Pressure) or nameof(BallProperties.KnuckleForce))).Select(of => ("ball." + of.Name, s_scene with { Ball = of.With })),
        .. Of(s_scene.Air).Select(of => ("air." + of.Name, s_scene with { Air = of.With })),
        .. Of(s_scene.Ground).Select(of => ("ground." + of.Name, s_scene with { Ground = of.With })),
        .. Of(s_scene.Ground.Material).Where(of => of.Name != nameof(SurfaceMaterial.MinimumExitSpeed)).Select(of => ("ground.material." + of.Name, s_scene with { Ground = s_scene.Ground with { Material = of.With } })),
        .. Of(s_post).Select(of => ("obstacle." + of.Name, s_scene with { Obstacles = [of.With] })),
        .. Of(s_post.Surface).Select(of => ("surface." + of.Name, s_scene with { Obstacles = [s_post with { Surface = of.With }] })),
        .. Of(s_net).Select(of => ("net." + of.Name, s_scene with { Nets = [of.With] })),
        .. Of(s_scene).Where(of => of.Name != "Obstacles").Select(of => ("scene." + of.Name, of.With)),
    ];

    /// <summary>Copies of a record with one number, or one vector, that is a little different.</summary>
    private static IEnumerable<(string Name, T With)> Of<T>(T record)
        where T : class
    {
        foreach (PropertyInfo property in typeof(T).GetProperties(BindingFlags.Public | BindingFlags.Instance).Where(property => property.CanWrite))
        {
            object? changed = property.GetValue(record) switch
            {
                double number when double.IsFinite(number) => number > 0 ? number * 0.9990234375 : number + 0.0009765625,
                Vector3d vector when typeof(T) != typeof(Net) || property.Name == "Center" => vector + new Vector3d(0.0625, 0.125, 0.25),
                Vector3d when property.Name == "Along" => new Vector3d(1, 1, -0.3),
                Vector3d normal => normal + new Vector3d(0, 0.125, 0),
                _ => null,
            };
            if (changed is not null)
            {
                var copy = (T)typeof(T).GetMethod("<Clone>$")!.Invoke(record, null)!;
                property.SetValue(copy, changed);
                yield return (property.Name, copy);
            }
        }
    }

    /// <summary>A sphere under a coat that its bounds do not show.</summary>
    private sealed class Coated(double thickness) : IShape
    {
        private static readonly SphereShape s_sphere = new(new Vector3d(2, 1, 3), 0.5);

        public double MaximumConcaveCurvature => 0;

        public Bounds3d Bounds => s_sphere.Bounds;

        public ShapePoint At(in Vector3d point)
        {
            ShapePoint at = s_sphere.At(in point);
            return new ShapePoint(at.Distance - thickness, at.Normal, at.Curvature);
        }
    }
}
