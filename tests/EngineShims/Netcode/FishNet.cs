using System;
using FishNet.Managing.Timing;
using UnityEngine;

namespace FishNet.Transporting
{
    public enum Channel : byte
    {
        Reliable = 0,
        Unreliable = 1,
    }
}

namespace FishNet.Managing.Timing
{
    public class TimeManager
    {
        public event Action? OnTick;

        public uint LocalTick { get; private set; }

        public double TickDelta { get; set; } = 1.0 / 60.0;

        public void Advance()
        {
            LocalTick++;
            OnTick?.Invoke();
        }
    }
}

namespace FishNet.Object.Prediction
{
    [Flags]
    public enum ReplicateState : byte
    {
        Invalid = 0,
        Ticked = 1,
        Replayed = 2,
        Created = 4,
    }

    public interface IReplicateData
    {
        uint GetTick();

        void SetTick(uint value);

        void Dispose();
    }

    public interface IReconcileData
    {
        uint GetTick();

        void SetTick(uint value);

        void Dispose();
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class ReplicateAttribute : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class ReconcileAttribute : Attribute
    {
    }

    public static class ReplicateStateExtensions
    {
        public static bool ContainsReplayed(this ReplicateState value) => (value & ReplicateState.Replayed) != 0;
    }
}

namespace FishNet.Object
{
    /// <summary>In the shim the weaver's work is done by the test: FishNet rewrites the methods with [Replicate] and [Reconcile].</summary>
    public abstract class NetworkBehaviour : MonoBehaviour
    {
        public TimeManager TimeManager { get; set; } = null!;

        public bool IsOwner { get; set; }

        public bool IsServerStarted { get; set; }

        public virtual void OnStartNetwork()
        {
        }

        public virtual void OnStopNetwork()
        {
        }

        public virtual void CreateReconcile()
        {
        }
    }
}
