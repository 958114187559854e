namespace FootballPhysics.Engines;

/// <summary>
/// The bulges of a scene's nets, for drawing. A bulge is as deep as the ball is in the net; once the ball leaves faster than the net, or has left it, the
/// net flattens at its own rate of return, that of <see cref="Net.Damping"/>.
/// </summary>
/// <remarks>For one ball. The simulation knows nothing of it: it may be asked or not, after every step or now and then.</remarks>
public sealed class NetBulges
{
    private readonly World _world;
    private readonly NetBulge[] _bulges;
    private double _time = double.NaN;

    /// <summary>For a ball of a scene.</summary>
    /// <param name="simulator">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public NetBulges(Simulator simulator)
    {
        Check.Given(nameof(simulator), simulator);
        _world = simulator.World;
        _bulges = new NetBulge[_world.Nets.Length];
    }

    /// <summary>How many nets there are: those of the scene, then those of each goal: back, roof, left, right.</summary>
    public int Count => _bulges.Length;

    /// <summary>The bulge of a net.</summary>
    /// <param name="net">0 … <see cref="Count"/> − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such net.</exception>
    public NetBulge this[int net]
    {
        get
        {
            Check.Index(nameof(net), net, Count);
            return _bulges[net];
        }
    }

    /// <summary>The name of a net, as events have it.</summary>
    /// <param name="net">0 … <see cref="Count"/> − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such net.</exception>
    public string NameOf(int net)
    {
        Check.Index(nameof(net), net, Count);
        return _world.Nets[net].Name;
    }

    /// <summary>Follows the ball. Allocates nothing.</summary>
    /// <param name="state">The ball now. Where its time has gone back, nets that it is not in hang still.</param>
    public void Follow(in BallState state)
    {
        double passed = state.Time >= _time ? state.Time - _time : double.PositiveInfinity;
        _time = state.Time;
        for (int i = 0; i < _bulges.Length; i++)
        {
            NetSheet net = _world.Nets[i];
            NetBulge before = _bulges[i];

            // F = 0 where δ̇ < −1/b: the sheet comes back more slowly than the ball.
            double left = before.Depth > 0 && net.ReturnSpeed * passed < before.Depth ? before.Depth - (net.ReturnSpeed * passed) : 0;
            double side = World.SideOf(state.NetSides, i);
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
