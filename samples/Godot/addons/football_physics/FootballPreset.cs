#nullable enable
using System;
using Godot;

namespace Football.Physics.GodotAddon;

/// <summary>Ball, air, ground and method as a resource that any number of balls share.</summary>
[GlobalClass, Icon("res://addons/football_physics/icon.svg")]
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
        Custom,
    }

    /// <summary>Grounds to choose from.</summary>
    public enum GroundChoice
    {
        Turf,
        WetTurf,
        Court,
        Sand,
        Custom,
    }

    /// <summary>Laws of the air to choose from.</summary>
    public enum AirChoice
    {
        Published,
        Regularised,
        Constant,
        Vacuum,
        Measured,
    }

    /// <summary>Which ball.</summary>
    [Export]
    public BallChoice Ball { get; set; } = BallChoice.Football;

    /// <summary>Mass of a custom ball, kg.</summary>
    [Export(PropertyHint.Range, "0.01,20,0.001,suffix:kg")]
    public float CustomMass { get; set; } = 0.43f;

    /// <summary>Radius of a custom ball, m.</summary>
    [Export(PropertyHint.Range, "0.01,2,0.001,suffix:m")]
    public float CustomRadius { get; set; } = 0.11f;

    /// <summary>Which ground.</summary>
    [Export]
    public GroundChoice Surface { get; set; } = GroundChoice.Turf;

    /// <summary>Part of the vertical speed that a bounce on a custom ground gives back.</summary>
    [Export(PropertyHint.Range, "0,1,0.01")]
    public float CustomRestitution { get; set; } = 0.6f;

    /// <summary>Friction of a ball that slides on a custom ground.</summary>
    [Export(PropertyHint.Range, "0,2,0.01")]
    public float CustomSlidingFriction { get; set; } = 0.5f;

    /// <summary>Friction of a ball that rolls on a custom ground.</summary>
    [Export(PropertyHint.Range, "0,1,0.001")]
    public float CustomRollingFriction { get; set; } = 0.05f;

    /// <summary>Which laws of the air.</summary>
    [Export]
    public AirChoice Laws { get; set; } = AirChoice.Published;

    /// <summary>The one-step method.</summary>
    [Export]
    public Integrator Integrator { get; set; } = Integrator.Rk4;

    /// <summary>Height of the ground, m.</summary>
    [Export(PropertyHint.Range, "-1000,1000,0.01,suffix:m")]
    public float GroundHeight { get; set; }

    /// <summary>Density of the air, kg/m³.</summary>
    [Export(PropertyHint.Range, "0,10,0.001,suffix:kg/m³")]
    public float AirDensity { get; set; } = 1.2f;

    /// <summary>Gravity, m/s².</summary>
    [Export(PropertyHint.Range, "0,30,0.01,suffix:m/s²")]
    public float Gravity { get; set; } = 9.81f;

    /// <summary>Wind, m/s; at most 1000.</summary>
    [Export(PropertyHint.None, "suffix:m/s")]
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
                BallChoice.Custom => BallProperties.Football with { Mass = CustomMass, Radius = CustomRadius },
                _ => throw new InvalidOperationException($"There is no ball {Ball}."),
            },
            Ground = Surface switch
            {
                GroundChoice.Turf => Ground.Turf,
                GroundChoice.WetTurf => Ground.WetTurf,
                GroundChoice.Court => Ground.Court,
                GroundChoice.Sand => Ground.Sand,
                GroundChoice.Custom => Ground.Turf with
                {
                    NormalRestitution = CustomRestitution,
                    SlidingFriction = CustomSlidingFriction,
                    RollingFriction = CustomRollingFriction,
                },
                _ => throw new InvalidOperationException($"There is no ground {Surface}."),
            },
            Forces = Laws switch
            {
                AirChoice.Published => ForceSet.Published,
                AirChoice.Regularised => ForceSet.Regularised,
                AirChoice.Constant => ForceSet.Constant,
                AirChoice.Vacuum => ForceSet.None,
                AirChoice.Measured => ForceSet.Measured,
                _ => throw new InvalidOperationException($"There are no laws {Laws}."),
            },
            Gravity = Gravity == 9.81f ? 9.81 : Gravity,
            Air = new Air { Density = AirDensity, Wind = GodotFrame.FromGodot(Wind) },
        };
        scene = scene with { Ground = scene.Ground with { Height = GroundHeight } };
        return new Simulator(scene, new SolverSettings { Integrator = Integrator });
    }
}
