namespace FootballPhysics.Labs.People;

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

    /// <summary>Moves him by a frame.</summary>
    public void Walk(double duration) => Place += duration * Velocity;

    /// <summary>Returns the distance from his surface, a time after the frame began; negative inside.</summary>
    public double Distance(Vector3d place, double after)
    {
        Vector3d foot = Place + (after * Velocity);
        return Solid.Capsule(place, foot + new Vector3d(0, Radius, 0), foot + new Vector3d(0, Top, 0), Radius);
    }
}
