namespace Football.Physics;

/// <summary>The numbers of a scene that a flight in lanes needs, in float.</summary>
internal readonly struct LaneAir
{
    /// <summary>Acceleration by gravity and buoyancy along the lanes' x, m/s².</summary>
    public readonly float AlongX;

    /// <summary>The same along their y.</summary>
    public readonly float AlongY;

    /// <summary>Scale of the drag factor: ½ ρ A / m, times C_D where that is constant; 1/m.</summary>
    public readonly float Drag;

    /// <summary>Scale of the lift factor: of the fitted law the powers' constants included, of the constant law per rad/s.</summary>
    public readonly float Lift;

    /// <summary>Scale of the spin decay: of the fitted law the power's constant included, of the constant law per rad/s.</summary>
    public readonly float Decay;

    /// <summary>Radius, m.</summary>
    public readonly float Radius;

    /// <summary>0.72 r²/4 of the two plates, m².</summary>
    public readonly float Plates;

    /// <summary>C_D0.</summary>
    public readonly float DragAtRest;

    /// <summary>(r/0.05)²: the drag law's jump in spin is where this · |ω|² = |u|².</summary>
    public readonly float Jump;

    /// <summary>Size of the acceleration by gravity and buoyancy, m/s².</summary>
    public readonly float Along;

    /// <param name="scene">The scene.</param>
    /// <param name="upAlongX">Whether up is along the lanes' x, else y.</param>
    public LaneAir(Scene scene, bool upAlongX)
    {
        ForceSet forces = scene.Forces;
        double up = Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene);
        double r = scene.Ball.Radius;
        double drag = 0;
        double lift = 0;
        double decay = 0;
        AirFlow unit = default;
        unit.Speed = 1;
        if (forces.Drag == ForceLaw.Empirical)
        {
            drag = AirScale.DynamicArea(scene);
        }
        else if (forces.Drag == ForceLaw.Constant)
        {
            ConstantDrag law = default;
            law.Prepare(scene);
            drag = law.Factor(in unit);
        }

        unit.SpinRate = 1;
        if (forces.Magnus == ForceLaw.Empirical)
        {
            lift = AirScale.DynamicArea(scene) * EmpiricalMagnus.Scale * LanePowers.LiftConstant;
        }
        else if (forces.Magnus == ForceLaw.Constant)
        {
            ConstantMagnus law = default;
            law.Prepare(scene);
            lift = law.Factor(in unit);
        }

        if (forces.SpinDecay == ForceLaw.Empirical)
        {
            // Both plates at |u| = 1 without spin.
            unit.SpinRate = 0;
            EmpiricalSpinDecay law = default;
            law.Prepare(scene);
            decay = law.Factor(in unit) * LanePowers.DecayConstant;
        }
        else if (forces.SpinDecay == ForceLaw.Constant)
        {
            ConstantSpinDecay law = default;
            law.Prepare(scene);
            decay = law.Factor(in unit);
        }

        AlongX = upAlongX ? (float)up : 0f;
        AlongY = upAlongX ? 0f : (float)up;
        Along = (float)Math.Abs(up);
        Drag = (float)drag;
        Lift = (float)lift;
        Decay = (float)decay;
        Radius = (float)r;
        Plates = (float)(0.72 * 0.25 * r * r);
        DragAtRest = (float)FittedDrag.AtRest;
        Jump = (float)(r * r / (FittedDrag.CriticalSpin * FittedDrag.CriticalSpin));
    }
}
