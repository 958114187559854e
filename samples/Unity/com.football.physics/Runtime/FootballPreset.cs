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

        /// <summary>Which ball.</summary>
        [Header("Ball")]
        public BallChoice ball = BallChoice.Football;

        /// <summary>Mass of a ball of your own, kg.</summary>
        [Range(0.01f, 20f), Tooltip("Mass of a custom ball, kg.")]
        public float customMass = 0.43f;

        /// <summary>Radius of a ball of your own, m.</summary>
        [Range(0.01f, 2f), Tooltip("Radius of a custom ball, m.")]
        public float customRadius = 0.11f;

        /// <summary>Which ground.</summary>
        [Header("Ground")]
        public GroundChoice ground = GroundChoice.Turf;

        /// <summary>Height of the ground, m.</summary>
        [Range(-1000f, 1000f), Tooltip("Height of the ground, m.")]
        public float groundHeight;

        /// <summary>Part of the vertical speed that a bounce on a ground of your own gives back.</summary>
        [Range(0f, 1f), Tooltip("Custom ground: part of the vertical speed that a bounce gives back.")]
        public float customRestitution = 0.6f;

        /// <summary>Friction of a ball that slides on a ground of your own.</summary>
        [Range(0f, 2f), Tooltip("Custom ground: friction of a ball that slides.")]
        public float customSlidingFriction = 0.5f;

        /// <summary>Friction of a ball that rolls on a ground of your own.</summary>
        [Range(0f, 1f), Tooltip("Custom ground: friction of a ball that rolls.")]
        public float customRollingFriction = 0.05f;

        /// <summary>Which laws of the air.</summary>
        [Header("Air")]
        public AirChoice laws = AirChoice.Published;

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

        /// <summary>Checks and compiles the scene. Throws ArgumentOutOfRangeException where a number is out of range.</summary>
        public Simulator Compile()
        {
            var scene = new Scene
            {
                Ball = Ball(),
                Air = new Air { Density = airDensity, Wind = UnityFrame.FromUnity(wind) },
                Gravity = gravity == 9.81f ? 9.81 : gravity,
                Forces = Forces(),
                Ground = Ground() with { Height = groundHeight },
            };
            return new Simulator(scene, new SolverSettings { Integrator = integrator });
        }

        private void OnValidate()
        {
            timeStep = Math.Min(0.1, Math.Max(0.001, timeStep));
            wind = new Vector3(Mathf.Clamp(wind.x, -60f, 60f), Mathf.Clamp(wind.y, -60f, 60f), Mathf.Clamp(wind.z, -60f, 60f));
            customMass = Mathf.Clamp(customMass, 0.01f, 20f);
            customRadius = Mathf.Clamp(customRadius, 0.01f, 2f);
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
                BallChoice.YouthFootball => BallProperties.YouthFootball,
                BallChoice.Futsal => BallProperties.Futsal,
                BallChoice.BeachBall => BallProperties.BeachBall,
                BallChoice.MedicineBall => BallProperties.MedicineBall,
                BallChoice.Custom => BallProperties.Football with { Mass = customMass, Radius = customRadius },
                _ => throw new ArgumentOutOfRangeException(nameof(ball)),
            };
        }

        private Ground Ground()
        {
            return ground switch
            {
                GroundChoice.Turf => Physics.Ground.Turf,
                GroundChoice.WetTurf => Physics.Ground.WetTurf,
                GroundChoice.Court => Physics.Ground.Court,
                GroundChoice.Sand => Physics.Ground.Sand,
                GroundChoice.Custom => Physics.Ground.Turf with
                {
                    NormalRestitution = customRestitution,
                    SlidingFriction = customSlidingFriction,
                    RollingFriction = customRollingFriction,
                },
                _ => throw new ArgumentOutOfRangeException(nameof(ground)),
            };
        }

        private ForceSet Forces()
        {
            return laws switch
            {
                AirChoice.Published => ForceSet.Published,
                AirChoice.Regularised => ForceSet.Regularised,
                AirChoice.Constant => ForceSet.Constant,
                AirChoice.Vacuum => ForceSet.None,
                AirChoice.Measured => ForceSet.Measured,
                _ => throw new ArgumentOutOfRangeException(nameof(laws)),
            };
        }
    }
}
