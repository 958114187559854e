using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <content>One step of a group, and of one register.</content>
#if NET8_0_OR_GREATER
internal sealed partial class LaneKernel<F, TLaw, TMethod>
#else
internal sealed partial class LaneKernel<TLane, TLaw, TMethod>
#endif
{
    /// <summary>Takes a step of all balls of a group.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private void Step(LaneGroup group, float length)
    {
        LaneState now = group.Now;
        LaneState next = group.Next;
        F h = F.Of(length);
        group.CrossingCount = 0;

        // Near its extreme, where u · a = 0, the distance from the jump bends by at most g h |Δu| in a step. Twice that counts as near.
        float reach = 2f * length * _jump.Gravity;
        F reachSquared = F.Of((float)(reach * reach));
        for (int i = 0; i < group.Flying; i += F.Count)
        {
            F ux = F.Load(now.Ux, i);
            F uy = F.Load(now.Uy, i);
            F uz = F.Load(now.Uz, i);
            F w = F.Load(now.W, i);
            F inside = _law.Jumps ? F.Load(group.Inside, i) : default;
            F nx = F.Load(group.Nx, i);
            F ny = F.Load(group.Ny, i);
            F nz = F.Load(group.Nz, i);
            F dux;
            F duy;
            F duz;
            F dw;
            F dpx;
            F dpy;
            F dpz;
            if (_law.Jumps && F.All(inside))
            {
                Integrate(
                    ref _law, in _weight, default(LanesWithSpin<F>), nx, ny, nz, h, ux, uy, uz, w,
                    out dux, out duy, out duz, out dw, out dpx, out dpy, out dpz);
            }
            else
            {
                Integrate(
                    ref _law, in _weight, new LanesOnEither<F>(inside), nx, ny, nz, h, ux, uy, uz, w,
                    out dux, out duy, out duz, out dw, out dpx, out dpy, out dpz);
            }

            // Compensated sums (Kahan).
            F x = Sum(ux, F.Load(now.UxRest, i), dux, out F rest);
            F.Store(x, next.Ux, i);
            F.Store(rest, next.UxRest, i);
            F y = Sum(uy, F.Load(now.UyRest, i), duy, out rest);
            F.Store(y, next.Uy, i);
            F.Store(rest, next.UyRest, i);
            F z = Sum(uz, F.Load(now.UzRest, i), duz, out rest);
            F.Store(z, next.Uz, i);
            F.Store(rest, next.UzRest, i);
            F px = Sum(F.Load(now.Px, i), F.Load(now.PxRest, i), dpx, out rest);
            F.Store(px, next.Px, i);
            F.Store(rest, next.PxRest, i);
            F py = Sum(F.Load(now.Py, i), F.Load(now.PyRest, i), dpy, out rest);
            F.Store(py, next.Py, i);
            F.Store(rest, next.PyRest, i);
            F pz = Sum(F.Load(now.Pz, i), F.Load(now.PzRest, i), dpz, out rest);
            F.Store(pz, next.Pz, i);
            F.Store(rest, next.PzRest, i);
            F spin = F.AtLeast(w + dw, default);
            F.Store(spin, next.W, i);

            if (_law.Jumps)
            {
                F squared = F.Squares(x, y, z);
                F changed = F.Squares(dux, duy, duz);
                F bySpeed = squared - F.Of(LaneJump.SpeedSquared);
                F bySpin = (F.Of(_jump.PerSpinSquared) * (spin * spin)) - squared;
                F least = F.AtMost(bySpeed, bySpin);
                F width = bySpeed + bySpin;
                F after = F.Less(default, least);
                F near = F.Or(F.Less(least * least, reachSquared * changed), F.Less(width * width, (F.Of(16f) * squared) * changed));
                if (F.Any(F.Or(F.Differs(inside, after), near)))
                {
                    F.Store(after, group.InsideAfter, i);
                    F.Store(near, group.Near, i);
                    group.NoteCrossings(i, F.Count, in _jump, length);
                }
            }
        }

        if (group.CrossingCount > 0)
        {
            for (int i = 0; i < group.CrossingCount; i += F.Count)
            {
                CutAtJump(group.Crossed, i, h);
            }

            group.Rejoin(in _jump, length);
        }
    }

    /// <summary>Collects the balls that reached their limits, or their highest points, in a step.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private void Note(LaneGroup group, float time)
    {
        LaneState now = group.Now;
        LaneState next = group.Next;
        F t = F.Of(time);
        for (int i = 0; i < group.Flying; i += F.Count)
        {
            F drift = F.Load(group.Drift, i);
            F noted = F.Less(F.Plus(F.Load(next.Py, i), drift, t), F.Load(group.Limit, i));
            if (FindsApex)
            {
                F rises = F.Less(default, F.Load(now.Uy, i) + drift);
                F stillRises = F.And(rises, F.Less(default, F.Load(next.Uy, i) + drift));
                noted = F.Or(noted, F.Differs(rises, stillRises));
            }

            if (F.Any(noted))
            {
                group.Note(i, F.Count, time, FindsApex);
            }
        }
    }

    /// <summary>Computes the branches of the drag law at the launch.</summary>
    [MethodImpl(Hot.Path)]
    private void FindBranch(LaneGroup group)
    {
        LaneState now = group.Now;
        for (int i = 0; i < group.Flying; i += F.Count)
        {
            F inside = InsideOf(in _jump, F.Load(now.Ux, i), F.Load(now.Uy, i), F.Load(now.Uz, i), F.Load(now.W, i));
            F.Store(inside, group.Inside, i);
        }
    }

    /// <summary>Repeats a step for the balls that cross the jump in it: on the first branch up to the crossing, then on the other.</summary>
    /// <remarks>The crossing is the root of a parabola through the function that changes its sign.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining | Hot.Path)]
    private void CutAtJump(LaneCrossings balls, int i, F h)
    {
        LaneState now = balls.Now;
        LaneState next = balls.Next;
        F one = F.Of(1f);
        F ux = F.Load(now.Ux, i);
        F uy = F.Load(now.Uy, i);
        F uz = F.Load(now.Uz, i);
        F w = F.Load(now.W, i);
        F nx = F.Load(balls.Nx, i);
        F ny = F.Load(balls.Ny, i);
        F nz = F.Load(balls.Nz, i);
        var before = new LanesOnEither<F>(F.Load(balls.Inside, i));
        F endX = F.Load(next.Ux, i);
        F endY = F.Load(next.Uy, i);
        F endZ = F.Load(next.Uz, i);
        F endSpin = F.Load(next.W, i);
        F after = F.Load(balls.InsideAfter, i);
        F start = LeastOf(in _jump, ux, uy, uz, w);
        F end = LeastOf(in _jump, endX, endY, endZ, endSpin);

        // First guess: the root of the chord.
        F share = Within01(start / (start - end));
        Integrate(
            ref _law, in _weight, before, nx, ny, nz, share * h, ux, uy, uz, w,
            out F dux, out F duy, out F duz, out F dw, out F dpx, out F dpy, out F dpz);
        F between = LeastOf(in _jump, ux + dux, uy + duy, uz + duz, F.AtLeast(w + dw, default));

        // The root of the parabola start + b s + c s² through the three points, with the sign chosen so that it falls.
        F sign = F.Select(F.Less(start, default), F.Of(-1f), one);
        F early = (between - start) / share;
        F late = (end - between) / (one - share);
        F c = late - early;
        F down = sign * ((c * share) - early);
        F root = F.Sqrt(F.AtLeast((down * down) - ((F.Of(4f) * c) * start), default));
        F better = ((F.Of(2f) * sign) * start) / (down + root);
        share = F.Select(F.And(F.Less(F.Of(0.001f), share), F.Less(share, F.Of(0.999f))), Within01(better), share);
        Integrate(
            ref _law, in _weight, before, nx, ny, nz, share * h, ux, uy, uz, w, out dux, out duy, out duz, out dw, out dpx, out dpy, out dpz);
        LaneState middle = balls.Middle;
        F.Store(share, balls.Share, i);
        Add(ux, now.UxRest, dux, middle.Ux, middle.UxRest, i);
        Add(uy, now.UyRest, duy, middle.Uy, middle.UyRest, i);
        Add(uz, now.UzRest, duz, middle.Uz, middle.UzRest, i);
        Add(F.Load(now.Px, i), now.PxRest, dpx, middle.Px, middle.PxRest, i);
        Add(F.Load(now.Py, i), now.PyRest, dpy, middle.Py, middle.PyRest, i);
        Add(F.Load(now.Pz, i), now.PzRest, dpz, middle.Pz, middle.PzRest, i);
        F.Store(F.AtLeast(w + dw, default), middle.W, i);
        Integrate(
            ref _law, in _weight, new LanesOnEither<F>(after), nx, ny, nz, (one - share) * h, ux + dux, uy + duy, uz + duz, F.AtLeast(w + dw, default),
            out F eux, out F euy, out F euz, out F ew, out F epx, out F epy, out F epz);

        Add(ux, now.UxRest, dux + eux, next.Ux, next.UxRest, i);
        Add(uy, now.UyRest, duy + euy, next.Uy, next.UyRest, i);
        Add(uz, now.UzRest, duz + euz, next.Uz, next.UzRest, i);
        Add(F.Load(now.Px, i), now.PxRest, dpx + epx, next.Px, next.PxRest, i);
        Add(F.Load(now.Py, i), now.PyRest, dpy + epy, next.Py, next.PyRest, i);
        Add(F.Load(now.Pz, i), now.PzRest, dpz + epz, next.Pz, next.PzRest, i);
        F spin = F.AtLeast(w + (dw + ew), default);
        F.Store(spin, next.W, i);

        // The ball is back on its first side: it slides along the jump, or is too close to it.
        F side = InsideOf(in _jump, F.Load(next.Ux, i), F.Load(next.Uy, i), F.Load(next.Uz, i), spin);
        F.Store(F.Differs(side, after), balls.Astray, i);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Add(F from, float[] fromRest, F change, float[] to, float[] toRest, int i)
    {
        F sum = Sum(from, F.Load(fromRest, i), change, out F rest);
        F.Store(sum, to, i);
        F.Store(rest, toRest, i);
    }

    /// <summary>Adds with compensation of the rounding error (Kahan).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Sum(F sum, F rest, F change, out F left)
    {
        F whole = change - rest;
        F next = sum + whole;
        left = (next - sum) - whole;
        return next;
    }

    /// <summary>Clamps to 0 … 1; NaN becomes 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Within01(F x) => F.AtMost(F.AtLeast(x, default), F.Of(1f));

    /// <summary>True if the branch of the published law with spin holds: |u| &gt; v_c and Sp &gt; 0.05.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F InsideOf(in LaneJump jump, F ux, F uy, F uz, F spin) => F.Less(default, LeastOf(in jump, ux, uy, uz, spin));

    /// <summary>Returns the smaller of |u|² − v_c² and (r|ω|/0.05)² − |u|².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F LeastOf(in LaneJump jump, F ux, F uy, F uz, F spin)
    {
        F squared = F.Squares(ux, uy, uz);
        F bySpeed = squared - F.Of(LaneJump.SpeedSquared);
        F bySpin = (F.Of(jump.PerSpinSquared) * (spin * spin)) - squared;
        return F.AtMost(bySpeed, bySpin);
    }
}
