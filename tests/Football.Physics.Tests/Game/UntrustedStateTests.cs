using FootballPhysics.Numerics;
using FootballPhysics.State;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>States that come from elsewhere: what no ball of the scene makes is refused, and what is not refused steps within its bounds.</summary>
public sealed class UntrustedStateTests
{
    private const double Tick = 1.0 / 60;

    /// <summary>docs/troubleshooting.md: the most evaluations, and pieces, of a step.</summary>
    private const long MostEvaluations = 32_768;
    private const long MostPieces = 8_192;

    private static readonly Obstacle s_table = new() { Name = "table", Shape = new BoxShape(new Vector3d(20, 0.4, 0), new Vector3d(1, 0.4, 1)), Surface = SurfaceMaterial.Wood };
    private static readonly Obstacle s_wall = new() { Name = "wall", Shape = new BoxShape(new Vector3d(0, 1, -20), new Vector3d(3, 1, 0.1)) };
    private static readonly Scene s_scene = Pitch.Standard.On(new Scene { Obstacles = [s_table, s_wall] });

    [Theory]
    [InlineData("nets")]
    [InlineData("no such net")]
    [InlineData("sides")]
    [InlineData("no such goal")]
    [InlineData("mouth")]
    [InlineData("passed and entered")]
    [InlineData("air distance")]
    [InlineData("air distance NaN")]
    [InlineData("carrier")]
    [InlineData("carrier far")]
    [InlineData("carrier net")]
    [InlineData("carrier goal")]
    [InlineData("engine")]
    [InlineData("airborne on")]
    [InlineData("rests and moves")]
    [InlineData("clear until")]
    [InlineData("clear without key")]
    [InlineData("clear through a wall")]
    [InlineData("fast in a net")]
    [InlineData("spin and speed")]
    public void What_no_ball_makes_is_refused(string what)
    {
        var simulator = new Simulator(s_scene);
        BallState state = what switch
        {
            "carrier" or "carrier far" or "carrier net" or "carrier goal" or "engine" or "rests and moves" => Resting(simulator, new Vector3d(20, 1, 0)),
            "clear through a wall" => Flying(simulator),
            _ => simulator.Launch(new Vector3d(0, 6, 40), new Vector3d(2, 3, -18), new Vector3d(0, 40, 0)),
        };
        simulator.Validate(in state);
        state = Crafted(what, state);
        Assert.True(IsRefused(simulator, in state), what);
        Assert.Throws<ArgumentOutOfRangeException>(() => new Ball(simulator) { State = state });
        Assert.Throws<ArgumentOutOfRangeException>(() => new FixedStepRunner(simulator).Restore(0, in state));
    }

