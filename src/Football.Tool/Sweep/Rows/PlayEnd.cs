namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>The end of a flight in the scalar simulation.</summary>
/// <param name="Kind">The index in the names of the ends.</param>
/// <param name="Time">The time, in s.</param>
/// <param name="Position">The position of the centre, in m.</param>
/// <param name="Velocity">The velocity just before the end, in m/s.</param>
/// <param name="Spin">The spin just before the end, in rad/s.</param>
/// <param name="VelocityAfter">The velocity just after the end, in m/s.</param>
/// <param name="SpinAfter">The spin just after the end, in rad/s.</param>
internal readonly record struct PlayEnd(int Kind, double Time, Vector3d Position, Vector3d Velocity, Vector3d Spin, Vector3d VelocityAfter, Vector3d SpinAfter)
{
    private const int Impact = 0;
    private const int TimeUp = 1;
    private const int Plane = 3;
    private const int Rest = 4;

    public bool IsFinite => double.IsFinite(Time) && Position.IsFinite && Velocity.IsFinite && Spin.IsFinite && VelocityAfter.IsFinite && SpinAfter.IsFinite;

    public static PlayEnd Of(Trajectory path, SweepScene scene)
    {
        if (scene.Plane is { } plane && path.TryGetCrossing(in plane, out PathPoint crossing))
        {
            Vector3d spin = path.Final.Spin;
            return new PlayEnd(Plane, crossing.Time, crossing.Position, crossing.Velocity, spin, crossing.Velocity, spin);
        }

        // Other events may follow an impact at the same time.
        BallEventKind? kind = scene.StopAt == SweepStop.Impact ? BallEventKind.Impact : scene.StopAt == SweepStop.Time ? null : BallEventKind.Rest;
        for (int i = path.Events.Count - 1; i >= 0 && kind is not null; i--)
        {
            ref readonly BallEvent last = ref path.Events[i];
            if (last.Kind == kind)
            {
                return kind == BallEventKind.Rest
                    ? new PlayEnd(Rest, last.Time, last.Position, last.VelocityBefore, last.SpinBefore, Vector3d.Zero, Vector3d.Zero)
                    : new PlayEnd(Impact, last.Time, last.Position, last.VelocityBefore, last.SpinBefore, last.Velocity, last.Spin);
            }
        }

        BallState final = path.Final;
        return new PlayEnd(TimeUp, final.Time, final.Position, final.Velocity, final.Spin, final.Velocity, final.Spin);
    }
}
