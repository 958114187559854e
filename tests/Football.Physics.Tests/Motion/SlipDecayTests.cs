using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>The closed form of a slide's end against small steps of ṡ = −k ŝ + c.</summary>
public sealed class SlipDecayTests
{
    [Fact]
    public void Time_and_integrals_are_those_of_the_equation()
    {
        var random = new Shots(2019);
        for (int i = 0; i < 20; i++)
        {
            double k = random.Uniform(2, 20);
            Vector3d slip = random.Uniform(0.01, 2) * Flat(random);
            Vector3d push = random.Uniform(0, 0.5) * k * Flat(random);
            var closed = new SlipDecay(in slip, in push, k);
            Integrate(slip, push, k, closed.Time, out Vector3d left, out Vector3d once, out Vector3d twice);
            Assert.InRange(left.Length, 0, 1e-3 * slip.Length);
            Assert.InRange(Vector3d.Distance(closed.Direction, once), 0, 2e-4 * closed.Time);
            Assert.InRange(Vector3d.Distance(closed.Twice, twice), 0, 2e-4 * closed.Time * closed.Time);
        }
    }

    [Fact]
    public void Without_a_push_the_slip_dies_along_a_straight_line()
    {
        var closed = new SlipDecay(new Vector3d(0.3, 0, -0.4), Vector3d.Zero, 10);
        Assert.Equal(0.05, closed.Time, 1e-15);
        Assert.InRange(Vector3d.Distance(closed.Direction, new Vector3d(0.03, 0, -0.04)), 0, 1e-15);
        Assert.InRange(Vector3d.Distance(closed.Twice, new Vector3d(0.00075, 0, -0.001)), 0, 1e-15);
    }

    /// <summary>The formulas with and without a push meet where they take over from each other.</summary>
    [Fact]
    public void A_vanishing_push_changes_nothing()
    {
        var slip = new Vector3d(0.3, 0, -0.4);
        var below = new SlipDecay(in slip, new Vector3d(0.99e-2, 0, 0), 10);
        var above = new SlipDecay(in slip, new Vector3d(1.01e-2, 0, 0), 10);
        Assert.InRange(Math.Abs(above.Time - below.Time), 0, 2e-5 * below.Time);
        Assert.InRange(Vector3d.Distance(above.Twice, below.Twice), 0, 1e-3 * below.Time * below.Time);
    }

    private static Vector3d Flat(Shots random)
    {
        double angle = random.Uniform(0, 2 * Math.PI);
        return new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
    }

    /// <summary>Midpoint steps that grow finer towards the end, where the direction turns ever faster.</summary>
    private static void Integrate(Vector3d slip, Vector3d push, double k, double duration, out Vector3d left, out Vector3d once, out Vector3d twice)
    {
        const int Steps = 20_000;
        Vector3d s = slip;
        once = Vector3d.Zero;
        twice = Vector3d.Zero;
        for (int i = 0; i < Steps; i++)
        {
            // t = T (1 − (1 − i/n)²)
            double from = 1 - ((double)i / Steps);
            double to = 1 - ((i + 1.0) / Steps);
            double h = duration * ((from * from) - (to * to));
            Vector3d middle = s + (0.5 * h * (push - (k / s.Length * s)));
            if (middle.Length < 1e-9 * slip.Length || Vector3d.Dot(middle, s) < 0)
            {
                break;
            }

            Vector3d direction = middle / middle.Length;
            twice += (h * once) + (0.5 * h * h * direction);
            once += h * direction;
            s += h * (push - (k * direction));
        }

        left = s;
    }
}
