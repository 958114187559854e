namespace FootballPhysics.Tests.Things;

/// <summary>A game engine as far as the ball sees it: shapes that move, and a sphere cast that is asked no more than it must answer.</summary>
internal sealed class ShapesAsEngine : IEngineColliders
{
    private const int Samples = 400;

    private readonly List<(EngineCollider Collider, IShape Shape, Vector3d Velocity, bool IsKnown)> _all = [];

    public double Time { get; set; }

    public double MaximumSpeed { get; set; }

    /// <summary>How often it was asked.</summary>
    public int Casts { get; private set; }

    /// <summary>Adds a thing.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="shape">Its shape at time 0.</param>
    /// <param name="velocity">Its velocity.</param>
    /// <param name="isKnown">Whether the library is told the shape; else only where it is touched.</param>
    public void Add(string name, IShape shape, Vector3d velocity = default, bool isKnown = true)
    {
        var collider = isKnown ? new EngineCollider(name, shape) : new EngineCollider(name);
        _all.Add((collider, shape, velocity, isKnown));
        MaximumSpeed = Math.Max(MaximumSpeed, velocity.Length);
    }

    public void RemoveAll() => _all.Clear();

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        Casts++;
        for (int i = 0; i < _all.Count; i++)
        {
            (EngineCollider collider, IShape shape, Vector3d velocity, bool isKnown) = _all[i];
            Vector3d gone = Time * velocity;
            double best = double.PositiveInfinity;
            Vector3d nearest = default;
            for (int k = 0; k <= Samples; k++)
            {
                Vector3d at = cast.From + (cast.Distance * k / Samples * cast.Direction);
                double distance = shape.At(at - gone).Distance;
                (best, nearest) = distance < best ? (distance, at) : (best, nearest);
            }

            if (best > cast.Radius + (cast.Distance / Samples))
            {
                continue;
            }

            if (isKnown)
            {
                collider.MoveTo(gone, Quaterniond.Identity, velocity, Vector3d.Zero);
            }
            else
            {
                ShapePoint point = shape.At(nearest - gone);
                double curvature = shape is SphereShape sphere ? 1 / sphere.Radius : 0;
                collider.TouchAt(nearest - (point.Distance * point.Normal), point.Normal, velocity, curvature);
            }

            hits.Add(collider);
        }
    }
}
