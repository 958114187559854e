using System;
using FootballPhysics.Laws;
using UnityEngine;

namespace FootballPhysics.Unity
{
    /// <summary>The ball, air, ground, integrator and time step, as an asset that several balls can share.</summary>
    [CreateAssetMenu(menuName = "Football/Preset", fileName = "FootballPreset")]
    public sealed class FootballPreset : ScriptableObject
    {
        /// <summary>The time step of a ball without a preset, s.</summary>
        public const double DefaultTimeStep = 0.02;

        /// <summary>The profile of the ground and the laws, unless they are set below. Default: measured.</summary>
        [Header("Profile"), Tooltip("Measured: like a ball without a preset. Published: the laws and numbers of the original thesis.")]
        public ProfileChoice profile = ProfileChoice.Measured;

        /// <summary>The ball. Default: a match football.</summary>
        [Header("Ball")]
        public BallChoice ball = BallChoice.Modern;

        /// <summary>Mass of a custom ball, kg.</summary>
        [Range(0.01f, 20f), Tooltip("Mass of a custom ball, kg.")]
        public float customMass = 0.43f;

        /// <summary>Radius of a custom ball, m.</summary>
        [Range(0.02f, 2f), Tooltip("Radius of a custom ball, m.")]
        public float customRadius = 0.11f;

        /// <summary>The ground. Default: the profile's, which is match turf in the measured profile.</summary>
        [Header("Ground")]
        public GroundChoice ground = GroundChoice.OfProfile;

        /// <summary>Height of the ground, m.</summary>
        [Range(-1000f, 1000f), Tooltip("Height of the ground, m.")]
        public float groundHeight;

        /// <summary>Fraction of the vertical speed that a bounce on a custom ground returns.</summary>
        [Range(0f, 1f), Tooltip("Custom ground: fraction of the vertical speed that a bounce returns.")]
        public float customRestitution = 0.67f;

        /// <summary>Friction of a ball that slides on a custom ground.</summary>
        [Range(0f, 2f), Tooltip("Custom ground: friction of a sliding ball.")]
        public float customSlidingFriction = 0.45f;

        /// <summary>Friction of a ball that rolls on a custom ground.</summary>
        [Range(0f, 1f), Tooltip("Custom ground: resistance of a rolling ball.")]
        public float customRollingFriction = 0.064f;

        /// <summary>The laws of the air. Default: the profile's.</summary>
        [Header("Air")]
        public AirChoice laws = AirChoice.OfProfile;

        /// <summary>Density of the air, kg/m³.</summary>
        [Range(0f, 10f), Tooltip("Density of the air, kg/m³; 1.2 at sea level, 0.9 in Mexico City.")]
        public float airDensity = 1.2f;

        /// <summary>Kinematic viscosity of the air, mm²/s.</summary>
        [Range(0.1f, 1000f), Tooltip("Kinematic viscosity of the air, mm²/s; 15 at sea level, 19.9 in Mexico City.")]
        public float airViscosity = 15f;

        /// <summary>Drag factor: 1 is realistic, 0 is no drag.</summary>
        [Range(0f, 3f), Tooltip("Drag factor: 1 is realistic, 0 is no drag.")]
        public float dragScale = 1f;

        /// <summary>Bend of a spinning ball: 1 is realistic, 0 is straight.</summary>
        [Range(0f, 3f), Tooltip("Bend of a spinning ball: 1 is realistic, 0 is straight.")]
        public float bendScale = 1f;

        /// <summary>Wind in Unity's frame, m/s.</summary>
        [Tooltip("Wind, m/s; at most 60 in each direction.")]
        public Vector3 wind;

        /// <summary>Gravity, m/s².</summary>
        [Range(0f, 30f), Tooltip("Gravity, m/s².")]
        public float gravity = 9.81f;

