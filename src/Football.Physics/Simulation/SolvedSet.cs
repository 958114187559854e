using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Checks and corrects what the solver of a contact set returns.</summary>
internal static class SolvedSet
{
    /// <summary>Corrects the velocity and the spin after a part: no contact closes, and stationary contacts do no work on the ball.</summary>
    /// <remarks>An exact solution stays as it is.</remarks>
    /// <param name="set">The contacts.</param>
    /// <param name="world">The world.</param>
    /// <param name="h">Length of the part, s; 0 for an impact.</param>
    /// <param name="solved">True if the solver found impulses for all contacts.</param>
    /// <param name="free">Velocity and spin without contacts.</param>
    /// <param name="v">Velocity, m/s.</param>
    /// <param name="w">Spin, rad/s.</param>
    public static void Correct(Span<Contact> set, World world, double h, bool solved, in Motion free, ref Vector3d v, ref Vector3d w)
    {
        if (!solved)
        {
            double speed = v.Length;
            double most = free.Velocity.Length;
            v = speed > most ? most / speed * v : v;
            if (!KeepOff(set, world, h, movers: true, ref v) && !ContactSet.HasMover(set))
            {
                v = Vector3d.Zero;
            }
        }

        var pressed = new PressedBall(world.Ball) { V = v, W = w, FreeV = free.Velocity, FreeW = free.Spin };
        ImpulseSolver.LimitWork(MemoryMarshal.CreateSpan(ref pressed, 1), set);
        v = pressed.V;
        w = pressed.W;
    }

    /// <summary>Removes the closing components of a velocity at stationary contacts, and optionally at moving ones, by impulses without friction.</summary>
    /// <returns>False if the contacts still close.</returns>
    [SkipLocalsInit]
    public static bool KeepOff(Span<Contact> set, World world, double h, bool movers, ref Vector3d v)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> smooth = world.Spare.Of(set.Length, room);
        int count = 0;
        foreach (ref readonly Contact contact in set)
        {
            if (movers || !contact.Moves)
            {
                smooth[count++] = contact with { Gap = h > 0 ? contact.Gap : 0, Material = default, Load = 0, Rub = Vector3d.Zero };
            }
        }

        Vector3d none = Vector3d.Zero;
        return ImpulseSolver.Solve(smooth.Slice(0, count), world.Ball, h, ref v, ref none, closing: ContactTolerances.Approaching);
    }

    /// <summary>Takes the energy of a lift from the speed and the spin of a ball: a projection onto stationary contacts does no work.</summary>
    /// <param name="s">The ball after the projection.</param>
    /// <param name="set">The contacts.</param>
    /// <param name="ball">Its properties.</param>
    /// <param name="weight">The acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="from">Its position before, m.</param>
    public static void PayForLift(ref BallState s, scoped Span<Contact> set, BallProperties ball, in Vector3d weight, in Vector3d from)
    {
        // The energy per mass, ½ |v|² + ½ α r² |ω|², less the work g·δ of the weight g in the displacement δ. α is the inertia factor.
        double energy = 0.5 * (s.Velocity.LengthSquared + (ball.InertiaFactor * ball.Radius * ball.Radius * s.SpinAxis.LengthSquared));
        double lift = -Vector3d.Dot(weight, s.Position - from);
        if (lift > ContactTolerances.PieceEnergy * energy && !Drives(set))
        {
            double share = Math.Sqrt(Math.Max(0, 1.0 - (lift / energy)));
            s.Velocity = share * s.Velocity;
            s.SpinAxis = share * s.SpinAxis;
        }
    }

    /// <summary>True if a surface has a velocity, also one that turns in place: it may do work on the ball.</summary>
    /// <param name="set">The contacts.</param>
    /// <param name="movers">Whether to count only objects that can move.</param>
    public static bool Drives(Span<Contact> set, bool movers = false)
    {
        foreach (ref readonly Contact contact in set)
        {
            if ((contact.Moves || !movers) && contact.Velocity != Vector3d.Zero)
            {
                return true;
            }
        }

        return false;
    }
}
