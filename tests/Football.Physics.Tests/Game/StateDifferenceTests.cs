using System.Globalization;
using FootballPhysics.Game;

namespace FootballPhysics.Tests.Game;

/// <summary>How the difference of two states names a field, and writes its two values.</summary>
public sealed class StateDifferenceTests
{
    /// <summary>The fields that are flags or indices. All others are numbers.</summary>
    private static readonly string[] s_whole = ["motion", "dragRegion", "carrier", "nets", "netSides", "goalsPassed", "clearIn", "goalsEntered", "reserved", "reservedToo"];

    public static TheoryData<int> Fields => [.. Enumerable.Range(0, StateFields.Count)];

    [Theory]
    [MemberData(nameof(Fields))]
    public void A_field_has_its_own_name_and_values_of_its_own_kind(int field)
    {
        BallState before = new Simulator().Launch(new Vector3d(1, 2, 3), new Vector3d(4, 5, 6), new Vector3d(7, 8, 9));
        BallState after = before;
        var change = new Change(field);
        StateFields.Visit(ref after, ref change);

        StateDifference difference = Assert.NotNull(Snapshot.Difference(in before, in after));
        string name = StateFields.NameOf(field).Name;
        Assert.Equal(name, difference.Field);
        Assert.Equal(field, StateFields.IndexOf(name));
        if (s_whole.Contains(name))
        {
            Assert.Equal((change.Before + 1).ToString(CultureInfo.InvariantCulture), difference.Actual);
            Assert.Equal(change.Before.ToString(CultureInfo.InvariantCulture), difference.Expected);
            Assert.Equal(0UL, difference.Ulps);
            Assert.DoesNotContain("ulp", difference.ToString(), StringComparison.Ordinal);
        }
        else
        {
            double value = BitConverter.UInt64BitsToDouble(change.Before);
            Assert.Equal(value, double.Parse(difference.Expected, CultureInfo.InvariantCulture));
            Assert.Equal(BitConverter.UInt64BitsToDouble(change.Before + 1), double.Parse(difference.Actual, CultureInfo.InvariantCulture));
            Assert.Equal(1UL, difference.Ulps);
            Assert.EndsWith(", 1 ulp apart", difference.ToString(), StringComparison.Ordinal);
        }
    }

    /// <summary>Adds 1 to the bits of one field.</summary>
    private struct Change(int field) : IFieldVisitor
    {
        private int _at;

        public ulong Before { get; private set; }

        public void Number(ref double value)
        {
            ulong bits = BitConverter.DoubleToUInt64Bits(value);
            Bits(ref bits);
            value = BitConverter.UInt64BitsToDouble(bits);
        }

        public void Member(ref int value)
        {
            ulong bits = (ulong)value;
            Bits(ref bits);
            value = (int)bits;
        }

        public void Bits(ref ulong value)
        {
            if (_at++ == field)
            {
                Before = value;
                value++;
            }
        }
    }
}
