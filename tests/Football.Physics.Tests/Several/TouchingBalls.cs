using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Balls that touch each other, and planes and spheres of their own below each.</summary>
internal sealed partial class TouchingBalls
{
    private const double Gravity = 9.81;

    // A time over which rates are measured by differences, s, and the error of such a rate.
    private const double Moment = 1e-4;
    private const double Close = 2e-3;

    private readonly ClusterSystem _system = new(new ClusterRoom());
    private readonly Simulator[] _simulators;
    private readonly Vector3d[] _places;
    private readonly Vector3d[] _velocities;
    private readonly Vector3d[] _spins;

    public TouchingBalls(Random random, int count, bool resists)
    {
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        Vector3d Vector(double size) => new(Any(-size, size), Any(-size, size), Any(-size, size));
        double[] radii = [.. Enumerable.Range(0, count).Select(_ => Any(0.08, 0.15))];
        _places = new Vector3d[count];
        _velocities = new Vector3d[count];
        _spins = new Vector3d[count];
        var pairs = new List<(int First, int Second)>();
        for (int i = 1; i < count; i++)
        {
            do
            {
                int other = random.Next(i);
                _places[i] = _places[other] + ((radii[i] + radii[other]) * (Vector(1) + new Vector3d(0, 1, 0)).Normalized());
                pairs.RemoveAll(pair => pair.Second == i);
                pairs.Add((other, i));
            }
            while (Enumerable.Range(0, i).Any(k => (_places[k] - _places[i]).Length < (radii[k] + radii[i]) * (1 - 1e-9)));
        }

        _system.Count = count;
        _system.Part = 1e-3;
        _simulators = new Simulator[count];
        for (int i = 0; i < count; i++)
        {
            Vector3d place = _places[i];
            double radius = radii[i];
            int things = i == 0 ? 1 + random.Next(2) : random.Next(2);
            bool turns = random.Next(3) == 0;
            _simulators[i] = new Simulator(new Scene
            {
                Air = new Air { Density = 0 },
                Gravity = Gravity,
                Ball = new BallProperties { Radius = radius, Mass = Any(0.2, 0.8), InertiaFactor = Any(0.3, 0.9) },
                Ground = Ground.None,
                Obstacles = [.. Enumerable.Range(0, things).Select(k =>
                {
                    Vector3d n = (new Vector3d(0, 1, 0) + Vector(0.6)).Normalized();
                    return new Obstacle
                    {
                        Name = $"{i} {k}",
                        Shape = random.Next(2) == 0 ? new SphereShape(place - ((radius + 0.5) * n), 0.5) : new PlaneShape(place - (radius * n), n),
                        Spin = turns ? Vector(6) : Vector3d.Zero,
                        Surface = SurfaceMaterial.GoalFrame with
                        {
                            SlidingFriction = Any(0.05, 1.2),
                            RollingResistance = resists ? Any(0.01, 0.2) : 0,
                            RollingResistancePerSpeed = resists ? Any(0, 0.01) : 0,
                            SpinDamping = resists ? Any(0, 1e-3) : 0,
                            TorsionalPatchRadius = resists ? Any(0, 0.03) : 0,
                        },
                    };
                })],
            });
        }

        double friction = random.Next(5) == 0 ? 0 : Any(0.05, 0.8);
        double lever = friction * (random.Next(2) == 0 ? 0 : Any(0, 0.02));
        for (int i = 0; i < count; i++)
        {
            World world = _simulators[i].World!;
            ref ClusterBall ball = ref _system.Balls[i];
            ball.Pile = _simulators[i].Pile;
            ball.World = world;
            ball.PerMass = 1 / world.Ball.Mass;
            ball.PerInertia = 1 / world.Ball.MomentOfInertia;
            ball.Radius = world.Ball.Radius;
            BallState state = _simulators[i].Launch(_places[i], Vector3d.Zero, Vector3d.Zero);
            foreach (Contact near in ContactSet.Near(world, in state, ContactTolerances.Touching, new Contact[ContactSet.Room], world.Room))
            {
                ref ClusterContact contact = ref _system.Contacts[_system.ContactCount++];
                contact = new ClusterContact { First = i, Second = -1 };
                contact.On.Prepare(in near, world.Colliders[near.Collider], world.Ball);
            }
        }

        foreach ((int first, int second) in pairs)
        {
            ref ClusterContact contact = ref _system.Contacts[_system.ContactCount++];
            contact = new ClusterContact { First = first, Second = second, Lever = lever };
            contact.On.Collider = -1;
            contact.On.Sliding = friction;
        }
    }

