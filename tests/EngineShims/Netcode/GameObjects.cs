using System;
using System.Collections.Generic;
using FootballPhysics.Shims;
using Unity.Collections;
using UnityEngine;

namespace Unity.Netcode
{
    public enum NetworkDelivery
    {
        Unreliable,
        UnreliableSequenced,
        Reliable,
        ReliableSequenced,
        ReliableFragmentedSequenced,
    }

    public struct FastBufferReader
    {
        private readonly byte[] _bytes;
        private readonly int[] _position;

        public FastBufferReader(byte[] bytes)
        {
            _bytes = bytes;
            _position = new int[1];
        }

        public readonly int Length => _bytes.Length;

        public readonly int Position => _position[0];

        public readonly void ReadBytesSafe(ref byte[] value, int size, int offset = 0)
        {
            Array.Copy(_bytes, _position[0], value, offset, size);
            _position[0] += size;
        }

        public readonly void ReadValueSafe(out long value)
        {
            value = BitConverter.ToInt64(_bytes, _position[0]);
            _position[0] += sizeof(long);
        }
    }

    public struct FastBufferWriter : IDisposable
    {
        private readonly List<byte> _bytes;

        public FastBufferWriter(int size, Allocator allocator, int maxSize = -1) => _bytes = new List<byte>(size);

        internal readonly byte[] All => _bytes.ToArray();

        public readonly void WriteValueSafe(in long value) => _bytes.AddRange(BitConverter.GetBytes(value));

        public readonly void WriteBytesSafe(byte[] value, int size = -1, int offset = 0) => _bytes.AddRange(new ArraySegment<byte>(value, offset, size < 0 ? value.Length : size));

        public readonly void Dispose()
        {
        }
    }

    public class NetworkTickSystem
    {
        public event Action? Tick;

        public uint TickRate { get; set; } = 60;

        public void Advance() => Tick?.Invoke();
    }

    public class CustomMessagingManager
    {
        private readonly Dictionary<string, HandleNamedMessageDelegate> _handlers = new Dictionary<string, HandleNamedMessageDelegate>();
        private readonly NetworkManager _own;

        internal CustomMessagingManager(NetworkManager own) => _own = own;

        public delegate void HandleNamedMessageDelegate(ulong senderClientId, FastBufferReader messagePayload);

        public void RegisterNamedMessageHandler(string name, HandleNamedMessageDelegate callback) => _handlers[name] = callback;

        public void SendNamedMessageToAll(string messageName, FastBufferWriter messageStream, NetworkDelivery networkDelivery = NetworkDelivery.ReliableSequenced)
        {
            foreach (NetworkManager other in NetworkManager.All)
            {
                if (other != _own)
                {
                    SendNamedMessage(messageName, other.LocalClientId, messageStream, networkDelivery);
                }
            }
        }

        public void SendNamedMessage(string messageName, ulong clientId, FastBufferWriter messageStream, NetworkDelivery networkDelivery = NetworkDelivery.ReliableSequenced)
        {
            byte[] bytes = messageStream.All;
            ulong from = _own.LocalClientId;
            NetworkManager to = NetworkManager.All.Find(other => other.LocalClientId == clientId)!;
            LateNetwork.Post(() => to.CustomMessagingManager._handlers[messageName](from, new FastBufferReader(bytes)));
        }
    }

    public class NetworkManager : MonoBehaviour
    {
        public const ulong ServerClientId = 0;

        public NetworkManager() => CustomMessagingManager = new CustomMessagingManager(this);

        /// <summary>All that are connected.</summary>
        public static List<NetworkManager> All { get; } = new List<NetworkManager>();

        public ulong LocalClientId { get; set; }

        public NetworkTickSystem NetworkTickSystem { get; } = new NetworkTickSystem();

        public CustomMessagingManager CustomMessagingManager { get; }
    }

    public abstract class NetworkBehaviour : MonoBehaviour
    {
        public NetworkManager NetworkManager { get; set; } = null!;

        public bool IsServer => NetworkManager.LocalClientId == NetworkManager.ServerClientId;

        public ulong OwnerClientId => NetworkManager.LocalClientId;

        public virtual void OnNetworkSpawn()
        {
        }
    }
}
