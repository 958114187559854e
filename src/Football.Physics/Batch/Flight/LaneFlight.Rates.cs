using System.Runtime.CompilerServices;
#if !NET8_0_OR_GREATER
using F = Football.Physics.Lanes1;
#endif

namespace Football.Physics;

/// <content>The integrators and the laws.</content>
#if NET8_0_OR_GREATER
internal sealed partial class LaneFlight<F, TLaw, TMethod>
#else
internal sealed partial class LaneFlight<TLaw, TMethod>
#endif
{
    /// <summary>The changes of velocity, spin and place in a step.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Integrate<TBranch>(
        in LaneAir air, F inside, F nx, F ny, F nz, F h, F ux, F uy, F uz, F w,
        out F dux, out F duy, out F duz, out F dw, out F dpx, out F dpy, out F dpz)
        where TBranch : struct, ILaneBranch
    {
        F gx = F.Of(air.AlongX);
        F gy = F.Of(air.AlongY);
        F ax = default;
        F ay = default;
        F az = default;
        F b = default;
        F vx = ux;
        F vy = uy;
        F vz = uz;
        F sumX = default;
        F sumY = default;
        F sumZ = default;
        F sumB = default;
        F earlyX = default; // k1 + k2 + k3 in the end
        F earlyY = default;
        F earlyZ = default;
        Begin(in air, w, out F perSpin, out F dragPower, out F liftPower, out F spins);
        bool noSpin = Jumps && !default(TBranch).AllWithSpin && !F.Any(inside);
        F half = F.Of(0.5f) * h;
        for (int stage = 0; stage < default(TMethod).Stages; stage++)
        {
            // Rk4: f(y), f(y + h/2 k1), f(y + h/2 k2), f(y + h k3), weights 1 2 2 1. Rk2: f(y), f(y + h/2 k1).
            F ahead = stage < 3 ? half : h;
            earlyX += ax;
            earlyY += ay;
            earlyZ += az;
            vx = F.Plus(ux, ahead, ax);
            vy = F.Plus(uy, ahead, ay);
            vz = F.Plus(uz, ahead, az);
            F vw = F.Plus(w, ahead, b);
            if (default(TLaw).Air)
            {
                Factors<TBranch>(
                    in air, inside, noSpin, perSpin, dragPower, liftPower, w, F.Squares(vx, vy, vz), vw,
                    out F drag, out F lift, out F decay);

                // L (ω̂ × u) − D u + g
                ax = F.Minus(lift, F.Minus(ny, vz, nz, vy), drag, vx) + gx;
                ay = F.Minus(lift, F.Minus(nz, vx, nx, vz), drag, vy) + gy;
                az = F.Minus(lift, F.Minus(nx, vy, ny, vx), drag, vz);
                b = F.Select(spins, default(F) - decay, default);
            }
            else
            {
                ax = gx;
                ay = gy;
            }

            if (default(TMethod).Stages == 4)
            {
                F weight = F.Of(stage == 1 || stage == 2 ? 2f : 1f);
                sumX = F.Plus(sumX, weight, ax);
                sumY = F.Plus(sumY, weight, ay);
                sumZ = F.Plus(sumZ, weight, az);
                sumB = F.Plus(sumB, weight, b);
            }
        }

        if (default(TMethod).Stages == 4)
        {
            // The sum of the velocities, 6 u + h (k1 + k2 + k3), apart: so that the small part is rounded by itself.
            F sixth = h * F.Of(1f / 6f);
            F squared = h * sixth;
            dux = sixth * sumX;
            duy = sixth * sumY;
            duz = sixth * sumZ;
            dw = sixth * sumB;
            dpx = F.Plus(h * ux, squared, earlyX);
            dpy = F.Plus(h * uy, squared, earlyY);
            dpz = F.Plus(h * uz, squared, earlyZ);
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

    /// <summary>What the laws need of the spin, once a step.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Begin(in LaneAir air, F w, out F perSpin, out F dragPower, out F liftPower, out F spins)
    {
        spins = F.Less(default, w);
        perSpin = default;
        dragPower = default;
        liftPower = default;
        if (default(TLaw).Fitted)
        {
            F one = F.Of(1f);
            F surface = air.Radius * w;
            perSpin = F.Select(spins, one / F.Select(spins, w, one), default);
            F z = Log2(F.AtLeast(surface, F.Of(LanePowers.LeastSurfaceSpeed)), LanePowers.SpinCentre);
            F zz = z * z;
            F zzzz = zz * zz;

            // (r|ω|)^β = r|ω| · 2^(−0.17 z): relative error 4e-7 with coefficients in float.
            F high = F.Cubic(z, zz, 8.03197054e-06f, -1.89066611e-07f, 3.73256759e-09f, -6.56786639e-11f);
            F power = F.Plus(
                F.Cubic(z, zz, 0.999999881f, -0.117834978f, 0.0069425744f, -0.00027269873f),
                zzzz,
                F.Plus(high, zzzz, F.Of(8.83904169e-13f)));
            liftPower = (air.Lift * surface) * power;

            // c (r|ω|)^d: 2^(0.3056 z), relative error 2e-7.
            z = z - F.Of(LanePowers.SpinDragCentre - LanePowers.SpinCentre);
            zz = z * z;
            zzzz = zz * zz;
            high = F.Cubic(z, zz, 8.38821506e-05f, 3.55078078e-06f, 1.25793065e-07f, 3.95011446e-09f);
            power = F.Plus(
                F.Cubic(z, zz, 0.99999994f, 0.211825743f, 0.0224351212f, 0.00158413267f),
                zzzz,
                F.Plus(high, zzzz, F.Of(9.71750666e-11f)));
            dragPower = LanePowers.DragConstant * power;
        }
    }

    /// <summary>The factors of a = −drag · u + lift · (ω̂ × u) and ω̇ = −decay.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Factors<TBranch>(
        in LaneAir air, F inside, bool noSpin, F perSpin, F dragPower, F liftPower, F spin, F speedSquared, F stageSpin,
        out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch
    {
        F speed = F.Sqrt(speedSquared);
        if (!default(TLaw).Fitted)
        {
            drag = F.Of(air.Drag) * speed;
            lift = F.Of(air.Lift) * stageSpin;
            decay = F.Of(air.Decay) * stageSpin;
            return;
        }

        F one = F.Of(1f);
        F z = Log2(F.AtLeast(speedSquared, F.Of(LanePowers.LeastSpeedSquared)), LanePowers.SpeedCentre);
        F zz = z * z;
        F zzzz = zz * zz;

        // (1 + δ)^q to second order: the spin hardly changes within a step.
        F delta = F.AtLeast((stageSpin - spin) * perSpin, F.Of(-1f));
        F squared = delta * delta;
        F coefficient = default;
        if (!noSpin)
        {
            // c (r|ω|/|u|)^d: 2^(−0.1528 z), relative error 6e-8.
            F power = F.Plus(
                F.Cubic(z, zz, 1f, -0.105912909f, 0.00560878497f, -0.000198011112f),
                zzzz,
                F.Cubic(z, zz, 5.24160578e-06f, -1.1114377e-07f, 2.00354622e-09f, -2.91470043e-11f));
            F onDrag = F.Parabola(delta, squared, 1f, (float)FittedDrag.D, (float)(FittedDrag.D * (FittedDrag.D - 1) / 2));
            coefficient = (dragPower * onDrag) * power;
        }

        if (!default(TBranch).AllWithSpin)
        {
            F free = WithoutSpin(speed);
            coefficient = default(TLaw).Regularised ? Blend(in air, speed, stageSpin, coefficient, free) : F.Select(inside, coefficient, free);
        }

        // |u|^(1−β): 2^(0.085 z), relative error 2e-8.
        F forLift = F.Plus(
            F.Cubic(z, zz, 1f, 0.0589175187f, 0.00173563533f, 3.40851402e-05f),
            zzzz,
            F.Parabola(z, zz, 5.0212185e-07f, 5.9638845e-09f, 5.77408468e-11f));
        F onLift = F.Parabola(delta, squared, 1f, (float)EmpiricalMagnus.Beta, (float)(EmpiricalMagnus.Beta * (EmpiricalMagnus.Beta - 1) / 2));

        // |u|^(−0.2): 2^(−0.1 z), relative error 1e-6. (1 + x)^1.8 + |1 − x|^1.8 = 2 + 1.44 x² within 1.3 % for x = r|ω|/(2|u|) up to 1.
        F forDecay = F.Plus(
            F.Cubic(z, zz, 1.00000072f, -0.0693144798f, 0.00240200292f, -5.55193255e-05f),
            zzzz,
            F.Parabola(z, zz, 9.74632371e-07f, -1.32054279e-08f, 0f));

        drag = (air.Drag * coefficient) * speed;
        lift = ((liftPower * onLift) * forLift) * F.AtLeast(F.Of(air.DragAtRest) - coefficient, default);
        decay = (air.Decay * forDecay) * F.Plus(speedSquared, air.Plates * stageSpin, stageSpin);
    }

    /// <summary>C_D = a + b / (1 + exp((|u| − v_c)/v_s)).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static F WithoutSpin(F speed)
    {
        F x = (speed - F.Of((float)FittedDrag.CriticalSpeed)) * F.Of((float)(1.4426950408889634 / FittedDrag.SpeedScale));
        return F.Of((float)FittedDrag.A) + (F.Of((float)FittedDrag.B) / (F.Of(1f) + Exp2(F.AtMost(x, F.Of(100f)))));
    }

    /// <summary>w = σ((|u| − v_c)/0.25) · σ((Sp − 0.05)/0.0025), C_D = w c Sp^d + (1 − w) C_D,no spin.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static F Blend(in LaneAir air, F speed, F spin, F withSpin, F withoutSpin)
    {
        F one = F.Of(1f);
        F parameter = (F.Of(air.Radius) * F.AtLeast(spin, default)) / F.AtLeast(speed, F.Of(1e-3f));
        F bySpeed = (F.Of((float)FittedDrag.CriticalSpeed) - speed) * F.Of((float)(1.4426950408889634 / 0.25));
        F bySpin = (F.Of((float)FittedDrag.CriticalSpin) - parameter) * F.Of((float)(1.4426950408889634 / 0.0025));
        F low = F.Of(-100f);
        F high = F.Of(60f);
        F weight = one / ((one + Exp2(F.AtMost(F.AtLeast(bySpeed, low), high))) * (one + Exp2(F.AtMost(F.AtLeast(bySpin, low), high))));
        return withoutSpin + (weight * (withSpin - withoutSpin));
    }

    /// <summary>Whether the published drag law's branch with spin holds: |u| &gt; v_c and Sp &gt; 0.05.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F InsideOf(in LaneAir air, F ux, F uy, F uz, F spin) => F.Less(default, LeastOf(in air, ux, uy, uz, spin));

    /// <summary>The lesser of |u|² − v_c² and (r|ω|/0.05)² − |u|².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F LeastOf(in LaneAir air, F ux, F uy, F uz, F spin)
    {
        F squared = F.Squares(ux, uy, uz);
        F bySpeed = squared - F.Of((float)(FittedDrag.CriticalSpeed * FittedDrag.CriticalSpeed));
        F bySpin = (F.Of(air.Jump) * (spin * spin)) - squared;
        return F.AtMost(bySpeed, bySpin);
    }

    /// <summary>log₂ x less a constant. Absolute error 1e-7 and the rounding of the result.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Log2(F x, float less)
    {
        // log₂ m = s (A + B s² + C s⁴), s = (m − 1)/(m + 1)
        F one = F.Of(1f);
        F.Split(x, out F m, out F e);
        F s = (m - one) / (m + one);
        F ss = s * s;
        return F.Plus(e - F.Of(less), s, F.Parabola(ss, ss * ss, 2.88539052f, 0.961588323f, 0.59578073f));
    }

    /// <summary>2^x for −126 ≤ x ≤ 127. Relative error 2e-7.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Exp2(F x)
    {
        F shift = F.Of(12582912f); // adding 1.5 · 2^23 rounds to a whole number
        F k = (x + shift) - shift;
        F r = x - k;
        F rr = r * r;
        F p = F.Plus(F.Cubic(r, rr, 1.00000012f, 0.693146944f, 0.240221202f, 0.0555071309f), rr * rr, F.Parabola(r, rr, 0.00967554096f, 0.00132764713f, 0f));
        return p * F.Power2(k);
    }
}
