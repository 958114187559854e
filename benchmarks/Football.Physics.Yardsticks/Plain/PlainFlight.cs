namespace FootballPhysics.Yardsticks;

/// <summary>The plain yardstick: a flight step in straightforward double-precision C#, as a good programmer writes it on the first day.</summary>
public abstract class PlainFlight
{
    /// <summary>Creates the flight of a ball in a scene's air.</summary>
    public static PlainFlight Create(PlainLawKind law, Integrator integrator, Scene? scene = null)
    {
        scene ??= SceneOf(law);
        return law switch
        {
            PlainLawKind.Published => new PlainFlight<PlainFitted>(new PlainFitted(scene, regularised: false), integrator, scene.Air.Wind),
            PlainLawKind.Regularised => new PlainFlight<PlainFitted>(new PlainFitted(scene, regularised: true), integrator, scene.Air.Wind),
            PlainLawKind.Constant => new PlainFlight<PlainConstant>(new PlainConstant(scene), integrator, scene.Air.Wind),
            _ => new PlainFlight<PlainVacuum>(new PlainVacuum(scene.Gravity), integrator, scene.Air.Wind),
        };
    }

    /// <summary>Returns the library's scene with the same law.</summary>
    public static Scene SceneOf(PlainLawKind law) => law switch
    {
        PlainLawKind.Published => Scene.Published,
        PlainLawKind.Regularised => Scene.Published with { Forces = ForceSet.Regularized },
        PlainLawKind.Constant => Scene.Published with { Forces = ForceSet.Constant },
        _ => Scene.Vacuum,
    };

    /// <summary>Advances a flight by one step.</summary>
    public abstract void Step(ref PlainState state, double h);
}

/// <summary>A plain flight with its law compiled in.</summary>
public sealed class PlainFlight<TLaw>(TLaw law, Integrator integrator, PlainVector wind) : PlainFlight
    where TLaw : struct, IPlainLaw
{
    private readonly TLaw _law = law;

    public override void Step(ref PlainState state, double h)
    {
        switch (integrator)
        {
            case Integrator.Euler:
                Euler(ref state, h);
                break;
            case Integrator.SemiImplicitEuler:
                SemiImplicitEuler(ref state, h);
                break;
            case Integrator.Rk2:
                Rk2(ref state, h);
                break;
            default:
                Rk4(ref state, h);
                break;
        }
    }

    private void Euler(ref PlainState s, double h)
    {
        _law.Rates(s.Velocity - wind, s.Spin, out PlainVector a, out PlainVector b);
        s.Position += h * s.Velocity;
        s.Velocity += h * a;
        s.Spin = Decayed(s.Spin, s.Spin + (h * b));
    }

    private void SemiImplicitEuler(ref PlainState s, double h)
    {
        _law.Rates(s.Velocity - wind, s.Spin, out PlainVector a, out PlainVector b);
        s.Velocity += h * a;
        s.Position += h * s.Velocity;
        s.Spin = Decayed(s.Spin, s.Spin + (h * b));
    }

    private void Rk2(ref PlainState s, double h)
    {
        _law.Rates(s.Velocity - wind, s.Spin, out PlainVector a1, out PlainVector b1);
        PlainVector v2 = s.Velocity + ((0.5 * h) * a1);
        _law.Rates(v2 - wind, s.Spin + ((0.5 * h) * b1), out PlainVector a2, out PlainVector b2);
        s.Position += h * v2;
        s.Velocity += h * a2;
        s.Spin = Decayed(s.Spin, s.Spin + (h * b2));
    }

    private void Rk4(ref PlainState s, double h)
    {
        PlainVector v1 = s.Velocity;
        _law.Rates(v1 - wind, s.Spin, out PlainVector a1, out PlainVector b1);
        PlainVector v2 = v1 + ((0.5 * h) * a1);
        _law.Rates(v2 - wind, s.Spin + ((0.5 * h) * b1), out PlainVector a2, out PlainVector b2);
        PlainVector v3 = v1 + ((0.5 * h) * a2);
        _law.Rates(v3 - wind, s.Spin + ((0.5 * h) * b2), out PlainVector a3, out PlainVector b3);
        PlainVector v4 = v1 + (h * a3);
        _law.Rates(v4 - wind, s.Spin + (h * b3), out PlainVector a4, out PlainVector b4);
        s.Position += (h / 6.0) * (v1 + (2.0 * (v2 + v3)) + v4);
        s.Velocity += (h / 6.0) * (a1 + (2.0 * (a2 + a3)) + a4);
        s.Spin = Decayed(s.Spin, s.Spin + ((h / 6.0) * (b1 + (2.0 * (b2 + b3)) + b4)));
    }

    // Decay never reverses a spin.
    private static PlainVector Decayed(PlainVector before, PlainVector after) => PlainVector.Dot(before, after) < 0 ? default : after;
}
