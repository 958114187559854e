using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>A force that scales the drag and Magnus force of a scene, for example by fitted factors.</summary>
public sealed class ScaledAir : IForce
{
    private readonly Scene _scene;
    private readonly double _mass;
    private readonly double _radius;

    /// <summary>Creates a force that scales drag and lift when added to the scene's custom forces.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="drag">The factor by which the drag is multiplied; at least 0.</param>
    /// <param name="lift">The factor by which the Magnus force is multiplied.</param>
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

    /// <summary>The factor by which the drag is multiplied.</summary>
    public double Drag { get; }

    /// <summary>The factor by which the Magnus force is multiplied.</summary>
    public double Lift { get; }

    /// <summary>The unscaled laws.</summary>
    internal AirLaws Laws { get; }

    /// <inheritdoc/>
    public void Apply(in ForceContext ball, ref ForceAndTorque sum)
    {
        Vector3d u = ball.AirVelocity;

        // Evaluate the scene's laws, then add the force that the factors contribute.
        DragBranch branch = DragJump.BranchAt(Laws.Jumps, u.LengthSquared, _radius * _radius * ball.Spin.LengthSquared);
        Vector3d w = ball.Spin;
        Vector3d cross = Vector3d.Cross(in w, in u);
        Laws.FactorsPerSpin(u.LengthSquared, w.LengthSquared, cross.LengthSquared, branch, out double drag, out double lift, out _);

        // (f_L − 1) m L (ω × u) − (f_D − 1) m D u
        sum.AddForce(_mass * (((Lift - 1.0) * lift * cross) - ((Drag - 1.0) * drag * u)));
    }

    /// <summary>Returns the only custom force of a scene if it scales the scene's own laws; otherwise null.</summary>
    /// <remarks>Such a force is merged into the laws, and the axis of the spin stays constant.</remarks>
    internal static ScaledAir? AloneIn(Scene scene) =>
        scene.Forces.CustomForces.Count == 1 && scene.Forces.CustomForces[0] is ScaledAir scaled && scaled.IsMadeFor(scene) ? scaled : null;

    /// <summary>Returns true if a scene has the same ball, air and laws as the scene of this force.</summary>
    private bool IsMadeFor(Scene scene) =>
        scene.Ball == _scene.Ball && scene.Air == _scene.Air && scene.Forces with { CustomForces = _scene.Forces.CustomForces } == _scene.Forces;
}
