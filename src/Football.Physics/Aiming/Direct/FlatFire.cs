using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A closed-form flight, accurate to a few centimetres at 20 m; the initial guess of the solvers.</summary>
/// <remarks>
/// Quadratic drag acts along the path. Gravity and Magnus force displace the ball across the path, damped by the same drag. All coefficients are means.
/// </remarks>
internal struct FlatFire
{
    /// <summary>The longest path, in lengths over which drag divides the speed by e.</summary>
    private const double MostDamping = 5;

    /// <summary>The relative distance at which a kick counts as reaching the target; it equals the error of the model.</summary>
    private const double Closeness = 0.005;

    /// <summary>The drag per length k, |u̇| = k |u|², in 1/m.</summary>
    public double Drag;

    /// <summary>The Magnus acceleration per unit of spin axis × velocity, in 1/s.</summary>
    public double Lift;

    /// <summary>The upward acceleration, in m/s².</summary>
    public double Upward;

    /// <summary>Returns the path length, its rate, and the two damped displacements, for launch speed x after time t.</summary>
    public readonly void Ways(double x, double t, out double along, out double speed, out double fall, out double bend)
    {
        // τ is the path length, relative to the length over which drag divides the speed by e. If τ is small, a series avoids rounding errors.
        double tau = Drag * x * t;
        double log;
        double half;
        double third;
        if (tau < 0.01)
        {
            log = 1.0 - (tau * (0.5 - (tau * (1.0 / 3.0))));
            half = 0.5 - (tau * ((1.0 / 6.0) - (tau * 0.125)));
            third = 0.5 - (tau * ((1.0 / 3.0) - (tau * 0.25)));
        }
        else
        {
            log = Elementary.Log(1.0 + tau) / tau;
            half = ((2.0 + tau) - (2.0 * log)) / (4.0 * tau);
            third = (1.0 - log) / tau;
        }

        along = x * t * log; // the path length, ln(1 + τ)/k, with the drag k per length
        speed = x / (1.0 + tau);
        fall = t * t * half; // the way of the speed w by an acceleration of 1: w' + k v w = 1
        bend = x * t * t * third; // the same by an acceleration of v: w' + k v w = v
    }

    /// <summary>Returns the time in which a kick covers a path length, in s.</summary>
    public readonly double TimeFor(double speed, double way) =>
        Drag * way > 1e-6 ? (Elementary.Exp(Math.Min(Drag * way, MostDamping)) - 1.0) / (Drag * speed) : way / speed;

    /// <summary>Returns the airspeed vector with which a ball reaches a position at a time.</summary>
    /// <param name="way">The position relative to the air.</param>
    /// <param name="axis">The unit axis of the spin, or zero.</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="direction">The unit direction of the velocity.</param>
    /// <param name="along">The derivative of the position along the velocity, in s.</param>
    /// <param name="across">The derivative of the position across the velocity, in s.</param>
    public readonly Vector3d Launch(in Vector3d way, in Vector3d axis, double time, out Vector3d direction, out double along, out double across)
    {
        // Iterate: the direction determines the displacements due to gravity and the Magnus force, and these determine the direction.
        double x = Math.Max(way.Length, 1e-3) / time;
        Vector3d air = Vector3d.Zero;
        for (int i = 0; i < 5; i++)
        {
            Ways(x, time, out _, out _, out double fall, out double bend);
            Vector3d a = way - new Vector3d(0, Upward * fall, 0) - (Lift * bend * Vector3d.Cross(in axis, in air));
            double size = Math.Max(a.Length, 1e-6);
            air = a / size;

            // The path length in the time t from the speed x, with the drag k per length: s = ln(1 + k x t)/k.
            double ks = Math.Min(Drag * size, MostDamping);
            x = (ks > 1e-6 ? (Elementary.Exp(ks) - 1.0) / Drag : size) / time;
        }

        Ways(x, time, out double went, out double speed, out _, out _);

        // The end p moves with the velocity v at the start: ∂p/∂v is t/(1 + τ) along the path, and s/x across it, with the time t, the path length s,
        // the speed x and τ = k x t.
        direction = air;
        along = time * speed / x;
        across = went / x;
        return x * air;
    }

