namespace Football.Physics.Tests.Things;

/// <summary>The impulses of a contact set, held to the law that they obey: no closing, loads that only press, Coulomb's law against the slip that is left, and their balances.</summary>
public sealed class ContactSolverTests
{
    private const double Close = 1e-7;
    private const double Duration = 0.001;
    private static readonly BallProperties Ball = Scene.Default.Ball;

    private static readonly Vector3d[][] Sets =
    [
        [Vector3d.Up],
        [Vector3d.Up, new Vector3d(1, 0, 0)],
        [Vector3d.Up, new Vector3d(1, 0.2, 0.3)],
        [new Vector3d(0.5, 1, 0), new Vector3d(-0.5, 1, 0.2)],
        [Vector3d.Up, new Vector3d(1, 0, 0), new Vector3d(0, 0.1, 1)],
        [new Vector3d(0.8, 1, 0.1), new Vector3d(-0.5, 1, -0.6), new Vector3d(-0.3, 1, 0.8)],
    ];

    public static TheoryData<int, bool> Cases()
    {
        var cases = new TheoryData<int, bool>();
        for (int i = 0; i < Sets.Length; i++)
        {
            cases.Add(i, false);
            cases.Add(i, true);
        }

        return cases;
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Impulses_obey_the_law_of_contact(int set, bool resists)
    {
        var random = new Random(set);
        int solved = 0;
        for (int i = 0; i < 60; i++)
        {
            Contact[] contacts = Touching(Sets[set], resists, i % 4 < 2, random, out Vector3d v, out Vector3d w);
            Vector3d before = v;
            Vector3d turned = w;
            if (ContactSolver.Solve(contacts, Ball, i % 2 == 0 ? Duration : 0, ref v, ref w))
            {
                Obeys(contacts, resists, i % 2 == 0 ? Duration : 0, in before, in turned, in v, in w);
                solved++;
            }
        }

        Assert.True(solved >= 57, $"{solved} solved");
    }

    /// <summary>Near the answer, with what bears, grips and slips known, one step of Newton's method leaves the square of the error.</summary>
    [Theory]
    [MemberData(nameof(Cases))]
    public void A_step_of_Newtons_method_squares_the_error(int set, bool resists)
    {
        var random = new Random(100 + set);
        var gains = new List<double>();
        for (int i = 0; i < 60; i++)
        {
            Contact[] contacts = Touching(Sets[set], resists, i % 4 < 2, random, out Vector3d v, out Vector3d w);
            Vector3d resisted = w;
            if (!ContactSolver.Solve(contacts, Ball, Duration, ref v, ref w) || ContactSet.Heaviest(contacts) < 0)
            {
                continue;
            }

            // What resisted the turning is what friction did not do.
            resisted = w - resisted - contacts.Aggregate(Vector3d.Zero, (sum, contact) => sum + Turn(in contact, in contact.Friction));
            int bearer = resists ? ContactSet.Heaviest(contacts) : -1;
            var resistance = new TurningResistance { Bearer = bearer };
            if (resists)
            {
                resistance.Drilling = Vector3d.Dot(in resisted, in contacts[bearer].Normal);
                resistance.Rolling = resisted - (resistance.Drilling * contacts[bearer].Normal);
            }

            // A little more load and friction on what bears, and what that does.
            Vector3d right = v;
            Vector3d turns = w;
            for (int k = 0; k < contacts.Length; k++)
            {
                ref Contact contact = ref contacts[k];
                double load = 1e-4 * contact.Load * random.NextDouble();
                Vector3d friction = 1e-4 * random.NextDouble() * contact.Friction;
                contact.Load += load;
                contact.Friction += friction;
                v += (load * contact.Normal) + friction;
                w += Turn(in contact, in friction);
            }

            double error = (v - right).Length + (Ball.Radius * (w - turns).Length);
            ContactNewton.Step(contacts, Ball, Duration, ref resistance, ref v, ref w);
            gains.Add(((v - right).Length + (Ball.Radius * (w - turns).Length)) / Math.Max(error, 1e-12));
        }

        Assert.True(gains.Order().ElementAt(gains.Count * 3 / 4) < 0.01, string.Join(' ', gains.Order().Select(gain => gain.ToString("g3", null))));
    }

    /// <summary>A gap may close within the time, and not faster.</summary>
    [Fact]
    public void A_gap_may_close_within_the_time()
    {
        Contact[] contacts = Of([Vector3d.Up], false, new Vector3d(0, -3, 0), Vector3d.Zero, gap: 1e-3);
        Vector3d v = new(0, -3, 0);
        Vector3d w = Vector3d.Zero;
        Assert.True(ContactSolver.Solve(contacts, Ball, 1e-3, ref v, ref w));
        Assert.Equal(-1, v.Y, 1e-9);
        Assert.Equal(2, contacts[0].Load, 1e-9);
    }

    private static void Obeys(Contact[] contacts, bool resists, double duration, in Vector3d before, in Vector3d turned, in Vector3d v, in Vector3d w)
    {
        double scale = before.Length + (Ball.Radius * turned.Length) + contacts.Sum(contact => contact.Load);
        Vector3d impulse = Vector3d.Zero;
        Vector3d turning = Vector3d.Zero;
        foreach (Contact contact in contacts)
        {
            Vector3d n = contact.Normal;
            double off = Vector3d.Dot(in v, in n);
            Assert.True(contact.Load >= 0 && off >= -Close * scale);
            Assert.Equal(0, contact.Load > Close * scale ? off : 0, Close * scale);

            // What is left of the slip: none within the bound, against it at the bound.
            double most = contact.Material.SlidingFriction * contact.Load;
            Vector3d slip = v - (off * n) + (Ball.Radius * Vector3d.Cross(in n, in w));
            Assert.True(contact.Friction.Length <= most + (Close * scale));
            Assert.Equal(0, Vector3d.Dot(in contact.Friction, in n), Close * scale);
            Assert.Equal(0, contact.Friction.Length < most - (Close * scale) ? slip.Length : ((slip.Length * contact.Friction) + (most * slip)).Length, 10 * Close * scale);
            impulse += (contact.Load * n) + contact.Friction;
            turning += Turn(in contact, in contact.Friction);
        }

        Assert.Equal(0, (v - before - impulse).Length, Close * scale);
        Vector3d resisted = w - turned - turning;
        int bearer = ContactSet.Heaviest(contacts);
        if (!resists || bearer < 0)
        {
            Assert.Equal(0, Ball.Radius * resisted.Length, Close * scale);
            return;
        }

        // On the heaviest alone: the spin about its normal is damped, then loses what the load allows; the rolling loses up to its bound.
        Contact heaviest = contacts[bearer];
        ContactMaterial material = heaviest.Material;
        double perSpin = Close * scale / Ball.Radius;
        double about = Vector3d.Dot(in w, in heaviest.Normal);
        double drilled = Vector3d.Dot(in resisted, in heaviest.Normal);
        double damped = (about - drilled) / (1 + (material.SpinDamping * duration / Ball.MomentOfInertia));
        double drills = material.DrillingLength * material.SlidingFriction * heaviest.Load / (Ball.InertiaFactor * Ball.Radius * Ball.Radius);
        Assert.Equal(Math.CopySign(Math.Max(0, Math.Abs(damped) - drills), damped), about, 10 * perSpin);
        Vector3d rolling = w - (about * heaviest.Normal);
        Vector3d slowed = resisted - (drilled * heaviest.Normal);
        double share = material.RollingFriction + (material.RollingFrictionBySpeed * v.Length);
        double bound = heaviest.Rolls ? (1 + (1 / Ball.InertiaFactor)) * share * heaviest.Load / Ball.Radius : 0;
        Assert.True(slowed.Length <= bound + (10 * perSpin));
        Assert.Equal(0, slowed.Length < bound - (10 * perSpin) ? rolling.Length : ((rolling.Length * slowed) + (bound * rolling)).Length / Math.Max(1, rolling.Length), 100 * perSpin);
    }

    /// <summary>What a push along a contact does to the spin: −n × F/(α r).</summary>
    private static Vector3d Turn(in Contact contact, in Vector3d push) => -1 / (Ball.InertiaFactor * Ball.Radius) * Vector3d.Cross(in contact.Normal, in push);

    private static Contact[] Touching(Vector3d[] normals, bool resists, bool rolls, Random random, out Vector3d v, out Vector3d w)
    {
        double Draw() => (2 * random.NextDouble()) - 1;
        v = new Vector3d(3 * Draw(), -2 * random.NextDouble(), 3 * Draw());
        w = new Vector3d(30 * Draw(), 30 * Draw(), 30 * Draw());
        if (rolls)
        {
            // Without slip on the first of them.
            Vector3d n = normals[0].Normalized();
            v = -(random.NextDouble() * n) - (Ball.Radius * Vector3d.Cross(in n, in w));
        }

        return Of(normals, resists, in v, in w, 0);
    }

    private static Contact[] Of(Vector3d[] normals, bool resists, in Vector3d v, in Vector3d w, double gap)
    {
        Surface surface = resists ? Surface.Board : Surface.Board with { RollingFriction = 0, RollingFrictionBySpeed = 0, SpinDamping = 0, DrillingLength = 0 };
        var world = new World(Scene.Default with
        {
            Ground = Ground.None,
            Obstacles = [.. normals.Select((n, i) => new Obstacle { Name = $"plane {i}", Shape = new PlaneShape(-(Ball.Radius + gap) * n.Normalized(), n.Normalized()), Surface = surface })],
        });
        BallState state = default;
        state.Velocity = v;
        state.SetFlightSpin(in w);
        Contact[] contacts = new Contact[ContactSet.Most];
        return contacts[..ContactSet.Near(world, in state, 0.01, contacts)];
    }
}
