using System.Runtime.CompilerServices;
using FootballPhysics.State;

namespace FootballPhysics.Batch;

/// <summary>The derivatives of the rates of plain flight at one instant.</summary>
/// <remarks>
/// v̇ = λ (n × u) − D u + g, |ω|˙ = −q, where λ, D and q depend on |u|², |ω| and |n × u|², and the axis n is constant.
/// </remarks>
internal struct FlightGenerator
{
    /// <summary>The relative change of a number in a difference quotient.</summary>
    private const double Share = 1e-4;

    /// <summary>∂v̇/∂v, row by row; then ∂|ω|˙/∂v.</summary>
    private Vector3d _x;
    private Vector3d _y;
    private Vector3d _z;
    private Vector3d _spin;

    /// <summary>∂v̇/∂|ω|, and the derivatives by the axis in two directions across it.</summary>
    private Vector3d _bySpin;
    private Vector3d _byFirst;
    private Vector3d _bySecond;

    /// <summary>The gradient of |ω|˙ by the spin.</summary>
    private Vector3d _spinBySpin;

    /// <summary>Computes the derivatives from difference quotients of the laws' factors.</summary>
    /// <param name="air">The air.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="needsAcross">True if the factors depend on |n × u|².</param>
    /// <param name="u">The velocity relative to the air, in m/s.</param>
    /// <param name="spin">|ω|, in rad/s; above 0.</param>
    /// <param name="n">The axis of the spin.</param>
    /// <param name="first">A unit vector across the axis.</param>
    /// <param name="second">The other unit vector across the axis.</param>
    /// <param name="g">The result.</param>
    public static void At(
        ref SceneAir air, DragBranch branch, bool needsAcross, in Vector3d u, double spin, in Vector3d n, in Vector3d first, in Vector3d second, out FlightGenerator g)
    {
        double squared = u.LengthSquared;
        double along = Vector3d.Dot(in n, in u);
        Vector3d turned = Vector3d.Cross(in n, in u);
        double across = turned.LengthSquared;
        double bySquared = Share * squared;
        Factors(ref air, branch, squared + bySquared, spin, across, out Vector3d high);
        Factors(ref air, branch, squared - bySquared, spin, across, out Vector3d low);
        Vector3d value = 0.5 * (high + low);
        Vector3d ofSpeed = (1.0 / bySquared) * (high - low);
        double bySpin = Share * spin;
        Factors(ref air, branch, squared, spin + bySpin, across, out high);
        Factors(ref air, branch, squared, spin - bySpin, across, out low);
        Vector3d ofSpin = (0.5 / bySpin) * (high - low);
        Vector3d ofAcross = Vector3d.Zero;
        if (needsAcross && across > 1e-12 * squared)
        {
            double byAcross = Share * across;
            Factors(ref air, branch, squared, spin, across + byAcross, out high);
            Factors(ref air, branch, squared, spin, across - byAcross, out low);
            ofAcross = (1.0 / byAcross) * (high - low);
        }

        // ∇|u|² = 2u, ∇|n × u|² = 2 (u − (n·u) n); the quotients include the factors of 2. The factors are (D, λ, q).
        Vector3d plane = u - (along * n);
        Vector3d drag = (ofSpeed.X * u) + (ofAcross.X * plane);
        Vector3d lift = (ofSpeed.Y * u) + (ofAcross.Y * plane);
        Vector3d decay = (ofSpeed.Z * u) + (ofAcross.Z * plane);

        // ∂v̇/∂v = λ [n]× − D 1 + (n × u) ∇λᵀ − u ∇Dᵀ
        g._x = (turned.X * lift) - (u.X * drag) + new Vector3d(-value.X, -value.Y * n.Z, value.Y * n.Y);
        g._y = (turned.Y * lift) - (u.Y * drag) + new Vector3d(value.Y * n.Z, -value.X, -value.Y * n.X);
        g._z = (turned.Z * lift) - (u.Z * drag) + new Vector3d(-value.Y * n.Y, value.Y * n.X, -value.X);
        g._spin = -decay;
        g._bySpin = (ofSpin.Y * turned) - (ofSpin.X * u);

        // Derivative by the axis: n × u turns with it, and |n × u|² changes by −2 (n·u)(u·δn).
        double firstAcross = -along * Vector3d.Dot(in u, in first);
        double secondAcross = -along * Vector3d.Dot(in u, in second);
        g._byFirst = (value.Y * Vector3d.Cross(in first, in u)) + (firstAcross * ((ofAcross.Y * turned) - (ofAcross.X * u)));
        g._bySecond = (value.Y * Vector3d.Cross(in second, in u)) + (secondAcross * ((ofAcross.Y * turned) - (ofAcross.X * u)));
        g._spinBySpin = new Vector3d(-ofSpin.Z, -firstAcross * ofAcross.Z, -secondAcross * ofAcross.Z);
    }

    /// <summary>Computes the rates of change of columns.</summary>
    public readonly void Apply(in FlightColumns c, out FlightColumns rates)
    {
        rates.X = Row(in _x, _bySpin.X, in c, _byFirst.X, _bySecond.X);
        rates.Y = Row(in _y, _bySpin.Y, in c, _byFirst.Y, _bySecond.Y);
        rates.Z = Row(in _z, _bySpin.Z, in c, _byFirst.Z, _bySecond.Z);
        rates.Spin = Row(in _spin, _spinBySpin.X, in c, _spinBySpin.Y, _spinBySpin.Z);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FlightRow Row(in Vector3d byVelocity, double bySpin, in FlightColumns c, double byFirst, double bySecond) => new(
        (byVelocity.X * c.X.ByVelocity) + (byVelocity.Y * c.Y.ByVelocity) + (byVelocity.Z * c.Z.ByVelocity) + (bySpin * c.Spin.ByVelocity),
        (byVelocity.X * c.X.BySpin) + (byVelocity.Y * c.Y.BySpin) + (byVelocity.Z * c.Z.BySpin) + (bySpin * c.Spin.BySpin) + new Vector3d(0, byFirst, bySecond));

    /// <summary>Returns drag, lift and decay as one vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Factors(ref SceneAir air, DragBranch branch, double squared, double spin, double across, out Vector3d factors)
    {
        double drag = 0;
        double lift = 0;
        double decay = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            air.Factors(squared, spin, across, branch, out drag, out lift, out decay);
        }

        factors = new Vector3d(drag, lift, air.SpinDecays ? decay : 0);
    }
}
