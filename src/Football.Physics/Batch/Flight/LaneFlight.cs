namespace Football.Physics;

/// <summary>Flies groups of balls, several at once in wide registers. Immutable: threads may share it.</summary>
internal abstract class LaneFlight
{
    /// <summary>Length of a step, s: the float next to what was asked for.</summary>
    public float TimeStep { get; private protected set; }

    /// <summary>Whether the highest point of each way is wanted.</summary>
    public bool FindsApex { get; private protected set; }

    /// <summary>Flies all balls of a group until their limits or a time.</summary>
    public abstract void Fly(LaneGroup group, double duration);

    /// <summary>Whether there is a flight in lanes for the laws of a scene: those of one kind, or none, and no force of the game's own.</summary>
    public static bool Covers(Scene scene)
    {
        ForceSet forces = scene.Forces;
        bool constant = forces.Drag == ForceLaw.Constant || forces.Magnus == ForceLaw.Constant || forces.SpinDecay == ForceLaw.Constant;
        bool empirical = forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical || forces.SpinDecay == ForceLaw.Empirical;
        return forces.Custom.Count == 0 && !(constant && empirical);
    }

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="fourthOrder">RK4, else RK2.</param>
    /// <param name="timeStep">Length of a step, s.</param>
    /// <param name="lanes">Floats in a register: 1, 4, 8 or 16.</param>
    /// <param name="upAlongX">Whether up is along x of the lanes, else y.</param>
    /// <param name="findsApex">Whether the highest point of each way is wanted.</param>
    public static LaneFlight Create(Scene scene, bool fourthOrder, double timeStep, int lanes, bool upAlongX = false, bool findsApex = false)
    {
        var air = new LaneAir(scene, upAlongX);
        LaneFlight flight = fourthOrder ? WithMethod<LaneRk4>(scene, in air, lanes) : WithMethod<LaneRk2>(scene, in air, lanes);
        flight.TimeStep = (float)timeStep;
        flight.FindsApex = findsApex;
        return flight;
    }

    private static LaneFlight WithMethod<TMethod>(Scene scene, in LaneAir air, int lanes)
        where TMethod : struct, ILaneMethod
    {
        ForceSet forces = scene.Forces;
        bool fitted = forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical || forces.SpinDecay == ForceLaw.Empirical;
        bool constant = forces.Drag == ForceLaw.Constant || forces.Magnus == ForceLaw.Constant || forces.SpinDecay == ForceLaw.Constant;
        return fitted && forces.Coefficients == CoefficientForm.Published ? WithLanes<PublishedLaneLaw, TMethod>(in air, lanes)
            : fitted ? WithLanes<RegularisedLaneLaw, TMethod>(in air, lanes)
            : constant ? WithLanes<ConstantLaneLaw, TMethod>(in air, lanes)
            : WithLanes<VacuumLaneLaw, TMethod>(in air, lanes);
    }

#if NET8_0_OR_GREATER
    /// <summary>How many floats are best put side by side here.</summary>
    public static int BestLanes { get; } =
        System.Runtime.Intrinsics.Vector512.IsHardwareAccelerated ? 16
        : System.Runtime.Intrinsics.Vector256.IsHardwareAccelerated ? 8
        : System.Runtime.Intrinsics.Vector128.IsHardwareAccelerated ? 4
        : 1;

    private static LaneFlight WithLanes<TLaw, TMethod>(in LaneAir air, int lanes)
        where TLaw : struct, ILaneLaw
        where TMethod : struct, ILaneMethod => lanes switch
        {
            16 => new LaneFlight<Lanes16, TLaw, TMethod>(in air),
            8 => new LaneFlight<Lanes8, TLaw, TMethod>(in air),
            4 => new LaneFlight<Lanes4, TLaw, TMethod>(in air),
            _ => new LaneFlight<Lanes1, TLaw, TMethod>(in air),
        };
#else
    /// <summary>How many floats are best put side by side here.</summary>
    public static int BestLanes => 1;

    private static LaneFlight WithLanes<TLaw, TMethod>(in LaneAir air, int lanes)
        where TLaw : struct, ILaneLaw
        where TMethod : struct, ILaneMethod => lanes >= 1 ? new LaneFlight<TLaw, TMethod>(in air) : throw new ArgumentOutOfRangeException(nameof(lanes));
#endif
}
