using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// A straight tube along the way of a ball in which no body was found, for some time. Until a ball leaves it, or bodies have strayed by its width from
/// where they were expected, none of them need be asked. Kept beside the bodies, not with the ball: it changes nothing but what is looked at.
/// </summary>
internal sealed class BodyTube
{
    /// <summary>Its least width, m: what bodies that do not go quite straight may stray.</summary>
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
    private double _strayed;

    public BodyTube(KinematicBodies bodies, double ballRadius)
    {
        _bodies = bodies;
        _ballRadius = ballRadius;
    }

    /// <summary>How wide a tube is in which a ball may go so far from a straight line, m.</summary>
    public static double Width(double bend) => LeastWidth + (0.5 * bend);

    /// <summary>True when a ball stays in it during a step.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="airSpeedSquared">|u|², m²/s².</param>
    /// <param name="spinRate">Spin, rad/s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Holds(in BallState s, double dt, double airSpeedSquared, double spinRate)
    {
        double gone = s.Time - _time;
        if (!(gone >= 0 && gone + dt <= _duration && dt <= _longestStep && spinRate <= _spinRate && airSpeedSquared <= _airSpeedSquared))
        {
            return false;
        }

        // Where it is at the start of the step, and how far its velocity there takes it off until the end: how it bends in between is allowed for.
        double x = Math.Abs(s.Position.X - _from.X - (gone * _velocity.X)) + (dt * Math.Abs(s.Velocity.X - _velocity.X));
        double y = Math.Abs(s.Position.Y - _from.Y - (gone * _velocity.Y)) + (dt * Math.Abs(s.Velocity.Y - _velocity.Y));
        double z = Math.Abs(s.Position.Z - _from.Z - (gone * _velocity.Z)) + (dt * Math.Abs(s.Velocity.Z - _velocity.Z));
        return x + y + z + (_bodies.Strayed - _strayed) <= _width;
    }

    /// <summary>Looks for a new one.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="spinRate">Its spin, rad/s.</param>
    /// <param name="dt">Length of its step, s.</param>
    /// <param name="longest">Length of the longest step that it is good for, s.</param>
    /// <param name="ahead">How far to look, s.</param>
    /// <param name="spare">What is free around it besides, m: as much as a look at one step alone asks for; 0 for that look, which is good for no other step.</param>
    /// <param name="airSpeed">The air speed up to which the ball goes no farther from a straight line than that, m/s.</param>
    /// <param name="bendOfStep">How far the ball may go from a straight line in the longest step, m.</param>
    /// <param name="bend">How far in all the time ahead, m; half of that is the more usual.</param>
    /// <returns>Whether it is long enough for the step.</returns>
    public bool Renew(in BallState s, double spinRate, double dt, double longest, double ahead, double spare, double airSpeed, double bendOfStep, double bend)
    {
        _width = Width(bend);
        var way = new StraightWay(s.Position, s.Velocity, s.Time, ahead, _ballRadius + _width + spare + bendOfStep);
        _from = s.Position;
        _velocity = s.Velocity;
        _spinRate = spinRate;
        _airSpeedSquared = airSpeed * airSpeed;
        _time = s.Time;
        _longestStep = longest;
        _strayed = _bodies.Strayed;
        double free = _bodies.FreeFor(in way);

        // Without room to spare the answer is for this step, and no tube is kept.
        _duration = spare > 0 ? free : -1;
        return dt <= free;
    }
}
