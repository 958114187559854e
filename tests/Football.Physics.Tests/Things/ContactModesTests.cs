using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>The forces of a contact set against the laws that they must fulfil: no ball is moved, and no law is solved here.</summary>
public sealed unsafe class ContactModesTests
{
    private const double Radius = 0.11;
    private const double Gravity = 9.81;

    // A time over which rates are measured by differences, s, and the error of such a rate.
    private const double Moment = 1e-4;
    private const double Close = 1e-3;

    private static readonly Vector3d s_place = new(0.3, 0.2, -0.2);

    /// <summary>Motions of a ball among its contacts.</summary>
    public enum Moving
    {
        /// <summary>With any spin.</summary>
        Slides,

        /// <summary>Without slip at the first contact.</summary>
        Rolls,

        /// <summary>Without slip at two contacts.</summary>
        RollsInGutter,

        /// <summary>It neither moves nor spins.</summary>
        Stands,

        /// <summary>It spins about the normal of the first contact.</summary>
        Spins,
    }

    [Theory]
    [InlineData(Moving.Slides, 1)]
    [InlineData(Moving.Slides, 2)]
    [InlineData(Moving.Slides, 3)]
    [InlineData(Moving.Rolls, 1)]
    [InlineData(Moving.Rolls, 2)]
    [InlineData(Moving.Rolls, 3)]
    [InlineData(Moving.RollsInGutter, 2)]
    [InlineData(Moving.Stands, 1)]
    [InlineData(Moving.Stands, 2)]
    [InlineData(Moving.Stands, 3)]
    [InlineData(Moving.Stands, 4)]
    [InlineData(Moving.Spins, 1)]
    [InlineData(Moving.Spins, 2)]
    [InlineData(Moving.Spins, 3)]
    public void Forces_fulfil_the_laws_of_every_contact(Moving moving, int count)
    {
        var random = new Random((10 * (int)moving) + count);
        int found = 0;
        for (int i = 0; i < 100; i++)
        {
            Scene scene = Draw(random, moving, count, resists: i % 3 > 0, airs: i % 5 == 0);
            var around = new Surroundings(scene, SceneAir.Of(scene));
            if (MotionOf(random, around.World, moving) is { } motion)
            {
                found += Check(around, in motion, carrier: random.Next(-1, count), moving, FormattableString.Invariant($"draw {i}")) ? 1 : 0;
            }
        }

        Assert.InRange(found, 30, 100);
    }

    /// <summary>The contacts of a ball that touches all objects of a scene.</summary>
    internal static ContactSystem Prepared(Surroundings around, in FootballPhysics.Motion at, SetContact* contacts)
    {
        World world = around.World;
        Vector3d velocity = at.Velocity;
        var state = new BallState { Position = at.Position, Velocity = velocity, SpinAxis = at.Spin };
        Span<Contact> set = ContactSet.Near(world, in state, ContactTolerances.Touching, new Contact[ContactSet.Room], world.Room);
        Assert.Equal(world.Colliders.Length, set.Length);
        for (int i = 0; i < set.Length; i++)
        {
            contacts[i].Prepare(in set[i], world.Colliders[set[i].Collider]);
        }

        return new ContactSystem { Around = around, World = world, Contacts = contacts, Count = set.Length, Bearer = -1 };
    }

    /// <summary>Finds the modes, and checks each contact and the balance of the ball.</summary>
    /// <returns>False if there are no modes.</returns>
    private static bool Check(Surroundings around, in FootballPhysics.Motion at, int carrier, Moving moving, string when)
    {
        World world = around.World;
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        ContactSystem system = Prepared(around, in at, contacts);
        int evaluations = 0;
        if (!ContactModes.Find(ref system, 0, in at, ContactTolerances.Sticking, carrier, ref evaluations))
        {
            return false;
        }

        Vector3d pushed = new(0, -Gravity, 0);
        Vector3d turned = default;
        if (around.AirActs)
        {
            FootballPhysics.MotionRates free = system.Free(0, in at);
            pushed = free.Acceleration;
            turned = free.SpinAcceleration;
        }

        for (int i = 0; i < system.Count; i++)
        {
            Vector3d friction = Contact(in system, i, in at, when);
            pushed += (contacts[i].Load * contacts[i].Normal) + friction;
            turned -= Vector3d.Cross(contacts[i].Normal, friction) / (world.Ball.InertiaFactor * Radius);
        }

        Resistance(in system, in at, system.Start.Acceleration - pushed, system.Start.SpinAcceleration - turned, moving == Moving.Stands, when);
        Brace(in system, when);
        Assert.True(moving != Moving.Slides || system.Bearer < 0 || !contacts[system.Bearer].Sticks, when);
        return true;
    }

