using System;
using UnityEngine;

namespace Football.Physics.Unity
{
    /// <summary>Ball, air, ground and method as an asset that any number of balls share.</summary>
    [CreateAssetMenu(menuName = "Football/Preset", fileName = "FootballPreset")]
    public sealed class FootballPreset : ScriptableObject
    {
        /// <summary>Which ball.</summary>
        public BallChoice ball = BallChoice.Football;

        /// <summary>Which ground.</summary>
        public GroundChoice ground = GroundChoice.Turf;

        /// <summary>Which laws of the air.</summary>
        public AirChoice laws = AirChoice.Published;

        /// <summary>The one-step method.</summary>
        public Integrator integrator = Integrator.Rk4;

        /// <summary>Height of the ground, m.</summary>
        [Tooltip("Height of the ground, m.")]
        public float groundHeight;

        /// <summary>Density of the air, kg/m³.</summary>
        [Min(0f), Tooltip("Density of the air, kg/m³.")]
        public float airDensity = 1.2f;

        /// <summary>Wind in Unity's frame, m/s.</summary>
        [Tooltip("Wind, m/s.")]
        public Vector3 wind;

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

        /// <summary>Checks and compiles the scene. Throws ArgumentOutOfRangeException where a number is out of range.</summary>
        public Simulator Compile()
        {
            var scene = new Scene
            {
                Ball = Ball(),
                Air = new Air { Density = airDensity, Wind = UnityFrame.FromUnity(wind) },
                Forces = Forces(),
                Ground = Ground() with { Height = groundHeight },
            };
            return new Simulator(scene, new SolverSettings { Integrator = integrator });
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
                _ => throw new ArgumentOutOfRangeException(nameof(laws)),
            };
        }
    }
}