        /// <summary>Pressure of the ball, bar.</summary>
        [Header("Condition"), Range(0.6f, 1.1f), Tooltip("Pressure of the ball, bar. The Laws allow 0.6 to 1.1; a soft ball bounces less.")]
        public float ballPressure = 0.8f;

        /// <summary>Water on the pitch and in the ball.</summary>
        [Range(0f, 1f), Tooltip("Water on the pitch and in the ball: 0 no extra water, 1 soaked.")]
        public float wetness;

        /// <summary>Wear of the ball.</summary>
        [Range(0f, 1f), Tooltip("Wear of the ball: 0 new, 1 worn. A worn ball flies a little farther.")]
        public float ballWear;

        /// <summary>Mud on the pitch and on the ball.</summary>
        [Range(0f, 1f), Tooltip("Mud on the pitch and on the ball: 0 none, 1 deep.")]
        public float mud;

        /// <summary>The integrator.</summary>
        [Header("Steps")]
        public Integrator integrator = Integrator.Rk4;

        /// <summary>The time step, s. It is a double, because 0.02f is not 0.02. Machines that must be bit-identical need the same one.</summary>
        [Tooltip("Time step, s; 0.001 to 0.1. Use the same on every machine that must stay in sync.")]
        public double timeStep = DefaultTimeStep;

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

        /// <summary>Grounds to choose from: the profile's, the presets of <see cref="FootballPhysics.Ground"/> and a custom one.</summary>
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

        /// <summary>The solver settings of the scene.</summary>
        public SolverSettings Settings => new SolverSettings { Integrator = integrator };

        /// <summary>A hash that changes when any of these numbers changes.</summary>
        internal int Stamp
        {
            get
            {
                var stamp = new HashCode();
                stamp.Add((int)profile);
                stamp.Add((int)ball);
                stamp.Add(customMass);
                stamp.Add(customRadius);
                stamp.Add((int)ground);
                stamp.Add(groundHeight);
                stamp.Add(customRestitution);
                stamp.Add(customSlidingFriction);
                stamp.Add(customRollingFriction);
                stamp.Add((int)laws);
                stamp.Add(airDensity);
                stamp.Add(airViscosity);
                stamp.Add(dragScale);
                stamp.Add(bendScale);
                stamp.Add(wind);
                stamp.Add(gravity);
                stamp.Add(ballPressure);
                stamp.Add(wetness);
                stamp.Add(ballWear);
                stamp.Add(mud);
                stamp.Add((int)integrator);
                stamp.Add(timeStep);
                return stamp.ToHashCode();
            }
        }

        /// <summary>Checks and compiles the scene. Throws ArgumentOutOfRangeException if a number is out of range.</summary>
        public Simulator Compile()
        {
            return new Simulator(MakeScene(), Settings);
        }

        /// <summary>Creates the scene from these numbers.</summary>
        public Scene MakeScene()
        {
            Scene own = profile switch
            {
                ProfileChoice.Measured => Scene.Measured,
                ProfileChoice.Published => Scene.Published,
                _ => throw new InvalidOperationException("There is no profile " + profile + "."),
            };
            var dials = new Dials { Pressure = Typed(ballPressure), Wetness = Typed(wetness), Wear = Typed(ballWear), Mud = Typed(mud) };
            Scene scene = dials.Apply(own with
            {
                Ball = BallOf(),
                Air = new Air { Density = Typed(airDensity), KinematicViscosity = Typed(airViscosity) / 1e6, Wind = WindAsTyped() },
                Gravity = Typed(gravity),
                Forces = Forces(own.Forces),
                Ground = AtHeight(Ground(own.Ground), Typed(groundHeight)),
            });
            return dragScale == 1f && bendScale == 1f
                ? scene
                : scene with { Forces = scene.Forces with { CustomForces = new IForce[] { new ScaledAir(scene, Typed(dragScale), Typed(bendScale)) } } };
        }

        /// <summary>Returns a ground at a height, m. A scene without ground has no height.</summary>
        internal static Ground AtHeight(Ground ground, double height)
        {
            return ground.IsNone ? ground : ground with { Height = height };
        }