    /// <summary>Returns the airspeed in a direction û of a ball kicked at speed v, |x û + W| = v; NaN if there is none.</summary>
    /// <param name="v">The speed of the kick.</param>
    /// <param name="along">W·û.</param>
    /// <param name="windSquared">|W|².</param>
    public static double AirSpeed(double v, double along, double windSquared)
    {
        double discriminant = (along * along) + (v * v) - windSquared;
        return discriminant > 0 ? Math.Sqrt(discriminant) - along : double.NaN;
    }

    /// <summary>Finds launch direction and time for a target.</summary>
    /// <param name="toTarget">The vector from the ball to the target.</param>
    /// <param name="wind">The wind minus the target's velocity.</param>
    /// <param name="launchWind">The wind.</param>
    /// <param name="v">The speed of the kick.</param>
    /// <param name="spins">The spins of the kick; their axis turns with its direction.</param>
    /// <param name="direction">The unit vector of the kick's velocity; its initial value is the start of the search.</param>
    /// <param name="time">The time to the target; its initial value is the start of the search.</param>
    /// <returns>False if the model does not reach the target; the direction is then the closest found.</returns>
    public readonly bool Solve(
        in Vector3d toTarget, in Vector3d wind, in Vector3d launchWind, double v, in Kick spins, ref Vector3d direction, ref double time)
    {
        // Solve for the time by Newton's method. Subtract the displacements due to gravity, wind and Magnus force from the vector to the target: the
        // remainder gives the direction, and its length minus the path length is the excess. Stop within the error of the model.
        double x = (v * direction - launchWind).Length;
        Vector3d air = x > 0 ? (v * direction - launchWind) / x : direction;
        double spinRate = spins.SpinRate;
        double perSpin = spinRate > 0 ? Lift / spinRate : 0;
        double t = time;
        double best = double.PositiveInfinity;
        for (int i = 0; i < 12; i++)
        {
            Ways(x, t, out double along, out double speed, out double fall, out double bend);

            // The spin ω = top (ŷ × d) + side ŷ, with the horizontal direction d.
            double flat = Math.Sqrt((direction.X * direction.X) + (direction.Z * direction.Z));
            double top = flat > 0 ? perSpin * spins.Top / flat : 0;
            var axis = new Vector3d(top * direction.Z, perSpin * spins.Side, -(top * direction.X));
            Vector3d a = toTarget - (t * wind) - new Vector3d(0, Upward * fall, 0) - (bend * Vector3d.Cross(in axis, in air));
            double size = a.Length;
            if (!(size > 1e-9))
            {
                return false;
            }

            air = a / size;

            double into = AirSpeed(v, Vector3d.Dot(in air, in launchWind), launchWind.LengthSquared);
            x = double.IsNaN(into) ? x : into;
            x = x > 1e-3 * v ? x : 1e-3 * v;
            direction = ((x * air) + launchWind) / v;
            double excess = size - along;
            time = t;

            // The derivative of the excess, d|a|/dt − s'.
            double slope = -Vector3d.Dot(in air, in wind) - (Upward * air.Y * (fall > 0 ? 2.0 * fall / t : 0)) - speed;
            if (Math.Abs(excess) < Closeness * size)
            {
                return true;
            }

            if (!(slope < 0) || (i > 6 && Math.Abs(excess) >= best))
            {
                return false;
            }

            best = Math.Abs(excess);

            // Limit a Newton step to a factor of about three, because the slope is meaningless far from the root.
            double next = t - (excess / slope);
            t = next > 3.0 * t ? 3.0 * t : next < 0.3 * t ? 0.3 * t : next;
        }

        return false;
    }
}
