using FootballPhysics.Unity;
using UnityEngine;

namespace FootballSamples
{
    /// <summary>Bends a Rigidbody of Unity like a football. Put it on an empty object and press play: it creates a ball, and kicks it every three seconds to alternate sides.</summary>
    public sealed class CurlARigidbody : MonoBehaviour
    {
        [SerializeField, Tooltip("Speed of the kick, m/s.")]
        private float speed = 26f;

        [SerializeField, Tooltip("Side spin of the kick, rad/s.")]
        private float sideSpin = 60f;

        private FootballAir _ball;
        private double _next;

        private void Start()
        {
            GameObject ground = GameObject.CreatePrimitive(PrimitiveType.Plane);
            ground.name = "Ground";
            ground.transform.localScale = new Vector3(10f, 1f, 10f);

            // You already have this part: a sphere of 0.22 m with a Rigidbody. Only Football Air is new.
            GameObject ball = GameObject.CreatePrimitive(PrimitiveType.Sphere);
            ball.name = "Ball";
            ball.transform.localScale = new Vector3(0.22f, 0.22f, 0.22f);
            ball.AddComponent<Rigidbody>();
            _ball = ball.AddComponent<FootballAir>();
        }

        private void FixedUpdate()
        {
            if (Time.fixedTimeAsDouble >= _next)
            {
                _next = Time.fixedTimeAsDouble + 3.0;
                _ball.transform.position = transform.position + new Vector3(0f, 0.11f, 0f);
                _ball.Kick(speed, new Vector3(0f, 0.25f, 1f), 0f, sideSpin);
                sideSpin *= -1f;
            }
        }
    }
}
