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

    private static IEnumerable<(string Name, Scene Scene)> Changed() =>
    [
        .. Of(s_scene.Ball).Select(of => ("ball." + of.Name, s_scene with { Ball = of.With })),
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
}
