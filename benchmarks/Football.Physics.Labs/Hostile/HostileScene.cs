using System.Globalization;

namespace FootballPhysics.Labs.Hostile;

/// <summary>A scene from far outside football, a kick, a method and the frames it is stepped with: all of it from one number.</summary>
internal sealed record HostileScene
{
    /// <summary>Its number, from which it is drawn.</summary>
    public required ulong Number { get; init; }

    public required Scene Scene { get; init; }

    public required SolverSettings Settings { get; init; }

    public required Vector3d Position { get; init; }

    public required Vector3d Velocity { get; init; }

    public required Vector3d Spin { get; init; }

    /// <summary>Lengths of the frames, s.</summary>
    public required double[] Frames { get; init; }

    public bool Windy => Scene.Air.Wind != Vector3d.Zero;

    /// <summary>Whether a wind lifts a ball that spins as hard as the scene likes: then nothing bounds how fast it gets.</summary>
    public bool LiftsByWind => Windy && Scene.Forces.Magnus == ForceLaw.Constant;

    public bool HasOwnForces => Scene.Forces.CustomForces.Count > 0;

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward => -Scene.Gravity + (Scene.Forces.Buoyancy
        ? 4.0 / 3.0 * Math.PI * Math.Pow(Scene.Ball.Radius, 3) * Scene.Air.Density * Scene.Gravity / Scene.Ball.Mass
        : 0);

    /// <summary>Whether every number is one that a game might have.</summary>
    public bool IsMild => Scene.Ball.Mass is >= 0.05 and <= 5
        && Scene.Ball.Radius is >= 0.05 and <= 0.3
        && Scene.Ball.InertiaFactor >= 0.3
        && !HasOwnForces
        && Scene.Forces.DragCoefficient <= 10
        && Math.Abs(Scene.Forces.MagnusCoefficient) <= 5
        && Scene.Forces.SpinDecayCoefficient <= 1
        && Velocity.Length <= 200
        && Spin.Length is 0 or (> 1e-100 and <= 1000)
        && Scene.Air.Wind.Length <= 200
        && Settings.CollisionTolerance <= 1e-3;

    /// <summary>½ m v² + ½ I ω² + m g y, J.</summary>
    public double Energy(in BallState state, double contactHeight) =>
        (0.5 * ((Scene.Ball.Mass * state.Velocity.LengthSquared) + (Scene.Ball.MomentOfInertia * state.Spin.LengthSquared)))
        - (Scene.Ball.Mass * Upward * (state.Position.Y - contactHeight));

    /// <summary>All of it in one line.</summary>
    public string Text() => string.Create(
        CultureInfo.InvariantCulture,
        $"{Scene.Ball} {Scene.Air} gravity {Scene.Gravity:R} {Scene.Forces} own forces [{string.Join(", ", Scene.Forces.CustomForces)}] {Scene.Ground} {Settings} "
        + $"from {Position} at {Velocity} with {Spin}, frames [{string.Join(", ", Frames.Take(8).Select(frame => frame.ToString("R", CultureInfo.InvariantCulture)))} …]");
}
