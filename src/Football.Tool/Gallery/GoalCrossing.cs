namespace FootballPhysics.Tool.Gallery;

/// <summary>Determines whether a shot is a goal, and by what margin.</summary>
internal static class GoalCrossing
{
    /// <summary>The distance of the ball's centre from the inside of a post below which it touches the post, m.</summary>
    private const double Touching = 0.12;

    /// <summary>Describes the crossing in a sentence.</summary>
    public static string Describe(Flight flight, Goal goal)
    {
        BallEvent? scored = Flight.First(flight.Outcome, item => item.Kind == BallEventKind.Goal);
        Vector3d? crossing = scored?.Position ?? Crossing(flight, goal);
        if (crossing is null)
        {
            return "It does not reach the goal line.";
        }

        // Left and right from the view of the player who shoots.
        double right = Vector3d.Dot(crossing.Value - goal.Center, Vector3d.Cross(-goal.Outward(), Vector3d.Up));
        double post = (0.5 * goal.Width) - Math.Abs(right);
        string side = right > 0 ? "right" : "left";
        string where = Math.Abs(right) < 0.2 * goal.Width ? "in the middle of the goal"
            : post < Touching ? $"off the {side} post"
            : post < 1 ? FormattableString.Invariant($"{100 * Math.Max(0, post):0} cm inside the {side} post")
            : $"in the {side} half of the goal";
        string height = FormattableString.Invariant($"{crossing.Value.Y:0.0} m high");
        return scored is not null ? $"A goal, {where}, {height}."
            : post < 0 ? FormattableString.Invariant($"No goal: {-post:0.0} m wide of the {side} post, {height}.")
            : crossing.Value.Y > goal.Height ? FormattableString.Invariant($"No goal: {crossing.Value.Y - goal.Height:0.0} m over the bar.")
            : $"No goal: it comes to the line {where}, {height}, and not over it.";
    }

    /// <summary>Returns the first point at which the ball crosses the plane of the goal line from the front; null if there is none.</summary>
    private static Vector3d? Crossing(Flight flight, Goal goal)
    {
        Vector3d last = flight.Start;
        foreach (Vector3d place in flight.Legs.SelectMany(leg => leg.Points))
        {
            double from = Vector3d.Dot(last - goal.Center, goal.Outward());
            double to = Vector3d.Dot(place - goal.Center, goal.Outward());
            if (from > 0 && to <= 0)
            {
                return last + (from / (from - to) * (place - last));
            }

            last = place;
        }

        return null;
    }
}
