using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>The nets that a ball is in, its side of each, and the goals that it has entered: the history stored in a state.</summary>
/// <remarks>
/// A placed ball has no history; its nets and goals follow from its position. A kick, and another scene with the same nets and goals, keep
/// the history.
/// </remarks>
internal static class Passages
{
    /// <summary>Sets the nets of a placed ball: those whose slab contains it, on the side of its centre.</summary>
    public static void PutInNets(World world, ref BallState s)
    {
        for (int i = 0; i < world.Nets.Length; i++)
        {
            PutInNet(world, i, ref s);
        }
    }

    /// <summary>Returns the goals whose mouth a placed or kicked ball has entered, one bit each.</summary>
    public static ulong GoalsEnteredAt(World world, in Vector3d position)
    {
        ulong entered = 0;
        for (int i = 0; i < world.Goals.Length; i++)
        {
            entered |= world.Goals[i].IsEntered(in position, world.Ball.Radius) ? 1UL << i : 0;
        }

        return entered;
    }

    /// <summary>Updates the goals of a ball that was displaced in a straight line through a mouth, in or out.</summary>
    public static void PassMouths(World world, ref BallState s, in Vector3d from)
    {
        for (int i = 0; i < world.Goals.Length; i++)
        {
            ulong bit = 1UL << i;

            // In front of the mouth, the ball is outside. Behind the mouth, it is inside if it entered through the opening.
            if (world.Goals[i].BeforeMouth(s.Position) > 0)
            {
                s.GoalsEntered &= ~bit;
            }
            else if ((s.GoalsPassed & bit) == 0 && world.Goals[i].IsEntered(in from, s.Position))
            {
                s.GoalsEntered |= bit;
            }
        }
    }

    /// <summary>Keeps the nets and entered goals of a kicked ball, and resets the goal lines that it has passed.</summary>
    /// <param name="world">The world.</param>
    /// <param name="before">The ball before the kick.</param>
    /// <param name="s">The same ball, kicked.</param>
    public static void Keep(World world, in BallState before, ref BallState s)
    {
        for (int i = 0; i < world.Nets.Length; i++)
        {
            CopyNet(world, i, in before, i, ref s);
        }

        for (int i = 0; i < world.Goals.Length; i++)
        {
            ulong bit = 1UL << i;
            s.GoalsEntered |= world.Goals[i].BeforeMouth(s.Position) <= 0 ? before.GoalsEntered & bit : 0;
        }
    }

    /// <summary>Transfers nets and goals of a ball to another scene: it keeps those in both scenes; new ones treat it as placed.</summary>
    /// <param name="old">The old world.</param>
    /// <param name="world">The new world.</param>
    /// <param name="before">The ball in the old world.</param>
    /// <param name="s">The ball in the new world, without nets and goals.</param>
    public static void Carry(World old, World world, in BallState before, ref BallState s)
    {
        for (int i = 0; i < world.Nets.Length; i++)
        {
            int same = Array.FindIndex(old.Nets, world.Nets[i].IsAt);
            if (same < 0)
            {
                PutInNet(world, i, ref s);
            }
            else
            {
                CopyNet(world, same, in before, i, ref s);
            }
        }

        ulong entered = GoalsEnteredAt(world, s.Position);
        for (int i = 0; i < world.Goals.Length; i++)
        {
            GoalMouth goal = world.Goals[i];
            int same = Array.FindIndex(old.Goals, goal.IsAt);
            s.GoalsEntered |= (same < 0 ? entered >> i & 1 : before.GoalsEntered >> same & 1) << i;
            s.GoalsPassed |= (same < 0 ? 0 : before.GoalsPassed >> same & 1) << i;
        }
    }

    private static void PutInNet(World world, int net, ref BallState s)
    {
        NetSheet sheet = world.Nets[net];
        Vector3d place = sheet.PlaceInFrame(s.Position);
        if (Math.Abs(place.X) <= sheet.HalfLength && Math.Abs(place.Y) <= sheet.HalfWidth && world.Ball.Radius - Math.Abs(place.Z) > ContactTolerances.Touching)
        {
            Set(net, isFront: place.Z >= 0, ref s);
        }
    }

    /// <summary>Copies whether the ball is in a net, unless the ball does not reach the net from that side.</summary>
    private static void CopyNet(World world, int from, in BallState before, int net, ref BallState s)
    {
        bool isIn = (before.Nets >> from & 1) != 0 && world.Nets[net].Depth(s.Position, NetSheet.SideOf(before.NetSides, from)) >= -ContactTolerances.Touching;
        if (isIn)
        {
            Set(net, (before.NetSides >> from & 1) != 0, ref s);
        }
    }

    private static void Set(int net, bool isFront, ref BallState s)
    {
        s.Nets |= 1UL << net;
        s.NetSides = isFront ? s.NetSides | (1UL << net) : s.NetSides & ~(1UL << net);
    }
}
