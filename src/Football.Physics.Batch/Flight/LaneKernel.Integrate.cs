using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <content>The integrators.</content>
#if NET8_0_OR_GREATER
internal sealed partial class LaneKernel<F, TLaw, TMethod>
#else
internal sealed partial class LaneKernel<TLane, TLaw, TMethod>
#endif
{
    /// <summary>Computes the changes of velocity, spin and position in a step.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private static void Integrate<TBranch>(
        ref TLaw law, in LaneWeight weight, TBranch branch, F nx, F ny, F nz, F h, F ux, F uy, F uz, F w,
        out F dux, out F duy, out F duz, out F dw, out F dpx, out F dpy, out F dpz)
        where TBranch : struct, ILaneBranch<F>
    {
        F gx = F.Of(weight.AlongX);
        F gy = F.Of(weight.AlongY);
        F ax = default;
        F ay = default;
        F az = default;
        F b = default;
        F vx = ux;
        F vy = uy;
        F vz = uz;
        F firstX = default; // k1
        F firstY = default;
        F firstZ = default;
        F firstB = default;
        F middleX = default; // k2 + k3
        F middleY = default;
        F middleZ = default;
        F middleB = default;
        F spins = F.Less(default, w);
        law.Begin(w, out LaneSpin<F> step);
        F half = F.Of(0.5f) * h;
        for (int stage = 0; stage < default(TMethod).Stages; stage++)
        {
            // Rk4: f(y), f(y + h/2 k1), f(y + h/2 k2), f(y + h k3). Rk2: f(y), f(y + h/2 k1).
            F ahead = stage < 3 ? half : h;
            vx = F.Plus(ux, ahead, ax);
            vy = F.Plus(uy, ahead, ay);
            vz = F.Plus(uz, ahead, az);
            F vw = F.Plus(w, ahead, b);
            if (law.Acts)
            {
                Accelerate(ref law, in step, branch, nx, ny, nz, vx, vy, vz, vw, gx, gy, spins, out ax, out ay, out az, out b);
            }
            else
            {
                ax = gx;
                ay = gy;
            }

            if (default(TMethod).Stages == 4 && stage == 0)
            {
                firstX = ax;
                firstY = ay;
                firstZ = az;
                firstB = b;
            }
            else if (default(TMethod).Stages == 4 && stage < 3)
            {
                middleX += ax;
                middleY += ay;
                middleZ += az;
                middleB += b;
            }
        }

        if (default(TMethod).Stages == 4)
        {
            Weigh(h, half, ux, firstX, middleX, ax, out dux, out dpx);
            Weigh(h, half, uy, firstY, middleY, ay, out duy, out dpy);
            Weigh(h, half, uz, firstZ, middleZ, az, out duz, out dpz);
            Weigh(h, half, w, firstB, middleB, b, out dw, out _);
        }
        else
        {
            dux = h * ax;
            duy = h * ay;
            duz = h * az;
            dw = h * b;
            dpx = h * vx;
            dpy = h * vy;
            dpz = h * vz;
        }
    }
    /// <summary>Computes the acceleration, m/s², and the angular acceleration about the axis of the spin, rad/s², of one stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Accelerate<TBranch>(
        ref TLaw law, in LaneSpin<F> step, TBranch branch, F nx, F ny, F nz, F vx, F vy, F vz, F w, F gx, F gy, F spins,
        out F ax, out F ay, out F az, out F b)
        where TBranch : struct, ILaneBranch<F>
    {
        F across = law.NeedsSpinAcross
            ? F.Squares(F.Minus(ny, vz, nz, vy), F.Minus(nz, vx, nx, vz), F.Minus(nx, vy, ny, vx))
            : default;
        law.Evaluate(in step, in branch, F.Squares(vx, vy, vz), across, w, out F drag, out F lift, out F decay);

        // L (ω̂ × u) − D u + g
        ax = F.Minus(lift, F.Minus(ny, vz, nz, vy), drag, vx) + gx;
        ay = F.Minus(lift, F.Minus(nz, vx, nx, vz), drag, vy) + gy;
        az = F.Minus(lift, F.Minus(nx, vy, ny, vx), drag, vz);
        b = F.Select(spins, default(F) - decay, default);
    }

    /// <summary>Computes the change of one component of the velocity or of the spin, and of the path, from the four stages of the Runge–Kutta method.</summary>
    /// <remarks>
    /// (k1 + 2 k2 + 2 k3 + k4)/6 = m + (k1 + k4 − 2 m)/6 and (k1 + k2 + k3)/3 = m + (k1 − m)/3 with m = (k2 + k3)/2, so the inexact factors
    /// 1/3 and 1/6 multiply only small numbers. The sum of the velocities, u + h/2 (k1 + k2 + k3)/3, is rounded separately for the same reason.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Weigh(F h, F half, F u, F first, F middle, F last, out F du, out F dp)
    {
        F mean = F.Of(0.5f) * middle;
        du = h * F.Plus(mean, F.Of(1f / 6f), (first + last) - middle);
        dp = F.Plus(h * u, h * half, F.Plus(mean, F.Of(1f / 3f), first - mean));
    }
}
