namespace FootballPhysics.Labs.People;

/// <summary>The objects of an arena that never move: distances in closed form, from the numbers of the arena alone.</summary>
internal sealed class StandingSolids
{
    private readonly List<Func<Vector3d, double>> _distances = [];

    /// <summary>Adds the posts and the bar of a goal that faces along z.</summary>
    public void Add(Goal goal)
    {
        double x = (0.5 * goal.Width) + goal.PostRadius;
        var up = new Vector3d(0, goal.Height + goal.PostRadius, 0);
        Vector3d left = goal.Center - new Vector3d(x, 0, 0);
        Vector3d right = goal.Center + new Vector3d(x, 0, 0);
        AddRod(left, left + up, goal.PostRadius);
        AddRod(right, right + up, goal.PostRadius);
        AddRod(left + up, right + up, goal.PostRadius);
    }

    /// <summary>Adds an axis-aligned box.</summary>
    public void AddBox(Vector3d center, Vector3d half) => _distances.Add(point => Solid.Box(point, center, half));

    /// <summary>Adds a capsule.</summary>
    private void AddRod(Vector3d from, Vector3d to, double radius) => _distances.Add(point => Solid.Capsule(point, from, to, radius));

    /// <summary>Adds an axis-aligned box, and returns it as an obstacle.</summary>
    public Obstacle Box(string name, Vector3d center, Vector3d half, SurfaceMaterial surface)
    {
        AddBox(center, half);
        return new Obstacle { Name = name, Shape = new BoxShape(center, half), Surface = surface };
    }

    /// <summary>Adds a capsule, and returns it as an obstacle.</summary>
    public Obstacle Rod(string name, Vector3d from, Vector3d to, double radius)
    {
        AddRod(from, to, radius);
        return new Obstacle { Name = name, Shape = new CapsuleShape(from, to, radius) };
    }

    /// <summary>Returns the distance of a point from the nearest surface, including the level ground at height 0; negative inside.</summary>
    public double Distance(Vector3d point)
    {
        double nearest = point.Y;
        foreach (Func<Vector3d, double> distance in _distances)
        {
            nearest = Math.Min(nearest, distance(point));
        }

        return nearest;
    }
}

/// <summary>Distances in closed form, implemented independently of the library's shapes.</summary>
internal static class Solid
{
    /// <summary>Returns the distance from the surface of a capsule; negative inside.</summary>
    public static double Capsule(Vector3d place, Vector3d from, Vector3d to, double radius)
    {
        Vector3d axis = to - from;
        double share = Math.Clamp(Vector3d.Dot(place - from, axis) / axis.LengthSquared, 0, 1);
        return (place - (from + (share * axis))).Length - radius;
    }

    /// <summary>Returns the distance from the surface of an axis-aligned box; negative inside.</summary>
    public static double Box(Vector3d place, Vector3d center, Vector3d half)
    {
        double x = Math.Abs(place.X - center.X) - half.X;
        double y = Math.Abs(place.Y - center.Y) - half.Y;
        double z = Math.Abs(place.Z - center.Z) - half.Z;
        double outside = new Vector3d(Math.Max(x, 0), Math.Max(y, 0), Math.Max(z, 0)).Length;
        return outside > 0 ? outside : Math.Max(x, Math.Max(y, z));
    }

    /// <summary>Returns the distance from the surface of a rotated box.</summary>
    public static double Box(Vector3d place, Vector3d at, Quaterniond turned, Vector3d center, Vector3d half) =>
        Box(new Quaterniond(-turned.X, -turned.Y, -turned.Z, turned.W).Rotate(place - at), center, half);
}

/// <summary>A footballer as a capsule on the ground, in a scene of his own.</summary>
internal sealed class WalkingPlayer
{
    public const double Radius = 0.25;
    private const double Top = 1.55;
    private readonly KinematicBody _body;

    public WalkingPlayer(KinematicBodies bodies, string name, SurfaceMaterial? surface = null, double mass = double.PositiveInfinity) =>
        _body = bodies.Add(name, new CapsuleShape(new Vector3d(0, Radius, 0), new Vector3d(0, Top, 0), Radius), surface ?? SurfaceMaterial.Boot, mass);

    /// <summary>The position on the ground, m.</summary>
    public Vector3d Place { get; set; }

    /// <summary>The velocity along the ground, m/s.</summary>
    public Vector3d Velocity { get; set; }

    /// <summary>Sets the body for the ball's next step.</summary>
    public void Put(double time) => _body.MoveTo(Place, Velocity, time);

    /// <summary>Changes his velocity towards another one, by at most a speed.</summary>
    public void Accelerate(Vector3d wanted, double most)
    {
        Vector3d change = wanted - Velocity;
        Velocity += change.Length > most ? most / change.Length * change : change;
    }

    /// <summary>Moves him by a frame.</summary>
    public void Walk(double duration) => Place += duration * Velocity;

    /// <summary>Returns the distance from his surface, a time after the frame began; negative inside.</summary>
    public double Distance(Vector3d place, double after)
    {
        Vector3d foot = Place + (after * Velocity);
        return Solid.Capsule(place, foot + new Vector3d(0, Radius, 0), foot + new Vector3d(0, Top, 0), Radius);
    }
}
