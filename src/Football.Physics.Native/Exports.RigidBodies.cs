using System.Runtime.InteropServices;

namespace FootballPhysics.Native;

/// <content>The force of the air on bodies that the caller's engine moves.</content>
internal static unsafe partial class Exports
{
    /// <summary>
    /// Computes the force and torque of the air on many bodies that another engine moves: drag, Magnus force, spin decay and wind, as in a flight of the library.
    /// Gravity and buoyancy are not included. Ground and obstacles are ignored. Allocates nothing.
    /// </summary>
    /// <param name="scene">The scene; its ball gives mass, radius and moment of inertia.</param>
    /// <param name="n">The number of bodies, 0 or more.</param>
    /// <param name="position">n rows x, y, z, m; components within +-1e6. Only a wind that varies by position depends on it.</param>
    /// <param name="velocity">n rows x, y, z, m/s; speed at most 1000.</param>
    /// <param name="spin">n rows x, y, z, rad/s; at most 10 000.</param>
    /// <param name="time">Time, s; 0 ... 1e12. Only a wind that varies in time depends on it.</param>
    /// <param name="airDistance">n distances flown through the air since the kick, m, for the knuckle force; null for 0.</param>
    /// <param name="orientation">n rows x, y, z, w, of any length except 0, for the knuckle force; null for the identity.</param>
    /// <param name="force">Receives n rows x, y, z, N.</param>
    /// <param name="torque">Receives n rows x, y, z, N m; null to skip them.</param>
    /// <returns>FP_OK; FP_ARGUMENT or FP_HANDLE, with nothing written.</returns>
    [UnmanagedCallersOnly(EntryPoint = "fp_air_many")]
    public static NativeStatus AirMany(
        [In] NativeScene* scene,
        long n,
        [In] double* position,
        [In] double* velocity,
        [In] double* spin,
        double time,
        [In] double* airDistance,
        [In] double* orientation,
        double* force,
        double* torque)
    {
        try
        {
            Aerodynamics air = Guard.SceneOf(scene).Aerodynamics;
            Guard.Several(position, n, "position");
            Guard.Several(velocity, n, "velocity");
            Guard.Several(spin, n, "spin");
            Guard.Several(force, n, "force");

            // The first pass only checks the arguments.
            for (long i = 0; i < 2 * n; i++)
            {
                long body = i < n ? i : i - n;
                ForceAndTorque load = air.Evaluate(Row(position, body), Row(velocity, body), Row(spin, body), time, airDistance is null ? 0 : airDistance[body], orientation is null ? null : Turned(orientation, body));
                if (i >= n)
                {
                    Put(load.Force, force + (3 * body));
                    if (torque is not null)
                    {
                        Put(load.Torque, torque + (3 * body));
                    }
                }
            }

            return NativeStatus.Ok;
        }
        catch (Exception e)
        {
            return Guard.Fail(e);
        }
    }

    private static Quaterniond Turned(double* rows, long row) => new(rows[4 * row], rows[(4 * row) + 1], rows[(4 * row) + 2], rows[(4 * row) + 3]);
}
