using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Simulates groups of balls, several at once in SIMD registers. Immutable and thread-safe.</summary>
internal abstract class LaneFlight
{
    private protected LaneFlight(double timeStep, bool findsApex)
    {
        TimeStep = (float)timeStep;
        FindsApex = findsApex;
    }

    /// <summary>The length of a step, in s: the requested length, rounded to float.</summary>
    public float TimeStep { get; }

    /// <summary>True if the highest point of each path is computed.</summary>
    public bool FindsApex { get; }

    /// <summary>Simulates all balls of a group up to their limits or a time.</summary>
    public abstract void Fly(LaneGroup group, double duration);

    /// <summary>Returns true if lanes support a scene.</summary>
    /// <remarks>
    /// They support laws of one kind, or none, above level ground. They support no custom forces, variable wind, knuckle force, reverse lift, or objects.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
    public static bool Covers(Scene scene) => !scene.HasOwnForces && !scene.IsTilted && !SceneAir.HasFieldIn(scene) && KindOf(scene.Forces) is not null && scene.Ball.ReverseLift == 0
        && scene.Ground.IsLevel && scene.Ground.Pattern is null && !scene.HasThings;

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="fourthOrder">True for RK4, false for RK2.</param>
    /// <param name="timeStep">The length of a step, in s.</param>
    /// <param name="lanes">The number of floats in a register: 1, 4, 8 or 16.</param>
    /// <param name="upAlongX">True if up is the lanes' x, false for y.</param>
    /// <param name="findsApex">True to compute the highest point of each path.</param>
    /// <exception cref="ArgumentOutOfRangeException">Lanes do not support the scene, or the number of lanes.</exception>
    public static LaneFlight Create(Scene scene, bool fourthOrder, double timeStep, int lanes, bool upAlongX = false, bool findsApex = false) =>
        fourthOrder
            ? WithMethod<LaneRk4>(scene, timeStep, lanes, upAlongX, findsApex)
            : WithMethod<LaneRk2>(scene, timeStep, lanes, upAlongX, findsApex);

#if NET8_0_OR_GREATER
    /// <summary>The best number of lanes on this machine.</summary>
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
    /// <summary>The best number of lanes on this machine.</summary>
    public static int BestLanes => 1;

    private static LaneFlight WithMethod<TMethod>(Scene scene, double timeStep, int lanes, bool upAlongX, bool findsApex)
        where TMethod : struct, ILaneMethod =>
        lanes >= 1 ? WithLanes<Lanes1, TMethod>(scene, timeStep, upAlongX, findsApex) : throw new ArgumentOutOfRangeException(nameof(lanes));
#endif

    /// <summary>Creates a flight with the laws of the scene. Only this method maps scenes to lane laws.</summary>
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

    /// <summary>Returns the kind of the laws that act; null if there are several kinds.</summary>
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
