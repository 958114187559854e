using System.Runtime.CompilerServices;

namespace FootballPhysics.Laws;

/// <summary>The forces with constant coefficients in a scene whose other forces are fitted.</summary>
/// <remarks>The fitted law computes all factors first, then these replace theirs. A scene without constant coefficients pays one predictable branch.</remarks>
internal struct ConstantParts
{
    /// <summary>True if any force has a constant coefficient.</summary>
    public bool Any;

    private bool _drags;
    private bool _lifts;
    private bool _decays;
    private double _drag;  // ½ ρ C_D A / m, 1/m
    private double _lift;  // C_M π ρ r³ / m
    private double _decay; // k / I, 1/s

    public void Prepare(Scene scene)
    {
        ForceSet forces = scene.Forces;
        _drags = forces.Drag == ForceLaw.Constant;
        _lifts = forces.Magnus == ForceLaw.Constant;
        _decays = forces.SpinDecay == ForceLaw.Constant;
        Any = _drags || _lifts || _decays;
        _drag = ConstantDrag.Scale(scene);
        _lift = ConstantMagnus.Scale(scene);
        _decay = ConstantSpinDecay.Scale(scene);
    }

    /// <summary>Replaces the factors of the forces that have constant coefficients.</summary>
    /// <param name="speed">|u|, m/s.</param>
    /// <param name="spinRate">|ω|, rad/s; a stage may overshoot zero.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L, 1/s.</param>
    /// <param name="decay">The angular deceleration, in rad/s².</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Replace(double speed, double spinRate, ref double drag, ref double lift, ref double decay)
    {
        // u is the velocity through the air; k_D, k_L and k are the constants of drag, lift and decay.
        // D = k_D |u|,  L = k_L |ω|,  |ω|˙ = −k |ω|
        drag = _drags ? _drag * speed : drag;
        lift = _lifts ? _lift * (spinRate > 0 ? spinRate : 0) : lift;
        decay = _decays ? _decay * Math.Abs(spinRate) : decay;
    }
}
