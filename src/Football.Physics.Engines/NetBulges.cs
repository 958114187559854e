using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>The bulges of a scene's nets for one ball, for drawing.</summary>
/// <remarks>
/// The depth of a bulge is the depth of the ball in the net. When the ball recedes faster than the net, or has left it, the net flattens at a rate given by
/// <see cref="Net.Damping"/>. The simulation does not depend on this object: update it after every step, or less often.
/// </remarks>
public sealed class NetBulges
{
    private readonly World _world;
    private readonly NetBulge[] _bulges;
    private double _time = double.NaN;

    /// <summary>Creates the bulges for a ball of a scene.</summary>
    /// <param name="simulator">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public NetBulges(Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        _world = simulator.World;
        _bulges = new NetBulge[_world.Nets.Length];
    }

    /// <summary>The number of nets: those of the scene, then back, roof, left and right of each goal.</summary>
    public int Count => _bulges.Length;

    /// <summary>Gets the bulge of a net.</summary>
    /// <param name="net">The index of the net, 0 … <see cref="Count"/> − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such net.</exception>
    public NetBulge this[int net]
    {
        get
        {
            Check.Index(nameof(net), net, Count);
            return _bulges[net];
        }
    }

    /// <summary>Returns the name of a net, as used in events.</summary>
    /// <param name="net">The index of the net, 0 … <see cref="Count"/> − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such net.</exception>
    public string NameOf(int net)
    {
        Check.Index(nameof(net), net, Count);
        return _world.Nets[net].Name;
    }

    /// <summary>Updates the bulges to the state of the ball. Does not allocate.</summary>
    /// <param name="state">The current state of the ball. If its time has gone back, nets without the ball hang flat.</param>
    /// <exception cref="ArgumentException"><paramref name="state"/> was never launched.</exception>
    public void Follow(in BallState state)
    {
        BallState.Launched(in state);
        double passed = state.Time >= _time ? state.Time - _time : double.PositiveInfinity;
        _time = state.Time;
        for (int i = 0; i < _bulges.Length; i++)
        {
            NetSheet net = _world.Nets[i];
            NetBulge before = _bulges[i];

            // F = 0 if δ̇ < −1/b. The net then returns more slowly than the ball.
            double left = before.Depth > 0 && net.ReturnSpeed * passed < before.Depth ? before.Depth - (net.ReturnSpeed * passed) : 0;
            double side = NetSheet.SideOf(state.NetSides, i);
            double depth = (state.Nets >> i & 1) != 0 ? Math.Max(0, net.Depth(state.Position, side)) : 0;
            if (depth >= left)
            {
                Vector3d direction = -side * net.Normal;
                _bulges[i] = new NetBulge(state.Position + (_world.Ball.Radius * direction), in direction, depth);
            }
            else
            {
                _bulges[i] = new NetBulge(before.Position - ((before.Depth - left) * before.Direction), before.Direction, left);
            }
        }
    }
}
