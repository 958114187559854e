using System.Reflection;
using System.Runtime.CompilerServices;
using FootballPhysics.Game;
using FsCheck.Fluent;
using FsCheck;

namespace FootballPhysics.Tests.Game;

public sealed class SnapshotTests
{
    [Fact]
    public void Hash_comparison_and_bytes_see_every_field_of_the_state()
    {
        var scalars = new List<FieldInfo[]>();
        Collect(typeof(BallState), [], scalars);
        Assert.Equal(StateFields.Count, scalars.Count);

        // A time until which the way is free needs the key of the scene.
        BallState state = Flying();
        state.ClearIn = 1;
        foreach (FieldInfo[] path in scalars)
        {
            BallState changed = Changed(state, path);
            string name = string.Join('.', path.Select(f => f.Name));
            Assert.True(Snapshot.Hash(state) != Snapshot.Hash(changed), name);
            Assert.False(Snapshot.Same(state, changed), name);
            var bytes = new byte[Snapshot.Size];
            Snapshot.Write(changed, bytes);
            if (name.EndsWith("Motion>k__BackingField", StringComparison.Ordinal))
            {
                Assert.Throws<FormatException>(() => Snapshot.Read(bytes));
                continue;
            }

            Assert.True(Snapshot.Same(name.StartsWith(nameof(BallState.Reserved), StringComparison.Ordinal) ? state : changed, Snapshot.Read(bytes)), name);
        }
    }

    /// <summary>Two programs that exchange bytes read the same of them: time, place, velocity first, little-endian; what a ball is in comes in its place.</summary>
    [Fact]
    public void The_bytes_of_a_ball_in_a_net_have_each_field_in_its_place()
    {
        var ball = new Ball(new Simulator(Pitch.Standard.On()));
        ball.Place(new Vector3d(1, 0.11, -46));
        ball.Kick(new Vector3d(1, 4, -24), new Vector3d(20, 30, -10));
        for (int i = 0; i < 300 && ball.State.Nets == 0; i++)
        {
            ball.Step(1.0 / 60.0);
        }

        BallState state = ball.State;
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(state, bytes);
        Assert.Equal(state.Time, BitConverter.ToDouble(bytes, 0));
        Assert.Equal(state.Position.X, BitConverter.ToDouble(bytes, 8));
        Assert.Equal(state.Position.Z, BitConverter.ToDouble(bytes, 24));
        Assert.Equal(state.Velocity.Y, BitConverter.ToDouble(bytes, 40));
        Assert.NotEqual(0UL, state.Nets);
        Assert.NotEqual(state.Nets, state.NetSides);
        Assert.Equal(state.Nets, BitConverter.ToUInt64(bytes, 19 * 8));
        Assert.Equal(state.NetSides, BitConverter.ToUInt64(bytes, 20 * 8));
    }

    [Fact]
    public void One_flipped_bit_anywhere_changes_the_hash()
    {
        BallState state = Flying();
        var words = new ulong[StateFields.Count];
        StateFields.Read(state, words);
        var read = new ulong[StateFields.Count];
        var seen = new HashSet<ulong> { Snapshot.Hash(state) };
        for (int bit = 0; bit < 64 * words.Length; bit++)
        {
            words[bit / 64] ^= 1UL << (bit % 64);
            BallState flipped = default;
            StateFields.Write(words, ref flipped);
            StateFields.Read(flipped, read);
            bool fits = words.AsSpan().SequenceEqual(read);
            words[bit / 64] ^= 1UL << (bit % 64);
            if (fits)
            {
                Assert.True(seen.Add(Snapshot.Hash(flipped)), $"bit {bit}");
            }
        }

        Assert.InRange(seen.Count, 64 * (StateFields.Count - 2), 64 * StateFields.Count);
    }

    [Fact]
    public void Zero_and_minus_zero_are_not_the_same()
    {
        var simulator = new Simulator(Scene.Published);
        BallState a = simulator.Launch(new Vector3d(0.0, 1, 0), Vector3d.Zero, Vector3d.Zero);
        BallState b = simulator.Launch(new Vector3d(-0.0, 1, 0), Vector3d.Zero, Vector3d.Zero);
        Assert.False(Snapshot.Same(a, b));
        Assert.NotEqual(Snapshot.Hash(a), Snapshot.Hash(b));
    }

    [Fact]
    public void Bytes_of_a_state_come_back_as_the_state()
    {
        var states =
            from simulator in Inputs.Simulators
            from kicks in Inputs.Kicks(60)
            select Inputs.Play(Inputs.Runner(simulator, kicks), 90)[90];
        Prop.ForAll(states.ToArbitrary(), state =>
        {
            var bytes = new byte[Snapshot.Size + 3];
            Snapshot.Write(state, bytes);
            Assert.True(Snapshot.Same(state, Snapshot.Read(bytes)));
            Assert.Equal(Snapshot.Hash(state), Snapshot.Hash(Snapshot.Read(bytes)));
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Bytes_that_are_no_state_are_refused()
    {
        var bytes = new byte[Snapshot.Size];
        Assert.Throws<FormatException>(() => Snapshot.Read(bytes));
        Array.Fill(bytes, (byte)0xFF);
        Assert.Throws<FormatException>(() => Snapshot.Read(bytes));
        Assert.Throws<ArgumentException>(() => Snapshot.Read(bytes.AsSpan(1)));
        Assert.Throws<ArgumentException>(() => Snapshot.Write(Flying(), bytes.AsSpan(1)));
    }

    private static BallState Flying()
    {
        var runner = new FixedStepRunner(new Simulator(Scene.Published));
        runner.QueueKick(new Vector3d(3, 8, -22), new Vector3d(5, 30, 2));
        return Inputs.Play(runner, 25)[25];
    }

    /// <summary>The scalars of a type, each as the path of fields that leads to it.</summary>
    private static void Collect(Type type, FieldInfo[] path, List<FieldInfo[]> found)
    {
        foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
        {
            FieldInfo[] longer = [.. path, field];
            if (field.FieldType.IsPrimitive || field.FieldType.IsEnum)
            {
                found.Add(longer);
            }
            else
            {
                Assert.False(RuntimeHelpers.IsReferenceOrContainsReferences<BallState>());
                Collect(field.FieldType, longer, found);
            }
        }
    }

    /// <summary>The state with one scalar slightly different.</summary>
    private static BallState Changed(BallState state, FieldInfo[] path)
    {
        var boxes = new object[path.Length];
        object box = state;
        for (int i = 0; i < path.Length; i++)
        {
            boxes[i] = box;
            box = path[i].GetValue(box)!;
        }

        object value = box switch
        {
            double number => Math.BitIncrement(number),
            Enum member => Enum.ToObject(member.GetType(), (Convert.ToInt32(member) + 1) % 4),
            long number => number + 1,
            ulong bits => bits ^ 1,
            _ => throw new NotSupportedException(box.GetType().Name),
        };
        for (int i = path.Length - 1; i >= 0; i--)
        {
            path[i].SetValue(boxes[i], value);
            value = boxes[i];
        }

        return (BallState)value;
    }
}
