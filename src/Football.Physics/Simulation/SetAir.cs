using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>The accelerations of a ball on several surfaces without contact forces, if all air forces act: g + L (ω × u) − D u, and
/// −decay ω.</summary>
/// <typeparam name="TAir">The laws of the air.</typeparam>
internal struct SetAir<TAir>
    where TAir : struct, IFlightAir
{
    /// <summary>Wind, m/s, and the maximum that a wind field adds to it.</summary>
    public readonly Vector3d Wind;
    public readonly double FastestWind;

    private readonly Vector3d _body;
    private TAir _air;

    public SetAir(Surroundings around, in TAir air)
    {
        Wind = around.Wind;
        FastestWind = around.Air.FastestWind;
        _body = around.Weight;
        _air = air;
    }

    /// <summary>Returns the accelerations at a state, m/s² and rad/s².</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void At(double time, in Vector3d position, in Vector3d velocity, in Vector3d spin, out Vector3d push, out Vector3d torque)
    {
        Vector3d u = velocity - Wind;
        u -= _air.HasField ? _air.WindAt(time, position.X, position.Y, position.Z) : Vector3d.Zero;
        Vector3d cross = Vector3d.Cross(in spin, in u);
        bool spins = _air.FactorsPerSpin(
            u.LengthSquared, spin.LengthSquared, cross.LengthSquared, DragBranch.Unknown, out double drag, out double lift, out double decay);
        push = _body + (lift * cross) - (drag * u);
        torque = (spins ? -decay : 0) * spin;
    }
}
