namespace FootballPhysics.Labs.People;

/// <summary>The objects of an arena that never move: distances in closed form, from the numbers of the arena alone.</summary>
internal sealed class StandingSolids
{
    private readonly List<(Vector3d From, Vector3d To, double Radius)> _rods = [];
    private readonly List<(Vector3d Center, Vector3d Half)> _boxes = [];

    /// <summary>Adds the posts and the bar of a goal that faces along z.</summary>
    public void Add(Goal goal)
    {
        double x = (0.5 * goal.Width) + goal.PostRadius;
        var up = new Vector3d(0, goal.Height + goal.PostRadius, 0);
        Vector3d left = goal.Center - new Vector3d(x, 0, 0);
        Vector3d right = goal.Center + new Vector3d(x, 0, 0);
        _rods.AddRange([(left, left + up, goal.PostRadius), (right, right + up, goal.PostRadius), (left + up, right + up, goal.PostRadius)]);
    }

    /// <summary>Adds an axis-aligned box.</summary>
    public void AddBox(Vector3d center, Vector3d half) => _boxes.Add((center, half));

    /// <summary>Adds a capsule.</summary>
    public void AddRod(Vector3d from, Vector3d to, double radius) => _rods.Add((from, to, radius));

    /// <summary>Returns the distance of a point from the nearest surface, including the level ground at height 0; negative inside.</summary>
    public double Distance(Vector3d point)
    {
        double nearest = point.Y;
        foreach ((Vector3d from, Vector3d to, double radius) in _rods)
        {
            nearest = Math.Min(nearest, Solid.Capsule(point, from, to, radius));
        }

        foreach ((Vector3d center, Vector3d half) in _boxes)
        {
            nearest = Math.Min(nearest, Solid.Box(point, center, half));
        }

        return nearest;
    }
}