    /// <summary>Loads keep the gap closed, and do not pull; friction keeps a slip at zero within its cone, or has the size of the cone and acts against the slip.</summary>
    /// <returns>The friction per mass, m/s².</returns>
    private static Vector3d Contact(in ContactSystem system, int index, in FootballPhysics.Motion at, string when)
    {
        ref readonly SetContact contact = ref system.Contacts[index];
        when += FormattableString.Invariant($", contact {index}: load {contact.Load}, sticks {contact.Sticks}, slip {contact.Slip.Length}");
        Collider collider = system.World.Colliders[contact.Collider];
        double gap = (Gap(in system, collider, in at, Moment) - (2 * Gap(in system, collider, in at, 0)) + Gap(in system, collider, in at, -Moment)) / (Moment * Moment);
        Vector3d normal = collider.At(at.Position, 0).Normal;
        Vector3d slip = Slip(in system, collider, in at, 0);
        Vector3d rate = (Slip(in system, collider, in at, Moment) - Slip(in system, collider, in at, -Moment)) / (2 * Moment);
        rate -= Vector3d.Dot(rate, normal) * normal;
        if (!contact.Bears)
        {
            Assert.True(contact.Load == 0 && contact.Friction == Vector3d.Zero, when);
            Assert.True(gap >= -Close, $"{when}, closes at {gap}");
            return Vector3d.Zero;
        }

        double most = collider.Surfaces[0].SlidingFriction * contact.Load;
        Assert.True(contact.Load > 0, when);
        double close = Close * (1 + (0.01 * system.Start.Acceleration.Length));
        Assert.True(Math.Abs(gap) <= close, $"{when}, opens at {gap}");
        Assert.Equal(gap, contact.Opening, close);
        if (contact.Sticks)
        {
            Assert.True(slip.Length <= ContactTolerances.Sticking, when);
            Assert.True(rate.Length <= Close, $"{when}, starts to slip at {rate.Length}");
            Assert.True(contact.Friction.Length <= most * (1 + 1e-9), $"{when}, friction {contact.Friction.Length} of {most}");
            Assert.Equal(most - contact.Friction.Length, contact.Grip, 1e-9);
            Assert.Equal(0, Vector3d.Dot(contact.Friction, normal), 1e-9);
            return contact.Friction;
        }

        Assert.True(contact.Friction == Vector3d.Zero, when);
        if (slip.Length >= ContactTolerances.Sticking || most == 0)
        {
            return slip.Length > 0 ? -most / slip.Length * slip : Vector3d.Zero;
        }

        // A slip that starts: its direction is that of its rate.
        Assert.True(rate.Length > 0 && (contact.Direction - (rate / rate.Length)).Length <= Close * (1 + (1 / rate.Length)), $"{when}, rate {rate.Length}");
        return -most * contact.Direction;
    }

    /// <summary>All that is left of the balance is the resistance of one contact: to rolling, to the spin about its normal, or what holds the ball or its spin.</summary>
    private static void Resistance(in ContactSystem system, in FootballPhysics.Motion at, in Vector3d left, in Vector3d leftTurning, bool stands, string when)
    {
        double greatest = 0;
        bool sticks = false;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (contact.Bears && (contact.Sticks ? !sticks || contact.Load > greatest : !sticks && contact.Load > greatest))
            {
                greatest = contact.Load;
                sticks = contact.Sticks;
            }
        }

        when += FormattableString.Invariant($": {left}, {leftTurning} beyond forces");
        Assert.Equal(greatest > 0, system.Bearer >= 0);
        if (system.Bearer < 0)
        {
            Assert.True(left.Length + leftTurning.Length <= Close, when);
            return;
        }

        ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
        Assert.True(bearer.Bears && bearer.Sticks == sticks && (system.IsTied || bearer.Load >= greatest * (1 - 1e-8)), when);
        Collider collider = system.World.Colliders[bearer.Collider];
        SurfaceMaterial surface = collider.Surfaces[0];
        Vector3d normal = collider.At(at.Position, 0).Normal;
        Vector3d rolling = at.Velocity - collider.MaterialVelocity(at.Position, 0);
        double speed = rolling.Length;
        Vector3d direction = speed > ContactTolerances.Rolling ? rolling / speed : system.Along;
        double most = !bearer.Sticks || system.Along == Vector3d.Zero ? 0 : bearer.Load * (surface.RollingResistance + (surface.RollingResistancePerSpeed * speed));
        if (system.Pinned)
        {
            // What holds the ball is less than what resists a roll, and leaves no acceleration along the line.
            Assert.True(speed <= ContactTolerances.Rolling && Math.Abs(Vector3d.Dot(left, system.Along)) <= most * (1 + 1e-9), when);
            Assert.Equal(0, Vector3d.Dot(system.Start.Acceleration, system.Along), Close);
            Assert.Equal(0, Vector3d.Cross(left, system.Along).Length, 1e-9);
            most = -Vector3d.Dot(left, system.Along);
            Assert.Equal(-most, system.Held, 1e-8);
            direction = system.Along;
        }
        else if (stands && most > 0)
        {
            // From a standstill, it resists the roll that starts.
            Assert.True(Vector3d.Dot(system.Start.Acceleration, system.Along) >= -Close, when);
        }

