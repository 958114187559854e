namespace Football.Physics;

/// <summary>Scenes whose laws are scaled and in which nothing else acts, for the default method: a fit simulates thousands of them.</summary>
internal sealed class ScaledProfile : AirProfile
{
    private ScaledProfile()
    {
    }

    public static ScaledProfile Instance { get; } = new();

    public override string Name => "Scaled";

    internal override Stepper Compile(Scene scene, SolverSettings settings) =>
        settings.Integrator == Integrator.Rk4 && ScaledLaws.TryOf(scene, out ScaledLaws laws)
            ? new Stepper<ScaledLaws, ClassicalRungeKutta>(scene, settings, in laws)
            : All.Compile(scene, settings);

    private protected override bool HasLaws(ForceSet forces) => true;
}
