using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The constants of the ground's forces, per mass or per moment of inertia.</summary>
internal struct GroundForces
{
    /// <summary>Sliding friction per mass, μ_s N/m, m/s².</summary>
    public double Sliding;

    /// <summary>Angular acceleration by sliding friction, r μ_s N / I, rad/s².</summary>
    public double SlidingTorque;

    /// <summary>Rolling friction per mass, μ_r N/m, m/s².</summary>
    public double Rolling;

    /// <summary>Damping of the spin about the vertical, c_ω / I, 1/s.</summary>
    public double SpinDamping;

    /// <summary>Ball radius, m.</summary>
    public double Radius;

    /// <summary>1/r, 1/m.</summary>
    public double PerRadius;

    public static GroundForces Of(Scene scene)
    {
        BallProperties ball = scene.Ball;
        double normal = NormalForce(scene);
        return new GroundForces
        {
            Sliding = scene.Ground.SlidingFriction * normal,
            SlidingTorque = scene.Ground.SlidingFriction * normal / (ball.InertiaFactor * ball.Radius),
            Rolling = scene.Ground.RollingFriction * normal,
            SpinDamping = scene.Ground.SpinDamping / ball.MomentOfInertia,
            Radius = ball.Radius,
            PerRadius = 1.0 / ball.Radius,
        };
    }

    /// <summary>Moves a ball to the end of a step on the ground.</summary>
    /// <param name="s">The ball at the step's start.</param>
    /// <param name="step">The step.</param>
    /// <param name="spin">Spin at its end, rad/s.</param>
    /// <param name="mayReverse">Whether a force acts that may reverse the spin about the vertical: damping and decay end it, they never reverse it.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Move(ref BallState s, in PlanarStep step, in Vector3d spin, bool mayReverse)
    {
        double about = s.SpinAxis.Y;
        s.BaseOrientation = s.BaseOrientation.Turned(in step.Rotation);
        s.Position = new Vector3d(step.End.X, s.Position.Y, step.End.Z);
        s.Velocity = new Vector3d(step.End.VX, 0, step.End.VZ);
        bool reversed = about > 0 ? spin.Y < 0 : about < 0 && spin.Y > 0;

        // What is damped for long ends at zero, and not at a denormal number.
        bool ends = (reversed && !mayReverse) || Math.Abs(spin.Y) is > 0 and < Vanishing.Least;
        s.SpinAxis = ends ? new Vector3d(spin.X, 0, spin.Z) : spin;
    }

    /// <summary>N/m = max(0, g − |F_B|/m), m/s²: gravity and buoyancy only.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double NormalForce(Scene scene) => Math.Max(0, -Weight.UpwardAcceleration(scene));
}
