#nullable enable
using System;
using FootballPhysics.Laws;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>The ball, air, ground and integrator, as a resource that several balls can share.</summary>
[Tool, GlobalClass, Icon("res://addons/football_physics/icon.svg")]
public partial class FootballPreset : Resource
{
    /// <summary>Profiles to choose from. Measured is the profile of a ball without a preset. Published has the laws and numbers of the original thesis.</summary>
    public enum ProfileChoice
    {
        Measured,
        Published,
    }

    /// <summary>Balls to choose from: the presets of <see cref="BallProperties"/> and a custom one.</summary>
    public enum BallChoice
    {
        Generic,
        Tango12,
        Teamgeist,
        Jabulani,
        Brazuca,
        YouthFootball,
        Futsal,
        BeachBall,
        MedicineBall,
        Custom,
        Modern,
        Telstar18,
        Flight2020,
        AlRihla,
        Fussballliebe,
        Trionda,
    }

    /// <summary>Grounds to choose from: the profile's, the presets of <see cref="Ground"/> and a custom one.</summary>
    public enum GroundChoice
    {
        OfProfile,
        DryTurf,
        ArtificialTurf,
        WetTurf,
        HardGround,
        LongGrass,
        Indoor,
        Concrete,
        Snow,
        PublishedTurf,
        PublishedWetTurf,
        PublishedCourt,
        PublishedSand,
        Custom,
        MatchTurf,
        None,
    }

    /// <summary>Laws of the air to choose from: the profile's and the presets of <see cref="ForceSet"/>.</summary>
    public enum AirChoice
    {
        OfProfile,
        Measured,
        Published,
        Regularised,
        Constant,
        Vacuum,
    }

    /// <summary>The profile of the ground and the laws, unless they are set below. Default: measured.</summary>
    [Export]
    public ProfileChoice Profile { get; set; } = ProfileChoice.Measured;

    /// <summary>The ball. Default: a match football.</summary>
    [Export]
    public BallChoice Ball { get; set; } = BallChoice.Modern;

    /// <summary>Mass of a custom ball, kg.</summary>
    [Export(PropertyHint.Range, "0.01,20,0.001,suffix:kg")]
    public float CustomMass { get; set; } = 0.43f;

    /// <summary>Radius of a custom ball, m.</summary>
    [Export(PropertyHint.Range, "0.02,2,0.001,suffix:m")]
    public float CustomRadius { get; set; } = 0.11f;

    /// <summary>The ground. Default: the profile's, which is match turf in the measured profile.</summary>
    [Export]
    public GroundChoice Surface { get; set; } = GroundChoice.OfProfile;

    /// <summary>Fraction of the vertical speed that a bounce on a custom ground returns.</summary>
    [Export(PropertyHint.Range, "0,1,0.001")]
    public float CustomRestitution { get; set; } = 0.67f;

    /// <summary>Friction of a ball that slides on a custom ground.</summary>
    [Export(PropertyHint.Range, "0,2,0.01")]
    public float CustomSlidingFriction { get; set; } = 0.45f;

    /// <summary>Friction of a ball that rolls on a custom ground.</summary>
    [Export(PropertyHint.Range, "0,1,0.001")]
    public float CustomRollingFriction { get; set; } = 0.064f;

    /// <summary>The laws of the air. Default: the profile's.</summary>
    [Export]
    public AirChoice Laws { get; set; } = AirChoice.OfProfile;

    /// <summary>The integrator.</summary>
    [Export]
    public Integrator Integrator { get; set; } = Integrator.Rk4;

    /// <summary>Height of the ground, m.</summary>
    [Export(PropertyHint.Range, "-1000,1000,0.01,suffix:m")]
    public float GroundHeight { get; set; }

    /// <summary>Density of the air, kg/m³.</summary>
    [Export(PropertyHint.Range, "0,10,0.001,suffix:kg/m³")]
    public float AirDensity { get; set; } = 1.2f;

    /// <summary>Kinematic viscosity of the air, mm²/s; 15 at sea level, 19.9 in Mexico City.</summary>
    [Export(PropertyHint.Range, "0.1,1000,0.1,suffix:mm²/s")]
    public float AirViscosity { get; set; } = 15;

    /// <summary>Drag factor: 1 is realistic, 0 is no drag.</summary>
    [Export(PropertyHint.Range, "0,3,0.01")]
    public float DragScale { get; set; } = 1;

    /// <summary>Bend of a spinning ball: 1 is realistic, 0 is straight.</summary>
    [Export(PropertyHint.Range, "0,3,0.01")]
    public float BendScale { get; set; } = 1;

    /// <summary>Gravity, m/s².</summary>
    [Export(PropertyHint.Range, "0,30,0.01,suffix:m/s²")]
    public float Gravity { get; set; } = 9.81f;

    /// <summary>Wind, m/s; at most 1000.</summary>
    [Export(PropertyHint.None, "suffix:m/s")]
    public Vector3 Wind { get; set; }

