using FootballPhysics.Shapes;

namespace FootballPhysics.Friction;

/// <summary>A straight track along z that presses on a ball from one or two sides.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Scene">The scene, without air.</param>
/// <param name="Position">The ball at the start.</param>
/// <param name="Lean">The angle between the normals and the vertical, rad; 0 for a plane.</param>
/// <param name="Friction">μ₀.</param>
internal sealed record Track(string Name, Scene Scene, Vector3d Position, double Lean, double Friction)
{
    private const double Radius = 0.11;
    /// <summary>Without friction about the normal: in a gutter, a ball that rolls also turns about the normals.</summary>
    private static readonly SurfaceMaterial s_turf = SurfaceMaterial.DryTurf with { TorsionalPatchRadius = 0, SpinDamping = 0 };
    private static readonly double s_side = 35 * Math.PI / 180;

    /// <summary>One of each kind: level ground, which has a fast form; a surface of an obstacle; two contacts.</summary>
    public static IReadOnlyList<Track> All { get; } =
    [
        new("level ground", InVacuum(), new Vector3d(0, Radius, 0), 0, new Scene().Ground.Material.SlidingFriction),
        new("a plank above the ground", InVacuum(new PlaneShape(new Vector3d(0, 3, 0), Vector3d.Up)), new Vector3d(0, 3 + Radius, 0), 0, s_turf.SlidingFriction),
        new("a gutter", InVacuum(Side(1), Side(-1)), new Vector3d(0, 3 + (Radius / Math.Cos(s_side)), 0), s_side, s_turf.SlidingFriction),
    ];

    private static PlaneShape Side(int sign) => new(new Vector3d(0, 3, 0), new Vector3d(sign * Math.Sin(s_side), Math.Cos(s_side), 0));

    private static Scene InVacuum(params PlaneShape[] shapes) => new Scene
    {
        Forces = ForceSet.None,
        Obstacles = [.. shapes.Select((shape, i) => new Obstacle { Name = $"side {i}", Shape = shape, Surface = s_turf })],
    };
}
