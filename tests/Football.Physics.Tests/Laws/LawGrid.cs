using FootballPhysics.State;

namespace FootballPhysics.Tests.Laws;

/// <summary>Speeds and spins over the whole domain of the laws, close to their jumps too.</summary>
internal static class LawGrid
{
    public static Scene Scene { get; } = new()
    {
        Ball = new BallProperties { Mass = 0.41, Radius = 0.108, InertiaFactor = 0.63 },
        Air = new Air { Density = 1.17, KinematicViscosity = 1.61e-5 },
    };

    public static IEnumerable<double> Speeds { get; } =
    [
        1e-8, 1e-3, 0.02, 0.3, 1, 3, 5, 8, 10, 11.5, 12, 12.1, 12.18, 12.1899, 12.1901, 12.2, 12.3, 12.5, 13, 14, 17, 20, 24, 28, 33, 40, 55, 80, 120, 160, 200,
    ];

    public static IEnumerable<double> Spins { get; } = [1e-6, 1e-3, 0.1, 0.7, 1.5, 3, 5, 7.7, 10, 15, 21, 30, 44, 60, 85, 130, 190, 300, 500, 750, 1000];

    public static IEnumerable<(double Speed, double Spin, double SpinParameter)> Points { get; } =
        [.. from speed in Speeds from spin in Spins select (speed, spin, Scene.Ball.Radius * spin / speed)];

    public static DragBranch BranchOf(double speed, double spinParameter) =>
        speed > PlainLaws.CriticalSpeed && spinParameter > PlainLaws.CriticalSpin ? DragBranch.Spinning : DragBranch.NoSpin;
}
