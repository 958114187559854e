using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Shapes: the normal is the gradient of the distance, the curvature its Hessian.</summary>
public sealed class ShapeTests
{
    private static readonly double[,] s_hills =
    {
        { 0, 0.1, -0.1, 0.2, 0.1 }, { 0.1, 0.3, 0.2, -0.1, 0 }, { -0.2, 0.1, 0.4, 0.2, 0.1 }, { 0.1, -0.1, 0.1, 0.3, 0.2 }, { 0, 0.2, 0.1, 0, -0.1 },
    };

    public static TheoryData<string> Shapes() => ["plane", "sphere", "capsule", "box", "heights"];

    [Theory]
    [MemberData(nameof(Shapes))]
    public void The_normal_is_the_gradient_and_the_curvature_the_Hessian(string name)
    {
        IShape shape = Make(name);
        var random = new Random(7);
        int checkedPoints = 0;
        for (int i = 0; i < 400; i++)
        {
            var p = new Vector3d(3 + (4 * random.NextDouble()), (name == "heights" ? 0.4 : 2) * random.NextDouble(), 3 + (4 * random.NextDouble()));
            ShapePoint at = shape.At(p);
            if (!(at.Distance > 0.02) || (name == "heights" && at.Distance > 0.3))
            {
                continue;
            }

            const double H = 1e-5;
            Vector3d gradient = default;
            Vector3d[] axes = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)];
            bool smooth = true;
            foreach (Vector3d axis in axes)
            {
                ShapePoint ahead = shape.At(p + (H * axis));
                ShapePoint behind = shape.At(p - (H * axis));
                gradient += (ahead.Distance - behind.Distance) / (2 * H) * axis;
                Vector3d turn = (ahead.Normal - behind.Normal) / (2 * H);
                Vector3d half = (ahead.Normal - at.Normal) / H;
                smooth &= Vector3d.Distance(turn, half) < 1e-2;
                if (smooth)
                {
                    Assert.True(Vector3d.Distance(turn, at.Curvature * axis) < 1e-5, $"{name} at {p}: {turn} against {at.Curvature * axis}");
                }
            }

            Assert.Equal(1, at.Normal.Length, 1e-12);
            Assert.True(!smooth || Vector3d.Distance(gradient, at.Normal) < 1e-8, $"{name} at {p}: {gradient} against {at.Normal}");
            checkedPoints += smooth ? 1 : 0;
        }

        Assert.InRange(checkedPoints, 50, 400);
    }

    [Fact]
    public void A_capsule_s_distance_is_that_from_its_segment()
    {
        var capsule = new CapsuleShape(new Vector3d(0, 0, 0), new Vector3d(0, 2, 0), 0.1);
        Assert.Equal(0.9, capsule.At(new Vector3d(1, 1, 0)).Distance, 1e-15);
        Assert.Equal(Math.Sqrt(2) - 0.1, capsule.At(new Vector3d(1, 3, 0)).Distance, 1e-15);
        Assert.Equal(-0.1, capsule.At(new Vector3d(0, 1, 0)).Distance, 1e-15);
    }

    [Fact]
    public void Heights_are_a_cubic_spline_that_keeps_a_plane()
    {
        double[,] values = new double[8, 8];
        for (int i = 0; i < 8; i++)
        {
            for (int j = 0; j < 8; j++)
            {
                values[i, j] = 0.1 * i;
            }
        }

        var field = HeightField.FromControlValues(0, 0, 1, values);
        Assert.Equal(0.35, field.HeightAt(3.5, 4.2), 1e-14);
        Assert.Equal(0.1, field.Steepest.Value, 1e-12);
        Assert.Equal(0.7, field.HeightAt(50, 4), 1e-14);
    }

    [Theory]
    [ProfileData]
    public void A_thing_of_no_size_is_refused_by_name(Profile profile)
    {
        Assert.Contains("halfSize[1] is 0", Assert.Throws<ArgumentOutOfRangeException>(() => new BoxShape(Vector3d.Zero, new Vector3d(1, 0, 1))).Message, StringComparison.Ordinal);
        Assert.Contains("normal is (0, 0, 0)", Assert.Throws<ArgumentOutOfRangeException>(() => new PlaneShape(Vector3d.Zero, Vector3d.Zero)).Message, StringComparison.Ordinal);
        Assert.Contains("radius is 0", Assert.Throws<ArgumentOutOfRangeException>(() => new SphereShape(Vector3d.Zero, 0)).Message, StringComparison.Ordinal);
        var steep = profile.Scene() with { Ground = profile.Ground() with { Heights = HeightField.FromControlValues(0, 0, 1, new double[,] { { 0, 0 }, { 3, 3 }, { 0, 0 } }) } };
        Assert.Contains("ground.heights", Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(steep)).Message, StringComparison.Ordinal);
    }

    internal static IShape Make(string name) => name switch
    {
        "plane" => new PlaneShape(new Vector3d(1, 0, 2), new Vector3d(1, 2, 0.5)),
        "sphere" => new SphereShape(new Vector3d(5, 0.5, 5), 0.6),
        "capsule" => new CapsuleShape(new Vector3d(4, 0, 4), new Vector3d(6, 1, 5.5), 0.2),
        "box" => new BoxShape(new Vector3d(5, 0.5, 5), new Vector3d(0.6, 0.3, 0.4), Quaterniond.FromAxisAngle(new Vector3d(0, 1, 0), 0.7)),
        _ => HeightField.FromControlValues(0, 0, 2, s_hills),
    };
}