        /// <summary>Returns a ground by its name.</summary>
        /// <param name="choice">The name; OfProfile and Custom return the given ground.</param>
        /// <param name="own">The ground of the profile.</param>
        internal static Ground GroundOf(GroundChoice choice, Ground own)
        {
            return choice == GroundChoice.OfProfile || choice == GroundChoice.Custom ? own : FootballPhysics.Ground.Presets[NameOf(choice.ToString())];
        }

        /// <summary>Returns the name of a preset in the library, which starts with a lower-case letter.</summary>
        internal static string NameOf(string choice)
        {
            return char.ToLowerInvariant(choice[0]) + choice.Substring(1);
        }

        /// <summary>Returns the decimal number of the inspector, not the nearest single-precision number: 1.2f is not 1.2.</summary>
        internal static double Typed(float number)
        {
            return Math.Abs(number) < 1e9f ? (double)(decimal)number : number;
        }

        private void OnValidate()
        {
            timeStep = Math.Min(0.1, Math.Max(0.001, timeStep));
            wind = new Vector3(Mathf.Clamp(wind.x, -60f, 60f), Mathf.Clamp(wind.y, -60f, 60f), Mathf.Clamp(wind.z, -60f, 60f));
            customMass = Mathf.Clamp(customMass, 0.01f, 20f);
            customRadius = Mathf.Clamp(customRadius, 0.02f, 2f);
            groundHeight = Mathf.Clamp(groundHeight, -1000f, 1000f);
            customRestitution = Mathf.Clamp(customRestitution, 0f, 1f);
            customSlidingFriction = Mathf.Clamp(customSlidingFriction, 0f, 2f);
            customRollingFriction = Mathf.Clamp(customRollingFriction, 0f, 1f);
            airDensity = Mathf.Clamp(airDensity, 0f, 10f);
            airViscosity = Mathf.Clamp(airViscosity, 0.1f, 1000f);
            dragScale = Mathf.Clamp(dragScale, 0f, 3f);
            bendScale = Mathf.Clamp(bendScale, 0f, 3f);
            gravity = Mathf.Clamp(gravity, 0f, 30f);
            ballPressure = Mathf.Clamp(ballPressure, 0.6f, 1.1f);
            wetness = Mathf.Clamp(wetness, 0f, 1f);
            ballWear = Mathf.Clamp(ballWear, 0f, 1f);
            mud = Mathf.Clamp(mud, 0f, 1f);
        }

        /// <summary>Returns the chosen ball.</summary>
        internal BallProperties BallOf()
        {
            return ball == BallChoice.Custom
                ? BallProperties.Modern with { Mass = Typed(customMass), Radius = Typed(customRadius) }
                : BallProperties.Presets[NameOf(ball.ToString())];
        }

        private Vector3d WindAsTyped()
        {
            return UnityFrame.FromUnity(wind) + Vector3d.Zero; // no negative zeros
        }

        private Ground Ground(Ground own)
        {
            Ground chosen = GroundOf(ground, own);
            return ground != GroundChoice.Custom ? chosen : chosen with
            {
                Material = chosen.Material with
                {
                    NormalRestitution = Typed(customRestitution),
                    SlidingFriction = Typed(customSlidingFriction),
                    RollingResistance = Typed(customRollingFriction),
                },
            };
        }

        private ForceSet Forces(ForceSet own)
        {
            return laws switch
            {
                AirChoice.OfProfile => own,
                AirChoice.Measured => ForceSet.Measured,
                AirChoice.Published => ForceSet.Published,
                AirChoice.Regularised => ForceSet.Regularized,
                AirChoice.Constant => ForceSet.Constant,
                AirChoice.Vacuum => ForceSet.None,
                _ => throw new InvalidOperationException("There are no laws " + laws + "."),
            };
        }
    }
}