        Assert.True((left + (most * direction)).Length <= 1e-8, $"{when}, expected {most}");
        Vector3d about = leftTurning + (most / Radius * Vector3d.Cross(normal, direction));
        Assert.Equal(0, Vector3d.Cross(about, normal).Length, 1e-7);
        double free = Vector3d.Dot(at.Spin - collider.Spin, normal);
        BallProperties ball = system.World.Ball;
        double damped = -surface.SpinDamping / ball.MomentOfInertia * free;
        double drills = surface.TorsionalPatchRadius * surface.SlidingFriction * bearer.Load * ball.Mass / ball.MomentOfInertia;
        if (Math.Abs(free) > ContactTolerances.Rolling)
        {
            Assert.Equal(damped - (Math.Sign(free) * drills), Vector3d.Dot(about, normal), 1e-7);
            return;
        }

        // It holds the spin, or resists with all it has: then the spin starts against it.
        double held = Vector3d.Dot(about, normal) - damped;
        Vector3d later = collider.At(at.Position + (Moment * at.Velocity), Moment).Normal;
        Vector3d earlier = collider.At(at.Position - (Moment * at.Velocity), -Moment).Normal;
        double starts = (Vector3d.Dot(at.Spin + (Moment * system.Start.SpinAcceleration), later) - Vector3d.Dot(at.Spin - (Moment * system.Start.SpinAcceleration), earlier)) / (2 * Moment);
        Assert.True(Math.Abs(held) <= drills * (1 + 1e-9) + 1e-9, $"{when}, holds {held} of {drills}");
        Assert.Equal(system.HoldsSpin ? held : system.HeldSpin, system.HeldSpin, 1e-6);
        Assert.True(system.HoldsSpin == (drills > 0 && Math.Abs(held) < drills * (1 - 1e-9)) || Math.Abs(Math.Abs(held) - drills) < 1e-6, when);
        Assert.True(drills == 0 || (system.HoldsSpin ? Math.Abs(starts) <= Close : held * starts <= Close), $"{when}, held {held}, starts {starts}");
    }

    /// <summary>Two contacts without slip may press the ball from both sides, in vain: they do so only if friction needs it, and then as little as possible.</summary>
    private static void Brace(in ContactSystem system, string when)
    {
        int first = -1;
        int second = -1;
        int sticking = 0;
        bool resists = false;
        for (int i = 0; i < system.Count; i++)
        {
            if (system.Contacts[i].Bears && system.Contacts[i].Sticks)
            {
                sticking++;
                first = second;
                second = i;
            }

            resists |= system.Contacts[i].Resistance.Rolling > 0 || system.Contacts[i].Resistance.Drills;
        }

        if (sticking != 2 || (resists && !system.Pinned))
        {
            return;
        }

        Vector3d line = system.Contacts[first].Normal - system.Contacts[second].Normal;
        line /= Math.Sqrt(2) * line.Length;
        double along = Vector3d.Dot(Force(in system.Contacts[first], 0) - Force(in system.Contacts[second], 0), line);
        double step = 1e-6 * Math.Max(1, Math.Abs(along));
        bool fits = IsWithin(in system.Contacts[first], -Math.Sign(along) * step) && IsWithin(in system.Contacts[second], Math.Sign(along) * step);
        Assert.True(Math.Abs(along) <= step || !fits, $"{when}, braces with {along}");

        Vector3d Force(in SetContact contact, double more) => (contact.Load * contact.Normal) + contact.Friction + (more * line);

        // Within the cone by more than a rounding error.
        bool IsWithin(in SetContact contact, double more)
        {
            Vector3d force = Force(in contact, more);
            double load = Vector3d.Dot(force, contact.Normal);
            return (force - (load * contact.Normal)).Length <= contact.Resistance.MostFriction(load) * (1 - 1e-9);
        }
    }

    private static double Gap(in ContactSystem system, Collider collider, in FootballPhysics.Motion at, double after) =>
        collider.At(at.Position + (after * at.Velocity) + (0.5 * after * after * system.Start.Acceleration), after).Distance - Radius;

    private static Vector3d Slip(in ContactSystem system, Collider collider, in FootballPhysics.Motion at, double after)
    {
        Vector3d position = at.Position + (after * at.Velocity) + (0.5 * after * after * system.Start.Acceleration);
        Vector3d n = collider.At(position, after).Normal;
        Vector3d relative = at.Velocity + (after * system.Start.Acceleration) - collider.SurfaceVelocity(position - (Radius * n), n, after);
        return relative - (Vector3d.Dot(relative, n) * n) + (Radius * Vector3d.Cross(n, at.Spin + (after * system.Start.SpinAcceleration)));
    }

    /// <summary>Planes and spheres about the ball, most of them below it; in motion if the ball is.</summary>
    private static Scene Draw(Random random, Moving moving, int count, bool resists, bool airs)
    {
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        Vector3d Vector(double size) => new(Any(-size, size), Any(-size, size), Any(-size, size));
        bool moves = moving is Moving.Slides or Moving.Rolls && count < 3 && random.Next(2) == 0;
        bool turns = moving is Moving.Slides or Moving.Rolls && random.Next(3) == 0;
        double most = random.Next(3) == 0 ? 0.2 : 1.2;
        bool isGroove = moving is Moving.Stands && count == 2;
        double turn = Any(0, 2 * Math.PI);
        int smooth = moving is Moving.Stands ? random.Next(2 * count) : -1;
        var obstacles = new List<Obstacle>();
        for (int i = 0; i < count; i++)
        {
            Vector3d n = (new Vector3d(0, Any(0.2, 1.2), 0) + Vector(0.8)).Normalized();
            n = i == 1 && random.Next(4) == 0 ? new Vector3d(random.Next(2) == 0 ? 1 : -1, 0, 0) : n;
            n = isGroove ? ((Any(0.3, 1) * Vector3d.Up) + ((i - 0.5) * new Vector3d(Math.Cos(turn), 0, Math.Sin(turn))) + Vector(0.02)).Normalized() : n;
            obstacles.Add(new Obstacle
            {
                Name = $"{i}",
                Shape = random.Next(2) == 0 ? new SphereShape(s_place - ((Radius + 0.5) * n), 0.5) : new PlaneShape(s_place - (Radius * n), n),
                Velocity = moves ? Vector(1) : Vector3d.Zero,
                Spin = turns ? Vector(8) : Vector3d.Zero,
                Pivot = Vector(0.5),
                Surface = SurfaceMaterial.GoalFrame with
                {
                    SlidingFriction = i == smooth || random.Next(12) == 0 ? 0 : Any(0.05, most),
                    RollingResistance = resists ? Any(0.01, 0.2) : 0,
                    RollingResistancePerSpeed = resists ? Any(0, 0.01) : 0,
                    SpinDamping = resists ? Any(0, 1e-3) : 0,
                    TorsionalPatchRadius = resists && random.Next(3) > 0 ? Any(0, 0.03) : 0,
                },
            });
        }

        return new Scene
        {
            Air = airs ? new Air { Wind = 4 * Vector(1) } : new Air { Density = 0 },
            Ball = new BallProperties { Radius = Radius },
            Gravity = Gravity,
            Ground = Ground.None,
            Obstacles = obstacles,
        };
    }

    /// <summary>A motion that keeps all gaps; null if there is none.</summary>
    private static FootballPhysics.Motion? MotionOf(Random random, World world, Moving moving)
    {
        Vector3d Vector(double size) => size * new Vector3d((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        Collider[] all = world.Colliders.ToArray();
        Vector3d[] normals = [.. all.Select(at => at.At(s_place, 0).Normal)];
        Vector3d v = moving is Moving.Stands or Moving.Spins ? Vector3d.Zero : Vector(4);
        double off = 0;
        for (int round = 0; round < 1000 && (round == 0 || off > 1e-13); round++)
        {
            off = 0;
            for (int i = 0; i < all.Length; i++)
            {
                double rate = Vector3d.Dot(v - all[i].Velocity, normals[i]);
                off = Math.Max(off, Math.Abs(rate));
                v -= rate * normals[i];
            }
        }

        if (off > 1e-13)
        {
            return null;
        }

        Vector3d n = normals[0];
        Vector3d along = normals.Length > 1 ? Vector3d.Cross(normals[0], normals[1]).Normalized() : default;
        double spin = random.Next(3) == 0 ? 0 : (20 * random.NextDouble()) - 10;
        v = v.Length < 1e-9 ? Vector3d.Zero : v;
        Vector3d w = moving switch
        {
            Moving.Slides => Vector(30),
            Moving.Rolls => (Vector3d.Cross(n, v - all[0].SurfaceVelocity(s_place - (Radius * n), n, 0)) / Radius) + ((spin + Vector3d.Dot(all[0].Spin, n)) * n),
            Moving.RollsInGutter => Vector3d.Dot(v, along) / (Radius * (1 + Vector3d.Dot(normals[0], normals[1]))) * Vector3d.Cross(normals[0] + normals[1], along),
            Moving.Spins => (spin + 12) * n,
            _ => Vector3d.Zero,
        };
        return new FootballPhysics.Motion(s_place, v, w);
    }
}
