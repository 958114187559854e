using FootballPhysics.Numerics;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Numerics;

/// <summary>The root finders on functions whose roots are known, kind ones and unkind ones.</summary>
public sealed class RootsTests
{
    [Fact]
    public void Newton_finds_the_root_of_a_falling_cubic_to_rounding()
    {
        var random = new Shots(21);
        for (int i = 0; i < 1000; i++)
        {
            // (r − x)(x² + b) is positive below r.
            double r = random.Uniform(0.05, 0.95);
            var f = new Cubic { Root = r, B = random.Uniform(0.1, 2) };
            double found = Roots.Newton(ref f, 0, 1, random.Uniform(0, 1));
            Assert.Equal(r, found, 1e-13);
            Assert.InRange(f.Evaluations, 1, 12);
        }
    }

    [Fact]
    public void Newton_stays_in_its_bracket_where_the_tangent_leads_out_of_it()
    {
        // Far from the root the tangent of atan is flat: Newton alone diverges.
        var f = new Arctangent { Root = 3 };
        double found = Roots.Newton(ref f, -1000, 1000, -999, closeness: 1e-12);
        Assert.Equal(3, found, 1e-11);
        Assert.InRange(f.Lowest, -1000, 1000);
        Assert.InRange(f.Highest, -1000, 1000);
    }

    [Fact]
    public void Newton_bisects_where_there_is_no_slope()
    {
        var f = new Jump { At = 0.3 };
        Assert.Equal(0.3, Roots.Newton(ref f, 0, 1, 1, closeness: 1e-12), 1e-11);
    }

    [Fact]
    public void Newton_ends_where_the_function_says_so()
    {
        var f = new Jump { At = 0.3, CloseEnough = 0.1 };
        double found = Roots.Newton(ref f, 0, 1, 1);
        Assert.InRange(found, 0.2, 0.4);
        Assert.Equal(found, f.Last);
    }

    [Fact]
    public void Illinois_finds_roots_that_regula_falsi_alone_creeps_towards()
    {
        var random = new Shots(22);
        for (int i = 0; i < 1000; i++)
        {
            // x⁵ − r⁵ is so curved that plain regula falsi keeps one end for good.
            double r = random.Uniform(0.1, 0.9);
            var f = new FifthPower { Root = r };
            double found = Roots.Illinois(ref f, 0, f.Value(0), 1, f.Value(1), 1e-14, 100);
            Assert.Equal(r, found, 1e-13);
            Assert.InRange(f.Evaluations, 1, 35);

            f = new FifthPower { Root = r };
            Assert.Equal(r, Roots.Illinois(ref f, 1, f.Value(1), 0, f.Value(0), 1e-14, 100), 1e-13);
        }
    }

    [Fact]
    public void Illinois_begins_with_an_end_whose_value_nobody_knows()
    {
        var f = new FifthPower { Root = 0.37 };
        Assert.Equal(0.37, Roots.Illinois(ref f, 0, double.NaN, 1, f.Value(1), 1e-13, 100), 1e-12);
    }

    [Fact]
    public void Bisection_halves_down_to_the_place_from_which_a_condition_holds()
    {
        double low = 0;
        double high = 1;
        var from = new From { Place = 0.7 };
        Assert.False(Roots.Bisect(ref from, ref low, ref high, 40));
        Assert.InRange(0.7, low, high);
        Assert.Equal(Math.Pow(2, -40), high - low, 1e-15);

        // No number lies between the ends: there is nothing left to halve.
        (low, high) = (0, 1);
        Assert.False(Roots.Bisect(ref from, ref low, ref high, 2000));
        Assert.Equal(Math.BitIncrement(low), high);
    }

    [Fact]
    public void Bisection_ends_where_the_condition_says_so()
    {
        double low = 0;
        double high = 1;
        var from = new From { Place = 0.7, Until = 3 };
        Assert.True(Roots.Bisect(ref from, ref low, ref high, 40));
        Assert.Equal(0.125, high - low);
    }

    private struct Cubic : IDifferentiableFunction
    {
        public double Root;
        public double B;
        public int Evaluations;

        public bool Evaluate(double x, out double value, out double slope)
        {
            Evaluations++;
            value = (Root - x) * ((x * x) + B);
            slope = (2 * x * (Root - x)) - (x * x) - B;
            return Math.Abs(value) < 1e-14;
        }
    }

    private struct Arctangent : IDifferentiableFunction
    {
        public double Root;
        public double Lowest;
        public double Highest;

        public bool Evaluate(double x, out double value, out double slope)
        {
            Lowest = Math.Min(Lowest, x);
            Highest = Math.Max(Highest, x);
            value = -Math.Atan(x - Root);
            slope = -1 / (1 + ((x - Root) * (x - Root)));
            return false;
        }
    }

    private struct Jump : IDifferentiableFunction
    {
        public double At;
        public double CloseEnough;
        public double Last;

        public bool Evaluate(double x, out double value, out double slope)
        {
            Last = x;
            value = x < At ? 1 : -1;
            slope = double.NaN;
            return Math.Abs(x - At) < CloseEnough;
        }
    }

    private struct FifthPower : IFunction
    {
        public double Root;
        public int Evaluations;

        public readonly double Value(double x) => Math.Pow(x, 5) - Math.Pow(Root, 5);

        public bool Evaluate(double x, out double value)
        {
            Evaluations++;
            value = Value(x);
            return false;
        }
    }

    private struct From : ICondition
    {
        public double Place;
        public int Until;
        private int _evaluations;

        public bool Evaluate(double x, out bool holds)
        {
            holds = x >= Place;
            return ++_evaluations == Until;
        }
    }
}