    /// <summary>Draws a motion that keeps all gaps, and perhaps some contacts without slip or relative spin: row by row, each condition is met by the least change.</summary>
    /// <returns>False if no motion is found.</returns>
    public bool Settle(Random random, bool rolls)
    {
        Vector3d Vector(double size) => size * new Vector3d((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        for (int i = 0; i < _system.Count; i++)
        {
            _velocities[i] = Vector(0.8);
            _spins[i] = Vector(10);
        }

        bool[] sticks = [.. Enumerable.Range(0, _system.ContactCount).Select(_ => rolls && random.Next(2) == 0)];
        bool[] turns = [.. sticks.Select(at => rolls && random.Next(2) == 0)];
        double off = 1;
        for (int round = 0; round < 1500 && off > 1e-12; round++)
        {
            off = 0;
            for (int k = 0; k < _system.ContactCount; k++)
            {
                int i = _system.Contacts[k].First;
                int j = _system.Contacts[k].Second;
                Vector3d n = NormalOf(k, 0);
                Meet(i, j, n, Vector3d.Zero, Vector3d.Zero, 0);
                if (sticks[k])
                {
                    Vector3d surface = SurfaceOf(k, 0);
                    Vector3d across = Vector3d.Cross(n, Math.Abs(n.X) < 0.6 ? new Vector3d(1, 0, 0) : Vector3d.Up).Normalized();
                    foreach (Vector3d t in new[] { across, Vector3d.Cross(n, across) })
                    {
                        Meet(i, j, t, Vector3d.Cross(t, n), Vector3d.Cross(t, n), Vector3d.Dot(t, surface));
                    }
                }

                if (turns[k])
                {
                    Meet(i, j, Vector3d.Zero, n / RadiusOf(i), j < 0 ? default : -n / RadiusOf(j), j < 0 ? Vector3d.Dot(ColliderOf(k).Spin, n) : 0);
                }
            }
        }

        for (int i = 0; i < _system.Count; i++)
        {
            _system.Balls[i].Start = _simulators[i].Launch(_places[i], _velocities[i], _spins[i]);
            _system.Balls[i].At = ClusterSystem.MotionOf(in _system.Balls[i].Start);
        }

        return off <= 1e-12;

        // a·(v₁ − v₂) + b·r₁ω₁ + c·r₂ω₂ = target.
        void Meet(int i, int j, Vector3d a, Vector3d b, Vector3d c, double target)
        {
            double error = Vector3d.Dot(a, _velocities[i]) + (RadiusOf(i) * Vector3d.Dot(b, _spins[i])) - target;
            double square = a.LengthSquared + b.LengthSquared;
            if (j >= 0)
            {
                error += (RadiusOf(j) * Vector3d.Dot(c, _spins[j])) - Vector3d.Dot(a, _velocities[j]);
                square += a.LengthSquared + c.LengthSquared;
                _velocities[j] += error / square * a;
                _spins[j] -= error / square / RadiusOf(j) * c;
                error = Vector3d.Dot(a, _velocities[i] - _velocities[j]) + (RadiusOf(i) * Vector3d.Dot(b, _spins[i])) + (RadiusOf(j) * Vector3d.Dot(c, _spins[j])) - target;
                square = a.LengthSquared + b.LengthSquared;
            }

            off = Math.Max(off, Math.Abs(error));
            _velocities[i] -= square > 0 ? error / square * a : Vector3d.Zero;
            _spins[i] -= square > 0 ? error / square / RadiusOf(i) * b : Vector3d.Zero;
        }
    }

    public bool Find()
    {
        _system.Look(0);
        return ClusterModes.Find(_system);
    }

    /// <returns>The number of contacts between balls with a load.</returns>
    public int Check(string when)
    {
        Vector3d[] pushed = [.. Enumerable.Range(0, _system.Count).Select(_ => new Vector3d(0, -Gravity, 0))];
        var turned = new Vector3d[_system.Count];
        int pressed = 0;
        for (int k = 0; k < _system.ContactCount; k++)
        {
            ref readonly ClusterContact contact = ref _system.Contacts[k];
            string at = FormattableString.Invariant($"{when}, contact {k} of {contact.First} and {contact.Second}");
            Vector3d n = NormalOf(k, 0);
            Vector3d friction = Friction(k, n, at);
            double twist = contact.Second < 0 ? 0 : Twist(k, n, at);
            Add(contact.First, 1);
            if (contact.Second >= 0)
            {
                Add(contact.Second, -1);
                pressed += contact.On.Bears ? 1 : 0;
            }

            void Add(int ball, double sign)
            {
                ref readonly ClusterContact of = ref _system.Contacts[k];
                pushed[ball] += sign * _system.Balls[ball].PerMass * ((of.On.Load * n) + friction);
                turned[ball] += _system.Balls[ball].PerInertia * ((sign * twist * n) - (RadiusOf(ball) * Vector3d.Cross(n, friction)));
            }
        }

        for (int i = 0; i < _system.Count; i++)
        {
            Resistance(i, _system.Balls[i].Rates.Acceleration - pushed[i], _system.Balls[i].Rates.SpinAcceleration - turned[i], FormattableString.Invariant($"{when}, ball {i}"));
        }

        return pressed;
    }

    private double RadiusOf(int ball) => _system.Balls[ball].Radius;

    private Collider ColliderOf(int contact) => _system.Balls[_system.Contacts[contact].First].World.Colliders[_system.Contacts[contact].On.Collider];

    private Vector3d PlaceOf(int ball, double after) => _places[ball] + (after * _velocities[ball]) + (0.5 * after * after * _system.Balls[ball].Rates.Acceleration);

    private Vector3d NormalOf(int contact, double after)
    {
        ref readonly ClusterContact at = ref _system.Contacts[contact];
        return at.Second < 0 ? ColliderOf(contact).At(PlaceOf(at.First, after), after).Normal : (PlaceOf(at.First, after) - PlaceOf(at.Second, after)).Normalized();
    }

    private double GapOf(int contact, double after)
    {
        ref readonly ClusterContact at = ref _system.Contacts[contact];
        return at.Second < 0 ? ColliderOf(contact).At(PlaceOf(at.First, after), after).Distance : (PlaceOf(at.First, after) - PlaceOf(at.Second, after)).Length;
    }

    private Vector3d SurfaceOf(int contact, double after)
    {
        ref readonly ClusterContact at = ref _system.Contacts[contact];
        Vector3d n = NormalOf(contact, after);
        return at.Second < 0 ? ColliderOf(contact).SurfaceVelocity(PlaceOf(at.First, after) - (RadiusOf(at.First) * n), n, after) : Vector3d.Zero;
    }

    private Vector3d SpinOf(int ball, double after) => _spins[ball] + (after * _system.Balls[ball].Rates.SpinAcceleration);

    private Vector3d SlipOf(int contact, double after)
    {
        ref readonly ClusterContact at = ref _system.Contacts[contact];
        Vector3d n = NormalOf(contact, after);
        Vector3d relative = _velocities[at.First] + (after * _system.Balls[at.First].Rates.Acceleration) - SurfaceOf(contact, after);
        Vector3d turning = RadiusOf(at.First) * SpinOf(at.First, after);
        if (at.Second >= 0)
        {
            relative -= _velocities[at.Second] + (after * _system.Balls[at.Second].Rates.Acceleration);
            turning += RadiusOf(at.Second) * SpinOf(at.Second, after);
        }

        return relative - (Vector3d.Dot(relative, n) * n) + Vector3d.Cross(n, turning);
    }

    private double AboutOf(int contact, double after)
    {
        ref readonly ClusterContact at = ref _system.Contacts[contact];
        return Vector3d.Dot(SpinOf(at.First, after) - SpinOf(at.Second, after), NormalOf(contact, after));
    }

    /// <summary>A load keeps the gap closed; friction keeps a slip at zero within its cone, or has the size of the cone and acts against the slip.</summary>
    private Vector3d Friction(int k, Vector3d n, string when)
    {
        ref readonly SetContact on = ref _system.Contacts[k].On;
        when += FormattableString.Invariant($": load {on.Load}, sticks {on.Sticks}, slip {on.Slip.Length}");
        double gap = (GapOf(k, Moment) - (2 * GapOf(k, 0)) + GapOf(k, -Moment)) / (Moment * Moment);
        Vector3d slip = SlipOf(k, 0);
        Vector3d rate = (SlipOf(k, Moment) - SlipOf(k, -Moment)) / (2 * Moment);
        rate -= Vector3d.Dot(rate, n) * n;
        double close = Close * (1 + (0.01 * rate.Length) + (0.01 * on.Load));
        Vector3d computed = ClusterModes.SlipRate(_system, in _system.Contacts[k]);
        Assert.True(Math.Abs(gap - on.Opening) <= close, $"{when}, opens at {gap}, not {on.Opening}");
        Assert.True((computed - rate).Length <= close, $"{when}, slip changes at {rate}, not {computed}");
        if (!on.Bears)
        {
            Assert.True(on.Load == 0 && gap >= -close, $"{when}, closes at {gap}");
            return Vector3d.Zero;
        }

        double friction = _system.Contacts[k].Second < 0 ? ColliderOf(k).Surfaces[0].SlidingFriction : on.Sliding;
        double most = friction * on.Load;
        Assert.True(on.Load > 0 && Math.Abs(gap) <= close, $"{when}, opens at {gap}");
        if (on.Sticks)
        {
            Assert.True(slip.Length <= ContactTolerances.GroupSticking && rate.Length <= close, $"{when}, starts to slip at {rate.Length}");
            Assert.True(on.Friction.Length <= most * (1 + 1e-9), $"{when}, friction {on.Friction.Length} of {most}");
            return on.Friction;
        }

        if (slip.Length >= ContactTolerances.GroupSticking || most == 0)
        {
            return slip.Length > 0 ? -most / slip.Length * slip : Vector3d.Zero;
        }

        Assert.True(rate.Length > 0 && (on.Direction - (rate / rate.Length)).Length <= close * (1 + (1 / rate.Length)), $"{when}, rate {rate.Length}");
        return -most * on.Direction;
    }

    /// <summary>Drilling friction between balls: against the relative spin about the normal, or as much as holds it.</summary>
    /// <returns>The torque on the first ball, N m.</returns>
    private double Twist(int k, Vector3d n, string when)
    {
        ref readonly ClusterContact contact = ref _system.Contacts[k];
        double about = AboutOf(k, 0);
        double starts = (AboutOf(k, Moment) - AboutOf(k, -Moment)) / (2 * Moment);
        double most = contact.Lever * contact.On.Load;
        if (!contact.On.Bears || most == 0)
        {
            return 0;
        }

        if (Math.Abs(about) > ContactTolerances.GroupTurning)
        {
            return -Math.Sign(about) * most;
        }

        if (contact.HoldsTwist)
        {
            Assert.True(Math.Abs(contact.Twist) <= most * (1 + 1e-9), $"{when}, holds {contact.Twist} of {most}");
            Assert.True(Math.Abs(starts) <= Close * (1 + (1e-3 * Vector3d.Cross(SpinOf(contact.First, 0), n).Length)), $"{when}, starts to turn at {starts}");
            return contact.Twist;
        }

        // If a later slip turns this torque the wrong way, the check at the end of a step finds it.
        return -contact.TwistSign * most;
    }

    /// <summary>All that is left of the balance of a ball is the resistance of one of its objects.</summary>
    private void Resistance(int index, Vector3d left, Vector3d leftTurning, string when)
    {
        when += FormattableString.Invariant($": {left}, {leftTurning} beyond forces");
        ref readonly ClusterBall ball = ref _system.Balls[index];
        double greatest = 0;
        bool sticks = false;
        for (int k = 0; k < _system.ContactCount; k++)
        {
            ref readonly ClusterContact contact = ref _system.Contacts[k];
            if (contact.First == index && contact.Second < 0 && contact.On.Bears && (contact.On.Sticks ? !sticks || contact.On.Load > greatest : !sticks && contact.On.Load > greatest))
            {
                greatest = contact.On.Load;
                sticks = contact.On.Sticks;
            }
        }

        Assert.Equal(greatest > 0, ball.Bearer >= 0);
        if (ball.Bearer < 0)
        {
            Assert.True(left.Length + leftTurning.Length <= 1e-7, when);
            return;
        }

        ref readonly SetContact bearer = ref _system.Contacts[ball.Bearer].On;
        Assert.True(bearer.Sticks == sticks && bearer.Load >= greatest * (1 - 1e-8), when);
        Collider collider = ColliderOf(ball.Bearer);
        SurfaceMaterial surface = collider.Surfaces[0];
        Vector3d n = NormalOf(ball.Bearer, 0);
        Vector3d rolling = _velocities[index] - collider.MaterialVelocity(_places[index], 0);
        rolling -= Vector3d.Dot(rolling, n) * n;
        double speed = rolling.Length;
        double most = sticks ? bearer.Load * ball.PerMass * (surface.RollingResistance + (surface.RollingResistancePerSpeed * speed)) : 0;
        Assert.True((left + (most / speed * rolling)).Length <= 1e-7, $"{when}, expected {most}");
        Vector3d about = leftTurning + (most / speed / ball.Radius * Vector3d.Cross(n, rolling));
        Assert.Equal(0, Vector3d.Cross(about, n).Length, 1e-6);

        double free = Vector3d.Dot(_spins[index] - collider.Spin, n);
        double damped = -surface.SpinDamping * ball.PerInertia * free;
        double drills = surface.TorsionalPatchRadius * surface.SlidingFriction * bearer.Load * ball.PerInertia;
        double held = Vector3d.Dot(about, n) - damped;
        if (Math.Abs(free) > ContactTolerances.GroupTurning)
        {
            Assert.Equal(-Math.Sign(free) * drills, held, 1e-6);
            return;
        }

        double starts = (Vector3d.Dot(SpinOf(index, Moment), NormalOf(ball.Bearer, Moment)) - Vector3d.Dot(SpinOf(index, -Moment), NormalOf(ball.Bearer, -Moment))) / (2 * Moment);
        Assert.True(Math.Abs(held) <= (drills * (1 + 1e-9)) + 1e-9, $"{when}, holds {held} of {drills}");
        Assert.Equal(ball.HoldsSpin ? held : ball.HeldSpin, ball.HeldSpin, 1e-6);
        Assert.True(drills == 0 || (ball.HoldsSpin ? Math.Abs(starts) <= Close : held * starts <= Close), $"{when}, held {held}, starts {starts}");
    }
}
