using System;
using UnityEngine;

namespace Football.Physics.Unity
{
    /// <summary>Ball, air, ground, method and time step as an asset that any number of balls share.</summary>
    [CreateAssetMenu(menuName = "Football/Preset", fileName = "FootballPreset")]
    public sealed class FootballPreset : ScriptableObject
    {
        /// <summary>The time step of a ball without a preset, s.</summary>
        public const double DefaultTimeStep = 0.02;

        /// <summary>The profile that ground and laws are of, where they do not say otherwise. Default measured, as without a preset.</summary>
        [Header("Profile"), Tooltip("Measured: as a ball without a preset. Published: the laws and numbers of the thesis that the library began with.")]
        public ProfileChoice profile = ProfileChoice.Measured;

        /// <summary>The ball. Default a match football.</summary>
        [Header("Ball")]
        public BallChoice ball = BallChoice.Football;

        /// <summary>Mass of a ball of your own, kg.</summary>
        [Range(0.01f, 20f), Tooltip("Mass of a custom ball, kg.")]
        public float customMass = 0.43f;

        /// <summary>Radius of a ball of your own, m.</summary>
        [Range(0.02f, 2f), Tooltip("Radius of a custom ball, m.")]
        public float customRadius = 0.11f;

        /// <summary>The ground. Default that of the profile: dry turf in the measured one.</summary>
        [Header("Ground")]
        public GroundChoice ground = GroundChoice.OfProfile;

        /// <summary>Height of the ground, m.</summary>
        [Range(-1000f, 1000f), Tooltip("Height of the ground, m.")]
        public float groundHeight;

        /// <summary>Part of the vertical speed that a bounce on a ground of your own gives back.</summary>
        [Range(0f, 1f), Tooltip("Custom ground: part of the vertical speed that a bounce gives back.")]
        public float customRestitution = 0.622f;

        /// <summary>Friction of a ball that slides on a ground of your own.</summary>
        [Range(0f, 2f), Tooltip("Custom ground: friction of a ball that slides.")]
        public float customSlidingFriction = 0.5f;

        /// <summary>Friction of a ball that rolls on a ground of your own.</summary>
        [Range(0f, 1f), Tooltip("Custom ground: friction of a ball that rolls.")]
        public float customRollingFriction = 0.07f;

        /// <summary>The laws of the air. Default those of the profile.</summary>
        [Header("Air")]
        public AirChoice laws = AirChoice.OfProfile;

        /// <summary>Density of the air, kg/m³.</summary>
        [Range(0f, 10f), Tooltip("Density of the air, kg/m³; 1.2 at sea level, 0.9 in Mexico City.")]
        public float airDensity = 1.2f;

        /// <summary>Wind in Unity's frame, m/s.</summary>
        [Tooltip("Wind, m/s; at most 60 in each direction.")]
        public Vector3 wind;

        /// <summary>Gravity, m/s².</summary>
        [Range(0f, 30f), Tooltip("Gravity, m/s².")]
        public float gravity = 9.81f;

        /// <summary>The one-step method.</summary>
        [Header("Steps")]
        public Integrator integrator = Integrator.Rk4;

        /// <summary>The time step, s: a double, for 0.02f is not 0.02. The same on every machine that is to have the same bits.</summary>
        [Tooltip("The time step, s; 0.001 to 0.1. The same on every machine that is to have the same bits.")]
        public double timeStep = DefaultTimeStep;

        /// <summary>Profiles to choose from: the measured one is what a ball without a preset has; the published one has the laws and numbers of the thesis that the library began with.</summary>
        public enum ProfileChoice
        {
            Measured,
            Published,
        }

        /// <summary>Balls to choose from: the presets of <see cref="BallProperties"/>, and one of your own.</summary>
        public enum BallChoice
        {
            Football,
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

        /// <summary>Grounds to choose from: that of the profile, the presets of <see cref="Physics.Ground"/>, and one of your own.</summary>
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
        }

        /// <summary>Laws of the air to choose from: those of the profile, and the presets of <see cref="ForceSet"/>.</summary>
        public enum AirChoice
        {
            OfProfile,
            Measured,
            Published,
            Regularised,
            Constant,
            Vacuum,
        }