    /// <summary>Pressure of the ball, bar; the Laws allow 0.6 to 1.1. A soft ball bounces less.</summary>
    [Export(PropertyHint.Range, "0.6,1.1,0.01,suffix:bar")]
    public float BallPressure { get; set; } = 0.8f;

    /// <summary>Water on the pitch and in the ball: 0 no extra water, 1 soaked.</summary>
    [Export(PropertyHint.Range, "0,1,0.01")]
    public float Wetness { get; set; }

    /// <summary>Wear of the ball: 0 new, 1 worn. A worn ball flies a little farther.</summary>
    [Export(PropertyHint.Range, "0,1,0.01")]
    public float BallWear { get; set; }

    /// <summary>Mud on the pitch and on the ball: 0 none, 1 deep.</summary>
    [Export(PropertyHint.Range, "0,1,0.01")]
    public float Mud { get; set; }

    /// <summary>The solver settings of the scene.</summary>
    public SolverSettings Settings => new() { Integrator = Integrator };

    /// <summary>A hash that changes when any of these numbers changes.</summary>
    internal int Stamp => HashCode.Combine(
        HashCode.Combine((int)Profile, (int)Ball, CustomMass, CustomRadius, (int)Surface, CustomRestitution, CustomSlidingFriction, CustomRollingFriction),
        HashCode.Combine((int)Laws, (int)Integrator, GroundHeight, AirDensity, AirViscosity, DragScale, BendScale),
        HashCode.Combine(BallPressure, Wetness, BallWear, Mud),
        Gravity,
        Wind);

    /// <summary>Checks and compiles the scene. Throws <see cref="ArgumentOutOfRangeException"/> if a number is out of range.</summary>
    public Simulator Compile() => new(MakeScene(), Settings);

    /// <summary>Creates the scene from these numbers.</summary>
    public Scene MakeScene()
    {
        Scene own = Profile switch
        {
            ProfileChoice.Measured => Scene.Measured,
            ProfileChoice.Published => Scene.Published,
            _ => throw new InvalidOperationException($"Profile is {Profile}, which does not exist. Choose Measured or Published."),
        };
        Ground ground = Surface != GroundChoice.Custom ? GroundOf(Surface, own.Ground) : own.Ground with
        {
            Material = own.Ground.Material with
            {
                NormalRestitution = Typed(CustomRestitution),
                SlidingFriction = Typed(CustomSlidingFriction),
                RollingResistance = Typed(CustomRollingFriction),
            },
        };
        var dials = new Dials { Pressure = Typed(BallPressure), Wetness = Typed(Wetness), Wear = Typed(BallWear), Mud = Typed(Mud) };
        Scene scene = dials.Apply(own with
        {
            Ball = BallOf(),
            Ground = AtHeight(ground, Typed(GroundHeight)),
            Forces = ForcesOf(own.Forces),
            Gravity = Typed(Gravity),
            Air = new Air { Density = Typed(AirDensity), KinematicViscosity = Typed(AirViscosity) / 1e6, Wind = GodotFrame.FromGodot(Wind) },
        });
        return DragScale == 1 && BendScale == 1
            ? scene
            : scene with { Forces = scene.Forces with { CustomForces = new IForce[] { new ScaledAir(scene, Typed(DragScale), Typed(BendScale)) } } };
    }

    /// <summary>Returns a ground at a height, m. A scene without ground has no height.</summary>
    internal static Ground AtHeight(Ground ground, double height) => ground.IsNone ? ground : ground with { Height = height };

    /// <summary>Returns a ground by its name.</summary>
    /// <param name="choice">The name; OfProfile and Custom return the given ground.</param>
    /// <param name="own">The ground of the profile.</param>
    internal static Ground GroundOf(GroundChoice choice, Ground own) =>
        choice is GroundChoice.OfProfile or GroundChoice.Custom ? own : Ground.Presets[NameOf(choice.ToString())];

    /// <summary>Returns the chosen ball.</summary>
    internal BallProperties BallOf() => Ball == BallChoice.Custom
        ? BallProperties.Modern with { Mass = Typed(CustomMass), Radius = Typed(CustomRadius) }
        : BallProperties.Presets[NameOf(Ball.ToString())];

    /// <summary>Returns the name of a preset in the library, which starts with a lower-case letter.</summary>
    private static string NameOf(string choice) => char.ToLowerInvariant(choice[0]) + choice.Substring(1);

    private ForceSet ForcesOf(ForceSet own) => Laws switch
    {
        AirChoice.OfProfile => own,
        AirChoice.Measured => ForceSet.Measured,
        AirChoice.Published => ForceSet.Published,
        AirChoice.Regularised => ForceSet.Regularized,
        AirChoice.Constant => ForceSet.Constant,
        AirChoice.Vacuum => ForceSet.None,
        _ => throw new InvalidOperationException($"There are no laws {Laws}."),
    };

    /// <summary>Returns the decimal number of the inspector, not the nearest single-precision number: 1.2f is not 1.2.</summary>
    internal static double Typed(float number) => Math.Abs(number) < 1e9f ? (double)(decimal)number : number;
}
