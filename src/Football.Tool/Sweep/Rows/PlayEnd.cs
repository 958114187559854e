namespace FootballPhysics.Tool.Sweep.Rows;

/// <summary>The end of a flight in the scalar simulation.</summary>
internal struct PlayEnd
{
    /// <summary>The index in the names of the ends.</summary>
    public int Kind;

    public double Time;

    public Vector3d Position;

    public Vector3d Velocity;

    public Vector3d Spin;

    public Vector3d VelocityAfter;

    public Vector3d SpinAfter;

    private const int Impact = 0;
    private const int TimeUp = 1;
    private const int Plane = 3;
    private const int Rest = 4;

    public readonly bool IsFinite => double.IsFinite(Time) && Position.IsFinite && Velocity.IsFinite && Spin.IsFinite && VelocityAfter.IsFinite && SpinAfter.IsFinite;

    public static PlayEnd Of(Trajectory path, SweepScene scene)
    {
        if (scene.Plane is { } plane && path.TryGetCrossing(in plane, out PathPoint crossing))
        {
            Vector3d spin = path.Final.Spin;
            return new PlayEnd
            {
                Kind = Plane,
                Time = crossing.Time,
                Position = crossing.Position,
                Velocity = crossing.Velocity,
                Spin = spin,
                VelocityAfter = crossing.Velocity,
                SpinAfter = spin,
            };
        }

        // Other events may follow an impact at the same time.
        BallEventKind? kind = scene.StopAt == SweepStop.Impact ? BallEventKind.Impact : scene.StopAt == SweepStop.Time ? null : BallEventKind.Rest;
        for (int i = path.Events.Count - 1; i >= 0 && kind is not null; i--)
        {
            ref readonly BallEvent last = ref path.Events[i];
            if (last.Kind == kind)
            {
                bool rests = kind == BallEventKind.Rest;
                return new PlayEnd
                {
                    Kind = rests ? Rest : Impact,
                    Time = last.Time,
                    Position = last.Position,
                    Velocity = last.VelocityBefore,
                    Spin = last.SpinBefore,
                    VelocityAfter = rests ? Vector3d.Zero : last.Velocity,
                    SpinAfter = rests ? Vector3d.Zero : last.Spin,
                };
            }
        }

        BallState final = path.Final;
        return new PlayEnd
        {
            Kind = TimeUp,
            Time = final.Time,
            Position = final.Position,
            Velocity = final.Velocity,
            Spin = final.Spin,
            VelocityAfter = final.Velocity,
            SpinAfter = final.Spin,
        };
    }
}
