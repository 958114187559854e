using System.Runtime.CompilerServices;
using FootballPhysics.Scenes;

namespace FootballPhysics.Simulation;

/// <summary>A straight tube along the ball's path that stays free of bodies for some time.</summary>
/// <remarks>
/// No query is needed until the ball leaves the tube, or a body is moved or pushed. The tube is stored with the bodies, not with the ball.
/// It only saves queries: if the tube holds, the query for that step alone (<see cref="IsFree"/>) finds no body either, for these reasons:
/// <list type="bullet">
/// <item>At every time of the step, the straight path of the query is within the width w of the axis of the tube, along each direction.</item>
/// <item>The margin of the query grows with the length of the step, the speed, the spin and the friction. The tube limits each of them. Its own
/// margin is that of the query at these limits, plus w and a margin for rounding errors.</item>
/// <item>Bounding sphere: both tests compare the distance at half the time with the radii plus the distances that the ball and the body cover in half
/// the time. Over a shorter time, the covered distances decrease by at least as much as the distance at half the time.</item>
/// <item>Bounding box: the box for a part of the time lies within that for the whole time (<see cref="Placement.BoundsDuring"/>).</item>
/// </list>
/// </remarks>
internal sealed class BodyTube
{
    /// <summary>Minimum width, m.</summary>
    private const double LeastWidth = 0.1;

    private readonly KinematicBodies _bodies;
    private readonly uint _ignores;
    private Vector3d _from;
    private Vector3d _velocity;
    private double _spinRate;
    private double _airSpeedSquared;
    private double _friction;
    private double _time;
    private double _duration = -1;
    private double _width;
    private double _longestStep;
    private long _moves;

    /// <param name="bodies">The bodies.</param>
    /// <param name="ignores">The layers that the ball ignores.</param>
    public BodyTube(KinematicBodies bodies, uint ignores)
    {
        _bodies = bodies;
        _ignores = ignores;
    }

    /// <summary>Returns the width of a tube for a given deviation of the ball from a straight line, m.</summary>
    public static double Width(double bend) => LeastWidth + (0.5 * bend);

    /// <summary>True if no body has moved since the last search.</summary>
    public bool IsWorthwhile => _bodies.Moves == _moves;

    /// <summary>True if a ball stays in the tube during a step.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="airSpeedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">Spin, rad/s.</param>
    /// <param name="friction">Factor by which friction increases the acceleration.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Holds(in BallState s, double dt, double airSpeedSquared, double spinRate, double friction)
    {
        double gone = s.Time - _time;
        if (!(_bodies.Moves == _moves && gone >= 0 && gone + dt <= _duration && dt <= _longestStep
            && spinRate <= _spinRate && airSpeedSquared <= _airSpeedSquared && friction <= _friction))
        {
            return false;
        }

        // The offset is the initial one plus the drift of the velocity until the end; the tube's radius covers the bend within the step.
        double x = Math.Abs(s.Position.X - _from.X - (gone * _velocity.X)) + (dt * Math.Abs(s.Velocity.X - _velocity.X));
        double y = Math.Abs(s.Position.Y - _from.Y - (gone * _velocity.Y)) + (dt * Math.Abs(s.Velocity.Y - _velocity.Y));
        double z = Math.Abs(s.Position.Z - _from.Z - (gone * _velocity.Z)) + (dt * Math.Abs(s.Velocity.Z - _velocity.Z));
        return x + y + z <= _width;
    }

    /// <summary>True if no body is near the ball in one step.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="around">Margin of the search around the ball's centre, m.</param>
    public bool IsFree(in BallState s, double dt, double around)
    {
        // The tube may be outdated.
        _duration = -1;
        _moves = _bodies.Moves;
        return dt <= _bodies.FreeFor(s.Position, s.Velocity, s.Time, dt, around, _ignores);
    }

    /// <summary>Searches for a new tube for the ball.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="push">Bounds of the forces for which the tube is valid.</param>
    /// <param name="dt">Length of its step, s.</param>
    /// <param name="longest">Longest step for which the tube is valid, s.</param>
    /// <param name="ahead">Time to search ahead, s.</param>
    /// <param name="width">Maximum offset of the ball from the axis, m.</param>
    /// <param name="around">Margin of a search for the longest step with these forces, m.</param>
    /// <returns>True if it covers the step.</returns>
    public bool Renew(in BallState s, in FlightPush push, double dt, double longest, double ahead, double width, double around)
    {
        _width = width;
        _from = s.Position;
        _velocity = s.Velocity;
        _spinRate = push.SpinRate;
        _airSpeedSquared = push.AirSpeedSquared;
        _friction = push.FrictionFactor;
        _time = s.Time;
        _longestStep = longest;
        _moves = _bodies.Moves;
        _duration = _bodies.FreeFor(in _from, in _velocity, _time, ahead, around + width + MovingLane.Rounding, _ignores);
        return dt <= _duration;
    }
}