    /// <summary>Bytes lose what earlier versions stored in the reserved fields; a struct, as C passes it, must not have it.</summary>
    [Theory]
    [InlineData(1, 0)]
    [InlineData(0, 1UL << 63)]
    public void A_state_with_reserved_fields_is_refused(ulong reserved, ulong too)
    {
        var simulator = new Simulator(s_scene);
        BallState state = Flying(simulator);
        state.Reserved = reserved;
        state.ReservedToo = too;
        Assert.Contains("state.reserved", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Validate(in state)).Message);
        Assert.Throws<ArgumentOutOfRangeException>(() => new Ball(simulator) { State = state });
    }

    /// <summary>The message states the bits, the position and the distance that do not fit.</summary>
    [Theory]
    [InlineData("nets", "^state.nets is 0x2; allowed: the nets that a ball at ")]
    [InlineData("no such net", "^state.nets is 0x10000000000; allowed: bits of the 8 nets of the scene")]
    [InlineData("no such goal", "^state.goals is 0x4; allowed: bits of the 2 goals of the scene")]
    [InlineData("mouth", "^state.goalsEntered is 0x1; allowed: the goals in whose mouth a ball at ")]
    [InlineData("passed and entered", "^state.goalsEntered is 0x1; allowed: goals whose line the ball has not passed")]
    [InlineData("carrier far", "^state.position is .* touches \"table\", which carries it; (3|2.99+[0-9]*|3.00+[0-9]*) m are between")]
    [InlineData("carrier net", "^state.carrier is [0-9]+; allowed: a thing that can carry the ball")]
    public void The_message_states_the_numbers_that_do_not_fit(string what, string message)
    {
        var simulator = new Simulator(s_scene);
        BallState state = what.StartsWith("carrier", StringComparison.Ordinal)
            ? Resting(simulator, new Vector3d(20, 1, 0))
            : simulator.Launch(new Vector3d(0, 6, 40), new Vector3d(2, 3, -18), new Vector3d(0, 40, 0));
        BallState crafted = Crafted(what, state);
        Assert.Matches(message, Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Validate(in crafted)).Message);
    }

    private static BallState Crafted(string what, BallState state)
    {
        switch (what)
        {
            case "nets":
                state.Position = new Vector3d(0, 1e4, 0);
                state.Nets = 2;
                break;
            case "no such net":
                state.Nets = 1UL << 40;
                break;
            case "sides":
                state.NetSides = 1UL << 63;
                break;
            case "no such goal":
                state.GoalsPassed = 4;
                break;
            case "mouth":
                state.GoalsEntered = 1;
                break;
            case "passed and entered":
                state.Position = new Vector3d(0, 1, -52.6);
                state.GoalsEntered = 1;
                state.GoalsPassed = 1;
                break;
            case "air distance":
                state.AirDistance = -1;
                break;
            case "air distance NaN":
                state.AirDistance = double.NaN;
                break;
            case "carrier":
                state.Carrier = 0;
                break;
            case "carrier far":
                state.Position += new Vector3d(0, 3, 0);
                break;
            case "carrier net":
                state.Carrier = new Simulator(s_scene).World.ThingOfNet(0);
                break;
            case "carrier goal":
                state.Carrier = new Simulator(s_scene).World.ThingOfGoal(0);
                break;
            case "engine":
                state.Carrier = EngineCollider.FirstNumber + 7;
                break;
            case "airborne on":
                state.Carrier = 1;
                break;
            case "rests and moves":
                state.Velocity = new Vector3d(1, 0, 0);
                break;
            case "clear until":
                state.ClearIn = 1;
                state.ClearUntil = double.PositiveInfinity;
                break;
            case "clear without key":
                state.ClearIn = 0;
                state.ClearUntil = 1;
                break;
            case "clear through a wall":
                // The key is that of the scene: the ball would fly through the wall.
                Assert.NotEqual(0UL, state.ClearIn);
                state.ClearUntil = state.Time + 3;
                break;
            case "fast in a net":
                state.Position = new Vector3d(0, 1, -54);
                state.Velocity = new Vector3d(0, 0, -1e24);
                state.Nets = 1;
                break;
            case "spin and speed":
                // Each is within its own bound.
                state.Velocity = new Vector3d(0, 0, 9e29);
                state.SetFlightSpin(new Vector3d(0, 9e30, 0));
                break;
        }

        return state;
    }

    /// <summary>Every state of plays of all kinds is one that a ball can have.</summary>
    [Theory]
    [ProfileData]
    public void What_a_ball_makes_is_not_refused(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", BodyKind.Player);
        var belt = new Obstacle { Name = "belt", Shape = new BoxShape(new Vector3d(-20, 0.4, 0), new Vector3d(5, 0.4, 5)), Velocity = new Vector3d(0.1, 0, 0.1), Spin = new Vector3d(0, 0.2, 0) };
        Scene[] scenes =
        [
            Pitch.Stadium.On(profile.Scene() with { Obstacles = [s_table, s_wall, belt], Bodies = bodies }),
            Pitch.Standard.On(profile.Scene() with { Obstacles = [s_table, s_wall, belt] }),
            profile.Scene() with { Ground = profile.Scene().Ground with { Normal = new Vector3d(0.02, 1, 0.01) }, Obstacles = [s_table, s_wall, belt] },
        ];
        int nets = 0;
        int carried = 0;
        foreach (Scene scene in scenes)
        {
            var simulator = new Simulator(scene);
            var log = new StepLog();
            for (int i = 0; i < 40; i++)
            {
                double a = SplitMix64.At(i, 0);
                double b = SplitMix64.At(i, 1);
                bool drops = i % 4 == 3;
                var from = drops ? new Vector3d(i % 8 == 3 ? 20 : -20, 1.5, a - 0.5) : new Vector3d((a - 0.5) * 20, 0.3, -45 + (10 * b));
                var velocity = drops ? new Vector3d(a - 0.5, 0, b - 0.5) : new Vector3d((b - 0.5) * 8, 3 * a, -5 - (25 * b));
                BallState ball = simulator.Launch(from, velocity, new Vector3d(0, 30 * (a - 0.5), 0));
                for (int tick = 0; tick < 240; tick++)
                {
                    player.MoveTo(new Vector3d(ball.Position.X + 0.5 - (0.01 * tick), 0, ball.Position.Z), new Vector3d(-0.6, 0, 0), ball.Time);
                    log.Clear();
                    simulator.Step(ref ball, i % 3 == 0 ? 0.004 : Tick, log);
                    simulator.Validate(in ball);
                    BallState read = Snapshot.Read(Bytes(in ball));
                    Assert.True(Snapshot.Same(in ball, in read));
                    nets += ball.Nets != 0 ? 1 : 0;
                    carried += ball.Carrier > 0 ? 1 : 0;
                }
            }
        }

        // They have been in nets and on things.
        Assert.True(nets > 500, $"{nets} ticks in nets");
        Assert.True(carried > 500, $"{carried} ticks on things");
    }

    /// <summary>A state of any speed in a net, and of any spin, is refused at once, or stays valid in the steps that follow.</summary>
    [Theory]
    [ProfileData]
    public void What_is_taken_stays_valid(Profile profile)
    {
        var simulator = new Simulator(Pitch.Standard.On(profile.Scene()));
        int taken = 0;
        int refused = 0;
        for (int i = 0; i < 300; i++)
        {
            double Draw(int field, double low, double high) => low + ((high - low) * SplitMix64.At(i, field));
            double Log(int field, double low, double high) => Math.Exp(Draw(field, Math.Log(low), Math.Log(high)));
            Vector3d Any(int field) => new Vector3d(Draw(field, -1, 1), Draw(field + 1, -1, 1), Draw(field + 2, -1, 1)).Normalized();
            var log = new StepLog();
            BallState state = simulator.Launch(new Vector3d(Draw(0, -2, 2), Draw(1, 0.11, 2), -53.4), new Vector3d(0, 1, -20), default);
            for (int k = 0; k < 30 && state.Nets == 0; k++)
            {
                simulator.Step(ref state, Tick, log);
            }

            state.Velocity = Log(2, 1, i % 3 == 0 ? 1e30 : 3e5) * Any(3);
            state.Position += Log(6, 0.01, i % 2 == 0 ? 1 : 1e4) * Any(7);
            if (i % 4 == 0)
            {
                state.SetFlightSpin(Log(10, 1, 1e35) * Any(11));
            }

            state.ClearUntil = 0;
            if (IsRefused(simulator, in state))
            {
                refused++;
                continue;
            }

            taken++;
            for (int k = 0; k < 3; k++)
            {
                simulator.Step(ref state, i % 2 == 0 ? Tick : 0.2, log);
                simulator.Validate(in state);
            }
        }

        Assert.True(taken > 60 && refused > 60, $"{taken} taken, {refused} refused");
    }

    /// <summary>Fields drawn at random, sealed with the right checksum: what is not refused takes a bounded step to a finite state.</summary>
    [Fact]
    public void What_is_not_refused_steps_within_its_bounds()
    {
        var stiff = new Net { Name = "stiff", Center = new Vector3d(0, 2, 0), Normal = new Vector3d(0, 0, 1), Along = new Vector3d(1, 0, 0), HalfLength = 500, HalfWidth = 500, Stiffness = 1e5, Damping = 100, TangentialDamping = 1e4, SpinDamping = 10 };
        Simulator[] simulators =
        [
            new(s_scene with { Forces = ForceSet.Measured with { KnuckleSeed = 3 } }),
            new(Pitch.Stadium.On()),
            new(new Scene { Nets = [stiff, stiff with { Normal = new Vector3d(1, 0, 0), Along = new Vector3d(0, 0, 1), Stiffness = 0 }] }),
            new(new Scene { Ground = Ground.None, Obstacles = [s_table] }),
        ];
        int accepted = 0;
        for (int i = 0; i < 20_000; i++)
        {
            Simulator simulator = simulators[i % simulators.Length];
            BallState state = Drawn(simulator, i);
            if (IsRefused(simulator, in state))
            {
                continue;
            }

            accepted++;
            var log = new StepLog();
            for (int step = 0; step < 2; step++)
            {
                log.Clear();
                simulator.Step(ref state, Tick, log);
                Assert.True(log.Evaluations <= MostEvaluations, $"{i}: {log.Evaluations} evaluations");
                Assert.True(log.Steps <= MostPieces, $"{i}: {log.Steps} pieces");
                Assert.True(state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite, $"{i}: {state}");
            }
        }

        Assert.InRange(accepted, 2_000, 18_000);
    }

    private static BallState Drawn(Simulator simulator, int i)
    {
        int draw = 10;
        double size = Math.Pow(10, (6 * U()) - 1);
        BallState state = simulator.Launch(Limited(size * V(), 1e6), Limited(Math.Pow(10, (8 * U()) - 4) * V(), 1000), Limited(Math.Pow(10, 5 * U()) * V(), 9000));
        if (U() < 0.3)
        {
            state.Velocity = Math.Pow(10, (12 * U()) - 4) * V();
        }

        state.Nets = Flags(0.4);
        state.NetSides = Flags(0.4);
        state.GoalsEntered = Flags(0.2) & 3;
        state.GoalsPassed = Flags(0.2) & 3;
        state.Time = U() < 0.5 ? 0 : Math.Pow(10, 8 * U());
        state.AirDistance = U() < 0.7 ? 0 : Math.Pow(10, 12 * U());
        state.Branch = (DragBranch)(int)(5 * U());
        if (U() < 0.3)
        {
            state.Motion = (MotionState)(int)(5 * U());
            state.SetGroundSpin(Math.Pow(10, (6 * U()) - 2) * V());
            state.Carrier = (int)(4 * U());
        }

        return state;

        double U() => SplitMix64.At(i, draw++);

        Vector3d V() => new((2 * U()) - 1, (2 * U()) - 1, (2 * U()) - 1);

        ulong Flags(double chance) => U() < chance ? (ulong)(16 * U()) : 0;

        static Vector3d Limited(Vector3d v, double most) => v.Length > most ? (0.5 * most / v.Length) * v : v;
    }

    private static BallState Resting(Simulator simulator, Vector3d from)
    {
        BallState ball = simulator.Launch(from, Vector3d.Zero, Vector3d.Zero);
        simulator.Run(ref ball, Tick, 20, StopAt.Rest, new StepLog());
        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.True(ball.Carrier > 0);
        return ball;
    }

    /// <summary>A ball on its way to the wall, with what it has found to be free.</summary>
    private static BallState Flying(Simulator simulator)
    {
        BallState ball = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 0.5, -15), Vector3d.Zero);
        simulator.Step(ref ball, Tick, new StepLog());
        Assert.True(ball.ClearUntil > ball.Time);
        return ball;
    }

    private static byte[] Bytes(in BallState state)
    {
        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(in state, bytes);
        return bytes;
    }

    private static bool IsRefused(Simulator simulator, in BallState state)
    {
        try
        {
            BallState read = Snapshot.Read(Bytes(in state));
            simulator.Validate(in read);
            return false;
        }
        catch (Exception refusal) when (refusal is FormatException or ArgumentOutOfRangeException)
        {
            return true;
        }
    }
}
