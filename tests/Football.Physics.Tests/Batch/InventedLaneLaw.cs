using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Batch;

/// <summary>
/// A law that the library does not have, all of it in this file: C_D falls smoothly with the speed and rises with the spin parameter S,
/// C_L saturates, the spin decays in proportion to speed and spin.
/// </summary>
internal struct InventedLaneLaw<F> : ILaneLaw<F>
    where F : struct, ILane<F>
{
    private const float Slowest = 0.01f;

    private float _scale; // ½ ρ A / m
    private float _radius;

    public readonly bool Acts => true;

    public readonly bool Jumps => false;

    public readonly bool NeedsSpinAcross => false;

    public void Prepare(Scene scene)
    {
        _scale = (float)AirScale.DynamicArea(scene);
        _radius = (float)scene.Ball.Radius;
    }

    public readonly void Begin(F spin, out LaneSpin<F> step) => step = default;

    public readonly void Evaluate<TBranch>(
        in LaneSpin<F> step, in TBranch branch, F speedSquared, F acrossSquared, F spin, out F drag, out F lift, out F decay)
        where TBranch : struct, ILaneBranch<F>
    {
        F one = F.Of(1f);
        F speed = F.Sqrt(speedSquared);
        F parameter = (_radius * F.AtLeast(spin, default)) / F.AtLeast(speed, F.Of(Slowest));
        F t = speedSquared * F.Of(1f / 225f);
        F dragCoefficient = (F.Of(0.15f) + (F.Of(0.25f) / (one + (t * t)))) + ((0.2f * parameter) / (F.Of(0.3f) + parameter));
        F liftCoefficient = (0.35f * parameter) / (F.Of(0.2f) + parameter);
        drag = (_scale * dragCoefficient) * speed;
        lift = (_scale * liftCoefficient) * speed;
        decay = (0.01f * speed) * spin;
    }

    /// <summary>The same in double, as accelerations of a ball in air at rest.</summary>
    public static MotionRates Rates(Scene scene, Vector3d u, Vector3d spin)
    {
        double speed = u.Length;
        double parameter = scene.Ball.Radius * spin.Length / speed;
        double t = speed * speed / 225;
        double drag = AirScale.DynamicArea(scene) * (0.15 + (0.25 / (1 + (t * t))) + (0.2 * parameter / (0.3 + parameter))) * speed;
        double lift = AirScale.DynamicArea(scene) * 0.35 * parameter / (0.2 + parameter) * speed;
        Vector3d axis = spin / spin.Length;
        Vector3d weight = new(0, Weight.UpwardAcceleration(scene), 0);
        return new MotionRates((lift * Vector3d.Cross(axis, u)) - (drag * u) + weight, -0.01 * speed * spin);
    }
}
