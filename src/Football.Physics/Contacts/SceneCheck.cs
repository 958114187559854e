using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>Validates that a state read from elsewhere fits a scene: its references exist, and the position of the ball is
/// possible.</summary>
/// <remarks>Moved and pushed objects may have any position, because a state does not store them.</remarks>
internal static class SceneCheck
{
    /// <summary>Maximum speed of a ball in a net, m/s, if it had no spin: more than the highest fall gives. A faster ball tears through.</summary>
    private const double FastestInNets = 2e5;
    private const double MostInNets = FastestInNets * FastestInNets;

    /// <summary>Maximum distance behind the line of a ball that entered a goal without passing the line, m.</summary>
    /// <remarks>An object may have pushed it there.</remarks>
    private const double BehindLine = 2.0;

    /// <summary>Returns the field of a state that does not fit the scene, with its value and the allowed values; null if the state
    /// fits.</summary>
    public static (string Field, string Value, string Allowed)? Fault(in BallState s, World world)
    {
        // A contact may turn spin into speed, so their energy has a common bound: v² + α r² ω², with the inertia factor α.
        double square = EnergyOf(in s, world);
        if (!(square <= StateCheck.FastestSpeed * StateCheck.FastestSpeed))
        {
            return ("state.spin", s.Spin.ToString("R", null), FormattableString.Invariant($"with the velocity, the energy of at most {StateCheck.FastestSpeed:R} m/s"));
        }

        // Fast path for the most common state: on level ground or in the air, not in a net or a goal.
        bool isInAny = (s.Nets | s.NetSides | s.GoalsEntered | s.GoalsPassed) != 0;
        if (!isInAny && s.Carrier == 0 && (s.Motion == MotionState.Airborne || (world.IsLevel && Math.Abs(s.Position.Y - world.LevelContact) <= ContactTolerances.CarrierDistance)))
        {
            return null;
        }

        if (isInAny && FaultOfPassages(in s, square, world) is { } passage)
        {
            return passage;
        }

        return s.Motion == MotionState.Airborne && s.Carrier == 0 ? null : FaultOfCarrier(in s, world);
    }

    /// <summary>True if a ball is too fast for any net.</summary>
    public static bool TearsNets(in BallState s, World world) => EnergyOf(in s, world) > MostInNets;

    /// <summary>v² + α r² ω², m²/s².</summary>
    private static double EnergyOf(in BallState s, World world) =>
        s.Velocity.LengthSquared + (world.Ball.InertiaFactor * world.Ball.Radius * world.Ball.Radius * s.Spin.LengthSquared);

    private static (string Field, string Value, string Allowed)? FaultOfPassages(in BallState s, double square, World world)
    {
        if (!IsWithin(s.Nets | s.NetSides, world.Nets.Length))
        {
            return ("state.nets", Text(s.Nets | s.NetSides), $"bits of the {world.Nets.Length} nets of the scene");
        }

        if (!IsWithin(s.GoalsEntered | s.GoalsPassed, world.Goals.Length))
        {
            return ("state.goals", Text(s.GoalsEntered | s.GoalsPassed), $"bits of the {world.Goals.Length} goals of the scene");
        }

        // The net takes the ball's energy: the deeper it is, the slower. So a state that is taken here stays valid in the net.
        double left = MostInNets - square;
        if (s.Nets != 0 && !(left >= 0))
        {
            return ("state.velocity", s.Velocity.ToString("R", null), FormattableString.Invariant($"with the spin, the energy of at most {FastestInNets:R} m/s in a net"));
        }

        for (int i = 0; i < world.Nets.Length && s.Nets >> i != 0; i++)
        {
            // The ball's momentum may carry it into the net, even past the net's edges: allow for this distance.
            if ((s.Nets >> i & 1) != 0 && world.Nets[i].PlaceInFrame(s.Position).Length > world.Nets[i].FarthestIn(Math.Sqrt(left)))
            {
                return ("state.nets", Text(s.Nets), $"the nets that a ball at {s.Position.ToString("R", null)} can be in");
            }
        }

        for (int i = 0; i < world.Goals.Length && s.GoalsEntered >> i != 0; i++)
        {
            // The ball must be behind the mouth, and in front of the goal line.
            double before = world.Goals[i].BeforeMouth(s.Position);
            if ((s.GoalsEntered >> i & 1) != 0 && !(before <= Tolerance(in s) && world.Goals[i].BeforeLine(s.Position, world.Ball.Radius) >= -BehindLine))
            {
                return ("state.goalsEntered", Text(s.GoalsEntered), $"the goals in whose mouth a ball at {s.Position.ToString("R", null)} can be");
            }
        }

        return (s.GoalsEntered & s.GoalsPassed) != 0 ? ("state.goalsEntered", Text(s.GoalsEntered), "goals whose line the ball has not passed") : null;
    }

