using System.Xml.Linq;
using FootballPhysics.Tool.Gallery;

namespace FootballPhysics.Tool.Tests;

/// <summary>The gallery's free kick that the two-point solver finds.</summary>
public sealed class AimGalleryTests
{
    private static readonly GalleryShot s_shot = GalleryShots.All.Single(shot => shot.Id == "found-free-kick");

    [Fact]
    public void It_passes_both_points_clears_the_wall_and_is_a_goal()
    {
        var flight = new Flight(s_shot.Scenario);
        Vector3d[] way = [.. flight.ToFirstTouchdown];
        foreach (Vector3d point in s_shot.Points)
        {
            Assert.True(way.Zip(way.Skip(1)).Min(pair => Distance(point, pair.First, pair.Second)) < 0.02);
        }

        GalleryTests.AssertPassesOver(way, s_shot);
        Assert.StartsWith("A goal", GoalCrossing.Describe(flight, s_shot.Scenario.Scene.Goals[0]));
    }

    [Fact]
    public void Its_points_are_drawn_from_the_side_and_from_above()
    {
        XElement drawing = ShownShot.Make(s_shot).Drawing;
        Assert.Contains(drawing.Descendants(), text => text.Value == "aimed at");
        Assert.Contains(drawing.Descendants(), text => text.Value == "wall");
        Assert.Contains(drawing.Descendants(), text => text.Value == "goal");
    }

    private static double Distance(Vector3d point, Vector3d a, Vector3d b)
    {
        Vector3d way = b - a;
        double share = Math.Clamp(Vector3d.Dot(point - a, way) / way.LengthSquared, 0, 1);
        return Vector3d.Distance(point, a + (share * way));
    }
}
