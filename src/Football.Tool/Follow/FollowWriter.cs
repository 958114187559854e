using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Follow;

/// <summary>Writes the estimate of a filter as a line of JSON.</summary>
internal static class FollowWriter
{
    /// <summary>Returns the line of a point.</summary>
    public static ReadOnlyMemory<byte> Line(BallFilter filter, double ahead, Trajectory path)
    {
        filter.LookAhead(ahead, path);
        BallEstimate estimate = filter.Estimate;
        return ResultWriter.Line(json =>
        {
            BallState state = estimate.State;
            json.WriteNumber("time", state.Time);
            ResultWriter.WriteVector(json, "position", state.Position);
            ResultWriter.WriteVector(json, "velocity", state.Velocity);
            ResultWriter.WriteVector(json, "spin", state.Spin);
            json.WriteStartObject("deviation");
            json.WriteNumber("position", estimate.PositionDeviation);
            json.WriteNumber("velocity", estimate.VelocityDeviation);
            json.WriteNumber("spin", estimate.SpinDeviation);
            json.WriteEndObject();
            json.WriteString("state", Word(state.Motion));
            if (estimate.HasKick)
            {
                json.WriteStartObject("kick");
                json.WriteNumber("time", estimate.KickTime);
                json.WriteNumber("deviation", estimate.KickDeviation);
                json.WriteNumber("probability", estimate.KickProbability);
                json.WriteEndObject();
            }
            else
            {
                json.WriteNull("kick");
            }

            json.WriteBoolean("outlier", estimate.IsOutlier);
            json.WriteBoolean("held", estimate.IsHeld);
            json.WriteStartObject("ahead");
            json.WriteNumber("time", path.EndTime);
            ResultWriter.WriteVector(json, "position", path.Final.Position);
            json.WriteNumber("deviation", filter.DeviationAt(path.EndTime));
            json.WriteEndObject();
        });
    }

    private static string Word(MotionState motion) => motion switch
    {
        MotionState.Airborne => "airborne",
        MotionState.Sliding => "sliding",
        MotionState.Rolling => "rolling",
        _ => "stopped",
    };
}