    private static (string Field, string Value, string Allowed)? FaultOfCarrier(in BallState s, World world)
    {
        long index = s.Carrier - world.FirstCollider;
        if (s.Motion == MotionState.Airborne || (s.Motion == MotionState.Pinned && s.Carrier == 0))
        {
            // The ball has no carrier.
            return s.Carrier == 0 ? null : Carrier(in s, "0 for a ball that nothing carries");
        }

        // In a pile, other balls may carry a ball at rest. Its group checks that they still touch it.
        if (s.Carrier == 0 && s.RestsInPile && !(world.Ground is { } ground && ground.At(s.Position, s.Time).Distance - world.Ball.Radius < -Tolerance(in s)))
        {
            return null;
        }

        if (s.Carrier >= EngineCollider.FirstNumber)
        {
            return world.Engine is null ? Carrier(in s, "one of the scene's things") : null;
        }

        // The carrier is a net, so the ball must be at rest in that net. The end of a net is a collider.
        long net = s.Carrier - world.ThingOfNet(0);
        bool isEnd = world.IsNetEnd(index);
        if (net >= 0 && !(isEnd && world.ActsOn(index, in s)))
        {
            bool hangs = s.Motion == MotionState.Rest && net < world.Nets.Length && (s.Nets >> (int)net & 1) != 0;
            return hangs ? null : Carrier(in s, "a thing that can carry the ball");
        }

        if (index < 0 || (world.Engine is not null && world.Engine.Has((int)index)))
        {
            return Carrier(in s, "a thing that can carry the ball");
        }

        // The state does not contain the positions of moved or pushed objects: do not check the distance to them.
        Collider carrier = world.ByIndex[index];
        if (world.Ignores(carrier))
        {
            return Carrier(in s, "a thing of a layer that the ball does not ignore");
        }

        if (carrier.IsBody || carrier.GivesWay || s.Motion == MotionState.Pinned)
        {
            return null;
        }

        double gap = carrier.At(s.Position, s.Time).Distance - world.Ball.Radius;
        if (!(Math.Abs(gap) <= Tolerance(in s)))
        {
            return ("state.position", s.Position.ToString("R", null), $"a place where the ball touches \"{carrier.Name}\", which carries it; {Text(gap)} m are between");
        }

        // A resting ball must move along with its carrier.
        Vector3d along = carrier.MaterialVelocity(s.Position, s.Time);
        return s.Motion == MotionState.Rest && !((s.Velocity - along).Length <= ContactTolerances.CarrierDistance * (1.0 + along.Length))
            ? ("state.velocity", s.Velocity.ToString("R", null), $"that of \"{carrier.Name}\" at a ball that rests on it")
            : null;
    }

    private static (string Field, string Value, string Allowed) Carrier(in BallState s, string allowed) =>
        ("state.carrier", s.Carrier.ToString(System.Globalization.CultureInfo.InvariantCulture), allowed);

    private static double Tolerance(in BallState s) =>
        ContactTolerances.CarrierDistance * (1.0 + Math.Max(Math.Abs(s.Position.X), Math.Max(Math.Abs(s.Position.Y), Math.Abs(s.Position.Z))) * 1e-3);

    private static bool IsWithin(ulong bits, int count) => count >= 64 || bits >> count == 0;

    private static string Text(ulong bits) => "0x" + bits.ToString("x", System.Globalization.CultureInfo.InvariantCulture);

    private static string Text(double value) => value.ToString("R", System.Globalization.CultureInfo.InvariantCulture);
}
