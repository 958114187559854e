namespace Football.Physics.Headless.Gallery;

/// <summary>Where a shot meets the plane of a goal that is looked at from the front. The model has no net: the ball flies on.</summary>
internal static class GoalCrossing
{
    /// <summary>Tells it in a sentence.</summary>
    public static string Describe(Flight flight, double along)
    {
        Vector3d? crossing = Find(flight, along);
        if (crossing is null)
        {
            return "It does not reach the goal.";
        }

        double post = Landmark.GoalHalfWidth - Math.Abs(ViewFrame.Left(crossing.Value));
        double bar = Landmark.GoalHeight - crossing.Value.Y;
        string side = ViewFrame.Left(crossing.Value) > 0 ? "left" : "right";
        return post > 0 && bar > 0
            ? FormattableString.Invariant($"A goal: over the line {post:0.00} m inside the {side} post, {crossing.Value.Y:0.00} m high (the model has no net, so it flies on).")
            : FormattableString.Invariant($"No goal: {Math.Max(0, -post):0.00} m outside the {side} post, {crossing.Value.Y:0.00} m high.");
    }

    private static Vector3d? Find(Flight flight, double along)
    {
        Vector3d last = flight.Start;
        foreach (Vector3d place in flight.Legs.SelectMany(leg => leg.Points))
        {
            double from = ViewFrame.Along(last);
            double to = ViewFrame.Along(place);
            if (from < along && to >= along)
            {
                return last + ((along - from) / (to - from) * (place - last));
            }

            last = place;
        }

        return null;
    }
}