        /// <summary>Checks and compiles the scene. Throws ArgumentOutOfRangeException where a number is out of range.</summary>
        public Simulator Compile()
        {
            Scene own = profile switch
            {
                ProfileChoice.Measured => Scene.Measured,
                ProfileChoice.Published => Scene.Published,
                _ => throw new InvalidOperationException("There is no profile " + profile + "."),
            };
            Scene scene = own with
            {
                Ball = Ball(),
                Air = new Air { Density = Typed(airDensity), Wind = WindAsTyped() },
                Gravity = Typed(gravity),
                Forces = Forces(own.Forces),
                Ground = Ground(own.Ground) with { Height = Typed(groundHeight) },
            };
            return new Simulator(scene, new SolverSettings { Integrator = integrator });
        }

        // The number in the inspector, not the single next to it: 1.2f is not 1.2.
        private static double Typed(float number)
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
            gravity = Mathf.Clamp(gravity, 0f, 30f);
        }

        private BallProperties Ball()
        {
            return ball switch
            {
                BallChoice.Football => BallProperties.Football,
                BallChoice.Tango12 => BallProperties.Tango12,
                BallChoice.Teamgeist => BallProperties.Teamgeist,
                BallChoice.Jabulani => BallProperties.Jabulani,
                BallChoice.Brazuca => BallProperties.Brazuca,
                BallChoice.Modern => BallProperties.Modern,
                BallChoice.Telstar18 => BallProperties.Telstar18,
                BallChoice.Flight2020 => BallProperties.Flight2020,
                BallChoice.AlRihla => BallProperties.AlRihla,
                BallChoice.Fussballliebe => BallProperties.Fussballliebe,
                BallChoice.Trionda => BallProperties.Trionda,
                BallChoice.YouthFootball => BallProperties.YouthFootball,
                BallChoice.Futsal => BallProperties.Futsal,
                BallChoice.BeachBall => BallProperties.BeachBall,
                BallChoice.MedicineBall => BallProperties.MedicineBall,
                BallChoice.Custom => BallProperties.Football with { Mass = Typed(customMass), Radius = Typed(customRadius) },
                _ => throw new InvalidOperationException("There is no ball " + ball + "."),
            };
        }

        private Vector3d WindAsTyped()
        {
            return UnityFrame.FromUnity(wind) + Vector3d.Zero; // no negative zeros
        }

        private Ground Ground(Ground own)
        {
            return ground switch
            {
                GroundChoice.OfProfile => own,
                GroundChoice.DryTurf => Physics.Ground.DryTurf,
                GroundChoice.ArtificialTurf => Physics.Ground.ArtificialTurf,
                GroundChoice.WetTurf => Physics.Ground.WetTurf,
                GroundChoice.MatchTurf => Physics.Ground.MatchTurf,
                GroundChoice.HardGround => Physics.Ground.HardGround,
                GroundChoice.LongGrass => Physics.Ground.LongGrass,
                GroundChoice.Indoor => Physics.Ground.Indoor,
                GroundChoice.Concrete => Physics.Ground.Concrete,
                GroundChoice.Snow => Physics.Ground.Snow,
                GroundChoice.PublishedTurf => Physics.Ground.PublishedTurf,
                GroundChoice.PublishedWetTurf => Physics.Ground.PublishedWetTurf,
                GroundChoice.PublishedCourt => Physics.Ground.PublishedCourt,
                GroundChoice.PublishedSand => Physics.Ground.PublishedSand,
                GroundChoice.Custom => own with
                {
                    NormalRestitution = Typed(customRestitution),
                    SlidingFriction = Typed(customSlidingFriction),
                    RollingFriction = Typed(customRollingFriction),
                },
                _ => throw new InvalidOperationException("There is no ground " + ground + "."),
            };
        }

        private ForceSet Forces(ForceSet own)
        {
            return laws switch
            {
                AirChoice.OfProfile => own,
                AirChoice.Measured => ForceSet.Measured,
                AirChoice.Published => ForceSet.Published,
                AirChoice.Regularised => ForceSet.Regularised,
                AirChoice.Constant => ForceSet.Constant,
                AirChoice.Vacuum => ForceSet.None,
                _ => throw new InvalidOperationException("There are no laws " + laws + "."),
            };
        }
    }
}
