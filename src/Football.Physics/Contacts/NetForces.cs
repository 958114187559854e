namespace FootballPhysics.Contacts;

/// <summary>The forces of the nets that a ball is in. A mask has a bit for each of these nets, and a second mask for the ball's side of each.</summary>
/// <param name="sheets">The nets.</param>
internal sealed class NetForces(NetSheet[] sheets)
{
    /// <summary>The longest part of a step in nets, times the rate at which they change the motion.</summary>
    /// <remarks>Each part follows one branch of the forces. A shot into a goal is then 8e-9 m off after 0.3 s with RK4, on average.</remarks>
    private const double Change = 3.0;

    /// <summary>Returns the accelerations by the nets that the ball is in.</summary>
    /// <param name="nets">The nets.</param>
    /// <param name="sides">The ball's side of each.</param>
    /// <param name="slack">The nets that count as slack, so that no force has a kink; if null, the velocity decides.</param>
    /// <param name="at">The ball.</param>
    public MotionRates Push(ulong nets, ulong sides, ulong? slack, in Motion at)
    {
        ulong loose = slack ?? SlackAt(nets, sides, at.Velocity, default);
        Vector3d acceleration = default;
        Vector3d spinAcceleration = default;
        for (int i = 0; i < sheets.Length && nets >> i != 0; i++)
        {
            if ((nets >> i & 1) != 0)
            {
                MotionRates push = sheets[i].Push(in at, NetSheet.SideOf(sides, i), (loose >> i & 1) != 0);
                acceleration += push.Acceleration;
                spinAcceleration += push.SpinAcceleration;
            }
        }

        return new MotionRates(in acceleration, in spinAcceleration);
    }

    /// <summary>Returns the nets that are slack from a state on: 1 + b δ̇ is negative, or zero and decreasing.</summary>
    public ulong SlackAt(ulong nets, ulong sides, in Vector3d velocity, in Vector3d acceleration)
    {
        ulong slack = 0;
        for (int i = 0; i < sheets.Length && nets >> i != 0; i++)
        {
            if ((nets >> i & 1) != 0)
            {
                double side = NetSheet.SideOf(sides, i);
                double tension = sheets[i].Tension(in velocity, side);
                bool isAtKink = Math.Abs(tension) <= ContactTolerances.AtNetSlack;
                slack |= (isAtKink ? sheets[i].TensionRate(in acceleration, side) : tension) < 0 ? 1UL << i : 0;
            }
        }

        return slack;
    }

    /// <summary>Returns the longest piece in nets that at most a number of parts take accurately, in s.</summary>
    public double Longest(ulong nets, ulong sides, in Vector3d position, in Vector3d velocity, int parts = 1)
    {
        // Nets that pull in one direction add up. The greatest depth δ + p v that the ball, of speed v, can reach in the time p, and the rates λ at
        // which the nets settle there, satisfy p Σ λ(δ + p v) = c, the change that a piece allows. This is quadratic in p.
        double change = parts * Change;
        double speed = velocity.Length;
        double rate = 0;
        double bend = 0;
        for (int i = 0; i < sheets.Length && nets >> i != 0; i++)
        {
            if ((nets >> i & 1) != 0)
            {
                rate += sheets[i].RateAt(Math.Max(0, sheets[i].Depth(in position, NetSheet.SideOf(sides, i))));
                bend += sheets[i].RatePerDepth * speed;
            }
        }

        return nets == 0 ? double.PositiveInfinity : 2.0 * change / (rate + Math.Sqrt((rate * rate) + (4.0 * bend * change)));
    }

    /// <summary>Returns the net in which the ball is deepest; −1 if it is in none.</summary>
    public int Deepest(in BallState s)
    {
        int deepest = -1;
        double most = double.NegativeInfinity;
        for (int i = 0; i < sheets.Length && s.Nets >> i != 0; i++)
        {
            double depth = (s.Nets >> i & 1) != 0 ? sheets[i].Depth(s.Position, NetSheet.SideOf(s.NetSides, i)) : double.NegativeInfinity;
            deepest = depth > most ? i : deepest;
            most = Math.Max(most, depth);
        }

        return deepest;
    }
}
