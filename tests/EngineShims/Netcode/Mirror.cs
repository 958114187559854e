using System;
using System.Collections.Generic;
using FootballPhysics.Shims;
using UnityEngine;

namespace Mirror
{
    public interface NetworkMessage
    {
    }

    /// <summary>Of Mirror's own interpolation.</summary>
    public interface Snapshot
    {
        double remoteTime { get; set; }

        double localTime { get; set; }
    }

    public static class Channels
    {
        public const int Reliable = 0;
        public const int Unreliable = 1;
    }

    public class NetworkConnectionToClient
    {
    }

    public abstract class NetworkBehaviour : MonoBehaviour
    {
        public bool isServer { get; set; }

        public bool isClient => !isServer;

        public uint netId { get; set; }

        public virtual void OnStartServer()
        {
        }

        public virtual void OnStartClient()
        {
        }
    }

    /// <summary>In the shim with one client.</summary>
    public static class NetworkServer
    {
        internal static readonly Dictionary<Type, Delegate> Handlers = new Dictionary<Type, Delegate>();

        public static void RegisterHandler<T>(Action<NetworkConnectionToClient, T> handler, bool requireAuthentication = true)
            where T : struct, NetworkMessage => Handlers[typeof(T)] = handler;

        public static void SendToAll<T>(T message, int channelId = Channels.Reliable, bool sendToReadyOnly = false)
            where T : struct, NetworkMessage => LateNetwork.Post(() => ((Action<T>)NetworkClient.Handlers[typeof(T)])(message));
    }

    public static class NetworkClient
    {
        internal static readonly Dictionary<Type, Delegate> Handlers = new Dictionary<Type, Delegate>();

        public static void RegisterHandler<T>(Action<T> handler, bool requireAuthentication = true)
            where T : struct, NetworkMessage => Handlers[typeof(T)] = handler;

        public static void Send<T>(T message, int channelId = Channels.Reliable)
            where T : struct, NetworkMessage => LateNetwork.Post(() => ((Action<NetworkConnectionToClient, T>)NetworkServer.Handlers[typeof(T)])(new NetworkConnectionToClient(), message));
    }
}
