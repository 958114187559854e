using System;
using Godot;

namespace Football.Physics.GodotAddon;

/// <summary>Ball, air, ground and method as a resource that any number of balls share.</summary>
[GlobalClass]
public partial class FootballPreset : Resource
{
    /// <summary>Balls to choose from.</summary>
    public enum BallChoice
    {
        Football,
        YouthFootball,
        Futsal,
        BeachBall,
        MedicineBall,
    }

    /// <summary>Grounds to choose from.</summary>
    public enum GroundChoice
    {
        Turf,
        WetTurf,
        Court,
        Sand,
    }

    /// <summary>Laws of the air to choose from.</summary>
    public enum AirChoice
    {
        Published,
        Regularised,
        Constant,
        Vacuum,
    }

    /// <summary>Which ball.</summary>
    [Export]
    public BallChoice Ball { get; set; } = BallChoice.Football;

    /// <summary>Which ground.</summary>
    [Export]
    public GroundChoice Surface { get; set; } = GroundChoice.Turf;

    /// <summary>Which laws of the air.</summary>
    [Export]
    public AirChoice Laws { get; set; } = AirChoice.Published;

    /// <summary>The one-step method.</summary>
    [Export]
    public Integrator Integrator { get; set; } = Integrator.Rk4;

    /// <summary>Height of the ground, m.</summary>
    [Export]
    public float GroundHeight { get; set; }

    /// <summary>Density of the air, kg/m³.</summary>
    [Export]
    public float AirDensity { get; set; } = 1.2f;

    /// <summary>Wind, m/s.</summary>
    [Export]
    public Vector3 Wind { get; set; }

    /// <summary>Checks and compiles the scene. Throws <see cref="ArgumentOutOfRangeException"/> where a number is out of range.</summary>
    public Simulator Compile()
    {
        var scene = new Scene
        {
            Ball = Ball switch
            {
                BallChoice.Football => BallProperties.Football,
                BallChoice.YouthFootball => BallProperties.YouthFootball,
                BallChoice.Futsal => BallProperties.Futsal,
                BallChoice.BeachBall => BallProperties.BeachBall,
                BallChoice.MedicineBall => BallProperties.MedicineBall,
                _ => throw new InvalidOperationException($"There is no ball {Ball}."),
            },
            Ground = Surface switch
            {
                GroundChoice.Turf => Ground.Turf,
                GroundChoice.WetTurf => Ground.WetTurf,
                GroundChoice.Court => Ground.Court,
                GroundChoice.Sand => Ground.Sand,
                _ => throw new InvalidOperationException($"There is no ground {Surface}."),
            },
            Forces = Laws switch
            {
                AirChoice.Published => ForceSet.Published,
                AirChoice.Regularised => ForceSet.Regularised,
                AirChoice.Constant => ForceSet.Constant,
                AirChoice.Vacuum => ForceSet.None,
                _ => throw new InvalidOperationException($"There are no laws {Laws}."),
            },
            Air = new Air { Density = AirDensity, Wind = GodotFrame.FromGodot(Wind) },
        };
        scene = scene with { Ground = scene.Ground with { Height = GroundHeight } };
        return new Simulator(scene, new SolverSettings { Integrator = Integrator });
    }
}
