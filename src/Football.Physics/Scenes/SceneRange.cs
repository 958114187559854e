namespace Football.Physics;

/// <summary>
/// The sizes that a scene's numbers may have, far beyond any ball: within them no square, product or quotient that a step makes of them
/// overflows or vanishes.
/// </summary>
internal static class SceneRange
{
    /// <summary>The most that the air may change a motion, 1/m.</summary>
    private const double Strongest = 1e299;

    /// <summary>The most that a damping may change a spin, 1/s.</summary>
    private const double StrongestDamping = 1e304;

    /// <summary>The most that a ball without drag may be accelerated by gravity and buoyancy, m/s².</summary>
    private const double FastestFall = 1e55;

    /// <summary>The smallest moment of inertia, kg m².</summary>
    private const double LeastInertia = 1e-303;

    /// <summary>Refuses what is beyond.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is; the message names field, value and range.</exception>
    public static void Validate(Scene scene)
    {
        BallProperties ball = scene.Ball;
        ForceSet forces = scene.Forces;
        Check.Within("ball.mass", ball.Mass, 1e-300, 1e100);
        Check.Within("ball.radius", ball.Radius, 1e-9, Limits.Length);
        Check.Within("ball.inertiaFactor", ball.InertiaFactor, 1e-12, 1);
        Check.Within("air.density", scene.Air.Density, 0, 1e12);
        Check.Within("air.kinematicViscosity", scene.Air.KinematicViscosity, 1e-15, 1e15);
        Check.Within("gravity", scene.Gravity, 0, 1e9);
        Check.Within("forces.dragCoefficient", forces.DragCoefficient, 0, 1e15);
        Check.Within("forces.magnusCoefficient", forces.MagnusCoefficient, -1e15, 1e15);
        Check.Within("forces.spinDecayCoefficient", forces.SpinDecayCoefficient, 0, 1e15);
        Check.Within("ground.slidingFriction", scene.Ground.SlidingFriction, 0, 1e9);
        Check.Within("ground.rollingFriction", scene.Ground.RollingFriction, 0, 1e9);
        Check.Within("ground.spinDamping", scene.Ground.SpinDamping, 0, 1e12);
        Check.Within("ground.minimumBounceSpeed", scene.Ground.MinimumBounceSpeed, 0.001, 1e12);

        // What the small masses leave of the moment of inertia, and what they make of forces and torques.
        double inertia = ball.MomentOfInertia;
        if (!(inertia >= LeastInertia))
        {
            Refuse("ball.mass", ball.Mass, "a moment of inertia of at least 1E-303 kg m²");
        }

        double coefficient = Math.Max(1, Math.Max(Drags(forces), Lifts(forces)));
        double size = Math.Max(1, ball.Radius) / ball.InertiaFactor;
        if (!(scene.Air.Density * ball.Radius * ball.Radius * coefficient * size / ball.Mass <= Strongest))
        {
            Refuse("air.density", scene.Air.Density, "an air that moves a ball of this mass and size by at most 1E+299 1/m");
        }

        bool drags = forces.Drag == ForceLaw.Empirical || Drags(forces) > 0;
        if (!drags && !(Math.Abs(Weight.UpwardAcceleration(scene)) <= FastestFall))
        {
            Refuse("ball.mass", ball.Mass, "a buoyancy that accelerates a ball without drag by at most 1E+55 m/s²");
        }

        if (forces.SpinDecay == ForceLaw.Constant && !(forces.SpinDecayCoefficient / inertia <= StrongestDamping))
        {
            Refuse("forces.spinDecayCoefficient", forces.SpinDecayCoefficient, "a decay of at most 1E+304 1/s");
        }

        if (!(scene.Ground.SpinDamping / inertia <= StrongestDamping))
        {
            Refuse("ground.spinDamping", scene.Ground.SpinDamping, "a damping of at most 1E+304 1/s");
        }
    }

    private static double Drags(ForceSet forces) => forces.Drag == ForceLaw.Constant ? forces.DragCoefficient : 0;

    private static double Lifts(ForceSet forces) => forces.Magnus == ForceLaw.Constant ? Math.Abs(forces.MagnusCoefficient) : 0;

    private static void Refuse(string field, double value, string allowed) =>
        throw Check.Refusal(field, value.ToString("R", System.Globalization.CultureInfo.InvariantCulture), allowed);
}
