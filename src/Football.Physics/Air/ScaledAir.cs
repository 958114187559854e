namespace FootballPhysics.Laws;

/// <summary>Drag and Magnus force of a scene's laws times factors, as a force of the game's own: what a fit has found goes into a scene with it.</summary>
public sealed class ScaledAir : IForce
{
    private readonly Scene _scene;
    private readonly double _mass;
    private readonly double _radius;

    /// <summary>Makes the force that, added to a scene's, scales its drag and lift.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="drag">Factor of the drag; not negative.</param>
    /// <param name="lift">Factor of the Magnus force.</param>
    /// <exception cref="ArgumentNullException"><paramref name="scene"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public ScaledAir(Scene scene, double drag, double lift)
    {
        Check.Given(nameof(scene), scene);
        Check.NotNegative(nameof(drag), drag);
        Check.Finite(nameof(lift), lift);
        _scene = scene;
        Laws = AirLaws.Of(scene);
        _mass = scene.Ball.Mass;
        _radius = scene.Ball.Radius;
        Drag = drag;
        Lift = lift;
    }

    /// <summary>Factor of the drag.</summary>
    public double Drag { get; }

    /// <summary>Factor of the Magnus force.</summary>
    public double Lift { get; }

    /// <summary>The laws without factors.</summary>
    internal AirLaws Laws { get; }

    /// <inheritdoc/>
    public void Apply(in ForceContext ball, ref ForceAccumulator sum)
    {
        Vector3d u = ball.AirVelocity;

        // What the scene's own laws give here, of which the factors add the rest.
        DragBranch branch = Laws.Jumps ? DragJump.At(u.LengthSquared, _radius * _radius * ball.Spin.LengthSquared).Branch : DragBranch.Unknown;
        Vector3d w = ball.Spin;
        AirRates.Factors(Laws, u.X, u.Y, u.Z, w.X, w.Y, w.Z, branch, out double drag, out double lift, out _);

        // (f_L − 1) m L (ω × u) − (f_D − 1) m D u
        sum.AddForce(_mass * (((Lift - 1.0) * lift * Vector3d.Cross(in w, in u)) - ((Drag - 1.0) * drag * u)));
    }

    /// <summary>The one own force of a scene, where it scales the scene's own laws: then it is taken as laws, and the axis of the spin stays constant.</summary>
    internal static ScaledAir? AloneIn(Scene scene) =>
        scene.Forces.CustomForces.Count == 1 && scene.Sideways == Vector3d.Zero && scene.Forces.CustomForces[0] is ScaledAir scaled && scaled.IsMadeFor(scene) ? scaled : null;

    /// <summary>True when a scene has the ball, the air and the laws that this was made for.</summary>
    private bool IsMadeFor(Scene scene) =>
        scene.Ball == _scene.Ball && scene.Air == _scene.Air && scene.Forces with { CustomForces = _scene.Forces.CustomForces } == _scene.Forces;
}
