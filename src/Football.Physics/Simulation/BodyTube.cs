using System.Runtime.CompilerServices;

namespace FootballPhysics.Simulation;

/// <summary>A straight tube along the ball's path that stays free of bodies for some time.</summary>
/// <remarks>
/// No query is needed until the ball leaves the tube, or a body is moved or pushed. The tube is stored with the bodies, not with the ball:
/// it only saves queries.
/// </remarks>
internal sealed class BodyTube
{
    /// <summary>Minimum width, m.</summary>
    private const double LeastWidth = 0.1;

    private readonly KinematicBodies _bodies;
    private readonly double _ballRadius;
    private Vector3d _from;
    private Vector3d _velocity;
    private double _spinRate;
    private double _airSpeedSquared;
    private double _time;
    private double _duration = -1;
    private double _width;
    private double _longestStep;
    private long _moves;

    public BodyTube(KinematicBodies bodies, double ballRadius)
    {
        _bodies = bodies;
        _ballRadius = ballRadius;
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
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Holds(in BallState s, double dt, double airSpeedSquared, double spinRate)
    {
        double gone = s.Time - _time;
        if (!(_bodies.Moves == _moves && gone >= 0 && gone + dt <= _duration && dt <= _longestStep && spinRate <= _spinRate && airSpeedSquared <= _airSpeedSquared))
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
    /// <param name="bendOfStep">Maximum deviation from a straight line in the longest step of a tube, m.</param>
    /// <param name="bend">Maximum deviation in this step, m.</param>
    public bool IsFree(in BallState s, double dt, double bendOfStep, double bend)
    {
        // The tube may be outdated.
        _duration = -1;
        _moves = _bodies.Moves;
        return dt <= _bodies.FreeFor(s.Position, s.Velocity, s.Time, dt, _ballRadius + Width(bend) + bendOfStep);
    }

    /// <summary>Searches for a new tube for the ball.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="spinRate">Its spin, rad/s.</param>
    /// <param name="dt">Length of its step, s.</param>
    /// <param name="longest">Longest step for which the tube is valid, s.</param>
    /// <param name="ahead">Time to search ahead, s.</param>
    /// <param name="spare">Extra free margin, m: as much as a query for one step needs.</param>
    /// <param name="airSpeed">Air speed up to which the deviations below hold, m/s.</param>
    /// <param name="bendOfStep">Maximum deviation from a straight line in the longest step, m.</param>
    /// <param name="bend">Maximum deviation over the whole time ahead, m; typically half of it is reached.</param>
    /// <returns>True if it covers the step.</returns>
    public bool Renew(in BallState s, double spinRate, double dt, double longest, double ahead, double spare, double airSpeed, double bendOfStep, double bend)
    {
        _width = Width(bend);
        _from = s.Position;
        _velocity = s.Velocity;
        _spinRate = spinRate;
        _airSpeedSquared = airSpeed * airSpeed;
        _time = s.Time;
        _longestStep = longest;
        _moves = _bodies.Moves;
        _duration = _bodies.FreeFor(in _from, in _velocity, _time, ahead, _ballRadius + _width + spare + bendOfStep);
        return dt <= _duration;
    }
}
