using System.Globalization;
using Football.Physics.Unity;
using UnityEngine;

namespace Football.Demo
{
    /// <summary>A pitch, a goal and a ball out of nothing: space kicks as the ball previews, R puts it back.</summary>
    public sealed class DemoPitch : MonoBehaviour
    {
        [SerializeField, Tooltip("Where the ball is put.")]
        private Vector3 spot = new Vector3(0f, 0.11f, 0f);

        private FootballBall _ball;

        private void Start()
        {
            GameObject grass = GameObject.CreatePrimitive(PrimitiveType.Plane);
            grass.transform.localScale = new Vector3(10f, 1f, 10f);
            Bar(new Vector3(-3.72f, 1.25f, 22f), new Vector3(0.12f, 1.25f, 0.12f), Quaternion.identity);
            Bar(new Vector3(3.72f, 1.25f, 22f), new Vector3(0.12f, 1.25f, 0.12f), Quaternion.identity);
            Bar(new Vector3(0f, 2.5f, 22f), new Vector3(0.12f, 3.72f, 0.12f), Quaternion.Euler(0f, 0f, 90f));

            GameObject ball = GameObject.CreatePrimitive(PrimitiveType.Sphere);
            ball.name = "Ball";
            ball.transform.localScale = new Vector3(0.22f, 0.22f, 0.22f);
            ball.transform.position = spot;
            ball.GetComponent<Collider>().isTrigger = true;
            _ball = ball.AddComponent<FootballBall>();
            _ball.Impact += (who, happened) => Debug.Log("hit the " + happened.Surface + " at " + happened.VelocityBefore.magnitude.ToString("0.0", CultureInfo.InvariantCulture) + " m/s");
        }

        private void Update()
        {
            if (Input.GetKeyDown(KeyCode.Space))
            {
                _ball.KickAsPreviewed();
            }

            if (Input.GetKeyDown(KeyCode.R))
            {
                _ball.Place(spot);
            }
        }

        private static void Bar(Vector3 position, Vector3 scale, Quaternion rotation)
        {
            GameObject bar = GameObject.CreatePrimitive(PrimitiveType.Cylinder);
            bar.transform.localScale = scale;
            bar.transform.SetPositionAndRotation(position, rotation);
        }
    }
}
