using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>A smooth segment of one ball's last step: the entire step, or its part before or after the jump in the drag law.</summary>
internal readonly struct LanePiece
{
    private readonly Vector3d _path;
    private readonly Vector3d _velocity;
    private readonly Vector3d _endPath;
    private readonly Vector3d _endVelocity;
    private readonly double _spin;
    private readonly double _endSpin;

    /// <summary>Creates the segment of an entire step.</summary>
    public LanePiece(LaneGroup group, int at, double time, double length)
        : this(group.Now, at, group.Next, at, group.Drift[at], time, length)
    {
    }

    /// <summary>Creates the segment before or after the jump.</summary>
    public LanePiece(LaneGroup group, int at, int crossing, bool first, double time, double length)
        : this(
            first ? group.Now : group.Crossed.Middle,
            first ? at : crossing,
            first ? group.Crossed.Middle : group.Next,
            first ? crossing : at,
            group.Drift[at],
            first ? time : time + (group.Crossed.Share[crossing] * length),
            first ? group.Crossed.Share[crossing] * length : (1.0 - group.Crossed.Share[crossing]) * length)
    {
    }

    [MethodImpl(Hot.Path)]
    private LanePiece(LaneState from, int start, LaneState to, int end, double drift, double time, double length)
    {
        _path = from.Path(start);
        _velocity = from.Velocity(start);
        _endPath = to.Path(end);
        _endVelocity = to.Velocity(end);
        _spin = from.W[start];
        _endSpin = to.W[end];
        Start = time;
        Length = length;
        StartHeight = _path.Y + (drift * time);
        EndHeight = _endPath.Y + (drift * (time + length));
        StartRise = _velocity.Y + drift;
        EndRise = _endVelocity.Y + drift;
    }

    /// <summary>The start time, in s since the launch.</summary>
    public double Start { get; }

    /// <summary>The duration, in s.</summary>
    public double Length { get; }

    /// <summary>The y at the start, including the wind's drift, in m.</summary>
    public double StartHeight { get; }

    /// <summary>The y at the end, including the wind's drift, in m.</summary>
    public double EndHeight { get; }

    /// <summary>The velocity along y at the start, including the wind, in m/s.</summary>
    public double StartRise { get; }

    /// <summary>The velocity along y at the end, including the wind, in m/s.</summary>
    public double EndRise { get; }

    /// <summary>Interpolates displacement and velocity by cubic Hermite polynomials, and the spin linearly.</summary>
    public void At(double time, out Vector3d path, out Vector3d velocity, out double spin)
    {
        var curve = PathSegment.Cubic(in _path, in _velocity, in _endPath, in _endVelocity, Length);
        path = curve.PositionAt(time);
        velocity = curve.VelocityAt(time);
        double s = Length > 0 ? time / Length : 0;
        spin = _spin + (s * (_endSpin - _spin));
    }
}
