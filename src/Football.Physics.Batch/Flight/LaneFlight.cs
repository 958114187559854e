namespace FootballPhysics.Batch;

/// <summary>Flies groups of balls, several at once in wide registers. Immutable: threads may share it.</summary>
internal abstract class LaneFlight
{
    private protected LaneFlight(double timeStep, bool findsApex)
    {
        TimeStep = (float)timeStep;
        FindsApex = findsApex;
    }

    /// <summary>Length of a step, s: the float next to what was asked for.</summary>
    public float TimeStep { get; }

    /// <summary>True when the highest point of each way is wanted.</summary>
    public bool FindsApex { get; }

    /// <summary>Flies all balls of a group until their limits or a time.</summary>
    public abstract void Fly(LaneGroup group, double duration);

    /// <summary>
    /// True when there is a flight in lanes for a scene: laws of one kind, or none, without a force of the game's own, wind by place and time, or a
    /// knuckle force, and nothing to hit but level ground.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene names a law that there is not.</exception>
    public static bool Covers(Scene scene) => !scene.HasOwnForces && !SceneAir.HasFieldIn(scene) && KindOf(scene.Forces) is not null
        && scene.Ground.IsLevel && scene.Ground.Pattern is null && !scene.HasThings;

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="fourthOrder">RK4, else RK2.</param>
    /// <param name="timeStep">Length of a step, s.</param>
    /// <param name="lanes">Floats in a register: 1, 4, 8 or 16.</param>
    /// <param name="upAlongX">Whether up is along x of the lanes, else y.</param>
    /// <param name="findsApex">Whether the highest point of each way is wanted.</param>
    /// <exception cref="ArgumentOutOfRangeException">The scene is not covered, or there is no such register.</exception>
    public static LaneFlight Create(Scene scene, bool fourthOrder, double timeStep, int lanes, bool upAlongX = false, bool findsApex = false) =>
        fourthOrder
            ? WithMethod<LaneRk4>(scene, timeStep, lanes, upAlongX, findsApex)
            : WithMethod<LaneRk2>(scene, timeStep, lanes, upAlongX, findsApex);

#if NET8_0_OR_GREATER
    /// <summary>How many floats are best put side by side here.</summary>
    public static int BestLanes { get; } =
        System.Runtime.Intrinsics.Vector512.IsHardwareAccelerated ? 16
        : System.Runtime.Intrinsics.Vector256.IsHardwareAccelerated ? 8
        : System.Runtime.Intrinsics.Vector128.IsHardwareAccelerated ? 4
        : 1;

    private static LaneFlight WithMethod<TMethod>(Scene scene, double timeStep, int lanes, bool upAlongX, bool findsApex)
        where TMethod : struct, ILaneMethod => lanes switch
        {
            16 => WithLanes<Lanes16, TMethod>(scene, timeStep, upAlongX, findsApex),
            8 => WithLanes<Lanes8, TMethod>(scene, timeStep, upAlongX, findsApex),
            4 => WithLanes<Lanes4, TMethod>(scene, timeStep, upAlongX, findsApex),
            1 => WithLanes<Lanes1, TMethod>(scene, timeStep, upAlongX, findsApex),
            _ => throw new ArgumentOutOfRangeException(nameof(lanes)),
        };
#else
    /// <summary>How many floats are best put side by side here.</summary>
    public static int BestLanes => 1;

    private static LaneFlight WithMethod<TMethod>(Scene scene, double timeStep, int lanes, bool upAlongX, bool findsApex)
        where TMethod : struct, ILaneMethod =>
        lanes >= 1 ? WithLanes<Lanes1, TMethod>(scene, timeStep, upAlongX, findsApex) : throw new ArgumentOutOfRangeException(nameof(lanes));
#endif

    /// <summary>With the law of the scene: the one place that names them.</summary>
    private static LaneFlight WithLanes<F, TMethod>(Scene scene, double timeStep, bool upAlongX, bool findsApex)
#if NET8_0_OR_GREATER
        where F : struct, ILane<F>
#endif
        where TMethod : struct, ILaneMethod
    {
        AerodynamicModel form = scene.Forces.Coefficients;
        return KindOf(scene.Forces) switch
        {
            ForceLaw.None => new LaneKernel<F, VacuumLaneLaw<F>, TMethod>(scene, timeStep, upAlongX, findsApex),
            ForceLaw.Constant => new LaneKernel<F, ConstantLaneLaw<F>, TMethod>(scene, timeStep, upAlongX, findsApex),
            ForceLaw.Empirical when form == AerodynamicModel.Published =>
                new LaneKernel<F, FittedLaneLaw<F, PublishedLaneFit<F>>, TMethod>(scene, timeStep, upAlongX, findsApex),
            ForceLaw.Empirical when form == AerodynamicModel.Regularized =>
                new LaneKernel<F, FittedLaneLaw<F, RegularisedLaneFit<F>>, TMethod>(scene, timeStep, upAlongX, findsApex),
            ForceLaw.Empirical when form == AerodynamicModel.Measured =>
                new LaneKernel<F, MeasuredLaneLaw<F>, TMethod>(scene, timeStep, upAlongX, findsApex),
            ForceLaw.Empirical => throw Check.Refusal("forces.coefficients", form.ToString(), "Published | Regularized | Measured"),
            _ => throw new ArgumentOutOfRangeException(nameof(scene), "A batch does not support force laws of different kinds. Set forces.drag, forces.magnus and forces.spinDecay to the same law."),
        };
    }

    /// <summary>Of which kind the laws that act are; null where they are of several.</summary>
    private static ForceLaw? KindOf(ForceSet forces)
    {
        ForceLaw kind = ForceLaw.None;
        for (int i = 0; i < 3; i++)
        {
            ForceLaw law = i == 0 ? forces.Drag : i == 1 ? forces.Magnus : forces.SpinDecay;
            Check.Defined("forces", law, (int)law, 3);
            if (law != ForceLaw.None && kind != ForceLaw.None && law != kind)
            {
                return null;
            }

            kind = law == ForceLaw.None ? kind : law;
        }

        return kind;
    }
}
