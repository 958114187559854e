using System;
using UnityEngine.Events;

namespace FootballPhysics.Unity
{
    /// <summary>An event of a ball for the inspector.</summary>
    [Serializable]
    public sealed class FootballUnityEvent : UnityEvent<FootballEvent>
    {
    }
}
