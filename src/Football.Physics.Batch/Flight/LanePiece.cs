using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>A smooth piece of one ball's last step: the whole of it, or up to the drag law's jump, or from there.</summary>
internal readonly struct LanePiece
{
    private readonly Vector3d _path;
    private readonly Vector3d _velocity;
    private readonly Vector3d _endPath;
    private readonly Vector3d _endVelocity;
    private readonly double _spin;
    private readonly double _endSpin;

    /// <summary>The whole step.</summary>
    public LanePiece(LaneGroup group, int at, double time, double length)
        : this(group.Now, at, group.Next, at, group.Drift[at], time, length)
    {
    }

    /// <summary>The part before the jump, or after it.</summary>
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

    /// <summary>When it starts, s after the launch.</summary>
    public double Start { get; }

    /// <summary>How long it lasts, s.</summary>
    public double Length { get; }

    /// <summary>Way along y at its start, the wind's part included, m.</summary>
    public double StartHeight { get; }

    /// <summary>Height at its end.</summary>
    public double EndHeight { get; }

    /// <summary>Velocity along y at its start, the wind's included, m/s.</summary>
    public double StartRise { get; }

    /// <summary>Rate of climb at its end.</summary>
    public double EndRise { get; }

    /// <summary>Cubic Hermite interpolation of way and velocity; the spin linearly.</summary>
    public void At(double time, out Vector3d path, out Vector3d velocity, out double spin)
    {
        var curve = new CubicHermite3d(in _path, in _velocity, in _endPath, in _endVelocity, Length);
        path = curve.PositionAt(time);
        velocity = curve.VelocityAt(time);
        double s = Length > 0 ? time / Length : 0;
        spin = _spin + (s * (_endSpin - _spin));
    }
}
